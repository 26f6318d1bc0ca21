"""Settings of what is done to road and tread: loading, adhesion, and how it is computed."""

from __future__ import annotations

from tyrecontact.settings import Choice, Count, Part, Quantity, Text

_UM, _MM, _MS = ("µm", 1e6), ("mm", 1e3), ("ms", 1e3)
_RATE, _FORCE_RATE = ("mm/s", 1e3), ("N/ms", 1e-3)


class Loading(Part):
    """How the road is moved into the tread (thesis, chapters 4.3 and 5.1)."""

    drive = Choice(
        "rigid",
        ["rigid", "machine", "force"],
        "The profile is the indentation; the far end of the machine's spring; or a force on a mass",
    )
    profile = Choice(
        "linear",
        ["linear", "quadratic", "load-hold-unload", "sinusoidal", "table"],
        "Indentation, or force, against time",
    )
    table = Text("", "Text file of the user's own profile: time [s], indentation [m] or force [N]")
    max_indentation = Quantity(0.2e-3, (1e-6, 2e-3), "m", "Largest indentation", _MM)
    rate = Quantity(0.03, (1e-4, 10.0), "m/s", "Rate of loading (linear, load-hold-unload)", _RATE)
    acceleration = Quantity(9.0, (1e-3, 1e5), "m/s²", "Acceleration (quadratic); 2 C of the thesis")
    period = Quantity(20e-3, (1e-5, 10.0), "s", "Period (sinusoidal)", _MS)
    hold_time = Quantity(2e-3, (0.0, 1e6), "s", "Time at the largest indentation or force", _MS)
    unloading_rate = Quantity(0.003, (1e-5, 10.0), "m/s", "Rate of unloading", _RATE)
    retraction = Quantity(
        0.2e-3, (0.0, 2e-3), "m", "How far above first contact the road ends after unloading", _MM
    )
    machine_stiffness = Quantity(
        1e6, (1e2, 1e12), "N/m", "Spring through which a machine moves the road", ("MN/m", 1e-6)
    )
    mass = Quantity(0.0, (0.0, 1e3), "kg", "Mass of the road and what moves with it")
    max_force = Quantity(100.0, (1e-3, 1e5), "N", "Largest force (force-driven)")
    force_rate = Quantity(3e4, (1.0, 1e8), "N/s", "Rate of loading (force-driven)", _FORCE_RATE)
    unloading_force_rate = Quantity(
        750.0, (1e-3, 1e8), "N/s", "Rate of unloading (force-driven)", _FORCE_RATE
    )
    pull = Quantity(50.0, (0.0, 1e5), "N", "Force at which unloading ends, pulling (force-driven)")


class Adhesion(Part):
    """What holds road and tread together (thesis, chapter 5)."""

    law = Choice(
        "release-force",
        ["release-force", "multiplicative", "bonds", "receding-contact", "hysteresis"],
        "When, and how, an element lets go",
    )
    release_force = Quantity(
        0.6, (0.0, 100.0), "N", "Tension at which an element lets go; 0: no adhesion"
    )
    table_step = Quantity(
        0.0,
        (0.0, 1e-4),
        "m",
        "Step of the thesis' table, which lets go one entry early; 0: exact",
        _UM,
    )
    area_exponent = Quantity(
        0.6, (0.0, 2.0), "", "Growth of the release force with the largest area (multiplicative)"
    )
    reference_area = Quantity(
        1e-6, (1e-12, 1e-3), "m²",
        "Area at which that factor is one (multiplicative): an element of 1 mm", ("mm²", 1e6),
    )  # fmt: skip
    ageing = Quantity(
        0.08, (0.0, 10.0), "", "Growth with the log of contact age (multiplicative, receding)"
    )
    ageing_time = Quantity(1e-3, (1e-9, 1e6), "s", "Age from which on it grows", _MS)
    rate_exponent = Quantity(
        0.3, (0.0, 2.0), "", "Growth of the release force with the rate (multiplicative)"
    )
    reference_rate = Quantity(
        1e-3, (0.0, 10.0), "m/s", "Rate at which it has doubled; 0: the rate does not matter", _RATE
    )
    bond_stress = Quantity(
        0.05e6, (1.0, 1e9), "Pa", "Stress that speeds breaking e times (bonds)", ("MPa", 1e-6)
    )
    binding_rate = Quantity(10.0, (0.0, 1e6), "1/s", "Rate at which bonds form (bonds)")
    unbinding_rate = Quantity(0.5, (0.0, 1e6), "1/s", "Rate at which unloaded bonds break (bonds)")
    work_of_adhesion = Quantity(
        0.05, (0.0, 100.0), "J/m²", "At rest and young (receding contact); 0: no adhesion"
    )
    crack_exponent = Quantity(
        0.55, (0.1, 2.0), "", "Gent and Schultz' exponent n (receding contact)"
    )
    crack_speed = Quantity(
        1e-6, (1e-12, 1e6), "m/s", "Speed v* at twice the work of adhesion", ("µm/s", 1e6)
    )


class Numerics(Part):
    """How it is computed."""

    kernel = Choice(
        "passive",
        ["passive", "passive-mobility", "band-limited", "static"],
        "Element kernel: passive is stable; passive-mobility too, but 16 % off at rest; "
        "band-limited is the thesis'; static is quasi-static",
    )
    quadrature = Choice("BDF2", ["BDF1", "BDF2"], "Convolution quadrature of the passive kernel")
    refinement = Choice(
        "interpolated",
        ["interpolated", "recomputed"],
        "Band-limited kernel at a finer step: interpolated as in the thesis, or computed anew",
    )
    statics = Choice(
        "exact",
        ["exact", "band-limited"],
        "Of the static kernel: the tread's own, or of the band-limited kernel, as in the thesis",
    )
    solver = Choice("robust", ["robust", "thesis"], "Newton's method: guarded, or the thesis' own")
    jacobian = Choice(
        "exact", ["exact", "as-printed"], "Of the thesis' solver; as printed it diverges (Eq. 8)"
    )
    time_resolution_factor = Count(1, (1, 16), "How many times finer than the sampling frequency")
    sampling_frequency = Quantity(51200.0, (10.0, 1e7), "Hz", "Sampling frequency", ("kHz", 1e-3))
    lags = Count(256, (2, 65536), "Lags of the kernel at the sampling frequency", "samples")
    tolerance = Quantity(
        1e-10,
        (1e-13, 1e-3),
        "",
        "Largest residual, per largest indentation (for a force: max_indentation)",
        ("1e-10", 1e10),
    )
    max_iterations = Count(50, (1, 1000), "Newton iterations allowed in a step; 10 in the thesis")
    initial_guess = Choice(
        "extrapolated",
        ["extrapolated", "last"],
        "First guess: from the last two steps (robust: three), or the last",
    )
    margin_interval = Count(
        1, (1, 100_000), "From one stability margin to the next; each takes a third of a step",
        "steps",
    )  # fmt: skip
    long_holds = Choice(
        "quasi-static",
        ["quasi-static", "stepped"],
        "A hold that outlasts the kernel's memory: at rest in growing steps, or step by step",
    )
    field_memory = Quantity(
        50e6, (0.0, 4e9), "B",
        "For maps of the elements: full, every second one goes; the first and the last always stay",
        ("MB", 1e-6),
    )  # fmt: skip
