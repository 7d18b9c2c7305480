"""Tasks and families: the declarations of a family's commands.py, from which its whole user interface is derived."""

from dynamics_cli.core.inputs.options import Option, options
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS
from dynamics_cli.core.inputs.specification import DRAWING, Specification, SpecificationError, specification
from dynamics_cli.records import docstring

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

# No parameter may use the name of an option that every task has.
UNIVERSAL = (*UNIVERSAL_OPTIONS, "help", "version")
# Folder of the example files in a checkout; `dynamics examples NAME --copy` writes them into the current folder.
EXAMPLES_FOLDER = "examples/"
# The head of the section of a docstring that says where a calculation comes from.
REFERENCES = "References\n"


def load(reference: str) -> "Any":
    """The object named by "package.module:name", imported now."""
    module, _, name = reference.partition(":")
    return getattr(__import__(module, fromlist=[name]), name)


class Model:
    """One way to answer a task, and where it comes from.

    A formula writes results and inputs as `{address|symbol}`, so that it can be shown with symbols or with numbers; of
    several (one for each alternative of the inputs) the one whose numbers are available is shown.
    `formula_of` names the function of the inputs, as a document has them, that gives the formula of this very case.
    `suffices` names a function of the same parameters that returns the reason why this model is sufficient, or None.
    `together` names one that answers many cases at once where the model takes no arrays: from the parameters of each,
    records with its numbers, or the error for a refused one.
    """

    def __init__(
        self,
        name: str,
        function: str,
        *,
        source: str = "",
        formula: "str | tuple[str, ...]" = "",
        formula_of: str = "",
        assumptions: "tuple[str, ...]" = (),
        method: str = "closed form",
        suffices: str = "",
        together: str = "",
    ) -> None:
        self.name = name
        self.together = together
        self.function = function
        self._source = source
        self.formulas = (formula,) if isinstance(formula, str) else formula
        self.formula_of = formula_of
        self.assumptions = assumptions
        self.method = method
        self.suffices = suffices

    @property
    def source(self) -> str:
        """Where it comes from: as stated, else the references of its function."""
        if not self._source:
            # Newer interpreters take the indentation away; the first word is the line under the heading.
            _, *words = docstring(self.call()).partition(REFERENCES)[2].partition("\n\n")[0].split() or [""]
            self._source = " ".join(words).rstrip(".")
        return self._source

    @property
    def key(self) -> str:
        """The name as `--model` takes it."""
        return self.name.split(",")[0].strip().lower().replace(" ", "-").replace("–", "-")

    def call(self) -> "Callable[..., Any]":
        """The physics function."""
        return load(self.function)  # type: ignore[no-any-return]


