"""The proof proved: points and accelerations against 60 digits, what is stated against what is, and wrong pieces."""

import random
import sys
from math import atan, pi
from pathlib import Path as FilePath

import numpy as np
import pytest
from geometry_cases import CYCLE, NOTHING, SWING
from mpmath import diff, mp, mpc, mpf
from references import generate_cam_motion_references as motion_references

from dynamics_cli.cam.export.export import export
from dynamics_cli.cam.export.path import Path
from dynamics_cli.cam.export.records import Curve, Form
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.fitting.deviation import proved
from dynamics_cli.numerics.fitting.pieces import controls, fit
from dynamics_cli.outlines import Arc, Cubic

sys.path.insert(0, str(FilePath(__file__).resolve().parents[1] / "references"))

from cam_envelope import Carried
from digits import MPMATH
from taylor import of_numbers

JOINED = [name for name in motion_references.LAWS if name != "linear" and not name.startswith("half")]
FOLLOWERS = {
    "knife": (followers.KnifeEdge(0.04, 0.01), "mm"),
    "roller": (followers.Roller(0.035, 0.008, -0.009), "mm"),
    "flat": (followers.FlatFace(0.08), "mm"),
    "arm": (followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1), "deg"),
    "rocker": (followers.OscillatingFlat(0.03, 0.09, 0.006), "deg"),
    "mate": (followers.ConjugateRoller(0.03, 0.008, 0.09, 0.004), "mm"),
    "mate arm": (followers.ConjugateOscillatingRoller(0.03, 0.008, 0.08, 0.1, 1.1), "deg"),
}


# a rocker whose curve runs backwards: no drawing is made of it
UNDERCUT = ("rise 9 deg in 86 deg gutman-1-3; dwell 40 deg; return in 75 deg 3-4-5; dwell",)


class Exact:
    """A cam in 60 digits: programs of a rise and a return with dwells, and the envelope by its definition."""

    def __init__(self, follower, unit, up, down, *, turn=1, side=1, away=0.0, angle=0.0) -> None:
        mp.dps = 60
        (self.rise, law_up), (self.fall, law_down) = up, down
        self.amount = 9
        self.laws = (motion_references.LAWS[law_up], motion_references.LAWS[law_down])
        self.program = (
            f"rise 9 {unit} in {self.rise} deg {law_up}; dwell 40 deg; return in {self.fall} deg {law_down}; dwell"
        )
        self.size = mpf(9) / 1000 if unit == "mm" else mpf(9) * mp.pi / 180
        tree = {"record": type(follower).__name__} | {key: repr(getattr(follower, key)) for key in follower.fields}
        self.carried = Carried(tree, turn, side, MPMATH)
        self.away, self.angle = mpf(away), mpf(angle)
        self.geometry = Geometry(follower, "ccw" if turn > 0 else "cw", "inner" if side > 0 else "outer")
        self.path = Path(self.geometry, motion_of(NOTHING, self.program), away=away, start_angle=angle)

    def lift(self, theta):
        degrees = theta * 180 / mp.pi
        if degrees < self.rise:
            return self.size * self.laws[0](degrees / self.rise)[0]
        degrees -= self.rise + 40
        if degrees < 0:
            return self.size + 0 * theta
        if degrees < self.fall:
            return self.size * (1 - self.laws[1](degrees / self.fall)[0])
        return 0 * theta

    def point(self, theta):
        z, n = self.carried.point(of_numbers(self.lift), theta)
        z = z + n * self.away
        return mpc(z.real, z.imag) * mp.exp(1j * self.angle)


def cams(seeds: int):
    for name, (follower, unit) in FOLLOWERS.items():
        for seed in range(seeds):
            chance = random.Random(f"{name} {seed}")
            up, down = ((chance.randint(60, 120), chance.choice(JOINED)) for _ in range(2))
            side = -1 if name == "roller" and seed % 2 else 1
            away = 0.0 if seed % 2 == 0 or name in ("flat", "rocker") else 0.007 * side
            yield name, Exact(follower, unit, up, down, turn=chance.choice((1, -1)), side=side, away=away, angle=0.3)


def inside(path: Path, piece: int, chance: random.Random) -> tuple[float, float]:
    """A cell within a piece of the motion: its middle and its half width."""
    low, high = float(path.starts[piece]), float(path.ends[piece])
    half = 0.45 * (high - low) * 10.0 ** chance.uniform(-7, -0.3)
    return chance.uniform(low + half * 1.1, high - half * 1.1), half


