"""The command line: presets, settings, runs, and what is understood of a road file."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from tqdm import tqdm

from tyrecontact import assembly, presets
from tyrecontact.errors import InputError, TyreContactError
from tyrecontact.road.scan import UNITS
from tyrecontact.scenario import Scenario, read_tables
from tyrecontact.settings import Tables
from tyrecontact.simulation import Simulation
from tyrecontact.writing import require_folder, require_writable, write_whole


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry of the console script; returns the exit code (2: input that cannot be used)."""
    options = _parser().parse_args(arguments)
    try:
        options.command(options)
    except TyreContactError as error:
        print(f"tyrecontact: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:  # before there was anything to keep
        return 130
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="tyrecontact", description=__doc__)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    listed = commands.add_parser("presets", help="list the presets")
    listed.add_argument("--members", action="store_true", help="with all members of each figure")
    listed.set_defaults(command=_presets)
    described = commands.add_parser("describe", help="list every setting of a scenario")
    described.set_defaults(command=_describe)
    run = commands.add_parser("run", help="run a preset or a scenario file")
    run.add_argument("scenario", metavar="PRESET|FILE.toml")
    run.add_argument(
        "--set", action="append", default=[], metavar="part.name=value", dest="changes",
        help="change a setting (SI units); may be repeated",
    )  # fmt: skip
    run.add_argument("--output", type=Path, metavar="FILE.nc", help="write the run as netCDF")
    run.add_argument("--json", action="store_true", help="print the headline figures as JSON")
    run.set_defaults(command=_run)
    _add_road(commands)
    _add_thesis(commands)
    return parser


def _add_road(commands: argparse._SubParsersAction) -> None:
    road = commands.add_parser("road", help="tell what is understood of a road file")
    road.add_argument("file", metavar="FILE")
    road.add_argument("--pitch", type=float, metavar="M", help="distance of its heights [m]")
    road.add_argument("--unit", metavar="|".join(UNITS), help="unit of its heights")
    road.add_argument(
        "--set", action="append", default=[], metavar="name=value", dest="changes",
        help="change another setting of the road, such as trim_start (SI units)",
    )  # fmt: skip
    road.add_argument("--json", action="store_true", help="print it as JSON")
    road.set_defaults(command=_road)


def _add_thesis(commands: argparse._SubParsersAction) -> None:
    thesis = commands.add_parser("thesis", help="run all figures of the thesis, and judge them")
    thesis.add_argument("--output", type=Path, required=True, metavar="DIR", help="where to write")
    thesis.add_argument(
        "--figures", default="", metavar="44,45", help="only these (default: all of them)"
    )
    thesis.add_argument("--jobs", type=int, default=2, metavar="N", help="runs at a time (2)")
    thesis.set_defaults(command=_thesis)


def _presets(options: argparse.Namespace) -> None:
    width = max(map(len, presets.names()))
    for name in presets.names():
        print(f"{name:<{width}}  {presets.caption(name)}")
        if options.members:
            for member in presets.members(name):
                print(f"    {member}")


def _thesis(options: argparse.Namespace) -> None:
    from tyrecontact import thesis  # what it takes, other commands need not wait for
    from tyrecontact.thesis import campaign, findings, table

    if not options.jobs >= 1:
        raise InputError(f"--jobs must be at least 1, got {options.jobs}")
    names = [name.strip() for name in options.figures.split(",") if name.strip()]
    selected, folder = campaign.chosen(names), options.output
    require_folder(folder)
    began = time.perf_counter()
    with tqdm(unit="step", unit_scale=True, smoothing=0) as bar:
        results = campaign.run_figures(selected, folder, options.jobs, bar)
    rows = findings.judged(thesis.FINDINGS, results)
    table.write_tables(rows, selected, campaign.files(selected), folder)
    minutes = (time.perf_counter() - began) / 60
    print(f"{sum(row.agrees for row in rows)} of {len(rows)} findings agree, {minutes:.1f} min")
    print(f"the table: {folder / 'thesis.md'}; as a page: python -m app.report {folder}")


def _describe(_: argparse.Namespace) -> None:
    for path, parameter, value in Scenario().settings():
        choices = getattr(parameter, "objects", None)
        bounds = getattr(parameter, "bounds", None)
        span = "tables, as JSON" if isinstance(parameter, Tables) else "any text"
        if choices:
            span = " | ".join(name or repr(name) for name in choices)
        elif bounds:
            span = f"{bounds[0]:g} to {bounds[1]:g}"
        unit = parameter.metadata["unit"]
        default = repr(value) if value == "" else value
        print(f"{path} = {default}{' ' + unit if unit else ''}  [{span}]\n    {parameter.doc}")


