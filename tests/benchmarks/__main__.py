"""Run all benchmarks and put their table into the README: `python -m tests.benchmarks`.

Kernels of large lattices come from the user's cache (TYRECONTACT_CACHE names another); where they
are not yet there they are made first, which takes some minutes and 3 GB. `--print` leaves the
README alone, `-k` selects as pytest does, `--read` takes what was kept of an earlier run.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.benchmarks.report import Measured, placed, text

_HERE = Path(__file__).parent
_README = _HERE.parents[1] / "README.md"
#: of every library that would take more
_THREADS = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL")}


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks", description=__doc__)
    parser.add_argument("--print", action="store_true", help="print the table only")
    parser.add_argument("-k", default="", metavar="EXPRESSION", help="benchmarks to run")
    parser.add_argument("--keep", type=Path, metavar="FILE", help="keep what was measured (JSON)")
    parser.add_argument("--read", type=Path, metavar="FILE", help="run nothing, read that")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        written = options.read or options.keep or Path(folder) / "measured.json"
        code = 0 if options.read else run(written, options.k)
        if not written.exists():
            return code or 1
        tables = text(Measured.read(json.loads(written.read_text(encoding="utf-8"))))
    print(tables)
    if not options.print:
        _README.write_text(placed(_README.read_text(encoding="utf-8"), tables), encoding="utf-8")
    return code


def run(written: Path, selected: str) -> int:
    """Run the benchmarks in a process with one thread; 0 if all went well."""
    files = sorted(map(str, _HERE.glob("bench_*.py")))
    command = [sys.executable, "-m", "pytest", "-q", "-n=0", "--benchmark-quiet", *files]
    command += [f"--benchmark-json={written.resolve()}", *(["-k", selected] if selected else [])]
    done = subprocess.run(command, cwd=_HERE.parents[1], env=os.environ | _THREADS, check=False)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
