"""The commands and files that Markdown pages show: found, carried out in a copy of the examples, written back.

In `console` blocks a line `$ …` is a command of sh, run in a copy of examples/ that one page's commands share; what
follows up to the next command is everything it prints. A block whose first line is a comment with a file name
(`# part.toml`) is written there before the commands run. A comment `<!-- picture: dynamics … --plot NAME -->` draws
docs/images/NAME. A page that shows files under dynamics_cli/ has its commands run by a copy of the package with those
files in it; a block `# in dynamics_cli/registry.py` is added at the end of that file's last table. Between
`<!-- fields: inertia body: parts -->` and `<!-- /fields -->` stand the fields of a group as its signature has them;
between `<!-- screens -->` and `<!-- /screens -->` how much each task prints.
"""

import os
import re
import shlex
import shutil
from collections.abc import Iterator
from contextlib import chdir
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

from harness import run
from shell import ROOT, shell

from dynamics_cli import cli
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.task_help import group_records, option_text
from dynamics_cli.core.inputs.options import Option
from dynamics_cli.core.inputs.specification import Field, Leaf, OneOf, Tagged

EXAMPLES = ROOT / "examples"
IMAGES = ROOT / "docs" / "images"
TOOLS = ("jq", "sqlite3")
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
SCRIPTS = sorted(EXAMPLES.glob("**/*.sh"))
OPERATORS = set("|&;<>()$`*?\\\n")
FILE_BLOCK = re.compile(r"^```\w+\n# (in )?([\w./-]+\.(?:py|toml|csv|json))\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PICTURE = re.compile(r"<!-- picture: (dynamics .*? --plot (\S+)) -->", re.DOTALL)
FIELDS = re.compile(r"<!-- fields: ([\w -]+): (\w+) -->.*?<!-- /fields -->", re.DOTALL)
SCREENS = re.compile(r"<!-- screens -->.*?<!-- /screens -->", re.DOTALL)
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")
ACCURATE = re.compile(r"(?<=accurate to )\d+(?= digits)")
# Processors and libraries round differently: estimates of that go either way, and numbers of five digits or more may
# differ by three in the sixth.
DIGITS, LAST = 5, 3
# Variables that would change an answer.
OURS = ("DYNAMICS_FORMAT", "DYNAMICS_GRAVITY", "DYNAMICS_UNITS", "DYNAMICS_DIGITS", "DYNAMICS_ROUTE", "COLUMNS")


@dataclass
class Session:
    """A command of a page and its printed output: its lines in the page, the first after the command and the end."""

    command: str
    output: str
    start: int
    end: int


def sessions(text: str) -> list[Session]:
    """The commands of a page's console blocks."""
    found: list[Session] = []
    inside = False
    for number, line in enumerate(text.splitlines()):
        if line.startswith("```"):
            inside = line == "```console"
        elif inside and line.startswith("$ "):
            found.append(Session(line[2:], "", number + 1, number + 1))
        elif inside and found:
            last = found[-1]
            if last.command.endswith("\\") and not last.output:
                last.command += f"\n{line}"
                last.start = last.end = number + 1
            else:
                last.output += f"{line}\n"
                last.end = number + 1
    return found


def missing(text: str) -> list[str]:
    """The tools that a text uses and that are not installed."""
    return [tool for tool in TOOLS if tool in text and shutil.which(tool) is None]


def plain(command: str) -> list[str] | None:
    """The words of a command that is nothing but one call of the program, else None."""
    joined = command.replace("\\\n", " ")
    quoted = re.sub(r'"[^"$`\\]*"|\'[^\']*\'', "", joined)
    if not joined.startswith("dynamics ") or OPERATORS & set(quoted):
        return None
    return shlex.split(joined)[1:]


class Workshop:
    """A folder with a copy of the examples, and of the package where the page adds to it."""

    def __init__(self, folder: Path, text: str = "") -> None:
        self.bin = folder / "bin"
        self.bin.mkdir()
        self.folder = folder / "examples"
        shutil.copytree(EXAMPLES, self.folder)
        blocks = [(bool(add), name, body) for add, name, body in FILE_BLOCK.findall(text)]
        self.root = ROOT
        if any(name.startswith("dynamics_cli/") for _, name, _ in blocks):
            self.root = folder / "package"
            # with its compiled files, which hold for copies of the same time
            shutil.copytree(ROOT / "dynamics_cli", self.root / "dynamics_cli")
        for add, name, body in blocks:
            self._place(add, name, body)

    def _place(self, add: bool, name: str, body: str) -> None:
        place = (self.root if name.startswith("dynamics_cli/") else self.folder) / name
        place.parent.mkdir(parents=True, exist_ok=True)
        if add:
            before, end, _ = place.read_text().rpartition("}\n")
            body = f"{before}{body}{end}"
        place.write_text(body)

    def run(self, command: str) -> str:
        """Everything that a command prints; standard output first."""
        words = plain(command)
        if words is None or self.root != ROOT:
            done = shell(command, self.folder, self.bin, self.root)
            return done.stdout + done.stderr
        before = {name: os.environ.pop(name) for name in OURS if name in os.environ}
        try:
            with chdir(self.folder):
                outcome = run(*words)
        finally:
            os.environ.update(before)
        return outcome.out + outcome.err


def outputs(text: str, folder: Path) -> list[tuple[Session, str | None]]:
    """Each command of a page with what it prints now; None where a tool that it uses is not installed."""
    workshop = Workshop(folder, text)
    return [
        (session, None if missing(session.command) else workshop.run(session.command)) for session in sessions(text)
    ]


def alike(printed: str, shown: str) -> bool:
    """Whether two outputs are the same but for the last digit of long numbers, and the spaces that it moves."""
    if printed == shown:
        return True
    printed, shown = (" ".join(ACCURATE.sub("", text).split()) for text in (printed, shown))
    if NUMBER.sub("0", printed) != NUMBER.sub("0", shown):
        return False
    return all(_near(*pair) for pair in zip(NUMBER.findall(printed), NUMBER.findall(shown), strict=True))


def _near(one: str, other: str) -> bool:
    """Whether two numbers are the same, or long and differ by little in the sixth digit."""
    digits = max(len(number.partition("e")[0].replace(".", "").strip("0")) for number in (one, other))
    first, second = Decimal(one), Decimal(other)
    unit = Decimal(1).scaleb(min(first.adjusted(), second.adjusted()) - DIGITS)
    return first == second or (digits >= DIGITS and abs(first - second) <= LAST * unit)


def with_outputs(text: str, printed: list[tuple[Session, str | None]]) -> str:
    """A page with the outputs as they are now."""
    lines = text.splitlines(keepends=True)
    for session, output in reversed(printed):
        if output is not None:
            lines[session.start : session.end] = [output]
    return "".join(lines)


def pictures(text: str) -> list[tuple[str, str]]:
    """The commands that draw a page's pictures, and the names of the files."""
    return [(" ".join(command.split()), name) for command, name in PICTURE.findall(text)]


def drawn(text: str, folder: Path) -> dict[str, bytes]:
    """The pictures of a page."""
    commands = pictures(text)
    if not commands:
        return {}
    workshop = Workshop(folder)
    for command, name in commands:
        said = workshop.run(command)
        assert (workshop.folder / name).exists(), said
    return {name: (workshop.folder / name).read_bytes() for _, name in commands}


def _field_rows(task: Task, fields: tuple[Field, ...], required: bool = True) -> Iterator[str]:
    for field in fields:
        node = field.node
        if isinstance(node, OneOf):
            needed = " (one is required)" if field.required else ""
            for number, member in enumerate(node.members):
                note = "or " if number else "either "
                for row in _field_rows(task, member.fields, required=False):
                    yield row.replace("| `", f"| {note}`", 1).removesuffix(" |") + (
                        f"{needed} |" if not number else " |"
                    )
                    note = "… with "
        elif isinstance(node, Tagged):
            yield f"| `{node.key}` | one of {len(node.members)} names; the sizes of the one named stand beside it |"
        else:
            leaf = node if isinstance(node, Leaf) else None
            option = Option(field.key, (field.key,), leaf, required=field.required, default=field.default)
            text = option_text(option, {(field.key,): field.text}) if leaf is not None else field.text.rstrip(".")
            text = re.sub(r" \[[^\]]*\]$", "", text).replace("|", "\\|")
            if text[1:2].islower() or text[1:2] == " ":
                text = text[:1].lower() + text[1:]
            needed = " (required)" if field.required and required and leaf is not None else ""
            yield f"| `{field.key}` | {text}{needed} |"


def with_fields(text: str) -> str:
    """A page with its tables of fields: what `<!-- fields: TASK: address -->` names, as signatures describe it."""

    def table(match: re.Match[str]) -> str:
        words, address = match[1].split(), match[2]
        task = cli.family(words[0]).tasks[words[1]]
        [record] = group_records(task.specification.fields, (address,))
        rows = ["| field | is |", "|---|---|", *_field_rows(task, record.fields)]
        return "\n".join([f"<!-- fields: {match[1]}: {address} -->", "", *rows, "", "<!-- /fields -->"])

    return FIELDS.sub(table, text)


def measured(text: str) -> tuple[int, int]:
    """Lines and widest line."""
    lines = text.splitlines()
    return len(lines), max(map(len, lines), default=0)


Screen = tuple[Task, tuple[int, int], tuple[int, int]]


def screens() -> Iterator[Screen]:
    """Each task's first example: what `--all` prints, as every answer once was, and what the answer prints."""
    with chdir(ROOT):
        for name in cli.FAMILIES:
            for task in cli.family(name).tasks.values():
                words = shlex.split(task.examples[0])[1:]
                if "--format" not in words and name != "accuracy":
                    yield task, measured(run(*words, "--all").out), measured(run(*words).out)


def with_screens(text: str, measured: list[Screen] | None = None) -> str:
    """A page with its table of screens."""
    if "<!-- screens -->" not in text:
        return text
    rows = [f"| `{task.path}` | {b[0]} × {b[1]} | {a[0]} × {a[1]} |" for task, b, a in measured or screens()]
    table = ["<!-- screens -->", "", "| task | before, and with `--all` | now |", "|---|---:|---:|", *rows]
    return SCREENS.sub("\n".join([*table, "", "<!-- /screens -->"]), text)
