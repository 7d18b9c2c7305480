"""Motions from tables of cam angles and lifts, against the laws that the tables were made of."""

from math import pi, radians, sin
from pathlib import Path

import pytest

from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.cam.program.revolution import motion
from dynamics_cli.cam.program.segments import Program
from dynamics_cli.errors import InadmissibleError

LINE = "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell"
LAW = motion_of(Program(), LINE)


def written(path: Path, step: int, head: str = "angle[deg],lift[mm]", separator: str = ",", scale: float = 1e3) -> str:
    rows = [f"{angle}{separator}{LAW.at(radians(angle), 0)[0] * scale!r}" for angle in range(0, 360, step)]
    path.write_text("\n".join(["# from a program", head, *rows]) + "\n", encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("step", [1, 2, 5])
def test_a_table_gives_its_law_back(tmp_path: Path, step: int) -> None:
    """A cubic spline is off by at most h⁴/384 of the fourth derivative, its second derivative by 3h²/8 of it."""
    turn = motion_of(Program(lifts=written(tmp_path / "lifts.csv", step)))
    assert [span.name for span in turn.segments] == ["rise", "dwell", "return", "dwell"]
    h = radians(step)
    fourth = max(
        abs(zone[4]) for i in range(len(LAW.zones)) for t in (0.0, 0.25, 0.5, 1.0) for zone in [LAW.in_zone(i, t, 4)]
    )
    for angle in (7.3, 44.4, 88.8, 120.0, 155.5, 200.2, 300.0):
        s, v, a = turn.at(radians(angle), 2)
        exact = LAW.at(radians(angle), 2)
        assert s == pytest.approx(exact[0], abs=fourth * h**4 / 100)
        assert v == pytest.approx(exact[1], abs=fourth * h**3 / 10)
        assert a == pytest.approx(exact[2], abs=fourth * h**2)
    assert turn.at(radians(120.0), 2) == (0.02, 0.0, 0.0)


def test_units_separators_and_a_closing_row(tmp_path: Path) -> None:
    plain = motion_of(Program(lifts=written(tmp_path / "a.csv", 5)))
    inches = written(tmp_path / "b.csv", 5, "lobe[deg]; lift[in]", "; ", 1.0 / 0.0254)
    Path(inches).write_text(Path(inches).read_text(encoding="utf-8") + "360; 0\n", encoding="utf-8")
    turn = motion_of(Program(lifts=inches))
    assert turn.joints == plain.joints
    assert turn.at(1.0, 2) == pytest.approx(plain.at(1.0, 2), rel=1e-12)


def test_without_a_dwell_the_turn_joins_smoothly(tmp_path: Path) -> None:
    rows = [f"{angle},{10 * sin(radians(angle)) + 3 * sin(radians(2 * angle))!r}" for angle in range(0, 360, 5)]
    path = tmp_path / "lifts.csv"
    path.write_text("angle[deg],lift[mm]\n" + "\n".join(rows), encoding="utf-8")
    found = motion(Program(lifts=str(path)))
    assert found.continuity == "C2"
    assert next(joint.between for joint in found.joints) == "lobe 1 to lobe 1"
    turn = motion_of(Program(lifts=str(path)))
    assert turn.at(0.0, 1)[1] == pytest.approx(0.016, abs=1e-6)
    assert turn.at(2.0 * pi, 2, -1)[2] == pytest.approx(turn.at(0.0, 2)[2], abs=1e-12)


def test_a_lobe_alone_dwells_for_the_remainder(tmp_path: Path) -> None:
    path = tmp_path / "lobe.csv"
    rows = [f"{angle}\t{sin(radians(1.8 * angle)) ** 2!r}" for angle in range(0, 100, 5)]
    path.write_text("deg[deg]\tlift[deg]\n" + "\n".join([*rows, "100\t0"]), encoding="utf-8")
    turn = motion_of(Program(lifts=str(path)))
    assert turn.swing
    assert [span.name for span in turn.segments] == ["lobe", "dwell"]
    assert turn.stroke == pytest.approx((0.0, radians(1.0)), abs=1e-6)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("angle,lift\n" + "0,0\n" * 9, "does not name an angle and a lift"),
        ("angle[deg],lift[mm]\n0,0\n", "has 1 rows"),
        (
            "angle[deg],lift[mm]\n" + "".join(f"{i},{i}\n" for i in range(9)),
            "begins with a lift of 0 m and ends with 0.008 m",
        ),
        ("angle[deg],lift[mm]\n" + "".join(f"{i % 8},{i}\n" for i in range(9)), "is not beyond the one before"),
        ("angle[deg],lift[mm]\n" + "".join(f"{i},x\n" for i in range(9)), "is not an angle and a lift"),
        ("angle[deg],lift[mm]\n" + "".join(f"{50 * i},{i}\n" for i in range(9)), "more than one turn"),
        ("angle[deg],lift[mm]\n" + "".join(f"{40 * i},1\n" for i in range(9)), "all lifts of the table are equal"),
    ],
)
def test_tables_refused(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "lifts.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InadmissibleError) as caught:
        motion_of(Program(lifts=str(path)))
    assert message in caught.value.message


def test_one_source_of_the_motion(tmp_path: Path) -> None:
    with pytest.raises(InadmissibleError, match="one is wanted"):
        motion_of(Program(lifts=written(tmp_path / "lifts.csv", 5)), LINE)