def _road(options: argparse.Namespace) -> None:
    """Say what was understood of a file, and whether the patch can be cut from it."""
    scenario = Scenario(road={"file": options.file})
    if options.pitch is not None:
        scenario.road.pitch = options.pitch
    if options.unit is not None:
        scenario.road.height_unit = options.unit
    _change(scenario, options.changes, "road.")
    found = assembly.road_understood(scenario.road)
    try:
        patch = assembly.road_patch(scenario.road)
        use = f"a patch of {patch.extent[0] * 1e3:.4g} mm, rms {patch.rms * 1e6:.4g} µm"
    except InputError as error:
        use = f"none: {error}"
    told = json.dumps({**found.to_dict(), "patch": use})
    print(told if options.json else "\n".join([*found.lines(), f"patch               {use}"]))


def _change(scenario: Scenario, changes: Sequence[str], prefix: str = "") -> None:
    for change in changes:
        path, equals, value = change.partition("=")
        if not equals:
            wanted = "name=value" if prefix else "part.name=value"
            raise InputError(f"--set must be given as {wanted}, got {change!r}")
        scenario.set(prefix + path.strip().removeprefix(prefix), value.strip())


def _run(options: argparse.Namespace) -> None:
    scenario = _scenario(options.scenario)
    _change(scenario, options.changes)
    if options.output is not None:
        require_writable(options.output)
    began = time.perf_counter()
    simulation = Simulation(scenario)
    simulation.springs  # noqa: B018 - a road that cannot be used is refused before a kernel is made
    kernel_began = time.perf_counter()
    simulation.kernel  # noqa: B018 - built here so that its time is known
    kernel_seconds = time.perf_counter() - kernel_began
    # a bar on a terminal, none otherwise
    results = simulation.run(partial(tqdm, disable=None, unit="step", leave=False))
    wall_seconds = time.perf_counter() - began
    summary = {**results.summary(), "wall_s": wall_seconds, "kernel_s": kernel_seconds}
    print(json.dumps(summary) if options.json else _in_words(summary))
    if options.output is not None:
        write_whole(options.output, results.to_xarray().to_netcdf)
        if results.kept is not None:
            every = results.kept[1] - results.kept[0]
            print(
                f"tyrecontact: maps of every {every} steps and of the last are in {options.output} "
                "(numerics.field_memory)",
                file=sys.stderr,
            )


def _scenario(name: str) -> Scenario:
    if not name.endswith(".toml"):
        return presets.get(name)
    tables = read_tables(Path(name))
    base = tables.pop("preset", "default")
    scenario = presets.get(base)
    changes = Scenario(**tables).to_dict()  # checks names and values before any is taken
    for part, values in tables.items():
        for setting in values:
            scenario.set(f"{part}.{setting}", changes[part][setting])
    return scenario


def _in_words(summary: dict) -> str:
    lines = [f"{summary['steps']} steps in {summary['wall_s']:.2f} s: {summary['stop_reason']}"]
    failed = summary["failed_at"]
    if failed:
        lines.append(
            f"first step that did not converge: {failed['step']}, at {failed['time'] * 1e3:.3f} ms "
            f"and an indentation of {failed['indentation'] * 1e3:.4f} mm"
        )
    unstable = summary["unstable_at"]
    if unstable:
        lines.append(
            f"may blow up from {unstable['indentation'] * 1e3:.4f} mm on, where springs are too "
            "stiff for the kernel (stability margin below 0)"
        )
    lines.append(f"largest force     {summary['max_force']:.4g} N")
    if summary["final_stiffness"] is not None:
        lines.append(f"final stiffness   {summary['final_stiffness'] / 1e6:.3g} MN/m")
    if summary["adherence_force"] is not None:
        lines.append(f"adherence force   {summary['adherence_force']:.3g} N")
    if summary["releases"]:
        lines.append(
            f"largest avalanche {summary['largest_avalanche']} of {summary['releases']} releases"
        )
    lines.append(
        f"Newton iterations {summary['iterations_mean']:.2f} a step, {summary['iterations_max']} "
        "at most"
    )
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
