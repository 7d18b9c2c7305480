"""A call as typed: words, the task's options, and the options every task has."""

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

# name: (how it is given, what its value is called, help). The one list the direct route, typer and the reference share.
UNIVERSAL_OPTIONS: "dict[str, tuple[str, str, str]]" = {
    "json": ("flag", "", "Write the result document as JSON (same as --format json)."),
    "format": ("value", "FORMAT", "table, json, ndjson, csv or markdown; DYNAMICS_FORMAT sets the default."),
    "output": ("value", "FILE", "Write the document to a file, whole or not at all."),
    "units": ("value", "SYSTEM", "Units of all results: si (the trade's metric), us, or base (coherent SI)."),
    "to": ("many", "NAME=UNIT", 'Unit of one result, for example --to speed=ft/s or --to length="ft;in".'),
    "digits": ("value", "N", "Significant digits in tables (6)."),
    "input": ("value", "FILE", "Parameters from JSON or TOML (- for standard input); options win."),
    "rows": ("value", "FILE", "A stream of cases, NDJSON or CSV (- for standard input); one row out per row in."),
    "jobs": ("value", "N", "Processes for a long --rows stream or --sweep (1; all: every processor)."),
    "sweep": ("many", "NAME=A:B:N", 'A table over one parameter, or two: --sweep "friction=0.3:0.9:7".'),
    "method": ("value", "NAME", "How uncertainty is propagated; the default chooses (auto, linear, monte-carlo, …)."),
    "samples": ("value", "N", "At most so many evaluations for uncertainty; the sample of Monte Carlo."),
    "seed": ("value", "N", "Seed of lattices and samples (1)."),
    "coverage": ("value", "P", "Probability of the intervals of uncertain results (95 %)."),
    "correlate": ("many", "A,B=RHO", "Correlation of two uncertain inputs: --correlate distance,friction=0.3."),
    "limit": ("many", "[NAME=]VALUE", "Compare a result (the first, unless named) with a limit."),
    "drawing": ("value", "FILE", "The shape itself as DXF, SVG or CSV, where the task has one."),
    "plot": ("value", "FILE", "A picture as SVG, PNG or PDF; - draws a small one in the terminal."),
    "model": ("value", "NAME", "Overrule the choice of model, where there are several."),
    "explain": ("flag", "", "Show the formula with its numbers, the source, the assumptions and the choice of model."),
    "timing": ("flag", "", "Add the time the computation itself took."),
}
METHODS = ("auto", "linear", "second-order", "unscented", "quadrature", "lattice", "monte-carlo")
FORMATS = ("table", "json", "ndjson", "csv", "markdown")
SYSTEMS = ("si", "us", "base")


class Call:
    """Words and options as typed; what they mean is decided later, in one place, whichever route they came by."""

    __slots__ = ("options", "settings", "words")

    def __init__(self) -> None:
        self.words: list[str] = []
        self.options: dict[str, str | bool | list[str]] = {}
        self.settings: dict[str, str | bool | list[str]] = {}


class Settings:
    """The universal options of one call, checked."""

    def __init__(self, given: "Mapping[str, str | bool | list[str]]", environ: "Mapping[str, str]") -> None:
        self.format = self._format(given, environ)
        self.output = self._text(given, "output")
        self.units = self._text(given, "units") or "si"
        if self.units not in SYSTEMS:
            raise _unknown("units", self.units, SYSTEMS)
        self.to = _pairs("to", given)
        self.digits = self._digits(given)
        self.input = self._text(given, "input")
        self.rows = self._text(given, "rows")
        self.jobs = self._jobs(given)
        self.sweep = _pairs("sweep", given)
        self.limit = self._limits(given)
        self.method = self._text(given, "method")
        self.samples = self._whole(given, "samples", 1_000_000_000)
        self.seed = self._whole(given, "seed", 2**63)
        self.coverage = self._text(given, "coverage")
        if self.coverage:
            from dynamics_cli.core.uncertain.document import read_coverage

            read_coverage(self.coverage)  # refused whether or not it is needed, as a method is
        self.correlate: list[str] = list(given.get("correlate", ()))  # type: ignore[arg-type]
        self.drawing = self._text(given, "drawing")
        self.plot = self._text(given, "plot")
        self.model = self._text(given, "model")
        self.explain = bool(given.get("explain"))
        self.timing = bool(given.get("timing"))
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

    @staticmethod
    def _text(given: "Mapping[str, str | bool | list[str]]", name: str) -> str:
        value = given.get(name, "")
        if value == "" and name in given:
            raise UsageError(f"--{name} is empty", parameter=name)
        return str(value)

    def _format(self, given: "Mapping[str, str | bool | list[str]]", environ: "Mapping[str, str]") -> str:
        self.format_given = bool(given.get("json") or given.get("format"))
        if given.get("json"):
            if given.get("format") not in (None, "json"):
                raise UsageError("--json and --format cannot be given together", parameter="format", code="exclusive")
            return "json"
        name = self._text(given, "format") or environ.get("DYNAMICS_FORMAT") or "table"
        if name not in FORMATS:
            raise _unknown("format", name, FORMATS)
        return name

    def _jobs(self, given: "Mapping[str, str | bool | list[str]]") -> int:
        text = self._text(given, "jobs")
        if not text:
            return 1
        if not (self.rows or "sweep" in given):
            message = "--jobs spreads a stream or a sweep, and this is one case"
            raise UsageError(message, parameter="jobs", code="exclusive", hint="give --rows or --sweep with it")
        from dynamics_cli.core.jobs import read_jobs

        return read_jobs(text)

    def _digits(self, given: "Mapping[str, str | bool | list[str]]") -> int:
        text = self._text(given, "digits")
        if not text:
            return 0
        if not (text.isascii() and text.isdigit()) or len(text) > 2 or not 1 <= int(text) <= 17:
            raise UsageError(f"read {text!r}, wanted 1 to 17 significant digits", parameter="digits")
        return int(text)

    def _whole(self, given: "Mapping[str, str | bool | list[str]]", name: str, most: int) -> "int | None":
        text = self._text(given, name)
        if not text:
            return None
        if not (text.isascii() and text.isdigit() and len(text) < 20) or not 1 <= int(text) <= most:
            raise UsageError(f"read {text!r}, wanted a whole number of at least 1", parameter=name)
        return int(text)

    @staticmethod
    def _limits(given: "Mapping[str, str | bool | list[str]]") -> "list[tuple[str, str]]":
        limits = []
        for item in given.get("limit", ()):  # type: ignore[union-attr]
            name, equals, value = item.partition("=")
            limits.append((name.strip().replace("-", "_"), value) if equals else ("", item))
        return limits


def _unknown(name: str, read: str, known: "tuple[str, ...]") -> UsageError:
    return UsageError(f"read {read!r}, wanted one of {', '.join(known)}", parameter=name, code="unknown-choice")


def _pairs(option: str, given: "Mapping[str, str | bool | list[str]]") -> "dict[str, str]":
    made: dict[str, str] = {}
    for item in given.get(option, ()):  # type: ignore[union-attr]
        name, equals, value = item.partition("=")
        key = name.strip().replace("-", "_")
        if not equals or not key or not value.strip():
            raise UsageError(f"read {item!r}, wanted NAME=VALUE", parameter=option, hint=UNIVERSAL_OPTIONS[option][2])
        if key in made:
            raise UsageError(f"{key} is given twice", parameter=option)
        made[key] = value.strip()
    return made
