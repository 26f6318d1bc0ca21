"""A page served in this very process: its threads and what it holds are seen by the test."""

from __future__ import annotations

import gc
import socket
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import panel as pn


@contextmanager
def served(build: Callable[[], Any], **options: Any) -> Iterator[str]:
    """Address of a page on a free port; afterwards nothing of the server is left."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
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


def _wait_until_it_answers(port: int) -> None:
    limit = time.monotonic() + 30
    while time.monotonic() < limit:
        with socket.socket() as caller:
            if caller.connect_ex(("127.0.0.1", port)) == 0:
                return
        time.sleep(0.05)
    raise TimeoutError(f"nothing answers at port {port}")
