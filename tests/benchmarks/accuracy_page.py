"""Writes the table of docs/accuracy.md and the diagram beside it, as measured here and now (minutes).

python tests/benchmarks/accuracy_page.py [FAMILY …]

With families only their lines are measured and written; the diagram and the rest stay.
"""

import compileall
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from typing import Any

from dynamics_cli.accuracy import catalogue, pictures
from dynamics_cli.accuracy.cases import DATA, load
from dynamics_cli.accuracy.report import Accuracy, accuracy
from dynamics_cli.accuracy.rows import CHOSEN, Row
from dynamics_cli.core.output.plot.pages import draw
from dynamics_cli.pictures import Picture

ROOT = Path(__file__).resolve().parents[2]
START, END = "<!-- accuracy -->", "<!-- /accuracy -->"
PAGE = ROOT / "docs" / "accuracy.md"
DIAGRAM = ROOT / "docs" / "images" / "accuracy.svg"
# Larger errors of a method whose bounds held are those of ill-conditioned results, where the bound is as large.
ILL = 1e-12
HEAD = ("question", "the program's method", "worst error", "instead", "worst error", "time of its formula, ours = 1")
# A whole call as a user makes it: nearly all of it is the start of the interpreter.
CALL = ("-m", "dynamics_cli", "skid", "speed", "--distance", "60 ft", "--friction", "0.7")
CALLS = 15
MEASURED = "Measured on"


def questions(report: Accuracy) -> list[list[Row]]:
    """The methods of each question, the program's own first."""
    blocks: dict[tuple[str, str], list[Row]] = {}
    for row in report.methods:
        blocks.setdefault((row.family, row.question), []).append(row)
    return list(blocks.values())


def error(row: Row) -> str:
    """An error as it is compared, with what it is measured in, and how many cases were not answered."""
    number = (
        "none right" if row.worst >= 0.95 and row.measure == "relative" else f"{row.worst:.1e}" if row.worst else "0"
    )
    if row.bound == "bound held" and row.worst > ILL:
        number += ", and says so"
    left = f" ({row.refused} of {row.cases + row.refused} not answered)" if row.refused else ""
    return (number if row.cases else "–") + left


def ratio(row: Row) -> str:
    """A time over the program's own, without an exponent."""
    if not row.slower:
        return ""
    return f"{row.slower:.0f}" if row.slower >= 10.0 else f"{row.slower:.2g}"


def alternative(others: list[Row]) -> Row | None:
    """What is put beside the program's method: what a textbook does, which the questions name first."""
    return next((row for row in others if row.cases), others[0] if others else None)


def line(own: Row, other: Row | None) -> str:
    """One question: the program's error over the results that the other method gives, the other's, and its time."""
    if other is None:
        return f"| {own.question} | {own.method.removesuffix(CHOSEN)} | {error(own)} | | | |"
    here = own if other.own_worst is None else Row(**{**own.__dict__, "worst": other.own_worst})
    measure = "" if own.measure == "relative" else f", in {own.measure}"
    cells = (
        own.question + measure,
        own.method.removesuffix(CHOSEN),
        error(here),
        other.method,
        error(other),
        ratio(other),
    )
    return "| " + " | ".join(cells) + " |"


def diagram(report: Accuracy) -> Picture:
    """All methods of all questions with several in one panel."""
    return Picture(
        (pictures.overview([rows for rows in pictures.by_question(report) if len(rows) > 1]),), pictures.TITLE
    )


def start_up() -> str:
    """What a user waits for: the median of a whole call's time over that of an empty process."""

    def elapsed(*words: str) -> float:
        start = time.perf_counter()
        subprocess.run([sys.executable, *words], check=True, capture_output=True, cwd=ROOT)
        return time.perf_counter() - start

    compileall.compile_dir(str(ROOT / "dynamics_cli"), quiet=2)
    ratio = median(elapsed(*CALL) / elapsed("-c", "pass") for _ in range(CALLS))
    return (
        f"A whole call of `dynamics skid speed` takes {ratio:.1f} times as long as an empty Python process, whichever "
        "formula it uses."
    )


def summary() -> str:
    """What the figures are, and how many cases there are."""
    cases = [case for path in sorted(DATA.glob("*.json")) for case in load(path.name)]
    hard = sum(case.hard for case in cases)
    return (
        "Errors are the worst over all cases, as shares of the reference unless said otherwise, of the results that "
        "both methods give; `none right` is an error as large as the answer, `and says so` that the bound stated with "
        "the answer is as large: its inputs are next to those where it is zero. Every bound that the program states "
        f"held, for every result of every case. {len(cases)} cases ship with the program, {hard} of them hard."
    )


def measured(report: Accuracy) -> str:
    """What only a measurement of everything tells."""
    here: Any = report.machine
    return (
        f"{MEASURED} {here.processor}, {here.python}, numpy {here.numpy}. Stated bounds are in the median "
        f"{report.looseness:.2g} times the true error. {start_up()}"
    )


def by_family(lines: list[str]) -> dict[str, list[str]]:
    """The lines of a table by the families of their questions; one that has no question stays with those above."""
    known = {question.name: question.family for question in catalogue.questions("", "")}
    parts: dict[str, list[str]] = {}
    family = ""
    for text in lines:
        name = text.split("|")[1].strip()
        family = known.get(name, known.get(name.partition(", in ")[0], family))
        parts.setdefault(family, []).append(text)
    return parts


def main(families: list[str]) -> None:
    """Rewrite the part of the page between the marks, or the lines of families in it."""
    start = time.perf_counter()
    text = PAGE.read_text(encoding="utf-8")
    if text.count(START) != 1 or text.count(END) != 1:
        sys.exit(f"{PAGE.name} must contain {START} and {END} once")
    before, _, rest = text.partition(START)
    old, _, after = rest.partition(END)
    reports = [accuracy(family, full=not family) for family in families or [""]]
    failed = [check.name for report in reports for check in report.checks if not check.passed]
    if failed:
        sys.exit(f"not written: {', '.join(failed)}")
    parts = by_family([text for text in old.splitlines() if text.startswith("| ")][1:]) if families else {}
    fresh: dict[str, list[str]] = {}
    for report in reports:
        for own, *others in questions(report):
            fresh.setdefault(own.family, []).append(line(own, alternative(others)))
    parts |= fresh
    if families:
        last = next(text for text in old.splitlines() if text.startswith(MEASURED))
    else:
        last = measured(reports[0])
        DIAGRAM.write_bytes(draw(diagram(reports[0]), "svg", "si"))
    order = dict.fromkeys(question.family for question in catalogue.questions("", ""))
    rows = [text for family in order for text in parts.get(family, [])]
    table = ["| " + " | ".join(HEAD) + " |", "|---|---|---:|---|---:|---:|", *rows]
    picture = f"![Work–precision diagram](images/{DIAGRAM.name})"
    page = "\n".join([before + START, "", *table, "", summary(), "", last, "", picture, "", END]) + after
    PAGE.write_text(page, encoding="utf-8")
    print(f"{len(rows)} questions, {sum(map(len, fresh.values()))} measured in {time.perf_counter() - start:.0f} s")


if __name__ == "__main__":
    main(sys.argv[1:])
