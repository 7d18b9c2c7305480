"""What one per cent of each input changes: a table of results by inputs, for `--explain`."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

TITLE = "sensitivity: change in % for +1 % of"


def sensitivity_lines(
    changes: "Mapping[str, Mapping[str, float]]",
    result_in_words: "Callable[[str], str]",
    input_in_words: "Callable[[str], str]",
    width: int,
) -> "list[str]":
    """A line for each result, a column for each input; inputs that do not fit go into further blocks."""
    labels = {result: result_in_words(result) or result for result in changes}
    left = max(map(len, labels.values()), default=0)
    heads = {name: input_in_words(name).split() for entry in changes.values() for name in entry}
    lines = [TITLE] if heads else []
    while heads:
        block: dict[str, int] = {}
        for name, words in heads.items():
            column = max(6, *map(len, words))
            if block and sum(block.values(), 2 * len(block) + 4 + left) + column > width:
                break
            block[name] = column
        for level in range(-max(len(heads[name]) for name in block), 0):
            words = [heads[name][level] if len(heads[name]) >= -level else "" for name in block]
            lines.append(_row("", left, words, block))
        for result, entry in changes.items():
            if any(name in entry for name in block):
                cells = [f"{entry[name]:.3g}" if name in entry else "" for name in block]
                lines.append(_row(labels[result], left, cells, block))
        heads = {name: words for name, words in heads.items() if name not in block}
    return lines


def _row(label: str, left: int, cells: "list[str]", columns: "Mapping[str, int]") -> str:
    row = "".join(f"  {cell:>{column}}" for cell, column in zip(cells, columns.values(), strict=True))
    return f"  {label:<{left}}{row}".rstrip()
