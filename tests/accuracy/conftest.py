"""The whole report without times, measured once for all tests that read it."""

from typing import Any

import pytest
from harness import answer


@pytest.fixture(scope="session")
def report_rows() -> list[dict[str, Any]]:
    return answer("accuracy", "--untimed")["results"]["methods"]  # type: ignore[no-any-return]
