"""Matrices of a linear system from a file: results of `vibration modes` or `motion modes`, JSON, or plain rows."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.polynomial_text import read_number
from dynamics_cli.numerics.exact.rational import product

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeAlias

    Pair: TypeAlias = tuple[int, int]
    Rows: TypeAlias = list[list[Pair]]

MOST_ROWS = 12
NAMES = {
    "A": "matrix", "M": "mass", "C": "damping", "G": "gyroscopic", "K": "stiffness", "mass_matrix": "mass",
    "damping_matrix": "damping", "stiffness_matrix": "stiffness", "matrix": "matrix", "mass": "mass",
    "damping": "damping", "gyroscopic": "gyroscopic", "stiffness": "stiffness",
}  # fmt: skip
HINT = "M, C, G and K, or A, each name on a line above its rows; or the JSON of dynamics vibration modes"


def read_system(file: str, alone: bool) -> "dict[str, Rows]":
    """The matrices in a file by the names of the task's options, exactly as their decimals are written there.

    Where it stands `alone`, modes that are not coupled are preferred to the matrices of their document: those are
    rounded, and a rigid mode would be off zero.
    """
    with open(file, encoding="utf-8-sig") as stream:
        text = stream.read()
    system = _of_document(text, alone) if text.lstrip()[:1] == "{" else _of_lines(text)
    require(bool(system), "the file has no matrix", code="matrix", hint=HINT)
    for name, rows in system.items():
        require(len(rows) <= MOST_ROWS, "{name} of the file has {rows} rows; {most} are the most", name=name,
                rows=str(len(rows)), most=str(MOST_ROWS), code="matrix")  # fmt: skip
        require(len({len(row) for row in rows}) == 1, "the rows of {name} in the file differ in length", name=name,
                code="matrix")  # fmt: skip
    return system


def _of_lines(text: str) -> "dict[str, Rows]":
    """Rows of numbers beneath the name of their matrix; rows without a name are A."""
    system: dict[str, Rows] = {}
    name = "matrix"
    for line in text.splitlines():
        line = line.partition("#")[0].strip().rstrip("=:").strip()
        if line in NAMES:
            name = NAMES[line]
            require(name not in system, "the file has {line} twice", line=line, code="matrix")
        elif line:
            system.setdefault(name, []).append([_number(cell) for cell in line.replace(",", " ").split()])
    return system


def _number(cell: "Any") -> "Pair":
    try:
        return read_number(str(cell))
    except Exception:
        require(False, "{cell} in the file is not a number", cell=repr(str(cell)[:30]), code="number", hint=HINT)
        raise


def _of_document(text: str, alone: bool) -> "dict[str, Rows]":
    """Matrices by name, or the modes of a document, each a coordinate of unit mass."""
    import json

    try:
        document = json.loads(text, parse_float=str, parse_int=str)
    except ValueError:
        document = {}
    results = document.get("results", document)
    system = {}
    for name, option in NAMES.items():
        value = results.get(name)
        value = value.get("value") if isinstance(value, dict) else value
        if isinstance(value, list) and all(isinstance(row, list) for row in value):
            system[option] = [[_number(cell) for cell in row] for row in value]
    modes = results.get("modes")
    if isinstance(modes, list) and (not system or (alone and not any(mode.get("phases") for mode in modes))):
        return _of_modes(modes)
    return system


def _of_modes(modes: "list[Any]") -> "dict[str, Rows]":
    """1, 2ζω and ω² along the diagonals; a rigid mode has zero."""
    rates, shares = [], []
    for number, mode in enumerate(modes, 1):
        rate, share = mode.get("angular_frequency"), mode.get("damping_ratio")
        require(
            isinstance(rate, dict) and rate.get("unit") == "rad/s",
            "mode {number} of the file has no angular frequency in rad/s",
            number=str(number),
            code="matrix",
            hint="write the document as the task does without --units and --to",
        )
        rates.append(_number(rate["value"]))
        shares.append(_number(share["value"]) if isinstance(share, dict) else (0, 1))
    pairs = list(zip(rates, shares, strict=True))
    squares, dampings = [product(rate, rate) for rate in rates], [product((2, 1), *pair) for pair in pairs]
    sides = {"mass": [(1, 1)] * len(rates), "damping": dampings, "stiffness": squares}
    return {
        name: [[value if i == j else (0, 1) for j in range(len(rates))] for i, value in enumerate(values)]
        for name, values in sides.items()
    }
