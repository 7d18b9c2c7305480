"""Three turns about coordinate axes, in any of 24 sequences: their names, and the angles of a rotation.

Small letters name turns about the body's axes as they have become, capitals turns about the fixed axes. Turns about
fixed axes are those about the body's in reverse order, so one kernel serves all 24.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan2, hypot, maximum, minimum, pi_beside, where
from dynamics_cli.numerics.orientation.quaternions import Quaternion, multiply, opposite
from dynamics_cli.numerics.orientation.rotations import ORDERS, Matrix
from dynamics_cli.numerics.turns import turned
from dynamics_cli.numerics.vectors import Vector
from dynamics_cli.records import record

# Sequences by the names that trades give them.
NAMES = {
    "yaw-pitch-roll": "zyx",
    "ypr": "zyx",
    "sae": "zyx",
    "cardan": "xyz",
    "bryan": "xyz",
    "dextral": "xyz",
    "euler": "zxz",
    "roll-pitch-yaw": "XYZ",
    "rpy": "XYZ",
    "urdf": "XYZ",
    "ros": "XYZ",
}

# Names of sequences, for completion.
ALL = (*ORDERS, *(order.upper() for order in ORDERS), *NAMES)


@record
class Sequence:
    """Axes 0, 1, 2 of three turns about the body's axes, and whether they were named as turns about fixed ones."""

    axes: tuple[int, int, int]
    fixed: bool

    @property
    def body(self) -> str:
        """The letters as turns about the body's axes."""
        return "".join("xyz"[axis] for axis in self.axes)

    @property
    def text(self) -> str:
        """The letters as they were named: small about the body's axes, capitals about the fixed ones."""
        return self.body[::-1].upper() if self.fixed else self.body

    @property
    def repeats(self) -> bool:
        """Whether the first axis is the last one too, as of Euler's angles."""
        return self.axes[0] == self.axes[2]

    @property
    def cycle(self) -> float:
        """+1 where first, second and remaining axis are in cyclic order, else −1."""
        i, j, _ = self.axes
        return 1.0 if (j - i) % 3 == 1 else -1.0


@record
class Angles:
    """Angles of a rotation, their alternative, and their distance from lock."""

    angles: Vector
    alternative: Vector
    margin: float
    """|cos| or |sin| of the middle angle: zero at lock."""
    distance: float
    """The angle from lock."""


def sequence_of(text: str) -> Sequence:
    """Read a sequence: letters, digits of the book (3-2-1), "body zyx", "fixed xyz", or a name of the trade.

    Raises
    ------
    InadmissibleError
        When it is not one of the 24 sequences.
    """
    words = text.strip().replace("_", "-").split()
    fixed = words[0].lower() in ("fixed", "extrinsic") if words else False
    last_word = words[-1] if words else ""
    letters = NAMES.get("-".join(words).lower(), last_word.replace("-", "").translate(str.maketrans("123", "xyz")))
    if len(words) == 2 and words[0].lower() in ("body", "fixed", "intrinsic", "extrinsic"):
        letters = letters.upper() if fixed else letters.lower()
    require(
        letters.lower() in ORDERS and letters in (letters.lower(), letters.upper()),
        "the sequence {read} is unknown",
        code="sequence",
        hint="three letters, no axis twice in a row: zyx or zxz about the turning axes, XYZ about the fixed ones; "
        "or yaw-pitch-roll, rpy, bryan, euler",
        read=repr(text),
    )
    first, second, third = ("xyz".index(letter) for letter in letters.lower())
    if letters.isupper():
        return Sequence(axes=(third, second, first), fixed=True)
    return Sequence(axes=(first, second, third), fixed=False)


