"""The thesis, figure by figure: all its runs, what it says of them, and what comes out."""

from tyrecontact.thesis import adhesion, cures, instability, rates
from tyrecontact.thesis.findings import Finding

#: in the order of the thesis
FINDINGS: tuple[Finding, ...] = (
    *instability.FINDINGS,
    *cures.FINDINGS,
    *rates.FINDINGS,
    *adhesion.FINDINGS,
)
