"""Headings in words, `north`, `NNE`, `N 30 E` or `30 deg east of north`, as degrees clockwise from north."""

from decimal import Decimal, InvalidOperation

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.inputs.context import Context

POINTS = ("n", "nne", "ne", "ene", "e", "ese", "se", "sse", "s", "ssw", "sw", "wsw", "w", "wnw", "nw", "nnw")
PLUS_MINUS = ("±", "+/-", "+-")
FORMS = "north, NE, N 30 E or 30 deg east of north"


def in_degrees(text: str, context: "Context") -> str:
    """A heading without words of the compass; a distribution is left as it is."""
    if "(" in text:
        return text
    words = text.strip()
    sign = next((sign for sign in PLUS_MINUS if sign in words), "±")
    centre, _, width = (part.strip() for part in words.partition(sign))
    if width[-1:].isalpha() and width.rpartition(" ")[2].lower() not in ("deg", "degrees", "rad"):
        # N 30 ± 2 E and 30 ± 2 deg east of north: the width stands within
        number = width.split()[0]
        centre, width = f"{centre} {width.removeprefix(number).strip().removeprefix('deg')}", number
    heading = _bearing(centre)
    if heading is None:
        hint = f"write for example 40 deg, or on a compass {FORMS}"
        raise UsageError(f"{words!r} is not a heading", code="heading", hint=hint)
    if context.axes.lower() not in ("compass", "north"):
        given = "--axes compass" if context.spell("axes").startswith("--") else 'axes = "compass"'
        raise UsageError(
            f"{words!r} is a direction of the compass, and the axes are {context.axes or 'mathematical'}",
            code="axes", hint=f"{given} counts all headings clockwise from north",
        )  # fmt: skip
    return f"{heading} deg ± {width}" if width else f"{heading} deg"


def _bearing(words: str) -> "Decimal | None":
    """Degrees clockwise from north of a point of the compass, or of an angle from one towards another."""
    if words[:1].isalpha() and words[1:].lstrip()[:1].isdigit():
        words = f"{words[1:-1]} {words[-1]} of {words[0]}"
    front, turned, base = words.rpartition(" of ")
    start = _point(base)
    if not turned or start is None:
        return None if start is None else start * Decimal("22.5")
    number, _, toward = front.rstrip().rpartition(" ")
    end = _point(toward)
    if end is None or (end - start) % 8 != 4:
        return None
    try:
        angle = Decimal(number.strip().removesuffix("°").removesuffix("deg").strip())
        within = 0 <= angle <= 90
    except InvalidOperation:
        return None
    if not within:
        return None
    return start * Decimal("22.5") + (angle if (end - start) % 16 == 4 else -angle)


def _point(words: str) -> "int | None":
    """The place of one of sixteen points, clockwise from north, by its letters or its name."""
    letters = words.strip().lower().removeprefix("due ").removesuffix("bound")
    for name in ("north", "east", "south", "west"):
        letters = letters.replace(name, name[0])
    letters = letters.replace("-", "").replace(" ", "")
    return POINTS.index(letters) if letters in POINTS else None
