"""Thomson, Theory of Vibration with Applications, appendix D: modes of uniform beams, βL and (βL)² as printed."""

import pytest

from dynamics_cli.vibration.shafts.beam import root_of

# Half of the last digit printed, and a hair.
PRINTED = 0.51e-4
TABLES = {
    "clamped-clamped": ((4.7300, 22.3733), (7.8532, 61.6728), (10.9956, 120.9034)),
    "clamped-free": ((1.8751, 3.5160), (4.6941, 22.0345), (7.8548, 61.6972)),
}


@pytest.mark.parametrize("ends", TABLES)
def test_roots_as_printed(ends: str) -> None:
    for nth, (root, square) in enumerate(TABLES[ends], 1):
        beta = root_of(ends, nth)
        assert beta == pytest.approx(root, abs=PRINTED)
        assert beta * beta == pytest.approx(square, abs=PRINTED)