class Task:
    """One command: its models in order of size (all of one signature), a line of help, and examples that run.

    How it calculates
        arrays: the function takes arrays for floats. branches: it does for cases that take the same branches.
        tracked: it takes tracked numbers. points: how many samples are taken at most without --samples (0: as
        many as of any task). cost: seconds of a usual processor that a case takes, where they limit the samples.
        errors: results that measure the calculation itself; rounding decides them, so none is
        spread over inputs. unspread: further results of the nominal case alone, such as a sensitivity; of both, two
        digits are shown. chances: a yes or no with the result that is not below zero where it is yes, for its
        probability: {"avoidable": "margin"}. limited: limits among the inputs, each with groups of results; of a group
        the first with a value is compared, {"scene.speed_limit": ("start_speed impact_speed",)}.
        verdict: the checks are the answer; the exit status shows a failed one.
    What it shows
        headline: the results of the short answer in the order of the trade, tables among them, each with a label where
        its address is not the trade's term, "centre_distance: centre distance a_w"; a result in braces stands in it,
        "distance: distance at {time}"; a table may name the columns that it shows first, "points: motion | angle=θ".
        digits: how many a table shows by default (17: all). table: the one that CSV writes (of several, separated by
        spaces, the one present). listing: that table is the answer. columns: the task takes --column. layout: the
        function that lays out results where rows and columns would be hard to read, from the document's results,
        digits and the terminal's width (0: not a terminal). findings: what a report says of results in place of their
        labels, a clause with the value in braces, the bodies by name, other results by address, "time_left: {second}
        came into sight {} before the impact", or a noun, "time: time to rest".
    What it writes
        plot: the function that makes the picture of --plot, from the result record and the task's own parameters by
        name. sheet: the one that makes a data sheet. writers: for endings of --drawing of the task's own, the function
        of the result record that gives the file's text or bytes, {"urdf": "module:function"}; one that takes more is
        given the task's own parameters by name.
    How it is called
        also: further names that a call may use; help and listings show the first. names: where to find the values that
        an option may take, for completion, {"material": "module:names"}. pointers: where to find values of parameters
        that are missing or typed as a word; under `drawing`, the task that writes what its own --drawing does not.
        unused: parameters of a file that other tasks of the same scene take, and this one does not.
        notes: the language of an option, after the examples in the help. scene: the values that a template shows, by
        address, where its required fields alone do not make a case with an answer, {"bodies[1].mass": "2 kg"}.
    """

    def __init__(
        self,
        name: str,
        summary: str,
        *models: Model,
        examples: "tuple[str, ...]" = (),
        table: str = "",
        arrays: bool = True,
        branches: bool = False,
        tracked: bool = True,
        digits: int = 6,
        writers: "dict[str, str] | None" = None,
        plot: str = "",
        sheet: str = "",
        layout: str = "",
        verdict: bool = False,
        names: "dict[str, str] | None" = None,
        headline: "tuple[str, ...]" = (),
        columns: bool = False,
        listing: bool = False,
        notes: str = "",
        scene: "dict[str, str] | None" = None,
        also: "tuple[str, ...]" = (),
        pointers: "dict[str, str] | None" = None,
        errors: "tuple[str, ...]" = (),
        unspread: "tuple[str, ...]" = (),
        chances: "dict[str, str] | None" = None,
        limited: "dict[str, tuple[str, ...]] | None" = None,
        findings: "tuple[str, ...]" = (),
        points: int = 0,
        cost: float = 0.0,
        unused: "tuple[str, ...]" = (),
    ) -> None:
        self.name = name
        self.unused = unused
        self.pointers = pointers or {}
        self.errors = errors
        self.unspread = (*errors, *unspread)
        self.chances = chances or {}
        self.limited = limited or {}
        self.findings = tuple(_labelled(entry) for entry in findings)
        self.points = points
        self.cost = cost
        self.also = also
        self.summary = summary
        self.plot = plot
        self.sheet = sheet
        self.notes = notes
        self.scene = scene or {}
        self.headline = tuple(_labelled(entry) for entry in headline)
        self.names = names or {}
        self.columns = columns
        self.listing = listing
        self.layout = layout
        self.verdict = verdict
        self.models = models
        self.examples = examples
        self.table = table
        self.arrays = arrays
        self.branches = branches
        self.tracked = tracked
        self.digits = digits
        self.writers = writers or {}
        self.family = ""
        self._specification: Specification | None = None
        self._options: dict[str, Option] | None = None

    @property
    def path(self) -> str:
        """The command as typed: "skid speed"."""
        return f"{self.family} {self.name}".strip()

    @property
    def shown_examples(self) -> "tuple[str, ...]":
        """The examples as they run once their files are copied into the current folder."""
        return tuple(example.replace(EXAMPLES_FOLDER, "") for example in self.examples)

    @property
    def specification(self) -> Specification:
        """The specification read from the first model's signature."""
        if self._specification is None:
            spec = specification(self.models[0].call())
            named = options(spec.fields)
            reserved = sorted(set(named) & set(UNIVERSAL))
            if reserved:
                raise SpecificationError(f"{self.path}: parameters may not be named {', '.join(reserved)}")
            if any(option.leaf is not None and option.leaf.kind is DRAWING for option in named.values()):
                raise SpecificationError(f"{self.path}: a drawing is a result, not a parameter")
            nodes = [getattr(field.node, "item", field.node) for field in spec.result.fields]
            draws = any(getattr(node, "kind", None) is DRAWING for node in nodes)
            if draws and not self.writers.keys().isdisjoint(("dxf", "svg", "csv")):
                raise SpecificationError(f"{self.path}: dxf, svg and csv have their writers")
            self._specification, self._options = spec, named
        return self._specification

    @property
    def options(self) -> "dict[str, Option]":
        """The task's own options by name."""
        if self._options is None:
            _ = self.specification
        return self._options  # type: ignore[return-value]


def _labelled(entry: str) -> "tuple[str, str]":
    address, _, label = entry.partition(":")
    return address.strip(), label.strip()


class Tasks(dict[str, Task]):
    """Tasks by name; looked up, further names of a task lead to it too, and are not listed."""

    def __missing__(self, name: str) -> Task:
        for task in self.values():
            if name in task.also:
                return task
        raise KeyError(name)

    def get(self, name: str, default: "Task | None" = None) -> "Task | None":  # type: ignore[override]
        """The task of a name, or of a further name."""
        try:
            return self[name]
        except KeyError:
            return default


class Family:
    """A family of tasks, or a command that is one task."""

    def __init__(self, name: str, summary: str, *tasks: Task) -> None:
        self.name = name
        self.summary = summary
        self.tasks = Tasks((task.name, task) for task in tasks)
        for task in tasks:
            task.family = name

    @property
    def alone(self) -> "Task | None":
        """The one task of a command without a TASK word."""
        return self.tasks.get("")
