"""Settings for every test."""

import pytest

from dynamics_cli import cli
from dynamics_cli.registry import Entry


@pytest.fixture
def toy(monkeypatch: pytest.MonkeyPatch) -> None:
    """The family `toy`, one small task for each convention of signatures."""
    monkeypatch.setitem(cli.FAMILIES, "toy", Entry("toys", "Toys", "Toys."))
