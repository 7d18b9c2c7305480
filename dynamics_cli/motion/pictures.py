"""A chain as a stroboscope sees it, its angles and the errors of the calculation over time."""

from itertools import accumulate

from dynamics_cli.motion.rods import chain_of, many
from dynamics_cli.motion.runs import Runs
from dynamics_cli.pictures import Axis, Band, Curve, Panel, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Length, Ratio, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GREY = 6
FLASHES = 24
# More rods than this have no line each in the history.
LINES = 6
# Errors below the last digit are not drawn.
DUST = 1e-16


def chain(made: "Any", *, lengths: "Any", masses: "Any", angles: "Any", duration: float, rates: "Any" = (),
          end_masses: "Any" = (), inertias: "Any" = (), count: int | None = None, gravity: float = STANDARD_GRAVITY,
          **_: "Any") -> Picture:  # fmt: skip
    """The chain at equal intervals with the path of its end, the angles of the rods, and the errors."""
    rods = chain_of(lengths, masses, end_masses, inertias, count, gravity)
    n = rods.n
    runs = Runs(rods, many(angles, n, "angles", 0.0) + many(rates, n, "rates", 0.0), duration)
    last = len(runs.times) - 1
    items: list[Any] = []
    for k in range(FLASHES + 1):
        x, y = rods.joints(runs.states[round(last * k / FLASHES)][:n])
        if k in (0, FLASHES):
            items.append(Curve(x, y, "at the start" if k == 0 else f"at the {'horizon' if runs.reached else 'end'}",
                               "thick", role=0 if k == 0 else 1))  # fmt: skip
        else:
            items.append(Curve(x, y, "", "thin", role=GREY))
    ends = [rods.joints(state[:n]) for state in runs.states]
    items.append(Curve([x[-1] for x, _ in ends], [y[-1] for _, y in ends], "path of the end", "dots", role=2))
    shown = range(n) if n <= LINES else (0, n // 2, n - 1)
    history: list[Any] = [
        Curve(runs.times, [state[i] for state in runs.states], f"rod {i + 1}", role=place)
        for place, i in enumerate(shown)
    ]
    if runs.reached:
        history.append(Band(runs.times[-1], duration, "past the horizon"))
    panels = (
        Panel(Axis("across", Length), Axis("up", Length), tuple(items), equal=True),
        Panel(Axis("time", Time, ends=(0.0, duration)), Axis("angle", Angle), tuple(history)),
        Panel(Axis("time", Time, ends=(0.0, duration)), Axis("error", Ratio, logarithmic=True), _errors(runs)),
    )
    return Picture(panels, f"chain of {n} rods" if n > 1 else "a rod on a pin")


def _errors(runs: Runs) -> "tuple[Curve, ...]":
    """The largest errors so far: what two tolerances differ by, and the change of the energy."""
    curves: list[Curve] = []
    for values, label in ((runs.parted, "two tolerances, rad"), (runs.energy_errors(), "energy, share")):
        largest = list(accumulate((max(value, DUST) for value in values), max))
        curves.append(Curve(runs.times, largest, label, role=len(curves)))
    return tuple(curves)


def modes(made: "Any", *, lengths: "Any", count: int | None = None, **_: "Any") -> Picture:
    """Sideways motion of the pins of the slowest modes, the chain hanging down."""
    n = count or len(lengths)
    depths = [0.0]
    for length in many(lengths, n, "lengths", 0.0):
        depths.append(depths[-1] - length)
    items: list[Any] = [Curve([0.0, 0.0], [0.0, depths[-1]], "", "centre", role=GREY)]
    items += [
        Curve([0.0, *mode.ends], depths, f"mode {mode.number}", role=mode.number - 1) for mode in made.modes[:LINES]
    ]
    return Picture((Panel(Axis("sideways", Ratio), Axis("up", Length), tuple(items)),), "small oscillations")
