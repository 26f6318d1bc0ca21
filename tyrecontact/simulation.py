"""The way from question to answer: one loop over time, which everything iterates."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property, lru_cache

import numpy as np

from tyrecontact import loading
from tyrecontact.contact import newton
from tyrecontact.contact.adhesion import ElementState, ReleaseForce
from tyrecontact.contact.equilibrium import Bodies, Equilibrium, Solver, State, advance
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.errors import InputError
from tyrecontact.results import Record, Results, Step
from tyrecontact.road import heights, scans, springs, textures
from tyrecontact.road.heights import Patch
from tyrecontact.scenario import Loading, Numerics, Road, Scenario, Tread
from tyrecontact.tread import cache, kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss


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
        path = _loading_path(self.scenario.loading)
        self.time, self.indentation = path.sampled(self.time_step)

    def __len__(self) -> int:
        return len(self.time)

    def __iter__(self) -> Iterator[Step]:
        bodies, solver = self.bodies, self.solver
        state = State.at_rest(bodies)
        for index, indentation in enumerate(self.indentation):
            equilibrium = advance(bodies, solver, state, float(indentation))
            step = self._step(index, equilibrium)
            yield step
            if step.stop_reason:
                return

    def run(self) -> Results:
        """Run to the end. Ctrl-C ends the run and keeps what was computed."""
        record = Record(len(self), self.bodies.kernel.shape)
        reason = ""
        try:
            for step in self:
                record.append(step)
        except KeyboardInterrupt:
            reason = "stopped by the user"
        return self.collect(record, reason)

    def quasi_static(self, steps: int) -> Simulation:
        """The same path with the tread at rest in every step, robustly solved.

        Of this simulation's steps about `steps` are kept, equally spaced along the path of the
        road; time has no meaning for the tread at rest.
        """
        still = self.scenario.copy()
        still.numerics.param.update(
            kernel="static", solver="robust", initial_guess="last", tolerance=1e-7,
            max_iterations=100,
        )  # fmt: skip
        other = Simulation(still)
        travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(self.indentation)))])
        marks = np.linspace(0, travelled[-1], steps)
        kept = np.unique(np.append(np.searchsorted(travelled, marks * (1 - 1e-12)), len(self) - 1))
        other.time, other.indentation = self.time[kept], self.indentation[kept]
        other.patch, other.springs = self.patch, self.springs
        return other

    def collect(self, record: Record, stop_reason: str = "") -> Results:
        """Results of the steps that a consumer of the loop has recorded."""
        return record.results(self.scenario, self.kernel.spacing, stop_reason)

    @cached_property
    def patch(self) -> Patch:
        """The road under the patch, at full resolution."""
        return road_patch(self.scenario.road)

    @cached_property
    def springs(self) -> springs.Springs:
        """Roughness springs, after the exchange; element (row, column) is row x nx + column."""
        settings, road = self.scenario.springs, self.scenario.road
        blocks = heights.element_heights(self.patch, road.elements).reshape(road.elements**2, -1)
        original = springs.from_heights(blocks, self.patch.pitch, settings.youngs_modulus)
        return springs.exchange_stiffest(
            original, settings.exchange_count, settings.exchange_compression
        )

    @cached_property
    def kernel(self) -> Kernel:
        """Element kernel of the tread."""
        road = self.scenario.road
        shape = (road.elements, road.elements)
        return tread_kernel(
            self.scenario.tread, self.scenario.numerics, shape, road.size / road.elements
        )

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
        step = Step(
            index=index,
            time=float(self.time[index]),
            indentation=float(self.indentation[index]),
            contact_force=float(solution.force.sum()),
            iterations=equilibrium.iterations,
            residual=solution.residual,
            converged=solution.converged,
            contacts=int(touching.sum()),
            releases=equilibrium.releases,
            element_force=solution.force.reshape(shape),
            compression=solution.compression.reshape(shape),
            displacement=equilibrium.displacement.reshape(shape),
            state=state.reshape(shape),
        )
        return replace(step, stop_reason=self._reason_to_stop(step))

    def _reason_to_stop(self, step: Step) -> str:
        """Why a run must not go on after this step, or nothing."""
        thickness = self.scenario.tread.thickness
        if np.abs(step.displacement).max() > thickness:
            return (
                f"diverged at step {step.index}: the tread is displaced by more than "
                f"its thickness of {thickness * 1e3:.3g} mm"
            )
        if self.scenario.numerics.solver == "robust" and not step.converged:
            return (
                f"not converged at step {step.index} after {step.iterations} iterations: "
                f"residual {step.residual:.2g} m; try a finer time_resolution_factor, more "
                "max_iterations, or the passive kernel"
            )
        return ""


def road_patch(road: Road) -> Patch:
    """The patch of road that a scenario asks for, cut to its size."""
    if road.file:
        found = scans.read(road.file, pitch=road.pitch or None, unit=road.height_unit or None)
        return heights.centred(found, road.elements, road.size)
    made = _made_road(
        road.size,
        road.pixel,
        road.valley_rms,
        road.plateau_rms,
        road.valley_offset,
        road.stone_size,
        road.plateau_wavelength,
        road.hurst,
        road.seed,
    )
    return heights.centred(made, road.elements, road.size)


@lru_cache(maxsize=4)
def _made_road(
    size: float,
    pitch: float,
    valley_rms: float,
    plateau_rms: float,
    offset: float,
    stone_size: float,
    plateau_wavelength: float,
    hurst: float,
    seed: int,
) -> Patch:
    """`textures.worn`, kept: the same few roads are asked for again and again."""
    patch = textures.worn(
        size,
        pitch,
        valley_rms=valley_rms,
        plateau_rms=plateau_rms,
        offset=offset,
        stone_size=stone_size,
        plateau_wavelength=plateau_wavelength,
        hurst=hurst,
        seed=seed,
    )
    patch.heights.flags.writeable = False
    return patch


def tread_kernel(
    tread: Tread, numerics: Numerics, shape: tuple[int, int], spacing: float
) -> Kernel:
    """The kernel that a scenario asks for; kernels in time come from the cache on disk.

    At a finer time resolution the passive kernel is recomputed with as many more lags; the
    band-limited one is interpolated, as in the thesis.
    """
    layers = tread_layers(tread)
    factor, step = numerics.time_resolution_factor, 1 / numerics.sampling_frequency
    if numerics.kernel == "static":
        return cache.static(layers, shape, spacing)
    if numerics.kernel == "passive":
        return cache.passive(layers, shape, spacing, step / factor, numerics.lags * factor)
    coarse = cache.band_limited(layers, shape, spacing, step, numerics.lags)
    return kernels.interpolated(coarse, factor)


def tread_layers(tread: Tread) -> list[Layer]:
    """The layers of a tread, from the top down."""
    rubber = FractionalKelvinVoigt(tread.static_modulus, tread.relaxation_time, tread.exponent)
    base = NearlyConstantLoss(tread.base_modulus, tread.base_loss_factor)
    return [
        Layer(tread.thickness, tread.density, rubber, tread.poissons_ratio),
        Layer(tread.base_thickness, tread.base_density, base, tread.base_poissons_ratio),
    ]


def _loading_path(settings: Loading) -> loading.Path:
    if settings.profile == "linear":
        return loading.linear(settings.max_indentation, settings.rate)
    if settings.profile == "quadratic":
        return loading.quadratic(settings.max_indentation, settings.acceleration)
    if settings.profile == "load-hold-unload":
        return loading.load_hold_unload(
            settings.max_indentation,
            settings.rate,
            settings.hold_time,
            settings.unloading_rate,
            settings.retraction,
        )
    raise InputError(f"loading.profile must be a known one, got {settings.profile!r}")
