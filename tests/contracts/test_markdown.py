"""Markdown that holds what users wrote: read by a reader of its own, it has no HTML, no link and no picture."""

import json
from pathlib import Path

import pytest
from harness import run
from markdown_it import MarkdownIt
from markdown_it.token import Token

HOSTILE = (
    "<script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "[press](javascript:alert(1))",
    "![seen](https://example.org/x.png)",
    "<https://example.org>",
    "a | b | c",
    "back \\ slash \\| <b>",
    "`code` *and* **more**",
)
READER = MarkdownIt("commonmark", {"html": True}).enable("table")
UNWANTED = {"html_block", "html_inline", "link_open", "image", "em_open", "code_inline"}


def tokens(text: str) -> list[Token]:
    return [one for block in READER.parse(text) for one in (block, *(block.children or ()))]


def words(text: str) -> str:
    return " ".join(" ".join(one.content for one in tokens(text) if one.type in ("text", "text_special")).split())


def scene(name: str) -> str:
    parts = [{"name": name, "shape": "sphere", "radius": "10 mm", "density": "7850 kg/m^3"},
             {"name": "other", "shape": "sphere", "radius": "20 mm", "density": "7850 kg/m^3"}]  # fmt: skip
    return json.dumps({"parts": parts})


@pytest.mark.parametrize("name", HOSTILE)
def test_a_name_is_shown_and_commands_nothing(name: str, tmp_path: Path) -> None:
    file, document = tmp_path / "a.json", tmp_path / "out.json"
    file.write_text(scene(name))
    told = run("inertia", "body", str(file), "--format", "markdown", "--explain")
    assert told.status == 0, told.err
    assert run("inertia", "body", str(file), "--json", "--output", str(document)).status == 0
    report = run("report", str(document))
    for text in (told.out, report.out):
        kinds = {one.type for one in tokens(text)} - ({"em_open"} if text == report.out else set())
        assert not kinds & UNWANTED, kinds & UNWANTED
        assert len([one for one in tokens(text) if one.type == "heading_open"]) < 40
    assert " ".join(name.split()) in words(told.out)
    assert [row for row in told.out.splitlines() if row.startswith("|")], told.out


def test_ordinary_names_stay_as_they_are() -> None:
    text = run("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--format", "markdown").out
    assert "\\" not in text
    assert "| total_distance | 18.288 m |" in text
