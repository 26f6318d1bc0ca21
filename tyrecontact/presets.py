"""Ready-made scenarios; each is a function whose docstring is its caption and source.

The figures of the thesis (figures.py) are presets too: "fig-44" is the main member of that
figure's family, "fig-44/14-N" another one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from tyrecontact import figures
from tyrecontact.errors import unknown_name
from tyrecontact.figures.base import TABLE_STEP
from tyrecontact.scenario import Scenario


def default() -> Scenario:
    """Thesis defaults with the passive kernel: a ramp to 0.2 mm at 30 mm/s, stable throughout."""
    return Scenario()


def thesis_instability() -> Scenario:
    """The thesis' dynamic run that blows up (Fig. 19): band-limited kernel, plain Newton."""
    return figures.dynamic()


def thesis_factor_2() -> Scenario:
    """The first cure of the thesis, half the time step by interpolation (Fig. 27)."""
    return figures.dynamic(2)


def thesis_factor_4() -> Scenario:
    """A quarter of the time step by interpolation: the thesis' run to 0.2 mm (Fig. 27)."""
    return figures.dynamic(4)


def thesis_exchange() -> Scenario:
    """The thesis' second cure, the 80 stiffest springs exchanged (Fig. 27): it reaches further."""
    scenario = thesis_instability()
    scenario.springs.exchange_count = 80
    return scenario


def quasi_static() -> Scenario:
    """The tread at rest in every step (Fig. 18): what all dynamic runs are compared with."""
    return Scenario(numerics={"kernel": "static"})


def adhesion() -> Scenario:
    """Pressed in by 0.063 mm, held, and pulled off a sticky road (after Figs. 42 and 43)."""
    return Scenario(
        loading={
            "profile": "load-hold-unload",
            "max_indentation": 63e-6,
            "hold_time": 2e-3,
            "unloading_rate": 1e-2,
            "retraction": 0.12e-3,
        },
        # the thesis' table lets go early (Appendix C.4)
        adhesion={"table_step": TABLE_STEP},
    )


def road_iso_10844() -> Scenario:
    """A road like the test track of ISO 10844, illustrative: mean profile depth about 0.5 mm."""
    return _worn_road(6e-3, 0.8e-3, -0.1e-3, 30e-6, 12e-3)


def road_sma_11() -> Scenario:
    """A road like stone mastic asphalt SMA 11, illustrative: mean profile depth about 1 mm."""
    return _worn_road(11e-3, 1.4e-3, -0.4e-3, 50e-6, 16e-3)


def road_dac_16() -> Scenario:
    """A road like dense asphalt concrete DAC 16, illustrative: mean profile depth about 0.9 mm."""
    return _worn_road(14e-3, 1.0e-3, -0.45e-3, 80e-6, 16e-3)


def _worn_road(
    stone_size: float,
    valley_rms: float,
    valley_offset: float,
    plateau_rms: float,
    plateau_wavelength: float,
) -> Scenario:
    """A worn road of that texture [m]; its mean profile depth is that of far more than a patch.

    ISO 13473-1 needs 100 mm of road; the patch of 20 mm holds a few stones, so seeds differ much.
    """
    return Scenario(
        road={
            "texture": "worn",
            "stone_size": stone_size,
            "valley_rms": valley_rms,
            "valley_offset": valley_offset,
            "plateau_rms": plateau_rms,
            "plateau_wavelength": plateau_wavelength,
            "polish": 0.0,
            "hurst": 0.8,
        }
    )


PRESETS: Mapping[str, Callable[[], Scenario]] = MappingProxyType(
    {
        "default": default,
        "thesis-instability": thesis_instability,
        "thesis-factor-2": thesis_factor_2,
        "thesis-factor-4": thesis_factor_4,
        "thesis-exchange": thesis_exchange,
        "quasi-static": quasi_static,
        "adhesion": adhesion,
        "road-iso-10844": road_iso_10844,
        "road-sma-11": road_sma_11,
        "road-dac-16": road_dac_16,
    }
)

#: preset -> the thesis' figure whose run it is, or is like
_FIGURES = {
    "thesis-instability": "fig-19",
    "thesis-factor-2": "fig-27-29",
    "thesis-factor-4": "fig-27-29",
    "thesis-exchange": "fig-27-29",
    "quasi-static": "fig-18",
    "adhesion": "fig-43",
}


def names() -> list[str]:
    """Names of all presets, in the order in which they tell the story; one for each figure.

    What the thesis lacks ("cause") can be had by its name, but is not listed.
    """
    return [*PRESETS, *(name for name, found in figures.FIGURES.items() if found.numbers)]


def members(name: str) -> list[str]:
    """Names of all members of a figure, which are presets as well; none for other presets."""
    return list(figures.find(name).members.values()) if name in figures.FIGURES else []


def get(name: str) -> Scenario:
    """A new scenario of a preset.

    Raises
    ------
    InputError : no preset has that name; the nearest is offered.
    """
    if _is_figure(name):
        return figures.scenario(name)
    return _function(name)()


def caption(name: str) -> str:
    """One line on what a preset shows, and where it is from."""
    if _is_figure(name):
        return figures.find(name.partition("/")[0]).caption
    return (_function(name).__doc__ or "").strip().partition("\n")[0]


def source(name: str) -> str:
    """Where in the thesis: "Fig. 19, chapter 4.1"; empty for what is not from there."""
    if _is_figure(name):
        return figures.find(name.partition("/")[0]).source
    _function(name)
    return figures.find(_FIGURES[name]).source if name in _FIGURES else ""


def _is_figure(name: str) -> bool:
    """Whether a name is meant for a figure: "fig-..." or the name of one."""
    head = name.partition("/")[0] if isinstance(name, str) else ""
    return head.startswith("fig-") or head in figures.FIGURES


def _function(name: str) -> Callable[[], Scenario]:
    if not isinstance(name, str) or name not in PRESETS:
        raise unknown_name("preset", name, names())
    return PRESETS[name]
