"""A call as typed: words, the task's options, and the options every task has."""

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

# name: (how it is given, placeholder, help). The one list that the direct route, typer and the reference share.
UNIVERSAL_OPTIONS: "dict[str, tuple[str, str, str]]" = {
    "json": ("flag", "", "Write the result document as JSON (same as --format json)."),
    "format": ("value", "FORMAT", "table, json, ndjson, csv or markdown; DYNAMICS_FORMAT sets the default."),
    "output": (
        "value",
        "FILE",
        "Write the document to a file; its ending decides: .json .ndjson .csv .md .txt (- for standard output).",
    ),
    "all": ("flag", "", "Every result with its error bound, every table, what drives each uncertain result."),
    "only": ("value", "NAME,...", "Only these results: one a line for $(...), of rows the columns."),
    "table": ("value", "NAME", "One table of the result, complete."),
    "quiet": ("flag", "", "Only the headline results."),
    "fail": ("flag", "", "Status 6 when a limit is exceeded or a verdict is negative."),
    "fail-above": ("value", "P", "With uncertain results, the probability above which --fail applies (50 %)."),
    "units": ("value", "SYSTEM", "Units of all results: si (the trade's metric), us, or base (coherent SI)."),
    "to": ("many", "NAME=UNIT", 'Unit of one result, for example --to speed=ft/s or --to length="ft;in".'),
    "digits": ("value", "N", "Significant digits in tables (6)."),
    "input": ("value", "FILE", "Parameters from JSON or TOML (- for standard input); options win."),
    "template": ("flag", "", "Write a commented file with every parameter, to fill in and give to --input."),
    "rows": ("value", "FILE", "A stream of cases, NDJSON or CSV (- for standard input); one row out per row in."),
    "column": (
        "many",
        "NAME=UNIT",
        "For convert --rows: a CSV column whose cells hold units, and the unit to convert it to.",
    ),
    "references": ("flag", "", "Let rows take results from files: @crash.json:speed."),
    "bounds": ("flag", "", "Add a column to rows and sweeps: the largest relative error bound of their results."),
    "jobs": ("value", "N", "Processes for a long --rows stream or --sweep (1; all: every processor)."),
    "sweep": (
        "many",
        "NAME=A:B:N",
        'A table over one parameter, or two: --sweep "friction=0.3:0.9:7", "distance=20, 40 m", "law=harmonic,3-4-5".',
    ),
    "method": ("value", "NAME", "How uncertainty is propagated; the default chooses (auto, linear, monte-carlo, …)."),
    "samples": (
        "value",
        "N",
        "Maximum number of evaluations for uncertainty, up to 1e8; the sample size of Monte Carlo.",
    ),
    "seed": ("value", "N", "Seed of lattices and samples (1)."),
    "coverage": ("value", "P", "Probability of the intervals of uncertain results (95 %)."),
    "correlate": ("many", "A,B=RHO", "Correlation of two uncertain inputs: --correlate distance,friction=0.3."),
    "limit": ("many", "[NAME=]VALUE", "Compare a result (the first, unless another is named) with a limit."),
    "quantile": ("many", "NAME=P", 'Quantile of an uncertain result: --quantile speed="5 %", --quantile speed=0.9.'),
    "drawing": ("value", "FILE", "Write the shape as DXF, SVG or CSV, where the task has one."),
    "plot": ("value", "FILE", "Write a picture as SVG, PNG or PDF; - draws a small one in the terminal."),
    "model": ("value", "NAME", "Choose the model, where the task has several."),
    "explain": ("flag", "", "Show the formula with its numbers, the source, the assumptions and the choice of model."),
    "timing": ("flag", "", "Add the time the computation itself took."),
    "time-limit": (
        "value",
        "TIME",
        'Stop after this time ("30 s") with what is finished by then; the exit status is 3.',
    ),
}
METHODS = ("auto", "linear", "second-order", "unscented", "quadrature", "lattice", "monte-carlo")
FORMATS = ("table", "json", "ndjson", "csv", "markdown")
# The format that the ending of --output selects.
ENDINGS = {"json": "json", "ndjson": "ndjson", "jsonl": "ndjson", "csv": "csv", "md": "markdown", "txt": "table"}
# Endings that other options write.
OTHER_WRITERS = {"dxf": "drawing", "svg": "drawing or --plot", "png": "plot", "pdf": "plot"}
SYSTEMS = ("si", "us", "base")
MOST_SAMPLES = 100_000_000


# The names of standard output: a file with the second name would replace the device.
STANDARD_OUTPUT = ("-", "/dev/stdout")


class Call:
    """Words and options as typed; they are interpreted later, in one place, whichever route they came by."""

    __slots__ = ("options", "settings", "words")

    def __init__(self) -> None:
        self.words: list[str] = []
        self.options: dict[str, str | bool | list[str]] = {}
        self.settings: dict[str, str | bool | list[str]] = {}


