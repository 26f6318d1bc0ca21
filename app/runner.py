"""One run on a thread of its own: one object, one end. It knows no screen.

The thread writes, everybody else reads: rows of `record` up to `record.count`, `baseline`, and
`phase`, which is written last when a run ends.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

from tyrecontact import Results, Scenario, Simulation
from tyrecontact.errors import TyreContactError
from tyrecontact.results import STOPPED, Record

from .baseline import Baseline
from .computation import Computation
from .gate import Gate
from .limits import Limits
from .pace import Pace
from .phase import Phase
from .slots import Slots

__all__ = ["Baseline", "Phase", "Run"]


class Run:
    """A scenario being run on a thread.

    Parameters
    ----------
    scenario : is copied.
    duration : least wall-clock time of the whole run [s], so that it can be watched; 0 is as
        fast as possible.
    after : a run that this one supersedes: it is stopped, and waited for, which takes no longer
        than a step, or a part of its preparation; what it has made is used again.
    paused : it pauses before its first step.
    baseline_first : the baseline comes before the first step; otherwise after the last one, in
        the phase COMPARING, unless it is there already. A run that is stopped has none then.
    limits : what it may take.  slots : the queue of all runs; none: it waits for nobody.

    Attributes
    ----------
    phase : where the run stands.
    simulation, record, baseline : None until they are made; `record` grows while running.
    message : why the run was refused or failed or had to end early, or empty.

    Raises
    ------
    InputError : a duration that is no time.
    """

    def __init__(
        self,
        scenario: Scenario,
        duration: float = 0.0,
        after: Run | None = None,
        *,
        paused: bool = False,
        baseline_first: bool = True,
        limits: Limits | None = None,
        slots: Slots | None = None,
    ) -> None:
        self.scenario = scenario.copy()
        self.phase = Phase.WAITING
        self.message = ""
        self._after, self._baseline_first = after, baseline_first
        self._limits = limits or Limits()
        self._pace = Pace(duration)
        self._gate = Gate(self._say, self._pace, slots or Slots(), self._limits.seconds, paused)
        self._computation = Computation(self.scenario, self._gate, self._pace, self._limits)
        self._at_end: list[Callable[[], None]] = []
        self._thread = threading.Thread(target=self._work, name="tyrecontact-run", daemon=True)

    @property
    def simulation(self) -> Simulation | None:
        return self._computation.simulation

    @property
    def record(self) -> Record | None:
        return self._computation.record

    @property
    def baseline(self) -> Baseline | None:
        return self._computation.baseline

    @property
    def duration(self) -> float:
        """Least wall-clock time of the whole run [s]; a change holds from the next step on."""
        return self._pace.duration

    @duration.setter
    def duration(self, seconds: float) -> None:
        self._pace.duration = seconds
        self._gate.wake()

    @property
    def stopping(self) -> bool:
        """Asked to end, and not at its end yet."""
        return self._gate.stopped and not self.phase.ended

    @property
    def paused(self) -> bool:
        """Asked to pause, with steps to come; `phase` is PAUSED as soon as it does."""
        return self._gate.paused and not (self.phase.ended or self.phase is Phase.COMPARING)

    @property
    def place(self) -> int:
        """Place in the queue, 1 for the next one; 0 for a run that is not in it."""
        return self._gate.place

    @property
    def progress(self) -> float:
        """Share of the steps that are done, from 0 to 1."""
        record, simulation = self.record, self.simulation
        return 0.0 if record is None or simulation is None else record.count / len(simulation)

    @property
    def time_left(self) -> float | None:
        """How long the other steps will take [s]; None while that cannot be said, or paused."""
        if self.phase is not Phase.RUNNING or self.record is None:
            return None
        return self._pace.time_left(self.record.count)

    def start(self) -> None:
        """Begin, once; a run that this one supersedes is stopped, and hands its place on."""
        if self._thread.ident is not None:
            raise RuntimeError("a run starts only once")
        after = self._after
        self._gate.queue(None if after is None else after._gate)
        if after is not None:
            after.stop()
        try:
            self._thread.start()
        except RuntimeError:  # there are no more threads
            self._gate.leave()
            raise

    def stop(self) -> None:
        """Ask the run to end; it does so before its next step and keeps what it has."""
        self._gate.stop()

    def pause(self) -> None:
        """Ask the run to pause before its next step."""
        self._gate.pause()

    def resume(self) -> None:
        """Let the run go on, at its pace: the time of the pause is not made up."""
        self._gate.resume()

    def step(self) -> None:
        """Let a run that pauses, or is to pause, take one more step; others take no notice."""
        self._gate.step()

    def join(self, timeout: float | None = None) -> bool:
        """Wait for the end; True if it has come."""
        self._thread.join(timeout)
        return not self._thread.is_alive()

    def results(self) -> Results | None:
        """What has been computed so far, or None if nothing has."""
        if self.simulation is None or self.record is None or self.record.count == 0:
            return None
        phase, count, total = self.phase, self.record.count, len(self.simulation)
        so_far = f"stopped for now, {count} of {total} steps" if count < total else ""
        reason = {Phase.STOPPED: self.message or STOPPED, Phase.FAILED: self.message}
        return self.simulation.collect(
            self.record, reason.get(phase, self.record.stop_reason or so_far)
        )

    def _say(self, phase: Phase) -> None:
        self.phase = phase

    def _work(self) -> None:
        try:
            end = self._go()
        except (TyreContactError, MemoryError) as error:
            end = self._failed(str(error) or "not enough memory for this run")
        except BaseException as error:
            end = self._failed(f"an error that should not be, {error!r}")
            raise
        finally:
            self._gate.leave()
            self.phase = end
            for tell in list(self._at_end):
                tell()
            self._at_end.clear()  # a run that is kept keeps no other alive

    def _go(self) -> Phase:
        """From the first wait to the last step; how it ended."""
        if not (self._succeeds() and self._gate.admits()):
            return Phase.STOPPED
        self.phase = Phase.PREPARING
        if self._computation.prepare(self._baseline_first) and self._computation.solve():
            self._compare()
            return Phase.FINISHED
        if not self._gate.stopped:
            seconds = self._limits.seconds
            self.message = f"stopped after {seconds:g} s, the longest that this server computes"
        return Phase.STOPPED

    def _failed(self, message: str) -> Phase:
        self.message = message
        begun = self.record is not None and self.record.count > 0
        return Phase.FAILED if begun else Phase.REFUSED

    def _succeeds(self) -> bool:
        """Wait for the run that this one supersedes, and for those that it had to wait for."""
        while self._after is not None:
            before = self._after
            if not before._is_over():
                before._at_end.append(self._gate.wake)
            if not self._gate.wait_for(before._is_over):
                return False
            self._computation.made = self._computation.made or before._computation.made
            self._after = before._after
        return True

    def _is_over(self) -> bool:
        """Whether it has ended, or never began."""
        return self.phase.ended or self._thread.ident is None

    def _compare(self) -> None:
        """Make the baseline where it is still missing; all steps are there, with or without."""
        if self.baseline is not None or self._gate.is_closed:
            return
        self.phase = Phase.COMPARING
        try:
            self._computation.compare()
        except (TyreContactError, MemoryError) as error:
            self.message = f"no quasi-static run to compare with: {error}"
