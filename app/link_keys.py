"""What settings are called in a link. Links live in slides and e-mails: no key ever changes.

A new setting gets a new key; the key of a setting that has gone is not used again.
"""

from __future__ import annotations

_ROAD = {
    "file": "f", "pitch": "p", "height_unit": "u", "height_direction": "d", "trim_start": "ts",
    "trim_end": "te", "levelling": "l", "fill_limit": "fl", "centre_x": "x", "centre_y": "y",
    "profile_use": "pu", "size": "s", "elements": "n", "texture": "t", "seed": "i", "pixel": "px",
    "clip_height": "ch", "stone_size": "ss", "valley_rms": "vr", "valley_offset": "vo",
    "plateau_rms": "pr", "plateau_wavelength": "pw", "polish": "po", "hurst": "h",
}  # fmt: skip
_SPRINGS = {
    "youngs_modulus": "e", "punch": "p", "reading": "r", "smoothing": "m", "simplification": "s",
    "standard_count": "sc", "linear_compression": "lc", "exchange_count": "x",
    "exchange_compression": "xc", "exchange_ranking": "xr",
}  # fmt: skip
_TREAD = {
    "material": "m", "modulus_table": "f", "static_modulus": "e", "glassy_modulus": "g",
    "exponent": "x", "relaxation_time": "r", "poissons_ratio": "p", "density": "d",
    "thickness": "t", "base_modulus": "be", "base_loss_factor": "bl", "base_poissons_ratio": "bp",
    "base_density": "bd", "base_thickness": "bt", "layers": "l",
}  # fmt: skip
_LOADING = {
    "drive": "d", "profile": "p", "table": "f", "max_indentation": "m", "rate": "r",
    "acceleration": "a", "period": "t", "hold_time": "h", "unloading_rate": "u",
    "retraction": "b", "machine_stiffness": "k", "mass": "w", "max_force": "mf",
    "force_rate": "fr", "unloading_force_rate": "fu", "pull": "fp",
}  # fmt: skip
_ADHESION = {
    "law": "l", "release_force": "f", "table_step": "s", "area_exponent": "ae",
    "reference_area": "ra", "ageing": "a", "ageing_time": "at", "rate_exponent": "re",
    "reference_rate": "rr", "bond_stress": "bs", "binding_rate": "br", "unbinding_rate": "bu",
    "work_of_adhesion": "w", "crack_exponent": "ce", "crack_speed": "cs",
}  # fmt: skip
_NUMERICS = {
    "kernel": "k", "quadrature": "q", "refinement": "r", "statics": "st", "solver": "s",
    "jacobian": "j", "time_resolution_factor": "f", "sampling_frequency": "sf", "lags": "l",
    "tolerance": "t", "max_iterations": "i", "initial_guess": "g", "margin_interval": "mi",
    "long_holds": "h", "field_memory": "m",
}  # fmt: skip
_PARTS = {
    "road": ("r", _ROAD), "springs": ("s", _SPRINGS), "tread": ("t", _TREAD),
    "loading": ("l", _LOADING), "adhesion": ("a", _ADHESION), "numerics": ("n", _NUMERICS),
}  # fmt: skip

#: path of a setting -> its key
KEYS = {
    f"{part}.{name}": letter + key
    for part, (letter, names) in _PARTS.items()
    for name, key in names.items()
}
#: setting of a layer of the tread -> its letter
LAYER_KEYS = {
    "thickness": "t", "density": "d", "poissons_ratio": "p", "material": "m",
    "static_modulus": "e", "glassy_modulus": "g", "exponent": "x", "relaxation_time": "r",
    "youngs_modulus": "y", "loss_factor": "l", "modulus_table": "f",
}  # fmt: skip
#: keys that are no setting's: version and preset
VERSION_KEY, PRESET_KEY = "v", "p"
#: begins the key of what is looked at, such as `_axis`
VIEW_MARK = "_"
