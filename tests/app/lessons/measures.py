"""Figures of a run that the lessons' texts give, by name; and every run is made once."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from functools import cache, cached_property
from typing import Any

import numpy as np

from tyrecontact import Results, Scenario, Simulation, presets
from tyrecontact.contact.bonds import ElementState
from tyrecontact.results import Record


def scenario(preset: str, settings: Mapping[str, Any]) -> Scenario:
    """A preset with settings changed."""
    made = presets.get(preset)
    for path, value in settings.items():
        made.set(path, value)
    return made


class Measured:
    """A run and what it is looked at by; each is made when it is asked for."""

    def __init__(self, asked: Scenario) -> None:
        self.scenario = asked

    @cached_property
    def simulation(self) -> Simulation:
        return Simulation(self.scenario)

    @cached_property
    def run(self) -> Results:
        """Until road and tread have parted: what comes after costs time and changes nothing."""
        record = Record(len(self.simulation), self.simulation.bodies.kernel.shape)
        touched = False
        for step in self.simulation:
            record.append(step)
            touched = touched or step.contacts > 0
            if touched and step.contacts == 0:
                break
        return self.simulation.collect(record)

    @cached_property
    def at_rest(self) -> Results:
        """On few steps, and without what does not matter at rest: then runs can share it."""
        still = {"loading.rate": 0.1, "numerics.kernel": "static"}
        return measured("default", still).run

    def fields(self, depth: float) -> dict[str, np.ndarray]:
        """The maps where an indentation [µm] is first reached."""
        step = int(np.argmax(self.run.indentation >= depth * 1e-6 * (1 - 1e-9)))
        return self.run.fields(step)[1]

    @property
    def at_zero(self) -> dict[str, np.ndarray]:
        """The maps where the force first pulls."""
        return self.run.fields(int(np.argmax(self.run.contact_force < 0)))[1]


@cache
def _measured(key: str) -> Measured:
    return Measured(Scenario(**json.loads(key)))


def measured(preset: str, settings: Mapping[str, Any]) -> Measured:
    """The run of a scenario, which lessons share."""
    made = scenario(preset, settings)
    # the margin of every step takes a third of the time; where it may fall, every few will do
    finer = made.numerics.time_resolution_factor
    made.numerics.margin_interval = finer if made.numerics.kernel == "band-limited" else 100
    return _measured(json.dumps(made.to_dict(), sort_keys=True))


def _place(step: int | None, run: Results) -> float:
    return -1.0 if step is None else float(run.indentation[step] * 1e6)


def _force_at(run: Results, depth: float) -> float:
    top = int(run.indentation.argmax()) + 1
    return float(np.interp(depth * 1e-6, run.indentation[:top], run.contact_force[:top]))


def _excess(found: Measured, depth: float) -> float:
    """Force above the one at rest at a depth [µm], in per cent; of the default road and tread."""
    return 100 * (_force_at(found.run, depth) / _force_at(found.at_rest, depth) - 1)


def _self_compliance(found: Measured, _: float) -> float:
    """What an element yields less than in the kernel before interpolation, in per cent."""
    plain = found.scenario.copy()
    plain.numerics.time_resolution_factor = 1
    before = Simulation(plain).kernel.values[:, 0, 0].sum()
    return float(100 * (1 - found.simulation.kernel.values[:, 0, 0].sum() / before))


def _edge_and_middle(found: Measured, depth: float) -> tuple[float, float]:
    force = found.fields(depth)["element_force"]
    inner = force[1:-1, 1:-1]
    edge = (force.sum() - inner.sum()) / (force.size - inner.size)
    return float(edge), float(inner.mean())


def _count(found: Measured, state: ElementState) -> float:
    return float((found.at_zero["state"] == state).sum())


#: name -> figure of a run, at a place where that matters
MEASURES: dict[str, Callable[[Measured, Any], float]] = {
    "failed_at_um": lambda m, _: _place(m.run.failed_at, m.run),
    "unstable_at_um": lambda m, _: _place(m.run.unstable_at, m.run),
    "unconverged_steps": lambda m, _: float((m.run.converged == 0).sum()),
    "iterations_max": lambda m, _: float(m.run.iterations.max()),
    "steps": lambda m, _: float(len(m.run)),
    "force_max_N": lambda m, _: float(m.run.contact_force.max()),
    "force_at_um_N": lambda m, depth: _force_at(m.run, depth),
    "force_jump_N": lambda m, _: float(np.abs(np.diff(m.run.contact_force)).max()),
    "contacts_jump": lambda m, _: float(np.abs(np.diff(m.run.contacts)).max()),
    "contacts_max": lambda m, _: float(m.run.contacts.max()),
    "excess_at_um_percent": _excess,
    "self_compliance_loss_percent": _self_compliance,
    "tread_energy_least_mJ": lambda m, _: float(m.run.layer_work.min() * 1e3),
    "adherence_N": lambda m, _: float(m.run.adherence_force or 0.0),
    "drive_work_mJ": lambda m, _: m.run.energy["drive_work"] * 1e3,
    "released_mJ": lambda m, _: m.run.energy["released_energy"] * 1e3,
    "tread_mJ": lambda m, _: m.run.energy["layer_work"] * 1e3,
    "machine_mJ": lambda m, _: float(m.run.machine_energy.max() * 1e3),
    "released_bonds": lambda m, _: float(m.run.releases.sum()),
    "largest_event": lambda m, _: float(m.run.largest_avalanche),
    "final_stiffness_MN_per_m": lambda m, _: float((m.run.final_stiffness or 0.0) / 1e6),
    "pulling_at_zero": lambda m, _: _count(m, ElementState.TENSION),
    "pressing_at_zero": lambda m, _: _count(m, ElementState.COMPRESSED),
    "contacts_at_um": lambda m, d: float((m.fields(d)["state"] != ElementState.APART).sum()),
    "area_at_um_mm2": lambda m, d: float(m.fields(d)["contact_area"].sum() * 1e6),
    "edge_force_N": lambda m, d: _edge_and_middle(m, d)[0],
    "middle_force_N": lambda m, d: _edge_and_middle(m, d)[1],
}
