"""Files of cams read back by a small reader of their own and measured against the exact curve."""

from math import hypot, pi, radians
from pathlib import Path

import numpy as np
import pytest
from geometry_cases import CYCLE, KINDS, NOTHING, STEEP, SWING, SWINGING, random_follower, random_program
from harness import run
from search_length import EVALUATIONS

from dynamics_cli.cam.export.export import export
from dynamics_cli.cam.export.path import Path as CamPath
from dynamics_cli.cam.export.records import Curve, Form
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.errors import DynamicsError, InadmissibleError
from dynamics_cli.outlines import Arc, Cubic

ROLLER = followers.Roller(0.025, 0.006)
WORDS = ("--follower", "roller", "--base-radius", "25 mm", "--roller-radius", "6 mm", "--program", CYCLE)


def pairs(text: str) -> list[tuple[int, str]]:
    lines = text.splitlines()
    return [(int(code), value.strip()) for code, value in zip(lines[::2], lines[1::2], strict=True)]


def entities(text: str) -> list[tuple[str, list[tuple[int, str]]]]:
    """The entities section of a DXF, each as its type and its group codes."""
    found: list[tuple[str, list[tuple[int, str]]]] = []
    inside = False
    for code, value in pairs(text):
        if (code, value) == (2, "ENTITIES"):
            inside = True
        elif (code, value) == (0, "ENDSEC"):
            inside = False
        elif inside and code == 0:
            found.append((value, []))
        elif inside and found:
            found[-1][1].append((code, value))
    return found


def read_dxf(text: str) -> list[tuple]:
    """Pieces of a DXF in millimetres: ("arc", p, q, bulge) and ("cubic", four points)."""
    pieces: list[tuple] = []
    for kind, codes in entities(text):
        if kind == "LWPOLYLINE":
            closed = any(code == 70 and int(value) & 1 for code, value in codes)
            vertices: list[list[float]] = []
            for code, value in codes:
                if code == 10:
                    vertices.append([float(value), 0.0, 0.0])
                elif code == 20:
                    vertices[-1][1] = float(value)
                elif code == 42:
                    vertices[-1][2] = float(value)
            last = len(vertices) if closed else len(vertices) - 1
            for i in range(last):
                p, q = vertices[i], vertices[(i + 1) % len(vertices)]
                pieces.append(("arc", (p[0], p[1]), (q[0], q[1]), p[2]))
        elif kind == "SPLINE":
            x = [float(value) for code, value in codes if code == 10]
            y = [float(value) for code, value in codes if code == 20]
            points = list(zip(x, y, strict=True))
            # knots of multiplicity three: neighbouring cubics share a point
            pieces += [("cubic", *points[i : i + 4]) for i in range(0, len(points) - 1, 3)]
    return pieces


def points_of(piece: tuple, count: int = 60) -> np.ndarray:
    """Points along a piece, the arc by its centre and angles."""
    t = np.linspace(0.0, 1.0, count)
    if piece[0] == "cubic":
        p = np.array(piece[1:])
        b = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3])
        return b.T @ p
    (x0, y0), (x1, y1), bulge = piece[1:]
    if bulge == 0.0:
        return np.stack((x0 + (x1 - x0) * t, y0 + (y1 - y0) * t), axis=1)
    # by a rational quadratic: no centre, no cancellation
    sweep = 4.0 * np.arctan(bulge)
    mx, my = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    ux, uy = 0.5 * (x1 - x0), 0.5 * (y1 - y0)
    away = (1.0 / bulge - bulge) / 2.0
    cx, cy = mx - away * uy, my + away * ux
    start = np.arctan2(y0 - cy, x0 - cx)
    radius = hypot(x0 - cx, y0 - cy)
    return np.stack((cx + radius * np.cos(start + sweep * t), cy + radius * np.sin(start + sweep * t)), axis=1)


