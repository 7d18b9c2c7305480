"""Numerical questions, the methods that answer them, and where their references are."""

from dynamics_cli.core.answering.task import load
from dynamics_cli.core.inputs.specification import Leaf, Many, OneOf, Record, Tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.core.answering.task import Family, Task
    from dynamics_cli.core.inputs.specification import Field


class Method:
    """One way to answer a question.

    `function` names a callable of the case's inputs by keyword that gives a record or a dictionary of results;
    `tracked` says that it carries rounding bounds, `needs` which library it comes from, `fields` are the parameters of
    its task.
    """

    def __init__(
        self,
        name: str,
        function: str,
        *,
        chosen: bool = False,
        tracked: bool = False,
        needs: str = "",
        fields: "Sequence[Field]" = (),
    ) -> None:
        self.name = name
        self.function = function
        self.chosen = chosen
        self.tracked = tracked
        self.needs = needs
        self.fields = fields

    def call(self) -> "Callable[..., Any]":
        """The callable of a case's inputs by keyword, as words or choices, whatever the task's parameters ask for."""
        function: Callable[..., Any] = load(self.function)
        code = getattr(function, "__code__", None)
        places = code.co_varnames[: code.co_posonlyargcount] if code else ()
        leaves = {field.name: field.node for field in self.fields if isinstance(field.node, Leaf)}
        choices = {name: leaf.choice for name, leaf in leaves.items() if leaf.choice is not None}
        several = code.co_varnames[code.co_argcount + code.co_kwonlyargcount] if code and code.co_flags & 0x04 else ""
        if not places and not choices and not several:
            return function

        def called(**given: "Any") -> "Any":
            for name, choice in choices.items():
                if isinstance(given.get(name), str):
                    given[name] = choice(given[name])
            first = [given.pop(name) for name in places if name in given]
            return function(*first, *given.pop(several, ()), **given)

        return called


class Question:
    """What is calculated, by which methods, against which cases: those of `file` whose task is `cases`.

    Errors are shares of each result, or of what the function named by `scale` says.
    """

    def __init__(
        self, family: str, task: str, name: str, file: str, cases: str, *methods: Method, scale: str = ""
    ) -> None:
        self.family = family
        self.task = task
        self.name = name
        self.file = file
        self.cases = cases
        self.methods = methods
        self.scale = scale


def textbooks(
    family: str, file: str, module: str, *rows: "tuple[str, str, str]", scale: str = ""
) -> "tuple[Question, ...]":
    """Alternatives to the tasks of a file of references: their cases, words and function.

    The program's own method joins them, and gives the question its name.
    """
    return tuple(
        Question(family, "", "", file, cases, Method(words, module + function), scale=scale)
        for cases, words, function in rows
    )


class Comparison:
    """A question whose rows a function of its own gives from a `Comparing`."""

    def __init__(self, family: str, task: str, name: str, function: str) -> None:
        self.family = family
        self.task = task
        self.name = name
        self.function = function


def groups_of(task: "Task") -> "dict[str, type]":
    """The record classes of a task's inputs: by the name of their group, and by their own name."""
    groups: dict[str, type] = {}
    for field in task.specification.fields:
        _groups(field.key, field.node, groups)
    return groups


def _groups(key: str, node: "Any", groups: "dict[str, type]") -> None:
    item = node.item if isinstance(node, Many) else node
    members: list[Record] = [item] if isinstance(item, Record) else []
    if isinstance(item, OneOf):
        members = list(item.members)
    elif isinstance(item, Tagged):
        members = list(item.members.values())
    if isinstance(item, Record):
        groups[key] = item.cls
    for member in members:
        if groups.get(member.cls.__name__) is member.cls:
            continue
        groups[member.cls.__name__] = member.cls
        for field in member.fields:
            _groups(field.key, field.node, groups)


def own_questions(family: "Family", file: str, cases: "set[str]") -> "list[Question]":
    """A question for every model of a family's tasks that has cases in a file: its cases bear the function's name."""
    questions = []
    for task in family.tasks.values():
        for model in task.models:
            name = model.function.rpartition(":")[2]
            if name not in cases:
                continue
            method = Method(
                model.method,
                model.function,
                chosen=True,
                tracked=task.tracked,
                fields=task.specification.fields,
            )
            title = task.path if len(task.models) == 1 else f"{task.path}, {model.name}"
            questions.append(Question(family.name, task.name, title, file, name, method))
    return questions
