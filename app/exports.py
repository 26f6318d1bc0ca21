"""A run as files: netCDF with everything, CSV with the numbers of every step."""

from __future__ import annotations

import io
import re
from csv import writer
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np

from tyrecontact import Results
from tyrecontact.steps import SCALARS

from . import code


def stem(preset: str) -> str:
    """Beginning of the name of a file: tyrecontact-fig-44-14-N."""
    return "tyrecontact-" + re.sub(r"[^A-Za-z0-9]+", "-", preset).strip("-")


def file_name(preset: str, ending: str, when: datetime | None = None) -> str:
    """A name that says what and when (UTC): tyrecontact-fig-44-14-N-20250601-143005.nc."""
    moment = (when or datetime.now(UTC)).astimezone(UTC)
    return f"{stem(preset)}-{moment:%Y%m%d-%H%M%S}.{ending}"


def netcdf(results: Results) -> bytes:
    """What `tyrecontact run --output` writes, numbers and maps (netCDF 3, read by all).

    No folder of the server is told.

    Parameters
    ----------
    results : of a run, complete or not.
    """
    told = replace(results, scenario=code.without_folders(results.scenario))
    return bytes(told.to_xarray().to_netcdf(engine="scipy"))


def csv(preset: str, results: Results) -> str:
    """Numbers of every step, a row each, to the last digit.

    The first line names the columns with their units, "contact_force [N]". Meanings and scenario
    follow the numbers as comments (#): in front, they would be taken for the head of the table by
    numpy.genfromtxt(names=True, delimiter=",") and by spreadsheets.
    """
    columns: dict[str, np.ndarray] = {"step": np.arange(len(results))}
    notes = ["step: number of the step, from 0"]
    units = {"time": ("s", "Time"), **{name: kept[:2] for name, kept in SCALARS.items()}}
    units["drive"] = ("N" if results.scenario.loading.drive == "force" else "m", units["drive"][1])
    for name, (unit, meaning) in units.items():
        label = name if unit == "1" else f"{name} [{unit}]"
        columns[label] = results.columns[name]
        notes.append(f"{label}: {meaning}")
    file = io.StringIO()
    table = writer(file, lineterminator="\n")
    table.writerow(columns)
    table.writerows(zip(*(column.tolist() for column in columns.values()), strict=True))
    scenario = code.without_folders(results.scenario)
    notes += [f"The run: {results.stop_reason}", "The scenario, for tyrecontact run FILE.toml:"]
    notes += code.toml(preset, scenario).splitlines()
    return file.getvalue() + "".join(f"# {note}".rstrip() + "\n" for note in notes)
