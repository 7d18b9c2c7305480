"""Numerical questions, the methods that answer them, and where their references are."""

from dynamics_cli.core.specification import Many, OneOf, Record, Tagged
from dynamics_cli.core.task import load

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.core.task import Family, Task


class Method:
    """One way to answer a question.

    `function` names a callable of the case's inputs by keyword that gives a record or a dictionary of results;
    `tracked` says that it carries rounding bounds, `arrays` that it takes arrays for floats, `needs` which library it
    comes from.
    """

    def __init__(
        self,
        name: str,
        function: str,
        *,
        chosen: bool = False,
        tracked: bool = False,
        arrays: bool = False,
        needs: str = "",
    ) -> None:
        self.name = name
        self.function = function
        self.chosen = chosen
        self.tracked = tracked
        self.arrays = arrays
        self.needs = needs

    def call(self) -> "Callable[..., Any]":
        """The callable."""
        return load(self.function)  # type: ignore[no-any-return]


class Question:
    """What is calculated, by which methods, against which cases: those of `file` whose task is `cases`."""

    def __init__(self, family: str, task: str, name: str, file: str, cases: str, *methods: Method) -> None:
        self.family = family
        self.task = task
        self.name = name
        self.file = file
        self.cases = cases
        self.methods = methods


class Comparison:
    """A question whose rows are made by a function of its own: it takes (name, hard, full, timed) and gives rows.

    Where it names `peers`, it also takes a tuple of those that are asked for and installed.
    """

    def __init__(self, family: str, task: str, name: str, function: str, *, peers: "tuple[str, ...]" = ()) -> None:
        self.family = family
        self.task = task
        self.name = name
        self.function = function
        self.peers = peers


def groups_of(task: "Task") -> "dict[str, type]":
    """The record classes of a task's inputs: by the name of their group, and by their own name."""
    made: dict[str, type] = {}
    for field in task.specification.fields:
        _groups(field.key, field.node, made)
    return made


def _groups(key: str, node: "Any", made: "dict[str, type]") -> None:
    item = node.item if isinstance(node, Many) else node
    members: list[Record] = [item] if isinstance(item, Record) else []
    if isinstance(item, OneOf):
        members = list(item.members)
    elif isinstance(item, Tagged):
        members = list(item.members.values())
    if isinstance(item, Record):
        made[key] = item.cls
    for member in members:
        if made.get(member.cls.__name__) is member.cls:
            continue
        made[member.cls.__name__] = member.cls
        for field in member.fields:
            _groups(field.key, field.node, made)


def own_questions(family: "Family", file: str, cases: "set[str]") -> "list[Question]":
    """A question for every model of a family's tasks that has cases in a file: its cases bear the function's name."""
    made = []
    for task in family.tasks.values():
        for model in task.models:
            name = model.function.rpartition(":")[2]
            if name in cases:
                own = Method(model.method, model.function, chosen=True, tracked=task.tracked, arrays=task.arrays)
                title = task.path if len(task.models) == 1 else f"{task.path}, {model.name}"
                made.append(Question(family.name, task.name, title, file, name, own))
    return made
