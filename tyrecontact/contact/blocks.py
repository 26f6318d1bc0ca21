r"""Sums over past steps in time that grows with the logarithm of how many are remembered.

    y_n = sum_(j=1)^(lags-1) g_j x_(n-j)

for many pairs g, x at once. Steps are taken in blocks, short ones within longer ones: when a block
of B steps is full, what it does to the B steps that follow is a circular convolution of 2 B points,
a product after a Fourier transform in time, and only the steps of the shortest block, the one that
is not full yet, are summed one by one. The result is that of the plain sum, to rounding.
(W. G. Gardner, J. Audio Eng. Soc. 43 (1995) 127; E. Hairer, C. Lubich and M. Schlichte,
SIAM J. Sci. Stat. Comput. 6 (1985) 532.)
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy import fft

from tyrecontact.fast import loops

#: steps of the shortest block, and how many of one length make one of the next
SHORTEST, RATIO = 16, 4
#: blocks of the longest length that the memory has at least
_AT_LEAST = 3
#: longer blocks are transformed by fast Fourier transforms, shorter ones faster by matrices
_MATRICES_UP_TO = 64


class Lagged:
    """The numbers g, arranged for blocks of several lengths.

    Parameters
    ----------
    kernel : g_0, which plays no part, g_1, .., shape (lags, waves); two lags or more.

    Attributes
    ----------
    recent : g of the lags `SHORTEST`, .., 2, 1, shape (SHORTEST, waves).
    by_length : rising in length, what acts on the last block, on the one before it and so on,
        transformed in time; shape (blocks, waves, length + 1), complex.
    """

    def __init__(self, kernel: np.ndarray) -> None:
        lags, waves = kernel.shape
        known = min(SHORTEST, lags - 1)
        self.recent = np.zeros((SHORTEST, waves))
        self.recent[SHORTEST - known :] = kernel[known:0:-1]
        self.by_length, length = [], SHORTEST
        while _AT_LEAST * RATIO * length < lags:
            self.by_length.append(_for_blocks(kernel, length, RATIO - 1))
            length *= RATIO
        self.by_length.append(_for_blocks(kernel, length, -(-(lags - 1) // length)))


def _for_blocks(kernel: np.ndarray, length: int, count: int) -> np.ndarray:
    spectra = np.empty((count, kernel.shape[1], length + 1), complex)
    for block, spectrum in enumerate(spectra):
        _in_frequency(kernel[block * length : (block + 2) * length], length, out=spectrum)
    return spectra


class Memory:
    """The last steps of x, and the sums over them.

    Parameters
    ----------
    kernel : g.  parts : how many x share each g.
    """

    def __init__(self, kernel: Lagged, parts: int) -> None:
        self._recent, waves = kernel.recent, kernel.recent.shape[1]
        self._blocks = [_Blocks(numbers, parts) for numbers in kernel.by_length]
        longest = self._blocks[-1].length
        self._steps = np.zeros((longest, parts, waves))  # of the longest block at hand
        self._known = np.zeros((SHORTEST, parts, waves))  # sums over all full blocks
        self._step = 0

    def sum(self) -> np.ndarray:
        """y of the coming step, shape (parts, waves)."""
        here = self._step % len(self._steps)
        recent = here % SHORTEST
        numbers, steps = self._recent[SHORTEST - recent :], self._steps[here - recent : here]
        fast = loops()
        y: np.ndarray
        if fast is not None:
            y = fast.recent_sum(numbers, steps, self._known[recent])
        else:
            y = np.einsum("jw,jpw->pw", numbers, steps)
            y += self._known[recent]
        return y

    def take(self, x: np.ndarray) -> None:
        """Remember x of the step that is over, shape (parts, waves)."""
        self._steps[self._step % len(self._steps)] = x
        self._step += 1
        if self._step % SHORTEST == 0:
            self._turn()

    def fill(self, x: np.ndarray) -> None:
        """Remember that x, shape (parts, waves), has not changed for longer than is remembered."""
        self._steps[:] = x
        self._step = len(self._steps) * len(self._blocks[-1])
        for _ in range(len(self._blocks[-1])):
            self._turn()

    def _turn(self) -> None:
        """Take the blocks that have become full, the longest first: they stand for shorter ones."""
        end = (self._step - 1) % len(self._steps) + 1
        self._known[:] = 0
        longer_turned = False
        for blocks in reversed(self._blocks):
            if longer_turned:
                blocks.clear()
            elif self._step % blocks.length == 0:
                blocks.take(self._steps[end - blocks.length : end])
                longer_turned = True
            begin = self._step % blocks.length
            self._known += blocks.ahead[begin : begin + SHORTEST]


class _Blocks:
    """The last full blocks of one length, and what they add to the sums of the block that follows.

    Attributes
    ----------
    ahead : shape (length, parts, waves).
    """

    def __init__(self, kernel: np.ndarray, parts: int) -> None:
        self._kernel, self.length = kernel, kernel.shape[2] - 1
        # the block before is the next one, around the end
        self._past = np.zeros((len(kernel), parts, *kernel.shape[1:]), complex)
        self._total, self._product = self._past[0].copy(), self._past[0, 0].copy()
        self.ahead = np.zeros((self.length, parts, kernel.shape[1]))
        self.clear()

    def __len__(self) -> int:
        return len(self._past)

    def clear(self) -> None:
        self._newest, self._count = 0, 0
        self.ahead[:] = 0

    def take(self, block: np.ndarray) -> None:
        """Add a block that has become full, shape (length, parts, waves)."""
        self._newest = (self._newest - 1) % len(self)
        self._count = min(self._count + 1, len(self))
        samples = block.reshape(self.length, -1)
        spectrum = self._past[self._newest].reshape(-1, self.length + 1)
        _in_frequency(samples, self.length, out=spectrum)
        self._sum_up()
        total, ahead = self._total.reshape(spectrum.shape), self.ahead.reshape(samples.shape)
        _in_time(total, self.length, out=ahead)

    def _sum_up(self) -> None:
        """Sum over all blocks, in frequency; part by part, which the processor's cache holds."""
        for part in range(len(self._total)):
            np.multiply(self._kernel[0], self._past[self._newest, part], out=self._total[part])
            for age in range(1, self._count):
                block = (self._newest + age) % len(self)
                np.multiply(self._kernel[age], self._past[block, part], out=self._product)
                self._total[part] += self._product


def _in_frequency(samples: np.ndarray, length: int, out: np.ndarray) -> None:
    """Transform in time of up to 2 length samples, (samples, waves) -> (waves, length + 1)."""
    if length > _MATRICES_UP_TO:
        out[:] = fft.rfft(samples, 2 * length, axis=0).T
    else:
        np.matmul(samples.T, _matrices(length)[0][: len(samples)], out=out.view(float))


def _in_time(spectrum: np.ndarray, length: int, out: np.ndarray) -> None:
    """The last `length` of the 2 length samples of a transform, (length, waves)."""
    if length > _MATRICES_UP_TO:
        out[:] = fft.irfft(spectrum, axis=1)[:, length:].T
    else:
        np.matmul(_matrices(length)[1], spectrum.view(float).T, out=out)


@lru_cache(maxsize=8)
def _matrices(length: int) -> tuple[np.ndarray, np.ndarray]:
    """Both transforms, (2 length, 2 length + 2) and (length, 2 length + 2); real, imaginary, .."""
    there = fft.rfft(np.eye(2 * length), axis=1).view(float)
    units = np.eye(2 * length + 2).view(complex)
    return there, np.ascontiguousarray(fft.irfft(units, axis=1)[:, length:].T)
