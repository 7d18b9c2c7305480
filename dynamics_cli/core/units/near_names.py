"""Similar words, for suggestions in errors: options, fields and units."""

from dynamics_cli.core.units.table import NAMES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

COMMON_PREFIXES = {"s": ("k", "M", "G", "m", "c", "u"), "w": ("kilo", "mega", "milli", "centi", "micro")}


MANY_RESULTS = 12


def nearest_words(word: str, known: "Iterable[str]", count: int = 3) -> "list[str]":
    """Up to `count` of the known words that look like `word`, nearest first; else those that it is a whole part of."""
    from difflib import get_close_matches

    by_plain = {name.lower().replace("-", "_"): name for name in known}
    plain = word.lower().replace("-", "_")
    near = get_close_matches(plain, sorted(by_plain), n=count, cutoff=0.67)
    near = near or [name for name in by_plain if f"_{plain}_" in f"_{name}_"][:count]
    return [by_plain[name] for name in near]


def instead_of(name: str, known: "Iterable[str]") -> str:
    """What stands instead of a result that there is not: all results, or of many those of a similar name."""
    listed = list(known)
    near = nearest_words(name, listed) if len(listed) > MANY_RESULTS else []
    return f"did you mean {' or '.join(near)}? --json shows all" if near else f"results are {', '.join(listed)}"


def names_like(name: str, count: int = 5) -> list[str]:
    """Find the names nearest to a misspelt one, nearest first; a difference of case alone is the nearest."""
    if not 0 < len(name) <= 40:
        return []
    lower = name.lower()
    limit = 0 if len(name) == 1 else 1 if len(name) <= 4 else 2
    candidates_near = []
    for spelling, prefixed in _spellings():
        if abs(len(spelling) - len(name)) > limit:
            continue
        distance = _edits(lower, spelling.lower(), limit)
        if distance <= limit:
            moved = sorted(spelling.lower()) != sorted(lower)
            candidates_near.append((distance, moved, prefixed, spelling[0] != name[0], len(spelling), spelling))
    # A name that differs in case alone is surely meant.
    surely = [each for each in candidates_near if each[0] == 0]
    return [spelling for *_, spelling in sorted(surely or candidates_near)[:count]]


def names_in_other_case(name: str) -> list[str]:
    """The names that differ from this one in capitals alone, with the common prefixes."""
    lower = name.lower()
    return sorted({spelling for spelling, _ in _spellings() if spelling.lower() == lower})


def _spellings() -> "Iterator[tuple[str, bool]]":
    for entry in NAMES.split():
        name, _, flags = entry.split("|")
        if not name[0].isdigit():
            yield name, False
        for flag in flags:
            for prefix in COMMON_PREFIXES[flag]:
                yield prefix + name, True


def _edits(a: str, b: str, limit: int) -> int:
    """Edits between two words, exchanged neighbours counting as one; a result above `limit` may be too large."""
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, character in enumerate(a, 1):
        older, before, row = before, row, [i]
        for j, other in enumerate(b, 1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (character != other))
            if i > 1 and j > 1 and character == b[j - 2] and a[i - 2] == other:
                cost = min(cost, older[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return row[-1]