def test_points_and_accelerations_hold_against_sixty_digits() -> None:
    ratios = []
    for name, cam in cams(3):
        chance = random.Random(name)
        moving = np.flatnonzero(~cam.path.still)
        for piece in (int(chance.choice(moving)) for _ in range(2)):
            middle, half = inside(cam.path, piece, chance)
            theta = mpf(middle) + mpf(half) * mpf(chance.uniform(-0.99, 0.99))
            bend, fast = (float(part[0]) for part in cam.path.acceleration(np.array([middle]), np.array([half]), piece))
            speed, turned = abs(diff(cam.point, theta)), abs(diff(cam.point, theta, 2))
            assert speed <= fast, (name, piece, middle, half)
            assert turned <= bend, (name, piece, middle, half)
            # and at a place they say what it is
            alone, swift = (float(part[0]) for part in cam.path.acceleration(np.array([middle]), np.zeros(1), piece))
            exact = abs(diff(cam.point, mpf(middle), 2))
            assert exact <= alone <= exact * (1 + mpf("1e-9")) + mpf("1e-12")
            ratios.append(bend / alone if half < 1e-3 else 1.0)
            x, y = cam.path.points(np.array([middle]), piece)
            z = cam.point(mpf(middle))
            for value, disc in ((z.real, x), (z.imag, y)):
                assert abs(value - float(disc.centre[0])) <= float(disc.radius[0]) <= 1e-13, (name, piece)
            assert swift >= abs(diff(cam.point, mpf(middle)))
    assert max(ratios) < 1.5


def own_pieces(path: Path, form: str, tolerance: float):
    """What the export proves: for every piece of the motion its places, shape and points."""
    for index, places, shape in fit(path, form, tolerance):
        on = path.on(index)
        if form == "cubics":
            shape = np.stack([part[:, 1:3] for part in controls(on, places, shape)], axis=2)
        yield index, places, shape, np.stack(on.at(places)[:2], axis=1)


def nearest(piece, z):
    """Distance of a point from an arc or a cubic, in 60 digits."""
    if isinstance(piece, Arc):
        p, q, b = mpc(*piece.start), mpc(*piece.end), mpf(piece.bulge)
        if not b:
            share = min(max(((z - p) / (q - p)).real, mpf(0)), mpf(1))
            return abs(z - p - share * (q - p))
        centre = (p + q) / 2 + 1j * (q - p) * (1 / b - b) / 4
        swept = mp.arg((z - centre) / (p - centre)) * mp.sign(b)
        if 0 <= swept % (2 * mp.pi) <= 4 * mp.atan(abs(b)):
            return abs(abs(z - centre) - abs(p - centre))
        return min(abs(z - p), abs(z - q))
    c = [mpc(*point) for point in (piece.start, piece.control1, piece.control2, piece.end)]
    best = min(range(65), key=lambda i: abs(complex(_cubic(c, mpf(i) / 64) - z)))
    t = mpf(best) / 64
    for _ in range(7):
        d = 3 * ((c[1] - c[0]) * (1 - t) ** 2 + 2 * (c[2] - c[1]) * t * (1 - t) + (c[3] - c[2]) * t * t)
        t = min(max(t + ((z - _cubic(c, t)) / d).real, mpf(0)), mpf(1))
    return abs(z - _cubic(c, t))


def _cubic(c, t):
    u = 1 - t
    return c[0] * u**3 + 3 * c[1] * u * u * t + 3 * c[2] * u * t * t + c[3] * t**3


@pytest.mark.parametrize("form", ["arcs", "cubics", "lines"])
@pytest.mark.parametrize("tolerance", [1e-5, 1e-9])
def test_what_is_stated_covers_what_is_in_sixty_digits(form: str, tolerance: float) -> None:
    if form == "lines":
        tolerance = max(tolerance, 1e-7)
    for name, cam in cams(2):
        if cam.away or cam.carried.kind.startswith("Conjugate") or cam.program in UNDERCUT:
            continue
        rotation = followers.Rotation("cw" if cam.geometry.turn < 0 else "ccw")
        flank = followers.Flank("outer" if cam.geometry.side < 0 else "inner")
        made = export(NOTHING, program=cam.program, follower=cam.geometry.follower, form=Form(form),
                      rotation=rotation, tolerance=tolerance, flank=flank, start_angle=0.3)  # fmt: skip
        assert made.deviation <= tolerance
        pieces = list(made.shape.outlines[0].pieces)
        if form == "lines":
            pieces = [Arc(a, b, 0.0) for run in pieces for a, b in zip(run.points, run.points[1:], strict=False)]
        chance = random.Random(f"{name} {form}")
        worst = mpf(0)
        for _ in range(10):
            theta = mpf(chance.uniform(0.01, 6.27))
            z = cam.point(theta)
            near = sorted(pieces, key=lambda one: abs(complex(*one.start) - complex(z)))[:4]
            before = [pieces[pieces.index(one) - 1] for one in near]
            worst = max(worst, min(nearest(one, z) for one in near + before))
        assert worst <= mpf(made.deviation)
        assert worst > 0.01 * made.deviation


