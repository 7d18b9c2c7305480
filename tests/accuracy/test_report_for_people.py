"""The accuracy report as people meet it: the table, the diagram, the progress bar, libraries of others."""

import io
import os
import re
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from harness import answer, run

from dynamics_cli.accuracy import catalogue, layout, pictures
from dynamics_cli.accuracy.machine import peer
from dynamics_cli.accuracy.measure import Errors, errors_of
from dynamics_cli.accuracy.questions import Method, Question
from dynamics_cli.accuracy.report import SLOW, Accuracy, Done, accuracy
from dynamics_cli.accuracy.rows import CHOSEN, Row, compared_worst, finished, row
from dynamics_cli.core.batch.rows import progress
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.pictures import Bars, Curve


@pytest.fixture(scope="module")
def gears() -> dict:
    return answer("accuracy", "gear", "pair")["results"]


@pytest.fixture(scope="module")
def measured() -> Accuracy:
    return accuracy("skid")


def made(question: str, method: str, time: float | None, error: float, refused: int = 0) -> Row:
    errors = Errors()
    errors.cases, errors.refused = 3, refused
    errors.note("a case", error, None)
    return row(question, method, errors, time, 1.0)


class TestTable:
    @pytest.mark.parametrize("width", [80, 100, 120, 140])
    def test_lines_are_as_wide_as_the_terminal(self, gears: dict, width: int) -> None:
        shown = layout.lines(gears, 3, width)
        assert max(map(len, "\n".join(shown).splitlines())) <= width
        assert len(shown) > 15

    def test_nothing_in_a_pipe_depends_on_the_terminal(self, monkeypatch: pytest.MonkeyPatch) -> None:
        first = run("accuracy", "gear", "bevel", "--untimed").out
        monkeypatch.setenv("COLUMNS", "80")
        assert run("accuracy", "gear", "bevel", "--untimed").out == first

    def test_the_width_is_that_of_standard_output(self) -> None:
        pty = pytest.importorskip("pty")
        ours, theirs = pty.openpty()
        import fcntl
        import struct
        import termios

        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 97, 0, 0))
        with os.fdopen(theirs, "wb") as out:
            assert Terminal(stdout=out).columns == 97
        os.close(ours)
        assert Terminal(stdout=io.BytesIO()).columns == 0

    def test_a_family_is_told_in_a_line_for_each_question(self) -> None:
        shown = run("accuracy", "skid", "--untimed").out.splitlines()
        assert len(shown) <= 20
        questions = [line for line in shown if "held ×" in line and line.startswith("skid ")]
        assert len(questions) == 11
        assert shown[0].endswith("textbook")
        assert "every method of a task: dynamics accuracy skid speed" in shown

    def test_everything_is_told_in_a_line_for_each_family(self, monkeypatch: pytest.MonkeyPatch) -> None:
        questions = [one for name in ("skid", "vec", "spin") for one in catalogue.questions(name, "")]
        monkeypatch.setattr(catalogue, "questions", lambda family, task: questions)
        shown = run("accuracy", "--untimed").out.splitlines()
        assert [line.split()[:2] for line in shown[1:4]] == [["skid", "11"], ["vec", "8"], ["spin", "6"]]
        assert shown[1].endswith("6 of 10")
        assert "over at most 30 hard cases of each question" in " ".join(shown)
        assert shown[-1].endswith("dynamics accuracy FAMILY")

    def test_all_families_are_told_from_few_cases_unless_all_are_wanted(self, monkeypatch: pytest.MonkeyPatch) -> None:
        questions = [one for one in catalogue.questions("impact", "") if one.name == "impact planar"]
        monkeypatch.setattr(catalogue, "questions", lambda family, task: questions)
        own, other = accuracy(untimed=True).methods
        assert 20 < own.cases == other.cases + other.refused <= 30
        assert accuracy(full=True, untimed=True).methods[0].cases > 100

    def test_slow_questions_are_called_as_they_are(self) -> None:
        assert set(SLOW) <= {question.name for question in catalogue.questions("", "")}

    def test_counts_are_right_or_wrong(self) -> None:
        shown = run("accuracy", "stability", "routh", "--untimed").out.splitlines()
        assert next(line for line in shown if "ε" in line).split()[-4:] == ["wrong", "0", "24%", "34"]
        assert layout._worst({"worst": {"value": 0.0}, "counts": True}, 3) == "right"
        # errors in shares of a size have no last place either
        assert "wrong" not in run("accuracy", "inertia", "compare", "--untimed").out

    def test_what_passed_is_told_in_full_on_request(self) -> None:
        assert "check: " not in run("accuracy", "vec", "--untimed").out
        assert "check: stated bounds below a true error: passed" in run("accuracy", "vec", "--untimed", "--all").out

    def test_every_method_stands_in_its_question_with_its_own_first(self, gears: dict) -> None:
        shown = [line for line in layout.lines(gears, 3, 120) if not line.startswith("      ")]
        marked = [line for line in shown if line.startswith("  ▸ ")]
        assert len(marked) == gears["questions"]["value"]
        for place, line in enumerate(shown):
            if line.startswith("  ▸ "):
                assert shown[place - 1].split()[-1] == "cases"  # the head of its block

    def test_the_worst_case_is_named_and_its_result_is_not_cut_off(self, gears: dict) -> None:
        shown = layout.lines(gears, 3, 80)
        for one in gears["methods"]:
            if one["worst"]["value"]:
                named = [line.partition(", truly ")[0] for line in shown if "      worst: " in line]
                assert any(line.endswith(one["worst_case"][-20:]) for line in named)

    def test_the_true_value_stands_beside_a_result_with_few_right_digits(self) -> None:
        shown = run("accuracy", "impact", "central", "--untimed").out
        assert "      worst: central 24: first.velocity, truly 2.22e-16\n" in shown
        assert "truly: the true value" in " ".join(shown.split())
        assert "truly" not in run("accuracy", "convert", "--untimed").out

    def test_the_figures_are_those_of_the_document(self, gears: dict) -> None:
        text = "\n".join(layout.lines(gears, 3, 140))
        for one in gears["methods"]:
            assert f"{one['worst']['value']:.1e}" in text

    def test_times_stand_under_the_unit_they_were_asked_in(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr("dynamics_cli.core.terminal.Terminal.columns", 118)
        text = run("accuracy", "skid", "yaw", "--to", "methods.time=ms").out
        assert "time ms" in text

    def test_columns_that_are_empty_are_left_out(self) -> None:
        text = run("accuracy", "gear", "ratio", "--untimed").out
        assert "ratio: time" not in text
        assert "time µs" not in text
        assert "in ulp" not in text

    def test_json_and_csv_keep_every_column(self, gears: dict) -> None:
        names = {"family", "task", "question", "method", "cases", "refused", "time", "slower", "worst", "median",
                 "worst_ulp", "median_ulp", "own_worst", "measure", "bound", "stated", "broken", "looseness",
                 "worst_case", "worst_reference", "share"}  # fmt: skip
        assert names <= set().union(*gears["methods"])
        head = run("accuracy", "skid", "yaw", "--format", "csv", "--table", "methods").out.splitlines()[0]
        assert names <= {name.partition("[")[0] for name in head.split(",")}

    def test_looseness_is_the_bound_over_the_error_but_over_half_a_last_bit_at_least(self) -> None:
        errors = Errors()
        errors.add("a", 1.0 + 2.0**-50, "1", 2.0**-48)
        errors.add("b", 1.0, "1", 2.0**-51)
        errors.add("c", 1.0, "1", 0.0)
        assert errors.looseness == [4.0, 4.0]

    def test_errors_too_large_for_a_double_have_an_end(self) -> None:
        errors = Errors()
        errors.add("a", 1e300, "1e-310", None)
        assert errors.worst[1] == 1e300

    def test_results_of_cases_of_one_name_are_kept_apart(self) -> None:
        errors = Errors()
        errors.add("a: x", 1.5, "1", None, "0 x")
        errors.add("a: x", 1.0, "1", None, "1 x")
        assert errors.by_result == {"0 x": 0.5, "1 x": 0.0}
        assert (errors.worst[0], errors.worst_reference) == ("a: x", 1.0)

    def test_alternatives_are_compared_over_their_own_results(self) -> None:
        own, other = Errors(), Errors()
        own.add("a", 1.0 + 2.0**-30, "1", None)
        own.add("b", 1.0 + 2.0**-52, "1", None)
        other.add("b", 1.0 + 2.0**-40, "1", None)
        assert row("q", "alternative", other, None, None, own=own).own_worst == pytest.approx(2.0**-52)
        assert row("q", "alternative", other, None, None).own_worst is None


def test_our_own_method_stands_by_its_error_where_another_answers() -> None:
    own, other = Errors(), Errors()
    own.cases = other.cases = 2
    own.add("hard", 1.5, "1", None)
    own.add("easy", 1.0, "1", None)
    other.add("easy", 1.25, "1", None)
    rows = [row("q", "ours (chosen)", own, 1.0, 1.0), row("q", "theirs", other, 1.0, 1.0, own=own)]
    assert rows[0].worst == 0.5
    assert [compared_worst(one, rows) for one in rows] == [0.0, 0.25]
    assert {(one.family, one.task) for one in finished(rows, "f", "t")} == {("f", "t")}


class TestDiagram:
    def test_every_question_has_its_panel_and_every_method_its_point(self, measured: Accuracy) -> None:
        picture = pictures.work_precision(measured)
        several = {one.question for one in measured.methods if not one.method.endswith(CHOSEN)}
        assert len(several) >= 9
        for question in several:
            (panel,) = [panel for panel in picture.panels if panel.title.startswith(f"{question} (")]
            assert len(panel.items) == len([one for one in measured.methods if one.question == question])

    def test_errors_without_a_right_digit_stand_at_the_end(self) -> None:
        panel = pictures.question_panel([made("q", "a (chosen)", 1.0, 0.0), made("q", "b", 1.0, 1e40)])
        assert [item.x[0] for item in panel.items if isinstance(item, Curve)] == [pictures.EXACT, pictures.WRONG]

    @pytest.mark.parametrize("form", ["svg", "png", "pdf"])
    def test_it_is_drawn_in_every_format(self, tmp_path: Path, form: str) -> None:
        pytest.importorskip("matplotlib")
        file = tmp_path / f"work.{form}"
        assert run("accuracy", "skid", "yaw", "--plot", str(file)).status == 0
        assert file.stat().st_size > 5000

    def test_a_pdf_has_pages(self, measured: Accuracy) -> None:
        pytest.importorskip("matplotlib")
        from dynamics_cli.core.output.plot.pages import draw

        picture = pictures.work_precision(measured)
        data = draw(picture, "pdf", "si")
        pages = -(-len(picture.panels) // picture.page)
        assert pages > 1
        assert len(re.findall(rb"/Type /Page\b(?!s)", data)) == pages
        assert draw(picture, "pdf", "si") == data

    def test_without_times_errors_are_drawn_alone(self) -> None:
        untimed = accuracy("skid", "vault", untimed=True)
        picture = pictures.work_precision(untimed)
        assert len(picture.panels) == 2
        drawn = [bars for panel in picture.panels for bars in panel.items if isinstance(bars, Bars)]
        lengths = [error for bars in drawn for error in bars.high]
        assert len(lengths) == len(untimed.methods)
        others = [one.worst for one in untimed.methods if not one.method.endswith(CHOSEN)]
        assert all(min(max(worst, pictures.EXACT), pictures.WRONG) in lengths for worst in others)

    def test_bars_in_the_terminal_know_powers_of_ten(self) -> None:
        from dynamics_cli.core.output.plot.small import sketch

        text = sketch(pictures.work_precision(accuracy("skid", "yaw", untimed=True)), "si", 80, 24)
        own, book = (line.count("█") for line in text.splitlines() if "█" in line)
        assert 0 < own < 0.25 * book


class Screen(io.BytesIO):
    def isatty(self) -> bool:
        return True


class TestProgress:
    def test_a_long_run_shows_how_far_it_is(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(progress, "PATIENCE", 0.0)
        screen, done = Screen(), Done(4)
        with progress.Progress(done, Terminal(stderr=screen), "questions") as bar:
            for _ in range(4):
                done.bytes_read += 1
                bar.advance(done.bytes_read)
        assert b"questions" in screen.getvalue()

    def test_a_short_one_and_one_into_a_pipe_show_nothing(self, monkeypatch: pytest.MonkeyPatch) -> None:
        screen = Screen()
        with progress.Progress(Done(1), Terminal(stderr=screen), "questions") as bar:
            bar.advance(1)
        assert screen.getvalue() == b""
        monkeypatch.setattr(progress, "PATIENCE", 0.0)
        pipe = io.BytesIO()
        with progress.Progress(Done(1), Terminal(stderr=pipe), "questions") as bar:
            bar.advance(1)
        assert pipe.getvalue() == b""


class TestPeers:
    def test_they_are_listed_with_their_versions(self) -> None:
        import pint

        document = answer("accuracy", "convert", "--untimed", "--peers")
        assert document["results"]["peers"] == [{"name": "pint", "version": pint.__version__, "installed": True}]
        assert "peers" not in answer("accuracy", "convert", "--untimed")["results"]

    def test_one_that_cannot_be_imported_is_none(self, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
        (tmp_path / "broken_peer.py").write_text("raise AttributeError('np.float')")
        monkeypatch.syspath_prepend(tmp_path)
        assert peer("broken_peer").installed is False
        assert "np.float" in peer("broken_peer").version
        assert peer("surely_no_such_library").version == ""
        monkeypatch.setitem(sys.modules, "homemade", ModuleType("homemade"))
        assert (peer("homemade").installed, peer("homemade").version) == (True, "unknown")

    def test_one_that_fails_in_its_own_way_has_no_answer(self) -> None:
        question = next(one for one in catalogue.questions("coords", "") if isinstance(one, Question))
        cases = [case for case in catalogue.load(question.file) if case.task == question.cases]

        def fails(**_: Any) -> dict:
            raise KeyError("whatever")

        assert errors_of(fails, cases, {}, tracked=False, foreign=True).refused == len(cases)
        with pytest.raises(KeyError):
            errors_of(fails, cases, {}, tracked=False)

    def test_a_method_of_a_library_that_was_not_asked_for_is_left_out(self, monkeypatch: pytest.MonkeyPatch) -> None:
        question = next(one for one in catalogue.questions("skid", "yaw") if isinstance(one, Question))
        extra = Method("a peer", "dynamics_cli.accuracy.alternatives.skid:yaw", needs="math")
        monkeypatch.setattr(question, "methods", (*question.methods, extra))
        with_peers = answer("accuracy", "skid", "yaw", "--untimed", "--peers")["results"]["methods"]
        without = answer("accuracy", "skid", "yaw", "--untimed")["results"]["methods"]
        names = [{row["method"] for row in rows} for rows in (with_peers, without)]
        assert names[0] - names[1] == {"a peer"}


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (("geer",), "did you mean gear"),
        (("SKID",), "did you mean skid?"),
        (("gear", "pear"), "did you mean pair?"),
        (
            ("nosuch",),
            "there are for balance, cam, convert, coords, energy, force, gear, human, impact",
        ),
    ],
)
def test_what_was_meant_is_guessed(words: tuple[str, ...], hint: str) -> None:
    failed = run("accuracy", *words)
    assert failed.status == 2
    assert hint in failed.err
