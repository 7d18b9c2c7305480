"""Rise laws and programs of cams in any field of numbers, for the references of geometry and of forces.

A law is a list of branches (share where it begins, share where it ends, function of the share); each is smooth.
"""

from collections.abc import Callable, Sequence
from typing import Any

from cam_envelope import Lift
from digits import Field
from mpmath import mpf, nstr
from taylor import circle

Segment = tuple[str, str | None, str]
Law = list[tuple[Any, Any, Callable[[Any], Any]]]


def laws(field: Field) -> dict[str, Law]:
    """Every law used, written out anew."""
    number, pi = field.number, field.pi
    one, e = number(1), number(1) / 8

    def cos(x: Any) -> Any:
        return circle(field, x)[0]

    def sin(x: Any) -> Any:
        return circle(field, x)[1]

    def whole(f: Callable[[Any], Any]) -> Law:
        return [(number(0), one, f)]

    def mirrored(branches: Law) -> Law:
        """A law of f(x) = 1 − f(1 − x) from the branches of its first half."""
        far = [(1 - b, 1 - a, lambda x, f=f: 1 - f(1 - x)) for a, b, f in reversed(branches)]
        return [*branches, *far]

    c = 2 / (pi + 2)
    wave, peak = c / (4 * pi), 4 * pi * c

    def first(x: Any) -> Any:
        return c * x - wave * sin(4 * pi * x)

    s1 = first(e)
    s2, v2 = s1 + c * 2 * e + peak / 2 * (2 * e) ** 2, c + peak * 2 * e
    trapezoid = mirrored([
        (number(0), e, first),
        (e, 3 * e, lambda x: s1 + c * (x - e) + peak / 2 * (x - e) ** 2),
        (3 * e, one / 2, lambda x: s2 + v2 * (x - 3 * e) + peak / (16 * pi**2) * (1 - cos(4 * pi * (x - 3 * e)))),
    ])  # fmt: skip
    k = 1 / (pi + 4)
    modified_sine = [
        (number(0), e, lambda x: k * (pi * x - sin(4 * pi * x) / 4)),
        (e, 7 * e, lambda x: k * (2 + pi * x - number(9) / 4 * sin(pi / 3 + 4 * pi * x / 3))),
        (7 * e, one, lambda x: k * (4 + pi * x - sin(4 * pi * x) / 4)),
    ]
    return {
        "cycloidal": whole(lambda x: x - sin(2 * pi * x) / (2 * pi)),
        "3-4-5": whole(lambda x: x**3 * (10 - 15 * x + 6 * x * x)),
        "4-5-6-7": whole(lambda x: x**4 * (35 - 84 * x + 70 * x * x - 20 * x**3)),
        "5-6-7-8-9": whole(lambda x: x**5 * (126 - 420 * x + 540 * x**2 - 315 * x**3 + 70 * x**4)),
        "harmonic": whole(lambda x: (1 - cos(pi * x)) / 2),
        "double-harmonic": whole(lambda x: (1 - cos(pi * x)) / 2 - (1 - cos(2 * pi * x)) / 8),
        "parabolic": mirrored([(number(0), one / 2, lambda x: 2 * x * x)]),
        "modified-sine": modified_sine,
        "modified-trapezoid": trapezoid,
    }


def branches(field: Field, segments: Sequence[Segment], levels: Sequence[Any]) -> list[tuple[Any, Any, Lift, bool]]:
    """(start, end, lift as a function of the angle, whether it rests) of every branch of one turn.

    Segments are (degrees as text, law or None, …), levels those at their ends.
    """
    known, made = laws(field), []
    start = level = field.number(0)
    for (span, law, _), top in zip(segments, levels, strict=True):
        end = start + field.number(span) * field.pi / 180
        if law is None:
            made.append((start, end, lambda t, level=level: level + 0 * t, True))
        else:
            width = end - start
            for a, b, f in known[law]:

                def lift(t: Any, f: Any = f, o: Any = start, w: Any = width, low: Any = level, high: Any = top) -> Any:
                    return low + (high - low) * f((t - o) / w)

                made.append((start + a * width, start + b * width, lift, False))
        start, level = end, top
    return made


def program_text(segments: Sequence[Segment], unit: str, scale: int) -> str:
    """What the program reads: its levels are in metres times the scale."""
    words = []
    for (span, law, to), (_, _, before) in zip(segments, [("", None, "0"), *segments], strict=False):
        if law is None:
            words.append(f"dwell {span} deg")
        else:
            move = "rise" if mpf(to) > mpf(before) else "return"
            amount = abs(mpf(to) - mpf(before)) * scale
            words.append(f"{move} {nstr(amount, 15, strip_zeros=True)} {unit} in {span} deg {law}")
    return "; ".join(words)


def at(made: Sequence[tuple[Any, Any, Lift, bool]], theta: Any) -> Lift:
    """The lift of the branch in which an angle lies."""
    return next((lift for _, end, lift, _ in made if theta < end), made[-1][2])
