"""Text that users wrote, within Markdown: what it says is shown, and it commands nothing."""

# What begins HTML, a code span, emphasis, or a cell of a table.
MARKS = "\\|<`*"


def markdown(text: str, marks: str = MARKS) -> str:
    r"""Text on one line, its marks escaped; a link stays text.

    >>> markdown("a <b> | [c](d)")
    'a \\<b> \\| [c]\\(d)'
    """
    escaped = "".join(f"\\{mark}" if mark in marks else mark for mark in text)
    return " ".join(escaped.replace("](", "]\\(").replace("][", "]\\[").split())


def fenced(text: str) -> str:
    """Text as a block of code, whatever it holds."""
    longest = run = 0
    for mark in text:
        run = run + 1 if mark == "`" else 0
        longest = max(longest, run)
    fence = "`" * max(3, 1 + longest)
    return f"{fence}\n{text}\n{fence}"
