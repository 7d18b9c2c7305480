"""The terms of gearing with their symbols, other names and formulas."""

from dynamics_cli.errors import require
from dynamics_cli.gear.terms import TERMS
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
    chosen = []
    for term in terms:
        entries = _matching(" ".join(term.lower().replace("-", " ").split()))
        require(
            bool(entries),
            "the glossary has no term {term}; similar terms: {near}",
            term=repr(term),
            near=", ".join(_near(term)),
            code="unknown-term",
            hint="dynamics gear glossary lists all",
        )
        chosen += [entry for entry in entries if entry not in chosen]
    rows = sorted(chosen) if terms else list(TERMS)
    return Glossary(tuple(Entry(*row) for row in rows))


def _matching(term: str) -> "list[tuple[str, ...]]":
    """The entry of exactly that name, else those whose name, symbol or other names contain the words."""
    if not term:
        return []
    names = [entry for entry in TERMS if term == entry[0] or term in entry[2].lower().split(", ")]
    if names:
        return names
    symbols = [entry for entry in TERMS if term and term in entry[1].lower().split(", ")]
    return symbols or [entry for entry in TERMS if term and term in f"{entry[0]} {entry[2]}".lower()]


def _near(term: str) -> list[str]:
    """The three terms that share the most pairs of letters."""
    term_pairs = {term.lower()[i : i + 2] for i in range(len(term) - 1)}

    def shared(entry: "tuple[str, ...]") -> float:
        pairs = {entry[0][i : i + 2] for i in range(len(entry[0]) - 1)}
        return len(term_pairs & pairs) / (1 + len(term_pairs | pairs))

    return [entry[0] for entry in sorted(TERMS, key=shared, reverse=True)[:3]]
