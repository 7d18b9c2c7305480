"""Inputs at the edge of what a calculation takes: answered, said once, and named by what was written."""

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.core.uncertainty.model import TaskModel
from dynamics_cli.impact.particles.hunt_crossley import shape
from dynamics_cli.sampling import Drawing

CENTRAL = ["impact", "central", "--first-mass", "1 kg", "--first-velocity", "1 m/s", "--second-mass", "1 kg"]


@pytest.mark.parametrize("restitution", ["1e-300", "1e-41", "5e-324"])
def test_a_restitution_may_be_as_small_as_it_likes(restitution: str) -> None:
    first = answer(*CENTRAL, "--restitution", restitution, "--units", "base")["results"]["first"]
    assert first["velocity"]["value"] == 0.5


def test_a_refused_rebound_is_told_apart_from_the_drop() -> None:
    refused = run("impact", "drop", "--height", "1 m", "--rebound-height", "1.0000001 m", "--json")
    assert refused.error["message"] == "a rebound to 1.0000001 m from a drop of 1 m would give energy"


def test_a_body_that_never_rests_is_said_once() -> None:
    warnings = answer("impact", "drop", "--height", "1 m", "--rebound-height", "1 m")["warnings"]
    assert [one["code"] for one in warnings].count("no-rest") == 1


def test_many_segments_carry_no_slopes_and_keep_their_bounds() -> None:
    """2,000 segments took the square of their number; v = √(2 g μ s) of their sum."""
    segments = [part for _ in range(2000) for part in ("--segment", "distance=0.01 m, friction=0.7")]
    document = answer("skid", "speed", *segments, "--units", "base")
    assert document["results"]["speed"]["value"] == pytest.approx((2.0 * 9.80665 * 0.7 * 20.0) ** 0.5, rel=1e-12)
    assert document["numerics"]["error_bound"]["speed"]["relative"] < 1e-12
    assert not document["numerics"].get("condition")


def test_a_model_asked_for_no_points_gives_none() -> None:
    model = TaskModel.__new__(TaskModel)
    model.names = ["speed"]
    results, refused = model({"friction": np.empty(0)})
    assert results["speed"].size == 0
    assert refused is None


def test_samples_of_a_lossy_contact_are_those_of_single_cases() -> None:
    """A sample took a millisecond a point: over a minute for `--restitution "1±2" --hunt-crossley`."""
    values = np.linspace(0.1, 1.0, 41)
    with Drawing():
        sampled = np.array(shape(values))  # type: ignore[arg-type]
    single = np.array([shape(value) for value in values.tolist()]).T
    assert sampled == pytest.approx(single, rel=1e-11)


def test_a_sum_of_millimetres_is_told_in_millimetres() -> None:
    call = ["impact", "oblique", "--first-mass", "1 kg", "--first-velocity", "3, 0 m/s", "--second-mass", "1 kg"]
    radii = ["--first-radius", "28.6 mm", "--second-radius", "28.6 mm"]
    outcome = run(*call, *radii, "--offset", "58 mm", "--restitution", "0.94", "--json")
    assert outcome.error["message"] == "no impact: an offset of 58 mm passes spheres whose radii sum to 57.2 mm"
