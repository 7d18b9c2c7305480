"""Every question there is: each task with references, and the comparisons of methods."""

import sys
from functools import cache
from pathlib import Path

from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.questions import Comparison, Question, groups_of, own_questions
from dynamics_cli.core.answering.task import load as imported
from dynamics_cli.records import Formula
from dynamics_cli.registry import FAMILIES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.accuracy.questions import Method
    from dynamics_cli.core.answering.task import Family

# Questions of the core, which no family asks.
CORE = {"uncertainty": "dynamics_cli.accuracy.alternatives.uncertainty.propagation"}


# Further methods, which only a checkout has beside the package.
PEERS = Path(__file__).parents[2] / "tests" / "accuracy" / "peers"


def _names() -> "list[str]":
    return [*(name for name, entry in FAMILIES.items() if entry.questions or entry.references), *CORE]


@cache
def _family(name: str) -> "Family":
    return imported(f"{FAMILIES[name].module}:FAMILIES")[name]  # type: ignore[no-any-return]


@cache
def groups(name: str) -> "dict[str, type]":
    """The record classes of a family's inputs."""
    classes: dict[str, type] = {"Formula": Formula}
    if name not in CORE:
        for task in _family(name).tasks.values():
            classes |= groups_of(task)
    return classes


def questions(family: str, task: str) -> "list[Question | Comparison]":
    """The questions of a family and task, or all; alternatives stand in the question of the program's own method."""
    asked: list[Question | Comparison] = []
    for name in _names():
        if family in ("", name):
            asked += [question for question in _questions(name) if task in ("", question.task)]
    return asked


@cache
def _questions(name: str) -> "list[Question | Comparison]":
    files, module = ((), CORE[name]) if name in CORE else (FAMILIES[name].references, FAMILIES[name].questions)
    named: list[Question | Comparison] = list(imported(f"{module}:QUESTIONS")) if module else []
    derived = {
        (question.file, question.cases): question
        for file in files
        for question in own_questions(_family(name), file, {case.task for case in load(file)})
        if question.name not in {entry.name for entry in named if isinstance(entry, Comparison)}
    }
    others: list[Question | Comparison] = []
    for question in named:
        own = derived.get((question.file, question.cases)) if isinstance(question, Question) else None
        if own is None or not isinstance(question, Question):
            others.append(question)
            continue
        own.scale = question.scale
        if any(method.chosen for method in question.methods):
            own.methods = question.methods
        else:
            own.methods = (*own.methods, *question.methods)
    return [*derived.values(), *others]


@cache
def peers() -> "dict[str, tuple[Method, ...]] | None":
    """Further methods by question: libraries of others and alternatives that lost. None without a checkout."""
    if not PEERS.is_dir():
        return None
    if str(PEERS.parent) not in sys.path:
        sys.path.append(str(PEERS.parent))
    return imported("peers:METHODS")  # type: ignore[no-any-return]
