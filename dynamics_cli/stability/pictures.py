"""Roots in the plane, root loci with stable ranges, roots over the delay, potentials with their equilibria."""

import math
from itertools import pairwise

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, AngularRate, Gain, GrowthRate, Length, PotentialEnergy, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

LOCUS_POINTS, HALVINGS = 400, 24
CIRCLE_POINTS = 181
CURVE_POINTS = 400
MOST_PLANES = 4
STABLE, UNSTABLE, GREY = 2, 1, 6


def _both(roots_shown: "Sequence[Any]") -> "list[tuple[float, float, int]]":
    """Roots and their conjugates."""
    out = []
    for root in roots_shown:
        out.append((root.real, root.imaginary, root.multiplicity))
        if root.pair:
            out.append((root.real, -root.imaginary, root.multiplicity))
    return out


def _plane(roots: "Sequence[tuple[float, float, int]]", title: str) -> Panel:
    reach = 1.15 * max([max(abs(x), abs(y)) for x, y, _ in roots] or [1.0]) or 1.0
    items: list[Any] = [
        Curve([-reach, 0.0, 0.0, -reach], [-reach, -reach, reach, reach], "", "fill", role=STABLE),
        Curve([0.0, 0.0], [-reach, reach], "", "thin", role=GREY),
        Curve([-reach, reach], [0.0, 0.0], "", "thin", role=GREY),
        Label(-0.5 * reach, 0.92 * reach, "stable"),
    ]
    for x, y, multiplicity in roots:
        items.append(Mark(x, y, f"× {multiplicity}" if multiplicity > 1 else "", role=UNSTABLE if x >= 0.0 else 0))
    side = (-reach, reach)
    return Panel(
        Axis("real part", GrowthRate, ends=side), Axis("imaginary part", AngularRate, ends=side), tuple(items), title,
        equal=True,
    )  # fmt: skip


