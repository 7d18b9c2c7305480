"""Results of one earlier document keep their correlation when they become inputs."""

import json
from pathlib import Path

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.core.uncertainty.carried_correlations import carried
from dynamics_cli.errors import UsageError


@pytest.fixture
def skid(tmp_path: Path) -> str:
    """A document whose speed and distance hang together by friction."""
    file = tmp_path / "skid.json"
    argv = ("skid", "speed", "--distance", "60 ± 2 ft", "--friction", "0.7 ± 0.05")
    assert run(*argv, "--json", "--output", str(file)).status == 0
    return str(file)


def back(skid: str, *more: str) -> dict:
    """The friction that speed and distance come from, calculated back from both."""
    argv = ("skid", "friction", "--speed", f"@{skid}:speed", "--distance", f"@{skid}:total_distance")
    return answer(*argv, *more)


def test_calculating_back_gives_the_first_input_again(skid: str) -> None:
    document = back(skid)
    assert document["numerics"]["uncertainty"]["correlations"]["speed,distance"] == pytest.approx(0.425, abs=0.01)
    low, high = document["results"]["friction"]["interval"]
    assert low == pytest.approx(0.7 - 1.96 * 0.05, abs=2e-3)
    assert high == pytest.approx(0.7 + 1.96 * 0.05, abs=2e-3)


def test_taken_as_independent_the_interval_would_be_too_wide(skid: str) -> None:
    """What `--correlate` says goes over what the document says."""
    apart = back(skid, "--correlate", "speed,distance=0")["results"]["friction"]["interval"]
    together = back(skid)["results"]["friction"]["interval"]
    assert apart[1] - apart[0] > 1.1 * (together[1] - together[0])


def test_a_document_as_input_carries_it_too(skid: str, tmp_path: Path) -> None:
    document = json.loads(Path(skid).read_text())
    document["results"]["distance"] = document["results"].pop("total_distance")
    names = document["covariance"]["results"]
    names[names.index("total_distance")] = "distance"
    file = tmp_path / "renamed.json"
    file.write_text(json.dumps(document))
    assert answer("skid", "friction", "--input", str(file))["results"] == back(skid)["results"]


def test_one_result_twice_is_one_number(skid: str) -> None:
    argv = ("skid", "distance", "--speed", f"@{skid}:speed", "--end-speed", f"@{skid}:speed", "--friction", "0.7")
    document = answer(*argv)
    assert document["numerics"]["uncertainty"]["correlations"]["speed,end_speed"] == 1.0
    assert document["results"]["distance"]["value"] == 0.0
    assert "interval" not in document["results"]["distance"] or document["results"]["distance"]["std"] < 1e-9


def test_results_of_different_documents_are_independent(skid: str, tmp_path: Path) -> None:
    other = tmp_path / "other.json"
    other.write_text(Path(skid).read_text())
    argv = ("skid", "friction", "--speed", f"@{skid}:speed", "--distance", f"@{other}:total_distance")
    assert "correlations" not in answer(*argv)["numerics"]["uncertainty"]


def test_rounded_correlations_are_brought_back_to_what_can_be() -> None:
    """Three results of two inputs: their matrix is singular, and six digits of it may be impossible."""
    rng = np.random.default_rng(3)
    mended = 0
    for _ in range(200):
        slopes = rng.normal(size=(4, 2))
        covariance = slopes @ slopes.T
        widths = np.sqrt(np.diag(covariance))
        rounded = np.round(covariance / np.outer(widths, widths), 6)
        entry = {"results": list("abcd"), "correlation": rounded.tolist()}
        found = carried({name: ("file", name, entry) for name in "abcd"}, list("abcd"))
        assert len(found) == 6
        for (one, other), rho in found.items():
            stated = rounded["abcd".index(one), "abcd".index(other)]
            assert rho == pytest.approx(stated, abs=1e-2 * abs(stated) + 1e-12)
            mended += rho != stated
    assert mended > 0