def distance_from(points: np.ndarray, geometry: Geometry, motion, away: float = 0.0, angle: float = 0.0) -> float:
    """Greatest distance of points from the exact curve: nearest of 20,000 points, then Newton for the foot."""
    path = CamPath(geometry, motion, away=away, start_angle=angle)
    theta = np.linspace(0.0, 2.0 * pi, 20_000, endpoint=False)
    x, y = path.at(theta)[:2]
    worst = 0.0
    for px, py in points:
        t = theta[int(np.argmin((x - px) ** 2 + (y - py) ** 2))]
        for _ in range(4):
            qx, qy, tx, ty, g = (float(part[0]) for part in path.at(np.array([t])))
            t += ((px - qx) * tx + (py - qy) * ty) / g
        qx, qy = (float(part[0]) for part in path.at(np.array([t]))[:2])
        worst = max(worst, hypot(px - qx, py - qy))
    return worst


def written(tmp_path: Path, *more: str) -> tuple[str, dict]:
    import json

    file = tmp_path / "cam.dxf"
    done = run("cam", "export", *WORDS, *more, "--drawing", str(file), "--json")
    assert done.status == 0, done.err
    return file.read_text(), json.loads(done.out)


@pytest.mark.parametrize(("form", "most"), [("arcs", 56), ("cubics", 22)])
def test_a_micrometre_in_a_file_that_is_read_back(tmp_path: Path, form: str, most: int) -> None:
    text, document = written(tmp_path, "--tolerance", "1 um", "--form", form)
    pieces = read_dxf(text)
    assert len(pieces) == document["results"]["pieces"]["value"] <= most
    points = np.concatenate([points_of(piece) for piece in pieces]) * 1e-3
    deviation = document["results"]["deviation"]["value"] * 1e-3
    assert deviation <= 1e-6
    measured = distance_from(points, Geometry(ROLLER), motion_of(NOTHING, CYCLE))
    # what is proved holds, and does not claim much more than there is
    assert 0.5 * deviation < measured <= deviation + 2e-16
    assert "deviation" in text
    # closed to the bit
    ends = [(piece[1], piece[2] if piece[0] == "arc" else piece[4]) for piece in pieces]
    assert all(ends[i][1] == ends[(i + 1) % len(ends)][0] for i in range(len(ends)))


def test_a_nanometre_takes_no_more_than_110_cubics() -> None:
    made = export(NOTHING, program=CYCLE, follower=ROLLER, form=Form("cubics"), tolerance=1e-9)
    assert made.pieces <= 110
    assert made.deviation <= 1e-9
    assert all(isinstance(piece, Cubic) for piece in made.shape.outlines[0].pieces)


