"""A modulus given as a table: storage modulus and loss factor against frequency.

    E(2 pi i f) = E'(f) [1 + i eta(f)],   ln E' and ln eta straight lines of ln f in between.

A table is a table: nothing makes its two columns belong to one causal material, and it says
nothing about complex s. Kernels that ask along s = 2 pi i f alone can use it.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError

#: a larger text is no table of a modulus
_MAX_BYTES = 2_000_000


@dataclass(frozen=True)
class Tabulated:
    """E' and loss factor by frequency, for s = 2 pi i f alone.

    Below the first frequency E' stays and the loss factor falls with f to nothing, so that the
    modulus is real at rest; above the last both stay.

    Attributes
    ----------
    frequency : f [Hz], positive and rising.
    storage_modulus : E' [Pa], positive.
    loss_factor : eta = E''/E' [-], positive.

    Raises
    ------
    InputError : columns that are not as above; a call with s off the imaginary axis.
    """

    frequency: tuple[float, ...]
    storage_modulus: tuple[float, ...]
    loss_factor: tuple[float, ...]

    def __post_init__(self) -> None:
        columns = {
            "frequency [Hz]": self.frequency,
            "storage modulus [Pa]": self.storage_modulus,
            "loss factor": self.loss_factor,
        }
        if not 2 <= len(self.frequency) == len(self.storage_modulus) == len(self.loss_factor):
            lengths = ", ".join(str(len(column)) for column in columns.values())
            raise InputError(
                f"columns of a modulus table must be of one length, at least 2, got {lengths}"
            )
        for name, column in columns.items():
            for row, value in enumerate(column, start=1):
                if not 0 < value < np.inf:
                    raise InputError(
                        f"{name} of a modulus table must be positive and finite, "
                        f"got {value:g} in row {row}"
                    )
        falls = np.flatnonzero(np.diff(self.frequency) <= 0)
        if falls.size:
            row = int(falls[0]) + 1
            raise InputError(
                "frequency [Hz] of a modulus table must rise from row to row, "
                f"got {self.frequency[row]:g} after {self.frequency[row - 1]:g} in row {row + 1}"
            )

    def __call__(self, laplace_frequency: np.ndarray) -> np.ndarray:
        s = np.asarray(laplace_frequency, dtype=complex)
        if np.any(s.real != 0):
            raise InputError(
                "a tabulated modulus must be asked at s = 2 pi i f alone, as the band-limited, "
                "passive-mobility and static kernels do: it is not causal and has no "
                "continuation to complex s"
            )
        frequency = np.abs(s.imag) / (2 * np.pi)
        lowest = self.frequency[0]
        # where f -> 0: E' stays, eta goes with f
        logarithm, known = np.log(np.maximum(frequency, lowest)), np.log(self.frequency)
        storage = np.exp(np.interp(logarithm, known, np.log(self.storage_modulus)))
        loss = np.exp(np.interp(logarithm, known, np.log(self.loss_factor)))
        loss = loss * np.minimum(frequency / lowest, 1) * np.sign(s.imag)
        return storage * (1 + 1j * loss)


#: the tread of the thesis (Appendix B): E' 25 MPa at rest, 50 MPa at high frequency, loss factor
#: 0.005 at 10 Hz and 0.55 at 50 kHz. No more of it is printed, and no causal material has it.
APPENDIX_B = Tabulated((10.0, 50e3), (25e6, 50e6), (0.005, 0.55))


def read_table(path: str | Path) -> Tabulated:
    """A modulus from a text file: rows of frequency [Hz], E' [Pa] and loss factor.

    Columns are separated by blanks or commas; `#` starts a comment.

    Raises
    ------
    InputError : a file that cannot be read, is no such table, or is larger than 2 MB.
    """
    name = Path(path).name
    try:
        with Path(path).open("rb") as file:
            content = file.read(_MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"modulus table must be readable, got {name}: {reason}") from None
    if len(content) > _MAX_BYTES:
        raise InputError(f"modulus table must be at most 2 MB, got more in {name}")
    try:
        lines = content.decode("utf-8-sig").replace(",", " ").splitlines()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of an empty table, which is refused below
            rows = np.loadtxt(lines, ndmin=2)
    except ValueError as error:
        raise InputError(f"modulus table must hold numbers, got {name}: {error}") from None
    if rows.shape[1] != 3:
        raise InputError(
            "modulus table must have three columns, frequency [Hz], storage modulus [Pa] and "
            f"loss factor, got {rows.shape[1] if rows.size else 0} in {name}"
        )
    frequency, storage, loss = (tuple(column) for column in rows.T.tolist())
    return Tabulated(frequency, storage, loss)
