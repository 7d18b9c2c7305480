"""Every command of every page and every example script, run and its output compared."""

import doctest
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from documents import (
    IMAGES,
    PAGES,
    SCRIPTS,
    alike,
    drawn,
    missing,
    outputs,
    pictures,
    screens,
    sessions,
    with_fields,
    with_screens,
)
from shell import ROOT, shell

RUNNABLE = [page for page in PAGES if sessions(page.read_text())]
PICTURED = [page for page in PAGES if pictures(page.read_text())]
LINK = re.compile(r"\]\((?!https?:|#)([^)#]+)")

# Drawn by refresh_report_pages.py.
REPORT_PAGES = ("report_crash.png", "report_gear_pair.png", "report_cam.png")
MOST_BYTES = 150_000
# A screen, and the lines for which no table is cut.
MOST_ON_SCREEN = 24 + 3


def name(page: Path) -> str:
    return str(page.relative_to(ROOT))


@pytest.mark.parametrize("page", RUNNABLE, ids=name)
def test_commands_print_what_the_page_shows(page: Path, tmp_path: Path) -> None:
    for session, printed in outputs(page.read_text(), tmp_path):
        if printed is not None:
            assert alike(printed, session.output), f"$ {session.command}\n{printed}"


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_fields_are_those_of_the_signatures(page: Path) -> None:
    assert with_fields(page.read_text()) == page.read_text()


def test_screens_are_as_small_as_the_page_says() -> None:
    page = ROOT / "docs" / "developers" / "screens.md"
    measured = list(screens())
    assert with_screens(page.read_text(), measured) == page.read_text()
    assert [
        task.path for task, _, (lines, width) in measured if task.headline and (lines > MOST_ON_SCREEN or width > 80)
    ] == []


@pytest.mark.parametrize("page", PICTURED, ids=name)
def test_pictures_are_drawn_and_kept(page: Path, tmp_path: Path) -> None:
    for file, data in drawn(page.read_text(), tmp_path).items():
        assert len(data) > 1000
        assert (IMAGES / file).exists()


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_links_lead_somewhere(page: Path) -> None:
    prose = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    for target in LINK.findall(prose):
        assert (page.parent / target).exists(), target


@pytest.mark.parametrize("script", SCRIPTS, ids=[path.name for path in SCRIPTS])
def test_example_scripts_print_what_stands_beside_them(script: Path, tmp_path: Path) -> None:
    if missing(script.read_text()):
        pytest.skip(f"{missing(script.read_text())} is not installed")
    done = shell(f"sh {script.name}", script.parent, tmp_path)
    assert done.returncode == 0, done.stderr
    assert alike(done.stdout, script.with_suffix(".out").read_text()), done.stdout


def test_pages_may_differ_in_the_last_digit_of_long_numbers_only() -> None:
    assert alike("x  4.56528 m", "x   4.56525 m")
    assert alike("0.08557  1", "0.085566 1") is False
    assert alike("0.08557  1", "0.0855699 1")
    assert alike("9.99999", "10")
    assert not alike("4.5652 m", "4.5655 m")
    assert not alike("4.56528 m", "4.56528 s")
    assert not alike("7.4 s", "7.5 s")
    assert not alike("1.2345e-7", "0")
    assert not alike("1.23456 2", "1.23456")


@pytest.mark.parametrize("script", SCRIPTS, ids=[path.name for path in SCRIPTS])
def test_example_scripts_pass_shellcheck(script: Path) -> None:
    if shutil.which("shellcheck") is None:
        pytest.skip("shellcheck is not installed")
    done = subprocess.run(["shellcheck", str(script)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_the_page_for_python_shows_what_happens() -> None:
    page = (ROOT / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "python.md", None, None)
    assert test.examples
    assert doctest.DocTestRunner().run(test).failed == 0


def test_the_readme_leads_with_its_two_commands() -> None:
    text = (ROOT / "README.md").read_text()
    ci = (ROOT / ".ci" / "run").read_text()
    assert text.index("pip install") < text.index("## ")
    assert "pip install -e '.[test]'" in text
    assert "-m pytest" in text
    assert "-e '.[test]'" in ci
    assert "-m pytest" in ci
    assert len(text.splitlines()) <= 200


def test_every_image_is_drawn_by_a_page() -> None:
    kept = {file for page in PAGES for _, file in pictures(page.read_text())} | {"accuracy.svg", *REPORT_PAGES}
    assert {path.name for path in IMAGES.iterdir()} == kept


def test_pages_of_reports_are_small_and_shown() -> None:
    shown = "".join(page.read_text() for page in PAGES)
    for page in REPORT_PAGES:
        assert f"](images/{page})" in shown
        assert (IMAGES / page).stat().st_size < MOST_BYTES