def wrong_arcs(bulges, points, off: float):
    """Displaced, bent otherwise, the other way round, and with ends that are not on the curve."""
    yield "the other arc of the same circle", -1.0 / bulges, points
    yield "bent to the other side", -bulges, points
    yield "flatter", bulges + 4.0 * off / np.hypot(*np.diff(points, axis=0).T), points
    yield "moved aside", bulges, points + (off, 0.0)
    yield "turned", bulges, points @ np.array([[1.0, 1e-3], [-1e-3, 1.0]])
    wrong = points.copy()
    wrong[1:-1:2] += (0.7 * off, 0.8 * off)
    yield "one end displaced", bulges, wrong
    yield "backwards", bulges, points[::-1]
    yield "one place on", np.roll(bulges, 1), np.roll(points, 1, axis=0)


@pytest.mark.parametrize("tolerance", [1e-5, 1e-8])
def test_displaced_arcs_are_not_accepted(tolerance: float) -> None:
    path = Path(Geometry(followers.Roller(0.025, 0.006)), motion_of(NOTHING, CYCLE), away=0.0)
    for index, places, bulges, points in own_pieces(path, "arcs", 0.96 * tolerance):
        right = proved(path, index, places, bulges, "arcs", points, tolerance)
        assert right.max() <= tolerance
        if path.still[index]:
            continue
        for name, shape, ends in wrong_arcs(bulges, points, 3.0 * tolerance):
            assert proved(path, index, places, shape, "arcs", ends, tolerance).max() > 1.5 * tolerance, (index, name)


@pytest.mark.parametrize("tolerance", [1e-5, 1e-8])
def test_displaced_cubics_are_not_accepted(tolerance: float) -> None:
    path = Path(Geometry(followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1)), motion_of(NOTHING, SWING), away=0.0)
    chance = random.Random(3)
    for index, places, inner, points in own_pieces(path, "cubics", 0.9 * tolerance):
        assert proved(path, index, places, inner, "cubics", points, tolerance).max() <= tolerance
        for _ in range(6):
            # a cubic moves by 4/9 of what one of its inner control points moves by
            wrong, which = inner.copy(), chance.randrange(inner.shape[0])
            side = points[which + 1] - points[which]
            normal = np.array([-side[1], side[0]]) / np.hypot(*side)
            wrong[which, chance.randrange(2)] += 9.0 * tolerance * chance.choice((-1, 1)) * normal
            found = proved(path, index, places, wrong, "cubics", points, tolerance)
            assert found[which] > 2.0 * tolerance
            assert (np.delete(found, which) <= tolerance).all()
        assert proved(path, index, places, inner[:, ::-1], "cubics", points, tolerance).max() > tolerance
        for shifted in (places + 1e3 * tolerance, places[::-1] * 1.0):
            if (np.diff(shifted) > 0.0).all():
                assert proved(path, index, shifted, inner, "cubics", points, tolerance).max() > tolerance


@pytest.mark.parametrize(
    ("program", "follower", "form", "rotation"),
    [
        ("rise 9 mm in 63 deg trapezoid; dwell 40 deg; return in 71 deg cycloidal; dwell", followers.FlatFace(0.08),
         "arcs", "cw"),
        ("rise 9 mm in 114 deg 5-6-7-8-9; dwell 40 deg; return in 92 deg modified-trapezoid; dwell",
         followers.Roller(0.035, 0.008, -0.009), "cubics", "ccw"),
    ],
)  # fmt: skip
def test_curves_on_which_equal_errors_never_settle(program: str, follower, form: str, rotation: str) -> None:
    for tolerance in (1e-9, 3e-9, 1e-8):
        for angle in (0.0, 0.3):
            made = export(NOTHING, program=program, follower=follower, form=Form(form), tolerance=tolerance,
                          rotation=followers.Rotation(rotation), start_angle=angle)  # fmt: skip
            assert made.deviation <= tolerance
            assert made.pieces < (900 if form == "arcs" else 90)


def test_a_small_displacement_is_counted_as_what_it_is() -> None:
    path = Path(Geometry(followers.FlatFace(0.05)), motion_of(NOTHING, CYCLE), away=0.0)
    for index, places, bulges, points in own_pieces(path, "arcs", 1e-9):
        right = proved(path, index, places, bulges, "arcs", points, 1e-9)
        for off in (1e-8, 1e-6):
            found = proved(path, index, places, bulges, "arcs", points + (off, 0.0), 1e-9)
            assert (found <= right + 1.001 * off).all()
            assert (found >= 0.2 * off).any()