def names_of(sequence: Sequence) -> str:
    """Other names of the same rotations.

    >>> names_of(sequence_of("zyx"))
    'body zyx = fixed xyz reversed = scipy "ZYX"; yaw, pitch, roll (SAE), URDF rpy reversed'
    """
    body, fixed = sequence.body, sequence.body[::-1]
    if sequence.fixed:
        trades = {"xyz": "roll, pitch, yaw (URDF, ROS)", "zyx": "Bryan angles reversed", "zxz": "Euler angles reversed"}
        text, trade = f'fixed {fixed} = body {body} reversed = scipy "{fixed}"', trades.get(fixed)
    else:
        trades = {"zyx": "yaw, pitch, roll (SAE), URDF rpy reversed", "xyz": "Bryan angles", "zxz": "Euler angles"}
        text, trade = f'body {body} = fixed {fixed} reversed = scipy "{body.upper()}"', trades.get(body)
    return f"{text}; {trade}" if trade else text


def angles_in_words(sequence: Sequence) -> str:
    """What the three angles are called, in their order.

    >>> angles_in_words(sequence_of("zyx")), angles_in_words(sequence_of("zxz"))
    ('yaw, pitch, roll', 'angles about z, x′, z″')
    """
    trade = {"zyx": "yaw, pitch, roll", "XYZ": "roll, pitch, yaw"}.get(sequence.text)
    if sequence.fixed:
        return trade or f"angles about fixed {', '.join(sequence.text.lower())}"
    first, second, third = tuple(sequence.text)
    return trade or f"angles about {first}, {second}′, {third}″"


def quaternion_of_angles(angles: Vector, sequence: Sequence) -> Quaternion:
    """The quaternion of three turns."""
    ordered = angles[::-1] if sequence.fixed else angles
    rotation = (1.0, 0.0, 0.0, 0.0)
    for nth, (axis, angle) in enumerate(zip(sequence.axes, ordered, strict=True)):
        cosine, sine = turned(0.5 * angle)
        parts = [cosine, 0.0, 0.0, 0.0]
        parts[axis + 1] = sine
        turn: Quaternion = (parts[0], parts[1], parts[2], parts[3])
        rotation = multiply(rotation, turn) if nth else turn
    return rotation


def angles_of_rotation(m: Matrix, sequence: Sequence, *, zero_third: bool = False) -> Angles:
    """The angles of a rotation matrix, which reproduce it to rounding however near to lock.

    The third angle is read after undoing the first. At exact lock, where only their sum or difference is determined,
    the first is 0, or the third with `zero_third`.
    """
    i, j, k = sequence.axes
    e = sequence.cycle
    last = 3 - i - j
    if sequence.repeats:
        y, x = m[j][i], _signed(-e, m[last][i])
        margin = hypot(y, x)
        b = atan2(margin, m[i][i])
        distance = atan2(margin, abs(m[i][i]))
    else:
        y, x = _signed(-e, m[j][k]), m[k][k]
        margin = hypot(y, x)
        b = atan2(_signed(e, m[i][k]), margin)
        distance = atan2(margin, abs(m[i][k]))
    locked = margin == 0.0
    divisor = where(locked, 1.0, margin)
    cosine, sine = where(locked, 1.0, x / divisor), y / divisor
    a = where(locked, 0.0, atan2(y, x))
    if sequence.repeats:
        c = atan2(
            _signed(-e, cosine * m[j][last] + _signed(e, sine * m[last][last])),
            cosine * m[j][j] + _signed(e, sine * m[last][j]),
        )
    else:
        c = atan2(
            _signed(e, cosine * m[j][i] + _signed(e, sine * m[k][i])), cosine * m[j][j] + _signed(e, sine * m[k][j])
        )
    return _ordered(a, b, c, margin, distance, locked, sequence, zero_third)


