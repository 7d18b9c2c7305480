"""The polhode of a free body, and its angular velocity over a period."""

import math

from dynamics_cli.numerics.elliptic import functions
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Time, TurnRate
from dynamics_cli.spin.free import NAMES, extremes, moduli

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 480


def free(
    made: "Any",
    *,
    moments: "tuple[float, float, float]",
    angular_velocity: "tuple[float, float, float]",
    **_: "Any",
) -> Picture:
    """Components over a period, and the polhode seen along the axis it goes round."""
    order = sorted(range(3), key=lambda k: plain(moments[k]))
    body: Any = tuple(plain(moments[k]) for k in order)
    rates: Any = tuple(abs(plain(angular_velocity[k])) for k in order)
    most, _least, split = extremes(body, rates)
    period = plain(made.period) if made.period is not None else None
    if period is None:
        times = [0.0, 1.0]
        paths = [[rate, rate] for rate in rates]
        about = 2
    else:
        about = 2 if split[1] > 0.0 else 0
        outer, inner = moduli(body, rates, split)
        complement = min(inner / outer, 1.0)
        modulus = ((1.0 - complement) * (1.0 + complement)) ** 0.5
        times = [period * k / POINTS for k in range(POINTS + 1)]
        states = [functions(outer * t, modulus, complement) for t in times]
        paths = [[], [most[1] * sn for sn, _cn, _dn in states], []]
        paths[about] = [most[about] * dn for _sn, _cn, dn in states]
        paths[2 - about] = [most[2 - about] * cn for _sn, cn, _dn in states]
    names = [NAMES[k] for k in order]
    curves = tuple(Curve(times, paths[k], f"about {names[k]}", role=k) for k in range(3))
    history = Panel(Axis("time", Time), Axis("angular velocity", TurnRate), curves)
    across = 2 - about
    turns = [2.0 * math.pi * k / POINTS for k in range(POINTS + 1)]
    x, y = ([size * shape(t) for t in turns] for size, shape in ((most[across], math.cos), (most[1], math.sin)))
    now = Mark(plain(angular_velocity[order[across]]), plain(angular_velocity[order[1]]), "as given", role=3)
    polhode = Panel(
        Axis(f"about {names[across]}", TurnRate),
        Axis(f"about {names[1]}", TurnRate),
        (Curve(x, y, "", role=about), now) if period is not None else (now,),
        equal=True,
    )
    about_text = f" about {names[about]}" if period is not None else ""
    return Picture((history, polhode), f"polhode{about_text}", subtitle="over one period, begun at an extreme")
