"""Published ranges by topic, surface and words, for comparison: never a default of a calculation."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Ratio, Text
from dynamics_cli.records import record
from dynamics_cli.skid.values.data import ROWS


@record
class Range:
    """One published range."""

    topic: Annotated[Text, "The subject."]
    what: Annotated[Text, "What was measured or proposed."]
    condition: Annotated[Text, "Under which condition."]
    surface: Annotated[Text, "On which surface, where it is of one."]
    least: Annotated[Ratio | None, "The lower end, in the row's unit; none where only an upper one is printed [-]."]
    greatest: Annotated[Ratio, "The upper end, in the row's unit; a single value stands at both [-]."]
    unit: Annotated[Text, "The unit of both ends; none for pure numbers."]
    source: Annotated[Text, "Where it is printed."]


@record
class Values:
    """The ranges asked for."""

    values: Annotated[tuple[Range, ...], "Published ranges, each with its source."]


TOPICS = tuple(dict.fromkeys(row[0] for row in ROWS))
SURFACES = tuple(dict.fromkeys(row[3] for row in ROWS if row[3]))


def values(
    *words: Annotated[Text, "A topic, or words to look for; all ranges unless any is given."],
    surface: Annotated[Text | None, "Only of this surface, e.g. asphalt."] = None,
) -> Values:
    """Published ranges of friction, drag, reaction, walking, restitution and the errors of methods, with their sources.

    Equation
    --------
    None: each row is as its source prints it. No calculation takes a value from here.

    Returns
    -------
    Values
        The ranges in which every word stands.

    Raises
    ------
    InadmissibleError
        When no range has all the words, or none is of the surface; the message names the topics available.

    References
    ----------
    Each row has its own; what is known through others says so.

    Examples
    --------
    >>> [(row.least, row.greatest) for row in values("friction", surface="ice").values]
    [(0.1, 0.15)]
    """
    surface_sought = surface.lower().strip() if surface is not None else None
    require(
        surface_sought is None or any(surface_sought in name for name in SURFACES),
        "no range is of the surface {surface}", surface=repr(surface), word=surface, code="unknown-surface",
        hint=f"there is {', '.join(SURFACES)}; a word of a row needs no option: dynamics skid values {{word}}",
    )  # fmt: skip
    query = " ".join(words).lower().replace("-", " ").split()
    rows = [row for row in ROWS if _fits(row, query, surface_sought)]
    require(
        bool(rows), "no range has {words}", code="unknown-value",
        words=" and ".join([*map(repr, query), *([f"the surface {surface!r}"] if surface else [])]),
        hint="topics: " + ", ".join(TOPICS),
    )  # fmt: skip
    return Values(tuple(Range(*row) for row in rows))


def _fits(row: "tuple[object, ...]", query: "list[str]", surface: "str | None") -> bool:
    """Whether every word begins a word of the row, and its surface is the one asked for."""
    text = " ".join(str(part) for part in (*row[:4], row[7])).lower().replace("-", " ")
    begun = f" {text}"
    return all(any(f" {form}" in begun for form in _forms(word)) for word in query) and (
        surface is None or surface in str(row[3])
    )


def _forms(word: str) -> "tuple[str, ...]":
    """A word with the endings that people write otherwise."""
    stem = word.removesuffix("s") if len(word) > 3 else word
    return (stem, OTHER_WORDS.get(stem, stem))


OTHER_WORDS = {
    "tire": "tyre", "perception": "reaction", "edr": "record", "cdr": "record", "mu": "friction", "rider": "riders",
    "coefficient": "friction", "rollover": "roll", "walk": "walking", "pedestrian": "pedestrian", "yaw": "yaw",
    "drag": "drag", "asphalt": "asphalt", "tarmac": "asphalt", "motorbike": "motorcycle", "brake": "brak",
}  # fmt: skip
