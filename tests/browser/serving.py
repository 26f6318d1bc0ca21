"""The page on a free port: by the README's command, or in this very process."""

from __future__ import annotations

import gc
import socket
import subprocess
import sys
import time
import urllib.request
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import panel as pn

_ROOT = Path(__file__).parents[2]


@contextmanager
def served_by_command(log: Path) -> Iterator[str]:
    """Address of the page, served as the README says; what the server writes is in the log."""
    port = _free_port()
    command = [sys.executable, "-m", "panel", "serve", "app", "--liveness", "--port", str(port)]
    with log.open("w") as output:
        server = subprocess.Popen(command, cwd=_ROOT, stdout=output, stderr=output)
        try:
            _wait_until_alive(f"http://localhost:{port}/liveness", server, log)
            yield f"http://localhost:{port}/app"
        finally:
            server.terminate()
            server.wait(20)


@contextmanager
def served(build: Callable[[], Any], **options: Any) -> Iterator[str]:
    """Address of a page of this process, whose threads and what it holds can be seen; afterwards
    nothing of the server is left.
    """
    port = _free_port()
    thread = pn.serve(
        {"app": build}, port=port, threaded=True, show=False, verbose=False, **options
    )
    try:
        _wait_until_it_answers(port)
        yield f"http://localhost:{port}/app"
    finally:
        thread.stop()
        thread.join(10)
        pn.state.reset()
        with warnings.catch_warnings():
            # Panel leaves the sockets of its loop to the collector, which complains of them
            warnings.simplefilter("ignore", ResourceWarning)
            gc.collect()


def _free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def _wait_until_alive(url: str, server: subprocess.Popen[bytes], log: Path) -> None:
    for _ in range(300):
        if server.poll() is not None:
            break
        try:
            with urllib.request.urlopen(url, timeout=1):
                return
        except OSError:
            time.sleep(0.1)
    raise TimeoutError(f"the server did not answer: {log.read_text()}")


def _wait_until_it_answers(port: int) -> None:
    limit = time.monotonic() + 30
    while time.monotonic() < limit:
        with socket.socket() as caller:
            if caller.connect_ex(("127.0.0.1", port)) == 0:
                return
        time.sleep(0.05)
    raise TimeoutError(f"nothing answers at port {port}")