NOT_READABLE = {
    "a list": [1, 2],
    "no names": {"results": None, "correlation": [[1.0]]},
    "names that are none": {"results": [["speed"], {}], "correlation": [[1.0]]},
    "a number for names": {"results": 5, "correlation": [[1.0]]},
    "too few rows": {"results": ["speed", "distance"], "correlation": [[1.0, 0.5]]},
    "rows too short": {"results": ["speed", "distance"], "correlation": [[1.0], [0.5]]},
    "numbers for rows": {"results": ["speed", "distance"], "correlation": [1.0, 0.5]},
    "no correlation": {"results": ["speed", "distance"]},
    "null": {"results": ["speed", "distance"], "correlation": None},
    "more than one": {"results": ["speed", "distance"], "correlation": [[1.0, 7.0], [7.0, 1.0]]},
    "not finite": {"results": ["speed", "distance"], "correlation": [[1.0, "nan"], ["nan", 1.0]]},
    "a list for copies": {"results": ["speed", "distance"], "correlation": [[1, 0], [0, 1]], "same": [1]},
}


@pytest.mark.parametrize("entry", NOT_READABLE.values(), ids=NOT_READABLE)
def test_a_covariance_that_cannot_be_read_is_refused_by_name(skid: str, entry: object) -> None:
    """It was an internal error, or the results counted as independent in silence."""
    document = json.loads(Path(skid).read_text())
    document["results"]["distance"] = document["results"].pop("total_distance")
    document["covariance"] = entry
    Path(skid).write_text(json.dumps(document))
    calls = (
        ("--input", skid),
        ("--speed", f"@{skid}:speed", "--distance", f"@{skid}:distance"),
    )
    for call in calls:
        outcome = run("skid", "friction", *call, "--json")
        assert outcome.status == 2, outcome.err
        assert json.loads(outcome.err)["error"]["code"] == "covariance"
        assert skid in json.loads(outcome.err)["error"]["message"]


def test_correlations_that_contradict_one_another_are_refused() -> None:
    """Three results cannot all be opposite to one another."""
    entry = {"results": list("abc"), "correlation": [[1, -1, -1], [-1, 1, -1], [-1, -1, 1]]}
    with pytest.raises(UsageError, match="contradict"):
        carried({name: ("file", name, entry) for name in "abc"}, list("abc"))


def test_what_is_carried_is_the_nominal_value(skid: str, tmp_path: Path) -> None:
    """One number for one thing: what one document finds is what the next one starts from, whatever its mean is."""
    source = json.loads(Path(skid).read_text())["results"]["speed"]
    assert source["value"] != source["mean"]
    argv = ("skid", "distance", "--speed", f"@{skid}:speed", "--friction", "0.7 ± 0.05")
    document = answer(*argv)
    assert document["inputs"]["speed"]["value"] == source["value"]
    certain = answer("skid", "distance", "--speed", f"{source['value']} {source['unit']}", "--friction", "0.7")
    assert document["results"]["distance"]["value"] == certain["results"]["distance"]["value"]
    again = tmp_path / "again.json"
    again.write_text(json.dumps({"speed": document["inputs"]["speed"]}))
    repeated = answer("skid", "distance", "--input", str(again), "--friction", "0.7 ± 0.05")
    assert repeated["inputs"]["speed"] == document["inputs"]["speed"]
    assert repeated["results"]["distance"]["value"] == document["results"]["distance"]["value"]


def test_a_vector_is_carried_by_its_nominal_components(tmp_path: Path) -> None:
    file = tmp_path / "hit.json"
    argv = ("impact", "oblique", "--first-mass", "2 kg", "--first-velocity", "3 ± 0.3, 1 m/s", "--second-mass", "3 kg",
            "--second-velocity", "-1, 0 m/s", "--normal", "10 ± 4 deg", "--restitution", "0.5 ± 0.1")  # fmt: skip
    assert run(*argv, "--json", "--output", str(file)).status == 0
    source = json.loads(file.read_text())["results"]["first"]["velocity"]
    document = answer("impact", "oblique", "--first-mass", "2 kg", "--first-velocity", f"@{file}:first.velocity",
                      "--second-fixed", "--normal", "180 deg", "--restitution", "0.5")  # fmt: skip
    assert document["inputs"]["first"]["velocity"]["value"] == source["value"]
