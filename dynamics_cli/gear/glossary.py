"""The terms of gearing with their symbols, other names and formulas."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Text
from dynamics_cli.records import record


@record
class Entry:
    """A term of gearing."""

    term: Annotated[Text, "The term."]
    symbol: Annotated[Text, "Its symbol in ISO 21771, or AGMA's."]
    also: Annotated[Text, "Other names."]
    formula: Annotated[Text, "A formula in which it occurs."]
    meaning: Annotated[Text, "Its definition."]


@record
class Glossary:
    """Terms of gearing."""

    entries: Annotated[tuple[Entry, ...], "The requested terms, in alphabetical order."]
    meaning: Annotated[Text | None, "The definition, where one term was asked for."]


def _terms() -> "list[tuple[str, ...]]":
    """The table of terms: one a line, its columns those of an entry."""
    with open(__file__.removesuffix("glossary.py") + "terms.txt", encoding="utf-8") as file:
        return [tuple(part.strip() for part in line.split("|")) for line in list(file)[1:]]


def glossary(*terms: Annotated[Text, "Terms, or parts of terms; all terms if left out."]) -> Glossary:
    """Explain the terms of gearing, with symbol, other names and a formula.

    Equation
    --------
    Each entry has its own.

    Returns
    -------
    Glossary
        The entries that match.

    Raises
    ------
    InadmissibleError
        When a term is not known; the message lists similar ones.

    Notes
    -----
    Terms of the glossary of the book; symbols of ISO 21771.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 17.16 (the terms; the words are ours).

    Examples
    --------
    >>> glossary("base pitch").entries[0].symbol
    'p_b'
    """
    table = _terms()
    chosen = []
    for term in terms:
        entries = _matching(" ".join(term.lower().replace("-", " ").split()), table)
        require(
            bool(entries),
            "the glossary has no term {term}; similar terms: {near}",
            term=repr(term),
            near=", ".join(_near(term, [entry[0] for entry in table])),
            code="unknown-term",
            hint="dynamics gear glossary lists all",
        )
        chosen += [entry for entry in entries if entry not in chosen]
    rows = sorted(chosen) if terms else table
    return Glossary(tuple(Entry(*row) for row in rows), rows[0][4] if len(rows) == 1 else None)


def _matching(term: str, table: "list[tuple[str, ...]]") -> "list[tuple[str, ...]]":
    """The entry of exactly that name, else those whose name, symbol or other names contain the words."""
    if not term:
        return []
    names = [entry for entry in table if term == entry[0] or term in entry[2].lower().split(", ")]
    symbols = [entry for entry in table if term in entry[1].lower().split(", ")]
    return names or symbols or [entry for entry in table if term in f"{entry[0]} {entry[2]}".lower()]


def _near(term: str, known: "list[str]") -> "list[str]":
    """The three terms spelled most alike."""
    from difflib import get_close_matches

    return get_close_matches(term.lower(), known, 3, 0.0)
