"""The whole report without times, measured once for all tests that read it."""

from typing import Any

import pytest
from harness import answer

from dynamics_cli.accuracy import report
from dynamics_cli.cli import find_task


@pytest.fixture(scope="session")
def untimed_report() -> report.Accuracy:
    return report.accuracy(full=True, untimed=True)


@pytest.fixture(scope="session")
def report_rows(untimed_report: report.Accuracy) -> list[dict[str, Any]]:
    found = find_task(["accuracy"])
    assert found is not None
    assert found[0].specification
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(report, "accuracy", lambda *_, **__: untimed_report)
        return answer("accuracy", "--untimed")["results"]["methods"]  # type: ignore[no-any-return]
