"""The whole report without times, measured once for all tests that read it."""

import os
import pickle
from typing import Any

import pytest
from harness import answer

from dynamics_cli.accuracy import report
from dynamics_cli.cli import find_task


@pytest.fixture(scope="session")
def untimed_report(tmp_path_factory: pytest.TempPathFactory) -> report.Accuracy:
    """Of several workers the second takes what the first has measured, where that has finished."""
    worker, own = os.environ.get("PYTEST_XDIST_WORKER", ""), tmp_path_factory.getbasetemp()
    kept = (own.parent if worker else own) / "untimed_report.pickle"
    if kept.exists():
        return pickle.loads(kept.read_bytes())  # type: ignore[no-any-return]
    made = report.accuracy(full=True, untimed=True)
    part = kept.with_suffix(f".part{worker}")
    part.write_bytes(pickle.dumps(made))
    part.rename(kept)
    return made


@pytest.fixture(scope="session")
def report_rows(untimed_report: report.Accuracy) -> list[dict[str, Any]]:
    found = find_task(["accuracy"])
    assert found is not None
    assert found[0].specification
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(report, "accuracy", lambda *_, **__: untimed_report)
        return answer("accuracy", "--untimed")["results"]["methods"]  # type: ignore[no-any-return]
