"""A road file is read once, whatever is then given about it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact.road import scans


def test_a_file_is_read_once_for_all_pitches_and_units(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "matrix.txt"
    np.savetxt(path, np.arange(12.0).reshape(3, 4))
    loaded = scans.load(path)
    with pytest.raises(scans.NotCarriedError) as missing:
        loaded.scan()
    assert missing.value.missing == ("pitch", "unit")
    monkeypatch.setattr(scans, "_raw", lambda *_: pytest.fail("read again"))
    for unit, scale in scans.UNITS.items():
        scan = loaded.scan(1e-4, unit)
        assert scan.heights == pytest.approx(np.arange(12.0).reshape(3, 4) * scale)
        assert scan.pitch == 1e-4