def routh(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The roots in the plane."""
    return Picture((_plane(_both(result.roots), result.verdict),), "roots of the characteristic polynomial")


matrix = routh


def gain(result: "Any", polynomial: str, **_: "Any") -> Picture:
    """The root locus, its stable stretches apart, with the critical gains."""
    import numpy as np

    from dynamics_cli.numerics.exact.polynomial_text import whole
    from dynamics_cli.stability.gain import characteristic

    family, below = whole(characteristic(polynomial))
    marks = [one.gain for one in result.critical or ()]
    reach = 2.0 * max([abs(mark) for mark in marks] + [abs(marks[0]) if marks else 1.0]) or 10.0
    low = min([0.0, *[1.2 * mark for mark in marks]])
    even = {*np.linspace(low, reach, LOCUS_POINTS).tolist(), *np.geomspace(reach * 1e-6, reach, LOCUS_POINTS).tolist()}
    found = {value: _roots_at(family, below, value) for value in sorted(even)}
    found |= _meetings(family, below, found)
    gains = sorted(found)
    tracks = _tracks([found[value] for value in gains])
    steady = [_stable_at(result.ranges, value) for value in gains]
    items: list[Any] = []
    for track in tracks:
        for is_stable, role in ((False, UNSTABLE), (True, STABLE)):
            # a line goes on to the first point of the other sort, so that none ends short of the axis
            shown = [
                now == is_stable or before == is_stable
                for now, before in zip(steady, [steady[0], *steady], strict=False)
            ]
            x = [root.real for root in track]
            y = [root.imag if show else math.nan for root, show in zip(track, shown, strict=True)]
            label = ("stable" if is_stable else "unstable") if track is tracks[0] else ""
            items.append(Curve(x, y, label, "solid" if is_stable else "dashed", role=role))
    frequencies = [one.frequency for one in result.critical or () if one.frequency]
    width = _reach([abs(root.real) for track in tracks for root in track])
    size = 1.2 * max([_reach([abs(root.imag) for track in tracks for root in track]), *frequencies])
    items.append(Curve([0.0, 0.0], [-size, size], "", "thin", role=GREY))
    items += [
        Mark(0.0, one.frequency, worded("K = {gain:5}", gain=(one.gain, Gain)), (14.0, -4.0), role=GREY)
        for one in result.critical or ()
        if one.frequency is not None
    ]
    panel = Panel(
        Axis("real part", GrowthRate, ends=(-width, 0.4 * width)),
        Axis("imaginary part", AngularRate, ends=(-size, size)), tuple(items),
        f"{polynomial}, K from {low:.4g} to {reach:.4g}",
    )  # fmt: skip
    return Picture((panel,), f"root locus: stable for {result.stable}")


def _reach(sizes: "Sequence[float]") -> float:
    """What most of them keep within: a root that goes to infinity is cut off."""
    finite = sorted(size for size in sizes if math.isfinite(size))
    return min(1.1 * finite[-1], 4.0 * finite[int(0.8 * (len(finite) - 1))]) or 1.0


def _roots_at(family: "Sequence[Sequence[int]]", below: int, gain: float) -> "list[complex]":
    import numpy as np

    coefficients = [math.fsum(p[k] / below * gain**j for j, p in enumerate(family)) for k in range(len(family[0]))]
    return np.roots(coefficients[::-1]).tolist()  # type: ignore[no-any-return]


def _meetings(
    family: "Sequence[Sequence[int]]", below: int, found: "dict[float, list[complex]]"
) -> "dict[float, list[complex]]":
    """Gains, with their roots, on both sides of where two roots meet on the real axis and part."""
    made = {}
    for low, high in pairwise(found):
        here = _on_the_line(found[low])
        if _on_the_line(found[high]) != here:
            for _ in range(HALVINGS):
                middle = 0.5 * (low + high)
                roots = made[middle] = _roots_at(family, below, middle)
                low, high = (middle, high) if _on_the_line(roots) == here else (low, middle)
    return made


def _on_the_line(roots: "list[complex]") -> int:
    return sum(root.imag == 0.0 for root in roots)


def _tracks(roots_at_gains: "Sequence[list[complex]]") -> "list[list[complex]]":
    """Each root followed from gain to gain by the nearest one."""
    most = max(map(len, roots_at_gains))
    tracks: list[list[complex]] = [[] for _ in range(most)]
    for roots in roots_at_gains:
        free = roots + [complex(math.nan, math.nan)] * (most - len(roots))
        for track in tracks:
            last = track[-1] if track else free[0]
            nearest = min(free, key=lambda root: abs(root - last) if abs(root - last) == abs(root - last) else math.inf)
            free.remove(nearest)
            track.append(nearest)
    return tracks


def _stable_at(ranges: "Sequence[Any]", value: float) -> bool:
    return any(
        one.right == 0
        and one.axis == 0
        and (one.low is None or one.low < value)
        and (one.high is None or value < one.high)
        for one in ranges
    )


def interval(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The roots of the four polynomials in the plane."""
    from dynamics_cli.numerics.exact.polynomial_text import read, whole
    from dynamics_cli.stability.roots import roots

    panels = []
    for corner in result.corners:
        roots_proved = roots(whole(read(corner.coefficients))[0][0])
        panels.append(_plane(_both(roots_proved), f"{corner.coefficients}: {corner.verdict}"))
    return Picture(tuple(panels), f"the four polynomials: {result.verdict}", columns=2)


def delay(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """Unstable roots over the delay."""
    last = result.ranges[-1].low or 1.0
    x: list[float] = []
    y: list[float] = []
    items: list[Any] = []
    for one in result.ranges:
        high = one.high if one.high is not None else 1.15 * last
        x += [one.low, high]
        y += [float(one.right)] * 2
        if one.verdict == "asymptotically stable":
            items.append(Band(one.low, high, "stable" if one.low == 0.0 else ""))
    items.append(Curve(x, y, "roots on the right", "thick"))
    panel = Panel(Axis("delay", Time, ends=(0.0, 1.15 * last)), Axis("roots on the right"), tuple(items))
    return Picture((panel,), "roots on the right over the delay", subtitle=f"stable for {result.stable}")


def discrete(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """Roots and the unit circle."""
    turns = [2.0 * math.pi * k / (CIRCLE_POINTS - 1) for k in range(CIRCLE_POINTS)]
    roots = _both(result.roots)
    reach = 1.15 * max([1.0, *[max(abs(x), abs(y)) for x, y, _ in roots]])
    items: list[Any] = [
        Curve([math.cos(t) for t in turns], [math.sin(t) for t in turns], "", "fill", role=STABLE),
        Curve([math.cos(t) for t in turns], [math.sin(t) for t in turns], "", "outline", role=GREY),
    ]
    for x, y, multiplicity in roots:
        outside = math.hypot(x, y) >= 1.0
        items.append(Mark(x, y, f"× {multiplicity}" if multiplicity > 1 else "", role=UNSTABLE if outside else 0))
    side = (-reach, reach)
    panel = Panel(
        Axis("real part", ends=side), Axis("imaginary part", ends=side), tuple(items), result.verdict, equal=True
    )
    return Picture((panel,), "roots in z and the unit circle")


def equilibrium(
    result: "Any", *, potential: "Any" = None, states: "Any" = (), let: "Any" = (), lowest: "float | None" = None,
    highest: "float | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """The potential with its equilibria; the phase portrait of two states, the roots of more."""
    if len(states) == 2:
        from dynamics_cli.stability.equilibria.phase_pictures import portrait

        return portrait(result.points, states, let)
    if states:
        panels = tuple(_plane(_both(point.roots), point.verdict) for point in result.points[:MOST_PLANES])
        return Picture(panels, "roots of the equilibria", columns=2 if len(panels) > 1 else 1)
    from dynamics_cli.numerics.expressions.laws import law_of, parsed

    angular = result.places[0].angle is not None
    name = (
        "x"
        if not angular
        else next(
            name for name in ("theta", "θ") if name in parsed(potential, (name, *(one.name for one in let))).names
        )
    )
    law = law_of(potential, let, (name,))
    low, high = (-math.pi, math.pi) if angular else (lowest, highest)
    assert low is not None
    assert high is not None
    x = [low + (high - low) * k / CURVE_POINTS for k in range(CURVE_POINTS + 1)]
    y = []
    for at in x:
        try:
            y.append(float(law(**{name: at})))
        except (ArithmeticError, ValueError):
            y.append(math.nan)
    items: list[Any] = [Curve(x, y, "potential")]
    for place in result.places:
        at = place.angle if angular else place.position
        stable = place.verdict.startswith("stable")
        # beyond the curve, which bends the other way
        aside = (5.0, -16.0) if stable else (5.0, 6.0)
        words = "stable" if stable else "unstable"
        items.append(Mark(at, place.energy, words, aside, role=STABLE if stable else UNSTABLE))
    axis = Axis("θ", Angle, step=math.pi / 2.0) if angular else Axis("x", Length)
    return Picture((Panel(axis, Axis("V", PotentialEnergy), tuple(items)),), "equilibria of the potential")
