"""Settings for every test."""

import os

import harness  # noqa: F401  before numpy: it sets how many threads there are
import pytest
from hypothesis import settings

from dynamics_cli import cli
from dynamics_cli.registry import Entry

# The same examples in every run, and none that fails because the machine is busy; PROPERTY_SEARCH=1 draws new ones.
settings.register_profile("steady", deadline=None, derandomize="PROPERTY_SEARCH" not in os.environ)
settings.load_profile("steady")
# Programs that tests start find their compiled code, as installed ones do.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)


@pytest.fixture
def toy(monkeypatch: pytest.MonkeyPatch) -> None:
    """The family `toy`, one small task for each convention of signatures."""
    monkeypatch.setitem(cli.FAMILIES, "toy", Entry("toys", "Toys", "Toys."))