def test_dwells_are_true_arcs() -> None:
    made = export(NOTHING, program=CYCLE, follower=ROLLER)
    circles = [piece for piece in made.shape.outlines[0].pieces if isinstance(piece, Arc)
               and abs(hypot(*piece.centre)) < 1e-12]  # fmt: skip
    assert sorted(round(piece.radius, 9) for piece in circles) == [0.025, 0.035]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(EVALUATIONS // 50))
@pytest.mark.parametrize("form", ["arcs", "cubics"])
def test_random_cams_stay_within_what_is_proved(kind: str, seed: int, form: str) -> None:
    import random

    chance = random.Random(1000 + seed)
    program = random_program(chance, swing=kind in SWINGING)
    follower, rotation = random_follower(chance, kind), followers.Rotation(chance.choice(("ccw", "cw")))
    try:
        made = export(NOTHING, program=program, follower=follower, rotation=rotation, form=Form(form),
                      tolerance=2e-6, start_angle=0.3)  # fmt: skip
    except InadmissibleError as error:
        known = ("undercut", "face-too-fast", "no-triangle", "pivot-inside")
        if error.code not in known:
            raise
        return
    assert made.deviation <= 2e-6
    outline = made.shape.outlines[0]
    pieces = [
        ("arc", one.start, one.end, one.bulge) if isinstance(one, Arc)
        else ("cubic", one.start, one.control1, one.control2, one.end)
        for one in outline.pieces
    ]  # fmt: skip
    points = np.concatenate([points_of(piece, 24) for piece in pieces])
    geometry = Geometry(follower, rotation)
    assert distance_from(points, geometry, motion_of(NOTHING, program), 0.0, 0.3) <= made.deviation + 1e-15
    # and from the curve to the file
    path = CamPath(geometry, motion_of(NOTHING, program), away=0.0, start_angle=0.3)
    x, y = path.at(np.linspace(0.0, 2.0 * pi, 600))[:2]
    dense = np.concatenate([points_of(piece, 400) for piece in pieces])
    worst = max(np.sqrt(((dense - (a, b)) ** 2).sum(axis=1).min()) for a, b in zip(x, y, strict=True))
    step = np.hypot(*np.diff(dense, axis=0).T).max()
    assert worst <= hypot(made.deviation, step)


@pytest.mark.parametrize("curve", ["pitch", "cutter"])
def test_pitch_and_cutter_curves(curve: str) -> None:
    made = export(NOTHING, program=CYCLE, follower=ROLLER, curve=Curve(curve), cutter_radius=0.01)
    away = {"pitch": 0.006, "cutter": 0.01}[curve]
    pieces = [("arc", one.start, one.end, one.bulge) for one in made.shape.outlines[0].pieces]
    points = np.concatenate([points_of(piece, 20) for piece in pieces])
    assert distance_from(points, Geometry(ROLLER), motion_of(NOTHING, CYCLE), away) <= made.deviation <= 1e-6


def test_errors_fall_with_the_third_and_the_sixth_power() -> None:
    counts = {
        (form, tolerance): export(NOTHING, program=CYCLE, follower=ROLLER, form=Form(form), tolerance=tolerance).pieces
        for form, tolerance in (("arcs", 1e-5), ("arcs", 1e-8), ("cubics", 1e-6), ("cubics", 1e-10))
    }
    assert counts["arcs", 1e-8] / counts["arcs", 1e-5] < 11.0
    assert counts["cubics", 1e-10] / counts["cubics", 1e-6] < 6.0


@pytest.mark.parametrize(
    ("code", "given"),
    [
        ("undercut", {"program": STEEP, "follower": followers.Roller(0.015, 0.015)}),
        ("velocity-jump", {"program": "rise 10 mm in 90 deg linear; dwell 90 deg; return in 90 deg linear; dwell"}),
        ("too-fine", {"tolerance": 1e-16}),
        ("too-fine", {"tolerance": 0.0}),
        ("cutter", {"curve": Curve("cutter")}),
        ("many-points", {"points": 10**9}),
    ],
)
def test_refusals(code: str, given: dict) -> None:
    with pytest.raises(DynamicsError) as error:
        export(NOTHING, **{"program": CYCLE, "follower": ROLLER, **given})
    assert error.value.code == code


@pytest.mark.parametrize(
    ("ending", "words"),
    [("polar", "polar angle"), ("st", "SMC_CAMXYVA"), ("mc", "MasterPos"), ("svg", "<path"), ("csv", "bulge")],
)
def test_tables_for_machines(tmp_path: Path, ending: str, words: str) -> None:
    file = tmp_path / f"cam.{ending}"
    done = run("cam", "export", *WORDS, "--points", "8", "--drawing", str(file))
    assert done.status == 0, done.err
    text = file.read_text()
    assert words in text
    if ending == "mc":
        rows = [[float(cell) for cell in line.split(";")] for line in text.splitlines()[1:]]
        assert [row[0] for row in rows] == [45.0 * i for i in range(9)]
        motion = motion_of(NOTHING, CYCLE)
        for angle, lift, velocity, _ in rows:
            s, s1 = motion.at(radians(angle), 1)
            assert lift == pytest.approx(1e3 * s, abs=1e-12)
            assert velocity == pytest.approx(1e3 * s1 * pi / 180, abs=1e-12)


def test_an_arm_has_a_table_of_swings(tmp_path: Path) -> None:
    file = tmp_path / "arm.mc"
    done = run(
        "cam", "export", "--program", SWING, "--follower", "oscillating-roller", "--base-radius", "30 mm",
        "--roller-radius", "8 mm", "--arm", "80 mm", "--pivot-distance", "100 mm", "--points", "6",
        "--drawing", str(file),
    )  # fmt: skip
    assert done.status == 0, done.err
    assert "SlavePos [deg]" in file.read_text()
    assert "15.0" in file.read_text()