class Settings:
    """The universal options of one call, checked."""

    def __init__(self, given: "Mapping[str, str | bool | list[str]]", environ: "Mapping[str, str]") -> None:
        self.output = named_file(self._text(given, "output"))
        self.format = self._format(given, environ)
        self.units = self._text(given, "units") or environ.get("DYNAMICS_UNITS") or "si"
        if self.units not in SYSTEMS:
            raise _unknown("units", self.units, SYSTEMS, given)
        self.to = _pairs("to", given)
        self.digits = self._digits(given, environ)
        self.all = bool(given.get("all"))
        self.only = [name.strip().replace("-", "_") for name in self._text(given, "only").split(",") if name.strip()]
        self.table = self._text(given, "table").replace("-", "_")
        self.quiet = bool(given.get("quiet"))
        self.fail = bool(given.get("fail")) or "fail-above" in given
        fail_above = self._text(given, "fail-above")
        self.fail_above = read_coverage(fail_above, "fail-above") if fail_above else 0.5
        self.input = self._text(given, "input")
        self.rows = self._text(given, "rows")
        self.columns: list[str] = list(given.get("column", ()))  # type: ignore[arg-type]
        if self.columns and not self.rows:
            raise UsageError("--column is for --rows", parameter="column", code="exclusive")
        self.references, self.bounds = bool(given.get("references")), bool(given.get("bounds"))
        self._require_many(given)
        self.jobs = self._jobs(given)
        self.sweep = _pairs("sweep", given)
        self.limit = self._limits(given)
        self.method = self._text(given, "method")
        self.quantile = self._quantiles(given)
        self.samples = self._whole(given, "samples", MOST_SAMPLES)
        self.seed = self._whole(given, "seed", 2**63)
        self.coverage = self._text(given, "coverage")
        if self.coverage:
            read_coverage(self.coverage)  # refused even if it is not needed, as a method is
        self.correlate: list[str] = list(given.get("correlate", ()))  # type: ignore[arg-type]
        self.drawing = self._text(given, "drawing")
        self.plot = self._text(given, "plot")
        self.model = self._text(given, "model")
        self.explain = bool(given.get("explain"))
        self.timing = bool(given.get("timing"))
        self.time_limit = self._text(given, "time-limit")
        if len(self.sweep) > 2:
            raise UsageError("at most two parameters can be swept", parameter="sweep")
        if self.rows and self.sweep:
            raise UsageError("--rows and --sweep cannot be given together", parameter="rows", code="exclusive")
        if self.drawing and (self.rows or self.sweep):
            many = "rows" if self.rows else "sweep"
            raise UsageError(f"--drawing is for one case and --{many} for many", parameter="drawing", code="exclusive")
        if self.plot and self.rows:
            raise UsageError("--plot is for one case and --rows for many", parameter="plot", code="exclusive")
        if self.rows == "-" and self.input == "-":
            raise UsageError("--rows and --input cannot both read standard input", parameter="rows", code="exclusive")

    def _require_many(self, options: "Mapping[str, str | bool | list[str]]") -> None:
        """Refuse options for many cases when there is one."""
        if self.references and not self.rows:
            raise UsageError("--references is for --rows", parameter="references", code="exclusive")
        if self.bounds and not (self.rows or options.get("sweep")):
            hint = "--all and --explain show the bounds of one case"
            raise UsageError("--bounds is for --rows and --sweep", parameter="bounds", code="exclusive", hint=hint)

    @staticmethod
    def _text(options: "Mapping[str, str | bool | list[str]]", name: str) -> str:
        value = options.get(name, "")
        if value == "" and name in options:
            raise UsageError(f"--{name} is empty", parameter=name)
        return str(value)

    def _format(self, options: "Mapping[str, str | bool | list[str]]", environ: "Mapping[str, str]") -> str:
        self.format_given = bool(options.get("json") or options.get("format"))
        if options.get("json"):
            if options.get("format") not in (None, "json"):
                raise UsageError("--json and --format cannot be given together", parameter="format", code="exclusive")
            if _ending_format(self.output) not in ("", "json"):
                raise UsageError(
                    f"--json and the ending of {self.output!r} contradict each other",
                    parameter="json",
                    code="exclusive",
                )
            return "json"
        name = self._text(options, "format")
        ending = _ending_format(self.output)
        if name in FORMATS and ending and name != ending:
            raise UsageError(
                f"--format {name} and the ending of {self.output!r} contradict each other",
                parameter="format",
                code="exclusive",
                hint="leave --format out, or give the file another ending",
            )
        name = name or ending or environ.get("DYNAMICS_FORMAT") or "table"
        if name not in FORMATS:
            raise _unknown("format", name, FORMATS, options)
        return name

    def _jobs(self, options: "Mapping[str, str | bool | list[str]]") -> int:
        text = self._text(options, "jobs")
        if not text:
            return 1
        if not (self.rows or "sweep" in options):
            message = "--jobs divides a stream or a sweep, and this is a single case"
            raise UsageError(message, parameter="jobs", code="exclusive", hint="give --rows or --sweep with it")
        return read_jobs(text)

    def _digits(self, options: "Mapping[str, str | bool | list[str]]", environ: "Mapping[str, str]") -> int:
        text = self._text(options, "digits") or environ.get("DYNAMICS_DIGITS", "")
        if not text:
            return 0
        if not (text.isascii() and text.isdigit()) or len(text) > 2 or not 1 <= int(text) <= 17:
            error = UsageError(f"read {text!r}, wanted 1 to 17 significant digits", parameter="digits")
            error.named = "" if "digits" in options else "DYNAMICS_DIGITS"
            raise error
        return int(text)

    def _whole(self, options: "Mapping[str, str | bool | list[str]]", name: str, most: int) -> "int | None":
        text = self._text(options, name)
        if not text:
            return None
        if not (text.isascii() and text.isdigit() and len(text) < 20) or not 1 <= int(text) <= most:
            raise UsageError(f"read {text!r}, wanted a whole number from 1 to {most}", parameter=name)
        return int(text)

    @staticmethod
    def _quantiles(options: "Mapping[str, str | bool | list[str]]") -> "list[tuple[str, str]]":
        """Each as a result's name and a probability; of one result there may be several."""
        items = options.get("quantile", ())
        return [pair for item in items for pair in _pairs("quantile", {"quantile": [item]}).items()]  # type: ignore[union-attr]

    @staticmethod
    def _limits(options: "Mapping[str, str | bool | list[str]]") -> "list[tuple[str, str]]":
        limits = []
        for item in options.get("limit", ()):  # type: ignore[union-attr]
            name, equals, value = item.partition("=")
            if any(sign in name for sign in "<>≤≥"):
                hint = 'for example --limit "speed=50 km/h"; the answer says whether it is exceeded'
                raise UsageError(f"read {item!r}, wanted [NAME=]VALUE", parameter="limit", hint=hint)
            limits.append((name.strip().replace("-", "_"), value) if equals else ("", item))
        return limits


