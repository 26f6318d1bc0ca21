"""Fewer springs than elements, or tamer ones: what may be lost of them without harm?

The thesis exchanges its stiffest springs (chapter 4.2.2), and asks whether one mean spring, a few
standard ones, or linear ones would do (chapter 6).
"""

from __future__ import annotations

import numpy as np
import scipy  # its parts are loaded where they are first used

from tyrecontact.errors import InputError, unknown_name
from tyrecontact.road.spring_tables import Springs, linear

RANKINGS = ("force", "stiffness")


def exchange_stiffest(
    springs: Springs, count: int, compression: float, ranking: str = "force"
) -> Springs:
    """The `count` stiffest springs, each replaced by one of the `count` next in the ranking.

    Parameters
    ----------
    count : number of springs to replace, at most half of them; 0 changes nothing.
    compression : [m] at which the springs are ranked.
    ranking : by their "force" or their "stiffness" there.

    Raises
    ------
    InputError : a count out of bounds, or an unknown ranking.

    Source: thesis, chapter 4.2.2 (80 springs, ranked at 9 um).
    """
    index = exchange_index(springs, count, compression, ranking)
    return springs.take(index) if count else springs


def exchange_index(
    springs: Springs, count: int, compression: float, ranking: str = "force"
) -> np.ndarray:
    """Which spring each element has after `exchange_stiffest`, its own but for the exchanged.

    Returns numbers of elements, shape (elements,); parameters and errors as there.
    """
    if not 0 <= 2 * count <= springs.count:
        half = springs.count // 2
        raise InputError(f"exchange_count must lie between 0 and {half}, got {count}")
    if ranking not in RANKINGS:
        raise unknown_name("ranking of springs", ranking, RANKINGS)
    index = np.arange(springs.count)
    if count:
        at = np.full(springs.count, compression)
        value = springs.force(at) if ranking == "force" else springs.stiffness(at)
        order = np.argsort(-value, kind="stable")
        index[order[:count]] = order[count : 2 * count]
    return index


def mean(springs: Springs) -> Springs:
    """One spring for all elements: at each compression the mean of their forces and punches."""
    return _averaged(springs, np.zeros(springs.count, int))


def standard(springs: Springs, count: int) -> Springs:
    """A few standard springs, each the mean of a cluster of like ones.

    Alike are springs whose forces differ by small factors at compressions from a hundredth of
    the depth to all of it: k-means on ln F, begun at equal steps of the ranking, so that the
    same springs give the same clusters. There may be fewer than `count` if there are fewer kinds.

    Raises
    ------
    InputError : a count below 1.
    """
    if not count >= 1:
        raise InputError(f"standard_count must be at least 1, got {count}")
    nodes = springs.nodes
    places = nodes[nodes >= 0.01 * springs.depth][::8]
    feature = np.log([springs.force(np.full(springs.count, place)) for place in places]).T
    kinds = np.unique(feature[np.argsort(feature.mean(axis=1), kind="stable")], axis=0)
    kinds = kinds[np.argsort(kinds.mean(axis=1), kind="stable")]
    first = np.unique(((np.arange(count) + 0.5) / count * len(kinds)).astype(int))
    centres, _ = scipy.cluster.vq.kmeans(feature, kinds[first])
    return _averaged(springs, scipy.cluster.vq.vq(feature, centres)[0])


def linearised(springs: Springs, compression: float) -> Springs:
    """Linear springs with the force, and the radius, that each has at a compression [m].

    Raises
    ------
    InputError : a compression that is not positive.
    """
    if not 0 < compression < np.inf:
        raise InputError(f"linear_compression must be positive, got {compression} m")
    at = np.full(springs.count, compression)
    return linear(springs.force(at) / compression, springs.depth, springs.radius(at))


def _averaged(springs: Springs, label: np.ndarray) -> Springs:
    """Each spring the mean of those with its label."""
    kinds, index, members = np.unique(label, return_inverse=True, return_counts=True)

    def averaged(table: np.ndarray) -> np.ndarray:
        total = np.zeros((kinds.size, *table.shape[1:]))
        np.add.at(total, index, table)
        return total / members[:, None, None]

    energy, contact = averaged(springs.energy_table), averaged(springs.contact_table)
    return Springs(springs.depth, energy, contact, springs.tangent).take(index)
