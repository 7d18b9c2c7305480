"""Pictures: in files the same every time, small in the terminal, of tasks, of sweeps and of uncertain results."""

import hashlib
import io
import math
from pathlib import Path

import pytest
from harness import Outcome, run

from dynamics_cli import cli
from dynamics_cli.core.output.plot import pages
from dynamics_cli.core.output.plot.axes import Scale
from dynamics_cli.core.output.plot.small import sketch
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import UsageError
from dynamics_cli.pictures import Axis, Bars, Curve, Panel, Picture
from dynamics_cli.quantities import Angle, Length, Temperature

pytestmark = pytest.mark.usefixtures("toy")
SPEED = ("skid", "speed", "--distance", "60 ± 2 ft", "--friction", "0.7 ± 0.05")


class Screen(io.BytesIO):
    """Standard error that is a terminal."""

    def isatty(self) -> bool:
        return True


def on_screen(*argv: str) -> str:
    screen = Screen()
    terminal = Terminal(io.BytesIO(), io.BytesIO(), screen, {})
    assert cli.run_argv(list(argv), terminal) == 0
    return screen.getvalue().decode()


@pytest.mark.parametrize(("form", "start"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")])
class TestFiles:
    def test_the_same_call_gives_the_same_bytes_listed_with_their_hash(
        self, tmp_path: Path, form: str, start: bytes
    ) -> None:
        file = tmp_path / f"picture.{form}"
        outcome = run("toy", "curve", "--lift", "12 mm", "--plot", str(file), "--json")
        assert outcome.status == 0, outcome.err
        data = file.read_bytes()
        assert data.startswith(start)
        assert outcome.document["files"] == [
            {"name": str(file), "sha256": hashlib.sha256(data).hexdigest(), "written": True}
        ]
        assert run("toy", "curve", "--lift", "12 mm", "--plot", str(file)).status == 0
        assert file.read_bytes() == data

    def test_other_numbers_give_other_bytes(self, tmp_path: Path, form: str, start: bytes) -> None:
        file, other = tmp_path / f"a.{form}", tmp_path / f"b.{form}"
        assert run("toy", "curve", "--lift", "12 mm", "--plot", str(file)).status == 0
        assert run("toy", "curve", "--lift", "13 mm", "--plot", str(other)).status == 0
        assert file.read_bytes() != other.read_bytes()


class TestWhatIsPictured:
    def test_an_uncertain_result_has_its_distribution_and_its_tornado(self, tmp_path: Path) -> None:
        file = tmp_path / "speed.svg"
        outcome = run(*SPEED, "--limit", "35 mph", "--plot", str(file), "--json")
        assert outcome.status == 0, outcome.err
        without = run(*SPEED, "--limit", "35 mph", "--json").document
        assert outcome.document["results"] == without["results"]
        assert file.stat().st_size > 10_000

    @pytest.mark.parametrize("method", ["linear", "monte-carlo", "lattice"])
    def test_by_any_method(self, method: str) -> None:
        assert "speed [km/h]" in on_screen(*SPEED, "--method", method, "--samples", "20000", "--plot", "-")

    def test_a_sweep_has_a_curve_for_every_result(self) -> None:
        sweeps = ("--sweep", "friction=0.3:0.9:7", "--sweep", "distance=20 ft:60 ft:2")
        text = on_screen("skid", "speed", "--distance", "60 ft", "--friction", "0.7", *sweeps, "--plot", "-")
        assert "speed [km/h]\na distance = 20 ft; b distance = 60 ft\n" in text
        assert "time [s]" in text

    def test_a_sweep_in_a_file(self, tmp_path: Path) -> None:
        file = tmp_path / "sweep.svg"
        argv = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--sweep", "friction=0.3:0.9:7")
        outcome = run(*argv, "--plot", str(file), "--json")
        assert outcome.status == 0, outcome.err
        assert outcome.document["files"][0]["name"] == str(file)

    def test_small_pictures_go_to_a_terminal_only(self) -> None:
        plain = run(*SPEED)
        assert run(*SPEED, "--plot", "-") == Outcome(0, plain.out, "")
        text = on_screen(*SPEED, "--plot", "-")
        assert "speed [km/h]" in text
        assert "friction (82 %)" in text

    def test_a_task_of_one_certain_case_may_have_none(self) -> None:
        outcome = run("toy", "mean", "--torques", "1, 2 N*m", "--side", "2 m", "--plot", "-", "--json")
        assert outcome.status == 2
        assert outcome.error["code"] == "no-picture"


class TestRefusals:
    @pytest.mark.parametrize("name", ["picture.gif", "picture", ".svg/"])
    def test_unknown_endings(self, name: str) -> None:
        outcome = run(*SPEED, "--plot", name, "--json")
        assert (outcome.status, outcome.error["parameter"]) == (2, "plot")

    def test_no_picture_of_rows(self) -> None:
        assert run("skid", "speed", "--rows", "-", "--plot", "a.svg", "--json").error["code"] == "exclusive"

    def test_not_the_same_file_as_the_document(self, tmp_path: Path) -> None:
        name = str(tmp_path / "a")
        assert run(*SPEED, "--plot", name, "--output", name, "--json").status == 2

    def test_what_cannot_be_written_is_said_and_nothing_is_left(self, tmp_path: Path) -> None:
        outcome = run(*SPEED, "--plot", str(tmp_path / "none" / "a.svg"), "--json")
        assert (outcome.status, outcome.error["parameter"], outcome.out) == (5, "plot", "")

    def test_without_the_library_it_says_what_to_install(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
        outcome = run(*SPEED, "--plot", "a.svg", "--json")
        assert outcome.status == 2
        assert "dynamics-cli[plot]" in outcome.error["hint"]
        with pytest.raises(UsageError):
            pages.need()


class TestAxes:
    def test_numbers_are_shown_in_the_units_of_the_system(self) -> None:
        assert Scale(Axis("angle", Angle), "si").label == "angle [deg]"
        assert Scale(Axis("angle", Angle), "si")([math.pi]) == pytest.approx([180.0])
        assert Scale(Axis("length", Length), "us")([0.3048]) == pytest.approx([1.0])
        assert Scale(Axis("heat", Temperature), "si")([273.15]) == pytest.approx([0.0], abs=1e-9)
        assert Scale(Axis("share"), "si").label == "share"


class TestSmall:
    def test_a_line_runs_from_corner_to_corner(self) -> None:
        text = sketch(Picture((Panel(Axis("x"), Axis("y"), (Curve([0.0, 1.0], [2.0, 5.0]),)),)), "si", 60, 20)
        rows = text.splitlines()
        assert rows[0] == "y"
        assert rows[1].startswith("         5 ")
        assert 0x2800 < ord(rows[1][-1]) <= 0x28FF
        assert len(rows[1]) > len(rows[-4])
        assert rows[-3].startswith("         2 ")
        assert rows[-1].strip() == "x"

    def test_equal_axes_keep_a_square_square(self) -> None:
        square = Curve([0.0, 1.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0, 0.0])
        text = sketch(Picture((Panel(Axis("x"), Axis("y"), (square,), equal=True),)), "si", 80, 20)
        body = [row[11:] for row in text.splitlines()[1:-2]]
        wide = max(len(row.rstrip()) for row in body) - min(len(row) - len(row.lstrip()) for row in body if row.strip())
        high = sum(bool(row.strip()) for row in body)
        assert abs(wide - 2 * high) <= 2

    def test_nothing_finite_is_said_so(self) -> None:
        empty = Picture((Panel(Axis("x"), Axis("y"), (Curve([0.0], [math.nan]),)),))
        assert "nothing to show" in sketch(empty, "si", 80, 20)

    def test_bars_and_a_narrow_terminal(self) -> None:
        bars = Picture((Panel(Axis("x"), Axis(""), (Bars(("a", "bb"), [1.0, 2.0], [3.0, 2.5]),)),), "t")
        rows = sketch(bars, "si", 20, 10).splitlines()
        assert rows[0] == "t"
        assert rows[2].startswith(" a █")
        assert max(map(len, rows)) <= 22


def drawn_axes(items: tuple[Bars | Curve, ...]) -> list:
    panel = Panel(Axis("x"), Axis("y"), items)
    figure = pages._figure(Picture((panel,)), (panel,), "si")
    figure.canvas.draw()
    return figure.axes


def test_bars_keep_off_both_ends_of_the_axis() -> None:
    pytest.importorskip("matplotlib")
    (axes,) = drawn_axes((Bars(("a", "b"), (77.0, 81.0), (87.0, 83.0)),))
    low, high = axes.get_xlim()
    assert 77.0 - low == pytest.approx(high - 87.0)
    assert low < 77.0


@pytest.mark.parametrize(("count", "beside"), [(4, False), (5, True)])
def test_the_names_of_many_curves_stand_beside_them(count: int, beside: bool) -> None:
    pytest.importorskip("matplotlib")
    (axes,) = drawn_axes(tuple(Curve((0.0, 1.0), (0.0, float(n)), f"curve {n}") for n in range(count)))
    assert bool(axes.get_legend().get_window_extent().x0 >= axes.get_window_extent().x1) == beside


def test_three_views_have_titles_as_other_pictures_have() -> None:
    pytest.importorskip("matplotlib")
    ends = Axis("x", ends=(0.0, 1.0)), Axis("y", ends=(0.0, 1.0))
    panels = tuple(Panel(*ends, (Curve((0.0, 1.0), (0.0, 1.0)),), f"{side} view") for side in ("top", "front", "side"))
    figure = pages._figure(Picture(panels, "rotor", columns=3, views=True), panels, "si")
    assert figure.get_suptitle() == "Rotor"
    assert [axes.get_title() for axes in figure.axes[:3]] == ["Top view", "Front view", "Side view"]
