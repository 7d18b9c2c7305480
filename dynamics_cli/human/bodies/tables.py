"""Published tables of body segments: masses, mass centres and radii of gyration, with where each comes from.

Shares are of the body's mass; centroids and radii are shares of the segment's own length, centroids from its first end.
"""

from dynamics_cli.records import Choice, record

PAIRS = ("upper arm", "forearm", "hand", "thigh", "shank", "foot", "shoulder")


class Sex(Choice):
    """Whose table."""

    names = ("male", "female")
    aliases = {"m": "male", "f": "female", "man": "male", "woman": "female", "men": "male", "women": "female"}  # noqa: RUF012


class SegmentTable(Choice):
    """A published table."""

    names = ("de-leva", "dempster-winter", "dempster", "zatsiorsky")
    aliases = {  # noqa: RUF012
        "deleva": "de-leva", "leva": "de-leva", "winter": "dempster-winter", "zatsiorsky-seluyanov": "zatsiorsky",
    }  # fmt: skip


SOURCES = {
    "de-leva": "de Leva 1996, table 4, as in BMClab/BMC, BSP{sex}_ZdeLeva.txt",
    "dempster-winter": "Dempster 1955 adapted by Winter 2009, as in BMClab/BMC, BSP_DempsterWinter.txt",
    "dempster": "Dempster 1955, as in wspr/body-segment-param, dempster1955.csv",
    "zatsiorsky": "regression of Zatsiorsky and Seluyanov, as in wspr/body-segment-param, zats2-M-mass.csv",
}
SAMPLES = {
    "de-leva": {"male": "100 young men", "female": "15 young women"},
    "dempster-winter": {"": "8 cadavers of men"},
    "dempster": {"": "8 cadavers of men"},
    "zatsiorsky": {"": "100 young men"},
}


@record
class Segment:
    """One segment of a table: its ends, its share of the mass, and where its mass is, as shares of its length."""

    name: str
    ends: str
    share: float
    centroid: "float | None" = None
    front_back: "float | None" = None
    left_right: "float | None" = None
    lengthwise: "float | None" = None

    @property
    def count(self) -> int:
        """How many of it a body has."""
        return 2 if self.name in PAIRS else 1


def plain_name(text: str) -> str:
    """A name as typed in any case, with hyphens or underscores for spaces."""
    return " ".join(text.lower().replace("_", " ").replace("-", " ").split())


def _percent(name: str, ends: str, *numbers: float) -> Segment:
    # rounded again, to the double nearest to the decimals of the share
    return Segment(name, ends, *[round(number / 100.0, 6) for number in numbers])


# mass, centroid, radii about the front-back, left-right and long axes, in percent; by sex
DE_LEVA = {
    sex: tuple(_percent(name, ends, *numbers[at]) for name, ends, *numbers in (
        ("head", "vertex-gonion", (6.68, 58.94, 33.0, 35.9, 31.8), (6.94, 59.76, 36.2, 37.6, 31.2)),
        ("head", "vertex-cervicale", (6.68, 48.41, 27.1, 29.5, 26.1), (6.94, 50.02, 30.3, 31.5, 26.1)),
        ("trunk", "suprasternale-hip", (42.57, 41.51, 35.7, 33.9, 17.1), (43.46, 44.86, 37.2, 34.7, 19.1)),
        ("trunk", "cervicale-hip", (42.57, 49.64, 30.7, 29.2, 14.7), (43.46, 51.38, 32.8, 30.6, 16.9)),
        ("trunk", "shoulder-hip", (42.57, 37.82, 37.9, 36.1, 18.2), (43.46, 43.10, 38.4, 35.8, 19.7)),
        ("upper trunk", "suprasternale-xiphion", (15.45, 20.77, 74.6, 50.2, 71.8), (15.96, 29.99, 71.6, 45.4, 65.9)),
        ("middle trunk", "xiphion-omphalion", (14.65, 45.12, 43.3, 35.4, 41.5), (16.33, 45.02, 48.2, 38.3, 46.8)),
        ("lower trunk", "omphalion-hip", (12.47, 49.20, 43.3, 40.2, 44.4), (11.17, 61.15, 61.5, 55.1, 58.7)),
        ("upper arm", "shoulder-elbow", (2.55, 57.54, 27.8, 26.0, 14.8), (2.71, 57.72, 28.5, 26.9, 15.8)),
        ("forearm", "elbow-wrist", (1.38, 45.59, 26.1, 25.7, 9.4), (1.62, 45.74, 27.6, 26.5, 12.1)),
        ("hand", "wrist-knuckle", (0.56, 74.74, 53.1, 45.4, 33.5), (0.61, 79.00, 62.8, 51.3, 40.1)),
        ("hand", "wrist-fingertip", (0.56, 34.27, 24.4, 20.8, 15.4), (0.61, 36.24, 28.8, 23.5, 18.4)),
        ("thigh", "hip-knee", (14.78, 36.12, 36.9, 36.4, 16.2), (14.16, 40.95, 32.9, 32.9, 14.9)),
        ("shank", "knee-ankle", (4.81, 43.52, 26.7, 26.3, 9.2), (4.33, 43.95, 25.1, 24.6, 10.2)),
        ("foot", "heel-toe", (1.29, 40.14, 29.9, 27.9, 13.9), (1.37, 44.15, 25.7, 24.5, 12.4)),
    ))
    for at, sex in enumerate(("female", "male"))
}  # fmt: skip

# mass, centroid from the proximal end, radius about the centroid
DEMPSTER_WINTER = tuple(
    Segment(name, "proximal-distal", share, centroid, None, radius)
    for name, share, centroid, radius in (
        ("head and neck", 0.081, 1.0, 0.495), ("thorax", 0.216, 0.82, None), ("abdomen", 0.139, 0.44, None),
        ("pelvis", 0.142, 0.105, None), ("upper arm", 0.028, 0.436, 0.322), ("forearm", 0.016, 0.430, 0.303),
        ("hand", 0.006, 0.506, 0.297), ("thigh", 0.100, 0.433, 0.323), ("shank", 0.0465, 0.433, 0.302),
        ("foot", 0.0145, 0.5, 0.475),
    )
)  # fmt: skip

DEMPSTER = tuple(
    Segment(name, "", round(share / 100.0, 6))
    for name, share in (
        ("chest", 11.0), ("abdomen and pelvis", 26.4), ("head and neck", 7.9), ("shoulder", 5.15), ("upper arm", 2.65),
        ("forearm", 1.55), ("hand", 0.6), ("thigh", 9.65), ("shank", 4.5), ("foot", 1.4),
    )
)  # fmt: skip

# kilograms: a constant, per kilogram of mass, per centimetre of height
ZATSIORSKY = (
    ("head", 1.296, 0.0171, 0.0143), ("thorax", 8.2144, 0.1862, -0.0584), ("abdomen", 7.181, 0.2234, -0.0663),
    ("pelvis", -7.498, 0.0976, 0.04896), ("upper arm", 0.250, 0.03012, -0.0027), ("forearm", 0.3185, 0.01445, -0.00114),
    ("hand", -0.1165, 0.0036, 0.00175), ("thigh", -2.649, 0.1463, 0.0137), ("shank", -1.592, 0.0362, 0.0121),
    ("foot", -0.829, 0.0077, 0.0073),
)  # fmt: skip
