"""The reference cases by name, as the manifest has them: how difficult each is, why, and where it comes from."""

import json
from functools import cache
from importlib.resources import files
from typing import Any

from dynamics_cli.pictures import Axis, Bars, Panel, Picture
from dynamics_cli.quantities import Annotated, Text
from dynamics_cli.records import record

MANIFEST = files(__package__) / "manifest.json"
HARD = "hard"


@record
class ReferenceCase:
    """A reference case."""

    command: Annotated[Text, "The command whose task it is a case of."]
    name: Annotated[Text, "Its name, unique within the task."]
    difficulty: Annotated[Text, "ordinary, or hard: chosen, or found by search, for being difficult."]
    why: Annotated[Text | None, "Why it is hard."]
    source: Annotated[
        Text,
        "Where it comes from: drawn at random, chosen by hand, made up for a limit, or found by a search for the "
        "largest error, for the error nearest to its bound, or for the loosest bound.",
    ]
    file: Annotated[Text, "The file of references that contains it."]
    task: Annotated[Text, "The file's name for the calculation."]


@cache
def manifest() -> "dict[str, Any]":
    """Every file of references, what made it, and its cases."""
    return json.loads(MANIFEST.read_text(encoding="utf-8"))  # type: ignore[no-any-return]


def listed(family: str, task: str, *, hard: bool) -> tuple[ReferenceCase, ...]:
    """The cases of a family and task, or all, those of one command together."""
    cases = [
        _case(file, case)
        for file in manifest()["files"]
        if family in ("", file["family"])
        for case in file["cases"]
        if task in ("", case["command"]) and (case["kind"] == HARD or not hard)
    ]
    places = {command: place for place, command in enumerate(dict.fromkeys(case.command for case in cases))}
    return tuple(sorted(cases, key=lambda case: places[case.command]))


def _case(file: "dict[str, Any]", case: "dict[str, str]") -> ReferenceCase:
    command = f"{file['family']} {case['command']}".strip()
    return ReferenceCase(
        command, case["name"], case["kind"], case.get("why"), case["source"], file["file"], case["task"]
    )


def lines(cases: "list[dict[str, Any]]", wrapped: "Any", width: int) -> "list[str]":
    """The cases for people: a block for each command, its hard cases with their reasons; `wrapped` breaks lines."""
    sources = {case["source"] for case in cases}
    meaning = "; ".join(f"{word}: {words}" for word, words in manifest()["sources"].items() if word in sources)
    text = ["", *(f"  {line}" for line in wrapped(meaning, width - 2))]
    before = ""
    for case in cases:
        if case["command"] != before:
            before = case["command"]
            alike = [entry for entry in cases if entry["command"] == before]
            hard = sum(entry["difficulty"] == HARD for entry in alike)
            text += ["", f"  {before}: {len(alike)} reference cases, {hard} hard"]
        mark = "▸ " if case["difficulty"] == HARD else "  "
        text += [f"  {mark}{line}" for line in wrapped(f"{case['name']} ({case['source']})", width - 4)]
        if case.get("why"):
            text += [f"      {line}" for line in wrapped(case["why"], width - 6)]
    return text


def counted(cases: tuple[ReferenceCase, ...]) -> Picture:
    """How many cases each command has, a bar for the hard ones below that of all."""
    commands = dict.fromkeys(case.command for case in cases)
    names: list[str] = []
    counts: list[float] = []
    for command in commands:
        alike = [case for case in cases if case.command == command]
        names += [command, "of these hard"]
        counts += [float(len(alike)), float(sum(case.difficulty == HARD for case in alike))]
    bars = Bars(tuple(names), [0.0] * len(names), counts)
    return Picture((Panel(Axis("reference cases"), Axis(""), (bars,)),), "reference cases of 40 digits")