HARD = {
    "a span of a millionth of a radian": (
        "rise 1e-12 mm in 5.7e-5 deg cycloidal; dwell 90 deg; return in 90 deg cycloidal; dwell",
        followers.Roller(0.03, 0.004), 1e-9,
    ),
    "a lift of a nanometre": (
        "rise 1e-6 mm in 0.1 deg 3-4-5; dwell 100 deg; return in 100 deg harmonic; dwell",
        followers.Roller(0.03, 0.004), 1e-9,
    ),
    "hardly a base circle": (
        "rise 10 mm in 180 deg cycloidal; return in 180 deg cycloidal", followers.KnifeEdge(1e-4), 1e-7
    ),
    "a roller nearly as large as the radius of curvature": (CYCLE, followers.Roller(0.02, 0.0122), 1e-6),
    "an arm near the limit of its triangle": (SWING, followers.OscillatingRoller(0.012, 0.0081, 0.08, 0.1), 1e-6),
    "a micrometre of tolerance in a metre": (CYCLE, followers.Roller(1.0, 0.1), 1e-6),
    "a tolerance near rounding": (CYCLE, followers.Roller(0.025, 0.006), 1e-12),
}  # fmt: skip


@pytest.mark.parametrize("name", HARD)
def test_hard_cams(name: str) -> None:
    program, follower, tolerance = HARD[name]
    form = Form("cubics")
    made = export(NOTHING, program=program, follower=follower, form=form, tolerance=tolerance)
    assert made.deviation <= tolerance
    motion, geometry = motion_of(NOTHING, program), Geometry(follower)
    path = Path(geometry, motion, away=0.0)
    cubics = made.shape.outlines[0].pieces
    starts = np.array([one.start for one in cubics])
    share = (np.arange(40) + 0.5) / 40
    theta = np.concatenate([a + (b - a) * share for a, b in zip(path.starts, path.ends, strict=True)])
    x, y = path.at(theta)[:2]
    for px, py in zip(x.tolist(), y.tolist(), strict=True):
        near = np.argsort(np.hypot(starts[:, 0] - px, starts[:, 1] - py))[:3].tolist()
        tried = {index % len(cubics) for i in near for index in (i - 1, i)}
        # the points themselves are rounded
        assert min(nearest(cubics[i], mpc(px, py)) for i in tried) <= mpf(made.deviation) + mpf(2e-15) * abs(
            px + 1j * py
        )


@pytest.mark.parametrize("seed", range(24))
def test_programs_of_all_laws_and_followers(seed: int) -> None:
    chance = random.Random(seed)
    name = chance.choice(list(FOLLOWERS))
    follower, unit = FOLLOWERS[name]
    laws = [*JOINED, "scca 0.2 0.5 0.3", "polynomial degree 7"]
    up, down = chance.choice(laws[:-2]), chance.choice(laws[:-2])
    program = (
        f"rise {chance.uniform(4, 9):.3f} {unit} in {chance.randint(70, 130)} deg {up}; dwell {chance.randint(1, 60)} "
        f"deg; return in {chance.randint(70, 130)} deg {down}; dwell"
    )
    form = Form(chance.choice(("arcs", "cubics")))
    curve = Curve(chance.choice(("cam", "pitch")))
    try:
        made = export(NOTHING, program=program, follower=follower, form=form, curve=curve, tolerance=1e-7)
    except InadmissibleError as error:
        if error.code not in ("undercut", "face-too-fast", "pivot-inside"):
            raise
        return
    assert made.deviation <= 1e-7
    geometry = Geometry(follower)
    away = geometry.roller if curve == "pitch" else 0.0
    path = Path(geometry, motion_of(NOTHING, program), away=away)
    pieces = made.shape.outlines[0].pieces
    starts = np.array([one.start for one in pieces])
    x, y = path.at(np.array([chance.uniform(0, 2 * pi) for _ in range(60)]))[:2]
    for px, py in zip(x.tolist(), y.tolist(), strict=True):
        near = np.argsort(np.hypot(starts[:, 0] - px, starts[:, 1] - py))[:3].tolist()
        tried = {index % len(pieces) for i in near for index in (i - 1, i)}
        assert min(nearest(pieces[i], mpc(px, py)) for i in tried) <= made.deviation + 1e-15
    sweeps = [4.0 * atan(abs(one.bulge)) for one in pieces if isinstance(one, Arc)]
    assert sum(sweeps) < 20.0
    assert all(isinstance(one, Arc | Cubic) for one in pieces)
