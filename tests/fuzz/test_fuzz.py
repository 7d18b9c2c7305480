"""A short run of each fuzzer; `python tests/fuzz/fuzz.py` makes long ones."""

import os

import pytest
from fuzz import MAKERS, ROOT, fuzz

SEED = int(os.environ.get("FUZZ_SEED", "1"))
SECONDS = float(os.environ.get("FUZZ_SECONDS", "5"))
# So many of the first cases, that a faster machine sees no others.
CASES = 150


@pytest.mark.parametrize("kind", MAKERS)
def test_no_call_ends_as_an_internal_error(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    most = CASES if "FUZZ_SECONDS" not in os.environ else 10**9
    assert list(fuzz(kind, SEED, SECONDS, most)) == []
