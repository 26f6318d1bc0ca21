"""The way from question to answer: one loop over time, which everything iterates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import cached_property, partial

import numpy as np

from tyrecontact import assembly
from tyrecontact.contact import newton
from tyrecontact.contact.bonds import Bonds, ElementState
from tyrecontact.contact.equilibrium import (
    Bodies,
    Equilibrium,
    NewtonMethod,
    Solver,
    State,
    advance,
)
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.machine import Moment
from tyrecontact.contact.stability import StabilityMargin
from tyrecontact.fast import one_thread
from tyrecontact.loading import Schedule
from tyrecontact.results import STOPPED, Record, Results, Step
from tyrecontact.road import heights
from tyrecontact.road.heights import Patch
from tyrecontact.road.springs import Springs
from tyrecontact.scenario import Scenario
from tyrecontact.tread.kernels import Kernel
from tyrecontact.watch import Watch

#: by `ElementState`
_TOUCHES = np.array(
    [state in (ElementState.COMPRESSED, ElementState.TENSION) for state in ElementState]
)


class Simulation:
    """A scenario made ready to run.

    Iterating yields a `Step` for each time step and starts from rest every time; `len` is the
    number of steps of a complete run. To cancel is to stop asking, and to let go of the iterator:
    products of matrices use one thread while there is one.

    Parameters
    ----------
    scenario : is copied; later changes of it do not reach this simulation.

    Raises
    ------
    InputError : settings that cannot go together, or a road file that cannot be used (when
        the road is first needed).
    """

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario.copy()
        self.stamps = self.scenario.file_stamps()
        numerics = self.scenario.numerics
        self.time_step = 1 / (numerics.sampling_frequency * numerics.time_resolution_factor)
        assembly.require_consistent(self.scenario)
        assembly.machine(self.scenario.loading)  # what it refuses is refused now
        path = assembly.loading_path(self.scenario.loading)
        assembly.require_shallow(path, self.scenario)
        stepped = numerics.long_holds == "stepped"
        memory = np.inf if stepped else numerics.lags / numerics.sampling_frequency
        self.schedule = path.schedule(self.time_step, memory)

    def __len__(self) -> int:
        return len(self.schedule.time)

    def __iter__(self) -> Iterator[Step]:
        with one_thread():
            yield from self._steps()

    def _steps(self) -> Iterator[Step]:
        bodies, solver, margin = self.bodies, self.solver, self.margin.fresh()
        state, value = State.at_rest(bodies, self._start), 1.0
        interval = self.scenario.numerics.margin_interval
        for index, moment in enumerate(self._moments()):
            equilibrium = advance(bodies, solver, state, moment)
            if index % interval == 0:
                value = margin.of(equilibrium.solution.stiffness)
            step = self._step(index, equilibrium, state, value)
            yield step
            if step.stop_reason:
                return

    def run(self, progress: Callable[[Iterable[Step]], Iterable[Step]] = iter) -> Results:
        """Run to the end. Ctrl-C ends the run and keeps what was computed.

        `progress` wraps the loop, as `tqdm` does. Numbers are kept of all steps, fields as many
        as `numerics.field_memory` takes.
        """
        record = Record(len(self), self.bodies.kernel.shape, self.scenario.numerics.field_memory)
        reason = ""
        try:
            for step in progress(self):
                record.append(step)
        except KeyboardInterrupt:
            reason = STOPPED
        return self.collect(record, reason)

    def quasi_static(self, steps: int) -> Simulation:
        """The same path with the tread at rest in every step, robustly solved.

        Of this simulation's steps about `steps` are kept, equally spaced along the path of the
        road, and those where it turns; time has no meaning for the tread at rest.
        """
        still = self.scenario.copy()
        still.numerics.param.update(
            kernel="static", solver="robust", initial_guess="last", tolerance=1e-7,
            max_iterations=100,
        )  # fmt: skip
        other = Simulation(still)
        drive = self.schedule.drive
        travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(drive)))])
        marks = np.linspace(0, travelled[-1], steps)
        spaced = np.searchsorted(travelled, marks * (1 - 1e-12))
        turns = np.flatnonzero(np.diff(np.sign(np.diff(drive)))) + 1
        kept = np.unique(np.concatenate([spaced, turns, [len(self) - 1]]))
        other.schedule = Schedule(self.schedule.time[kept], drive[kept], np.ones(kept.size, bool))
        other.patch, other.springs = self.patch, self.springs
        return other

    def collect(self, record: Record, stop_reason: str = "") -> Results:
        """Results of the steps that a consumer of the loop has recorded."""
        return record.results(self.scenario, self.kernel.spacing, stop_reason)

    @cached_property
    def patch(self) -> Patch:
        """The road under the patch, at full resolution."""
        return assembly.road_patch(self.scenario.road)

    @cached_property
    def springs(self) -> Springs:
        """Roughness springs, after the exchange; element (row, column) is row x nx + column."""
        return assembly.arranged_springs(self.original_springs, self.scenario.springs)

    @cached_property
    def original_springs(self) -> Springs:
        """Roughness springs as read off the road, before the exchange."""
        return assembly.original_springs(self.patch, self.scenario)

    @cached_property
    def kernel(self) -> Kernel:
        """Element kernel of the tread."""
        return assembly.tread_kernel(self.scenario)

    @cached_property
    def lattice(self) -> LatticeKernel:
        """The kernel ready for products with element forces."""
        return LatticeKernel(self.kernel)

    @cached_property
    def margin(self) -> StabilityMargin:
        """How far the kernel is from where time stepping blows up, before the first step."""
        return StabilityMargin(self.kernel)

    @cached_property
    def bodies(self) -> Bodies:
        """Road and tread, ready for the solver."""
        tops = heights.element_tops(self.patch, self.scenario.road.elements).ravel()
        law = assembly.adhesion_law(self.scenario.adhesion, self.springs)
        machine = assembly.machine(self.scenario.loading)
        return Bodies(self.lattice, self.springs, law, tops - tops.max(), machine)

    @cached_property
    def _watch(self) -> Watch:
        thickness = assembly.tread_thickness(self.scenario.tread)
        return Watch(thickness, self.scenario.numerics.kernel, self.solver.method is newton.robust)

    @cached_property
    def solver(self) -> Solver:
        """How each step is solved."""
        numerics, loading = self.scenario.numerics, self.scenario.loading
        # a force says nothing of the depth to expect
        deepest = loading.max_indentation
        if loading.drive != "force":
            deepest = float(self.schedule.drive.max())
        return Solver(
            method=newton.robust if numerics.solver == "robust" else self._thesis_method,
            tolerance=numerics.tolerance * deepest,
            max_iterations=numerics.max_iterations,
            extrapolates=numerics.initial_guess == "extrapolated",
        )

    @property
    def _thesis_method(self) -> NewtonMethod:
        if self.scenario.numerics.jacobian == "as-printed":
            return partial(newton.thesis, as_printed=True)
        return newton.thesis

    @property
    def _start(self) -> float:
        """Where the road is before the first step [m]: first touch, or above it."""
        forced = self.scenario.loading.drive == "force"
        return 0.0 if forced else min(float(self.schedule.drive[0]), 0.0)

    def _moments(self) -> Iterator[Moment]:
        schedule = self.schedule
        durations = np.diff(schedule.time, prepend=-self.time_step)
        for drive, duration, at_rest in zip(
            schedule.drive, durations, schedule.at_rest, strict=True
        ):
            yield Moment(float(drive), float(duration), bool(at_rest))

    def _step(self, index: int, equilibrium: Equilibrium, state: State, margin: float) -> Step:
        solution, shape = equilibrium.solution, self.bodies.kernel.shape
        element, bonds, energy = equilibrium.state, state.bonds, state.energy
        touching = _TOUCHES.take(element)
        return Step(
            index=index,
            time=float(self.schedule.time[index]),
            indentation=equilibrium.indentation,
            contact_force=float(solution.force.sum()),
            drive=float(self.schedule.drive[index]),
            iterations=equilibrium.iterations,
            residual=solution.residual,
            converged=solution.converged,
            stability_margin=margin,
            contacts=int(np.count_nonzero(touching)),
            releases=equilibrium.releases,
            drive_work=energy.drive,
            spring_energy=energy.springs,
            machine_energy=energy.machine,
            layer_work=energy.layer,
            released_energy=energy.released,
            algorithmic_loss=energy.algorithmic,
            element_force=solution.force.reshape(shape).copy(),
            # copies, since the solver goes on with its own
            compression=solution.compression.reshape(shape).copy(),
            displacement=equilibrium.displacement.reshape(shape).copy(),
            contact_area=self._contact_area(bonds, touching).reshape(shape),
            age=bonds.age.reshape(shape).astype(np.float32),
            state=element.reshape(shape),
            stop_reason=self._watch.reason_to_stop(index, equilibrium, energy),
        )

    def _contact_area(self, bonds: Bonds, touching: np.ndarray) -> np.ndarray:
        """Area of each contact [m2]: an adhering one keeps its largest."""
        held = np.maximum(bonds.compression, 0.0)
        np.copyto(held, bonds.reach, where=bonds.bonded)
        radius = self.springs.radius(held)
        radius *= radius
        area: np.ndarray = np.multiply(radius, np.pi * touching, dtype=np.float32)
        return area