def angles_of_quaternion(q: Quaternion, sequence: Sequence, *, zero_third: bool = False) -> Angles:
    """The angles of a unit quaternion, by half sums and half differences (Bernardes & Viollet 2022).

    References
    ----------
    E. Bernardes, S. Viollet, Quaternion to Euler angles conversion: a direct, general and computationally
    efficient method, PLoS ONE 17 (2022) e0276302.
    """
    i, j, _ = sequence.axes
    e = sequence.cycle
    w, v = q[0], q[1:]
    last = 3 - i - j
    if sequence.repeats:
        p, r, s, t = w, v[i], v[j], _signed(e, v[last])
        first, second = hypot(p, r), hypot(s, t)
        b = 2.0 * atan2(second, first)
        margin = 2.0 * first * second
        distance = 2.0 * atan2(minimum(first, second), maximum(first, second))
    else:
        p, r, s, t = w - v[j], v[i] - _signed(e, v[last]), w + v[j], v[i] + _signed(e, v[last])
        first, second = hypot(p, r), hypot(s, t)
        total = first + second
        # 2·atan2(second, first) − 90° would lose the digits of a small angle
        b = 2.0 * atan2(4.0 * (w * v[j] + _signed(e, v[i] * v[last])), total * total)
        margin = first * second
        distance = 2.0 * atan2(minimum(first, second), maximum(first, second))
    plus, minus = _angle_or_zero(r, p, first), _angle_or_zero(t, s, second)
    locked = margin == 0.0
    a, c = plus + minus, plus - minus
    if not sequence.repeats:
        c = _signed(-e, c)
    # at lock only the sum or difference of both is known; the half sums divide it between them
    a, c = where(locked, 0.0, a), where(locked, 2.0 * c, c)
    return _ordered(wrapped(a), b, wrapped(c), margin, distance, locked, sequence, zero_third)


def _angle_or_zero(y: float, x: float, size: float) -> float:
    """atan2, but 0 at the origin for zeros of any sign."""
    return where(size == 0.0, 0.0, atan2(y, x))


def _signed(sign: float, x: float) -> float:
    return opposite(x) if sign < 0.0 else opposite(opposite(x))


def _ordered(
    a: float, b: float, c: float, margin: float, distance: float, locked: bool, sequence: Sequence, zero_third: bool
) -> Angles:
    """Angles in the order of their names, the one that lock leaves open at zero."""
    if zero_third != sequence.fixed:
        sense = where(b > 1.0, 1.0, -1.0) * sequence.cycle
        if sequence.repeats:
            sense = where(b > 1.0, -1.0, 1.0)
        a, c = where(locked, sense * c, a), where(locked, 0.0, c)
    pi = pi_beside(a, b, c)
    across = opposite(b) if sequence.repeats else where(b < 0.0, opposite(pi + b), pi - b)
    other = (wrapped(a + pi), across, wrapped(c + pi))
    triple = (a, b, c)
    if sequence.fixed:
        triple, other = (c, b, a), other[::-1]
    return Angles(angles=triple, alternative=other, margin=margin, distance=distance)


def wrapped(angle: float, beside: float = 0.0) -> float:
    """The same angle within half a turn of another: from −180° (left out) to 180° about it."""
    pi = pi_beside(angle, beside)
    off = angle - beside
    # whole turns first, for angles far from it
    turns = _whole(off)
    off = off - turns * (2.0 * pi)
    off = where(off > 3.141592653589793, off - 2.0 * pi, where(off <= -3.141592653589793, off + 2.0 * pi, off))
    return off + beside


def _whole(off: float) -> float:
    """How many whole turns an angle is, as a number without slope."""
    value = getattr(off, "value", off)
    if getattr(value, "ndim", 0):
        import numpy as np

        return np.rint(value / 6.283185307179586)  # type: ignore[no-any-return]
    return float(round(value / 6.283185307179586))


def nearest(angles: Angles, near: Vector) -> Vector:
    """Of both triples and their whole turns, the angles nearest to the given ones."""
    first = tuple(wrapped(angle, beside) for angle, beside in zip(angles.angles, near, strict=True))
    two = tuple(wrapped(angle, beside) for angle, beside in zip(angles.alternative, near, strict=True))
    far = [sum(abs(angle - beside) for angle, beside in zip(triple, near, strict=True)) for triple in (first, two)]
    nearer = far[0] <= far[1]
    return tuple(where(nearer, p, q) for p, q in zip(first, two, strict=True))  # type: ignore[return-value]