def named_file(output: str) -> str:
    """The file that --output names; none for standard output."""
    return "" if output in STANDARD_OUTPUT else output


def _ending_format(output: str) -> str:
    """The format that the ending of a file asks for, or nothing where it has no ending."""
    base = output.rpartition("/")[2].rpartition("\\")[2]
    stem, dot, ending = base.rpartition(".")
    if not dot or not stem:
        return ""
    format_ = ENDINGS.get(ending.lower())
    if format_ is None:
        writer = OTHER_WRITERS.get(ending.lower())
        hint = f"--{writer} writes such files" if writer else f"endings are {' '.join('.' + e for e in ENDINGS)}"
        hint += "; `dynamics report` makes one of a document in .json" if ending.lower() in ("pdf", "html") else ""
        raise UsageError(
            f"a document cannot be written as .{ending}",
            parameter="output",
            code="format",
            hint=hint,
        )
    return format_


def _unknown(
    name: str, read: str, known: "tuple[str, ...]", options: "Mapping[str, str | bool | list[str]]"
) -> UsageError:
    message, hint = f"read {read!r}, wanted one of {', '.join(known)}", None
    if name == "units":
        hint = f"the unit of one result: --to NAME={read}; of the numbers in a file of a mesh: --length-unit {read}"
    error = UsageError(message, parameter=name, code="unknown-choice", hint=hint)
    error.named = "" if name in options else f"DYNAMICS_{name.upper()}"
    return error


def _pairs(option: str, options: "Mapping[str, str | bool | list[str]]") -> "dict[str, str]":
    pairs: dict[str, str] = {}
    for item in options.get(option, ()):  # type: ignore[union-attr]
        name, equals, value = item.partition("=")
        key = name.strip().replace("-", "_")
        if not equals or not key or not value.strip():
            _, form, hint = UNIVERSAL_OPTIONS[option]
            raise UsageError(f"read {item!r}, wanted {form}", parameter=option, hint=hint)
        if key in pairs:
            raise UsageError(f"{key} is given twice", parameter=option)
        pairs[key] = value.strip()
    return pairs


def read_coverage(text: str, parameter: str = "coverage") -> float:
    """`95 %` or `0.95`."""
    return read_probability(text, parameter, 0.0) if text else 0.95


def read_jobs(text: str) -> int:
    """`4`, or `all` for every processor there is."""
    import os

    if text == "all":
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not (text.isascii() and text.isdigit() and len(text) < 4 and int(text) >= 1):
        raise UsageError(f"read {text!r}, wanted a number of processes from 1 to 999, or all", parameter="jobs")
    return int(text)


def read_probability(text: str, option: str, least: float) -> float:
    """`95 %` or `0.95`, above the minimum and below one by as much."""
    from dynamics_cli.core.inputs.quantity_text import read_scalar
    from dynamics_cli.quantities import Kind

    try:
        return read_scalar(text, Kind(option, "", above=least, below=1.0 - least, example="95 %")).si
    except UsageError as error:
        error.parameter = option
        raise
