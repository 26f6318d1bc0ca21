"""A visitor's name of a file, as far as it can be one on the server: no folder, no signs."""

from __future__ import annotations

import re

#: characters of a name at most
_LENGTH = 60


def harmless(name: str, ending: str, otherwise: str) -> str:
    """The name to keep a file by, with the ending that it is read by.

    Parameters
    ----------
    name : that the visitor's browser told; it may be anything.
    ending : that the kept name must have, ".npy"; empty for any.
    otherwise : the name, without an ending, of what has none that can be kept.
    """
    kept = re.sub(r"[^\w .()+-]", "_", re.split(r"[/\\]", name)[-1])
    kept = kept.strip(" .")[-_LENGTH:].strip(" .")
    return kept if kept and kept.lower().endswith(ending) else f"{otherwise}{ending}"
