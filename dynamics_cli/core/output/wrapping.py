"""Lines no wider than the terminal, without the cost of importing textwrap."""


def wrapped(text: str, width: int, indent: int) -> "list[str]":
    """A paragraph in lines of at most `width` columns, further lines indented; words longer than that stand alone.

    >>> wrapped("one two three", 8, 2)
    ['one two', '  three']
    """
    lines: list[str] = []
    line = ""
    for word in text.split(" "):
        if line.strip() and len(line) + 1 + len(word) > width:
            lines.append(line)
            line = " " * indent + word
        else:
            line = f"{line} {word}" if line else word
    return [*lines, line]


def fitted(head: str, remarks: "list[str]", width: int, indent: int) -> "list[str]":
    """A head and its remarks on one line where they fit, else the remarks below it.

    >>> fitted("speed  57 km/h", ["exceeds the limit"], 40, 7)
    ['speed  57 km/h    exceeds the limit']
    """
    lines = []
    line = head
    for remark in remarks:
        gap = "  " if line == head else ""
        if len(line) + 2 + len(gap) + len(remark) > width:
            lines.append(line.rstrip())
            line = " " * indent + remark
        else:
            line = f"{line}  {gap}{remark}"
    lines.append(line.rstrip())
    return [part for line in lines for part in wrapped(line, width, indent)] if len(lines[-1]) > width else lines
