"""The tables of body segments: sums, ratios between ends, consistency, and transcription errors that were met."""

import math

import pytest
from harness import answer, run

from dynamics_cli.human.bodies.tables import DE_LEVA, DEMPSTER, DEMPSTER_WINTER, Segment

# Printed radii have two or three digits.
RATIO_DIGITS = 0.011
# Of Dempster's table as adapted by Winter: segments taken together, as shares of the body.
COMPOUNDS = {
    "forearm and hand": 0.022, "whole arm": 0.050, "shank and foot": 0.061, "whole leg": 0.161, "trunk": 0.497,
    "trunk, head and neck": 0.578, "head, arms and trunk": 0.678,
}  # fmt: skip


def rows(sex: str, name: str) -> dict[str, Segment]:
    return {row.ends: row for row in DE_LEVA[sex] if row.name == name}


@pytest.mark.parametrize(("sex", "whole"), [("male", 1.0), ("female", 0.9999)])
def test_de_leva_adds_up_to_the_body(sex: str, whole: float) -> None:
    parts = ("head", "trunk", "upper arm", "forearm", "hand", "thigh", "shank", "foot")
    shares = {row.name: row.count * row.share for row in DE_LEVA[sex]}
    assert math.isclose(sum(shares[name] for name in parts), whole, abs_tol=1e-12)
    trunk = sum(share for name, share in shares.items() if name.endswith(" trunk"))
    assert math.isclose(trunk, shares["trunk"], abs_tol=1e-12)


@pytest.mark.parametrize("sex", ["male", "female"])
@pytest.mark.parametrize(
    ("name", "one", "other"),
    [
        ("head", "vertex-gonion", "vertex-cervicale"),
        ("trunk", "suprasternale-hip", "cervicale-hip"),
        ("trunk", "suprasternale-hip", "shoulder-hip"),
        ("hand", "wrist-knuckle", "wrist-fingertip"),
    ],
)
def test_radii_and_centroids_scale_alike_between_two_pairs_of_ends(sex: str, name: str, one: str, other: str) -> None:
    first, second = rows(sex, name)[one], rows(sex, name)[other]
    radii = [
        getattr(first, axis) / getattr(second, axis) for axis in ("front_back", "left_right", "lengthwise")
    ]  # fmt: skip
    # the trunk's pairs share their lower end, the others their first
    places = [row.centroid or 0.0 for row in (first, second)]
    if name == "trunk":
        places = [1.0 - place for place in places]
    ratios = [*radii, places[0] / places[1]]
    assert max(ratios) / min(ratios) - 1.0 < RATIO_DIGITS * 2.0


def test_the_ratios_find_a_misprint() -> None:
    """A public page has 63.1 for the female hand's radius, where the others say 53.1."""
    hand = rows("female", "hand")
    long, short = hand["wrist-knuckle"], hand["wrist-fingertip"]
    assert long.left_right is not None
    assert short.left_right is not None
    assert short.front_back is not None
    assert abs(0.631 / short.front_back / (long.left_right / short.left_right) - 1.0) > 0.15


def test_dempster_and_winter_add_up_both_ways() -> None:
    assert math.isclose(sum(row.count * row.share for row in DEMPSTER_WINTER), 1.0, abs_tol=1e-12)
    share = {row.name: row.share for row in DEMPSTER_WINTER} | COMPOUNDS
    assert math.isclose(2 * share["whole arm"] + 2 * share["whole leg"] + share["trunk, head and neck"], 1.0)
    assert math.isclose(share["head, arms and trunk"], share["trunk, head and neck"] + 2 * share["whole arm"])
    assert math.isclose(share["whole leg"], share["thigh"] + share["shank and foot"])
    assert math.isclose(share["shank and foot"], share["shank"] + share["foot"])
    assert math.isclose(share["whole arm"], share["upper arm"] + share["forearm and hand"])
    assert math.isclose(share["trunk"], share["thorax"] + share["abdomen"] + share["pelvis"])


def test_winters_head_about_its_neck_is_misprinted() -> None:
    """The transcription prints 0.116 about the proximal end; radius and centroid give √(0.495² + 1²)."""
    head = DEMPSTER_WINTER[0]
    assert head.left_right is not None
    assert head.centroid is not None
    assert math.isclose(math.hypot(head.left_right, head.centroid), 1.116, abs_tol=5e-4)


def test_dempster_lost_mass() -> None:
    assert math.isclose(sum(row.count * row.share for row in DEMPSTER), 0.963, abs_tol=1e-12)
    made = answer("human", "segments", "--mass", "100 kg", "--segment-table", "dempster", "--normalise")
    head = made["results"]["segments"][2]
    assert math.isclose(head["mass"]["value"], 8.20353063343717549325)
    assert "0.963" in run("human", "segments", "--mass", "100 kg", "--segment-table", "dempster", "--normalise").out


def test_a_table_with_a_head_ten_times_too_heavy_is_refused() -> None:
    table = [("head", 0.694, 1), ("trunk", 0.4346, 1), ("upper arm", 0.0271, 2), ("forearm", 0.0162, 2),
             ("hand", 0.0061, 2), ("thigh", 0.1416, 2), ("shank", 0.0433, 2), ("foot", 0.0137, 2)]  # fmt: skip
    options = [
        word for name, share, count in table
        for word in ("--custom-segment", f"name={name}, share={share}, count={count}")
    ]  # fmt: skip
    out = run("human", "segments", "--mass", "75 kg", *options, "--json")
    assert out.status == 3
    assert out.error["code"] == "table-sum"
    assert "121.845 kg" in out.error["message"]


def test_masses_by_regression() -> None:
    made = answer("human", "segments", "--mass", "80 kg", "--height", "1.80 m", "--segment-table", "zatsiorsky")
    assert math.isclose(made["results"]["mass"]["value"], 80.145)
    made = answer("human", "segments", "--mass", "60 kg", "--height", "165 cm", "--segment-table", "zatsiorsky")
    assert math.isclose(made["results"]["mass"]["value"], 60.1155)
