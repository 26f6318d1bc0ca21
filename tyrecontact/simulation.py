"""The way from question to answer: one loop over time, which everything iterates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cached_property

import numpy as np

from tyrecontact import assembly
from tyrecontact.contact import newton
from tyrecontact.contact.adhesion import ElementState, ReleaseForce
from tyrecontact.contact.equilibrium import Bodies, Equilibrium, Solver, State, advance
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.results import STOPPED, Record, Results, Step
from tyrecontact.road import heights
from tyrecontact.road.heights import Patch
from tyrecontact.road.springs import Springs
from tyrecontact.scenario import Scenario
from tyrecontact.tread.kernels import Kernel


class Simulation:
    """A scenario made ready to run.

    Iterating yields a `Step` for each time step and starts from rest every time; `len` is the
    number of steps of a complete run. To cancel is to stop asking.

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
        numerics = self.scenario.numerics
        self.time_step = 1 / (numerics.sampling_frequency * numerics.time_resolution_factor)
        assembly.require_consistent(self.scenario)
        path = assembly.loading_path(self.scenario.loading)
        self.time, self.indentation = path.sampled(self.time_step)

    def __len__(self) -> int:
        return len(self.time)

    def __iter__(self) -> Iterator[Step]:
        bodies, solver = self.bodies, self.solver
        state = State.at_rest(bodies)
        for index, indentation in enumerate(self.indentation):
            equilibrium = advance(bodies, solver, state, float(indentation))
            step = self._step(index, equilibrium)
            step = replace(step, stop_reason=self._reason_to_stop(step, state))
            yield step
            if step.stop_reason:
                return

    def run(self, progress: Callable[[Iterable[Step]], Iterable[Step]] = iter) -> Results:
        """Run to the end. Ctrl-C ends the run and keeps what was computed.

        `progress` wraps the loop, as `tqdm` does.
        """
        record = Record(len(self), self.bodies.kernel.shape)
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
        travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(self.indentation)))])
        marks = np.linspace(0, travelled[-1], steps)
        spaced = np.searchsorted(travelled, marks * (1 - 1e-12))
        turns = np.flatnonzero(np.diff(np.sign(np.diff(self.indentation)))) + 1
        kept = np.unique(np.concatenate([spaced, turns, [len(self) - 1]]))
        other.time, other.indentation = self.time[kept], self.indentation[kept]
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
        return assembly.roughness_springs(self.patch, self.scenario)

    @cached_property
    def kernel(self) -> Kernel:
        """Element kernel of the tread."""
        return assembly.tread_kernel(self.scenario)

    @cached_property
    def bodies(self) -> Bodies:
        """Road and tread, ready for the solver."""
        tops = heights.element_tops(self.patch, self.scenario.road.elements).ravel()
        law = ReleaseForce(self.scenario.adhesion.release_force)
        return Bodies(LatticeKernel(self.kernel), self.springs, law, tops - tops.max())

    @cached_property
    def solver(self) -> Solver:
        """How each step is solved."""
        numerics = self.scenario.numerics
        return Solver(
            method=newton.robust if numerics.solver == "robust" else newton.thesis,
            tolerance=numerics.tolerance * self.scenario.loading.max_indentation,
            max_iterations=numerics.max_iterations,
            extrapolates=numerics.initial_guess == "extrapolated",
        )

    def _step(self, index: int, equilibrium: Equilibrium) -> Step:
        solution, shape = equilibrium.solution, self.bodies.kernel.shape
        state = equilibrium.state
        touching = (state == ElementState.COMPRESSED) | (state == ElementState.TENSION)
        return Step(
            index=index,
            time=float(self.time[index]),
            indentation=float(self.indentation[index]),
            contact_force=float(solution.force.sum()),
            iterations=equilibrium.iterations,
            residual=solution.residual,
            converged=solution.converged,
            contacts=int(touching.sum()),
            releases=equilibrium.releases,
            element_force=solution.force.reshape(shape).copy(),
            # copies, since the solver goes on with its own
            compression=solution.compression.reshape(shape).copy(),
            displacement=equilibrium.displacement.reshape(shape).copy(),
            state=state.reshape(shape),
        )

    def _reason_to_stop(self, step: Step, state: State) -> str:
        """Why a run must not go on after this step, or nothing."""
        limit = self.scenario.tread.thickness  # more than that is no solution of anything
        if not np.abs(step.displacement).max() <= limit:
            return (
                f"diverged at step {step.index}: the tread is displaced by more than "
                f"its thickness of {limit * 1e3:.3g} mm"
            )
        if self.scenario.numerics.solver == "thesis":
            return ""  # it goes on, whatever comes: that is what it is there to show
        if state.creates_energy:
            return (
                f"unstable at step {step.index}: the tread has given back more energy than it was "
                f"given, which no tread can; try {self._advice()}"
            )
        if not step.converged:
            return (
                f"not converged at step {step.index} after {step.iterations} iterations: "
                f"residual {step.residual:.2g} m; try {self._advice()}"
            )
        return ""

    def _advice(self) -> str:
        if self.scenario.numerics.kernel == "band-limited":
            return "time_resolution_factor 4 or the passive kernel: it is unstable on stiff springs"
        return "a finer time_resolution_factor, a slower loading or more max_iterations"
