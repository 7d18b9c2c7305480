"""Near words, for errors that suggest what was meant."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


def nearest_words(word: str, known: "Iterable[str]", count: int = 3) -> "list[str]":
    """Up to `count` of the known words that look like `word`, nearest first."""
    from difflib import get_close_matches

    by_plain = {name.lower().replace("-", "_"): name for name in known}
    near = get_close_matches(word.lower().replace("-", "_"), sorted(by_plain), n=count, cutoff=0.6)
    return [by_plain[name] for name in near]
