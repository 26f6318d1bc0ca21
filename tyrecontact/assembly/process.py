"""From settings to what is done to road and tread: the path, the machine, the adhesion law."""

from __future__ import annotations

import numpy as np

from tyrecontact import loading
from tyrecontact.contact.adhesion import (
    Hysteresis,
    Law,
    Multiplicative,
    ReleaseForce,
    table_limits,
)
from tyrecontact.contact.kinetics import BondKinetics, RecedingContact
from tyrecontact.contact.machine import Machine
from tyrecontact.errors import InputError
from tyrecontact.parts.process import Adhesion, Loading
from tyrecontact.road.springs import Springs


def loading_path(settings: Loading) -> loading.Path:
    """The path of the drive that the settings of the loading stand for.

    Raises
    ------
    InputError : a table that cannot be used, a profile that a force cannot follow, or one that
        never presses.
    """
    path = _path(settings)
    if not path.drive.max() > 0:
        unit = "N" if settings.drive == "force" else "m"
        raise InputError(
            f"loading must reach contact, got a profile of at most {path.drive.max():g} {unit}"
        )
    return path


def _path(settings: Loading) -> loading.Path:
    forced = settings.drive == "force"
    largest = settings.max_force if forced else settings.max_indentation
    rate = settings.force_rate if forced else settings.rate
    back = settings.pull if forced else settings.retraction
    if settings.profile == "table":
        if not settings.table:
            raise InputError("loading.table must name a file for the profile table, got none")
        return loading.read_table(settings.table)
    if settings.profile == "linear":
        return loading.linear(largest, rate)
    if settings.profile == "sinusoidal":
        # a force that begins by pulling would only make the mass fly off
        return loading.sinusoidal(largest, -back, settings.period, first=0.0 if forced else None)
    if settings.profile == "quadratic":
        if forced:
            raise InputError(
                "loading.profile must be linear, load-hold-unload, sinusoidal or table for a "
                "force, got quadratic"
            )
        return loading.quadratic(largest, settings.acceleration)
    unloading = settings.unloading_force_rate if forced else settings.unloading_rate
    return loading.load_hold_unload(largest, rate, settings.hold_time, unloading, back)


def machine(settings: Loading) -> Machine:
    """What moves the road.

    Raises
    ------
    InputError : a force-driven road without a mass.
    """
    if settings.drive == "rigid":
        return Machine()
    if settings.drive == "machine":
        return Machine(settings.machine_stiffness, settings.mass)
    return Machine(0.0, settings.mass)


def adhesion_law(settings: Adhesion, springs: Springs) -> Law:
    """What holds road and tread together."""
    if settings.law == "multiplicative":
        return Multiplicative(
            settings.release_force,
            settings.area_exponent,
            settings.reference_area,
            settings.ageing,
            settings.ageing_time,
            settings.reference_rate or np.inf,
            settings.rate_exponent,
        )
    if settings.law == "bonds":
        return BondKinetics(settings.binding_rate, settings.unbinding_rate, settings.bond_stress)
    if settings.law == "receding-contact":
        return RecedingContact(
            settings.work_of_adhesion,
            settings.ageing,
            settings.ageing_time,
            settings.crack_speed,
            settings.crack_exponent,
        )
    if settings.law == "hysteresis":
        return Hysteresis(settings.release_force)
    if settings.table_step > 0 and settings.release_force > 0:
        return ReleaseForce(table_limits(springs, settings.release_force, settings.table_step))
    return ReleaseForce(settings.release_force)
