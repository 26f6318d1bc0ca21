"""What the thread of a run computes: made ready, solved step by step, and compared."""

from __future__ import annotations

from tyrecontact import Scenario, Simulation
from tyrecontact.results import Record
from tyrecontact.reuse import hand_on

from . import baseline
from .baseline import Baseline
from .gate import Gate
from .limits import Limits
from .pace import Pace


class Computation:
    """A scenario on its way from settings to results; one thread works, others may look on.

    Parameters
    ----------
    gate : what each step passes; where it closes, the work ends.
    pace : is told the number of steps.  limits : what is refused.

    Attributes
    ----------
    simulation, record, baseline : None until they are made; `record` grows.
    made : the simulation as far as it has been made, or one before it: parts are used again.
    """

    def __init__(self, scenario: Scenario, gate: Gate, pace: Pace, limits: Limits) -> None:
        self.simulation: Simulation | None = None
        self.record: Record | None = None
        self.baseline: Baseline | None = None
        self.made: Simulation | None = None
        self._scenario, self._gate, self._pace, self._limits = scenario, gate, pace, limits

    def prepare(self, baseline_first: bool) -> bool:
        """Make what the loop needs; False where the run is to end instead.

        Raises
        ------
        InputError : settings that cannot go together, or that are beyond the limits.
        """
        simulation = Simulation(self._scenario)
        self._limits.check(simulation)
        if self.made is not None:
            hand_on(self.made, simulation)
        self.made = simulation
        for part in ("patch", "springs", "kernel", "bodies", "margin"):
            if self._gate.is_closed:
                return False
            getattr(simulation, part)
        found = baseline.kept(simulation)
        if found is None and baseline_first:
            found = baseline.made(simulation, lambda: self._gate.is_closed)
            if found is None:
                return False
        memory = simulation.scenario.numerics.field_memory
        self.record = Record(len(simulation), simulation.bodies.kernel.shape, memory)
        self.baseline, self.simulation = found, simulation
        return True

    def solve(self) -> bool:
        """The loop; False where the run is to end before its last step."""
        assert self.simulation is not None
        assert self.record is not None
        steps, total = iter(self.simulation), len(self.simulation)
        self._pace.steps = total
        self._gate.goes_on()
        while self._gate.lets_through():
            step = next(steps)
            self.record.append(step)
            if step.stop_reason or self.record.count == total:
                return True
        return False

    def compare(self) -> None:
        """Make the baseline after the last step, unless the run is to end."""
        assert self.simulation is not None
        self.baseline = baseline.made(self.simulation, lambda: self._gate.is_closed)
