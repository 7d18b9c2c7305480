"""The configuration graph of a chain of turns: unit vectors of each frame as dots, and the lines between them."""

from dynamics_cli.errors import worded
from dynamics_cli.orient.turns.compose import letter
from dynamics_cli.pictures import Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.orient.turns.compose import SimpleTurn

# Columns stand this far apart, rows at a distance of one.
APART = 1.6


def configuration(answer: "Any", *, turns: "Any", about: str = "body", base: str = "A", **_: "Any") -> Picture:
    """Frames as columns of dots; a level line for the axis of a turn, a slanted one where only plus signs stand."""
    del answer
    chain: list[SimpleTurn] = list(turns) if isinstance(turns, tuple) else [turns]
    names = [base, *(turn.name or letter(nth) for nth, turn in enumerate(chain, 1))]
    subtitle = "level: the axis of the turn; slanted: the pair with plus signs only; the third pair takes the minus"
    if about == "fixed":
        # about fixed axes the last turn is the first about the body's
        chain = chain[::-1]
        names = [base, *(f"{turn.name or 'turn ' + turn.axis}" for turn in chain)]
        subtitle = "turns about fixed axes, in the reverse order as turns about the body's"
    items: list[Any] = []
    for place, name in enumerate(names):
        items.append(Label(APART * place, 0.6, name))
        items += [Mark(APART * place, -float(k), role=6) for k in range(3)]
    items += [Label(-0.45, -float(k), axis) for k, axis in enumerate("xyz")]
    for place, turn in enumerate(chain):
        i = "xyz".index(turn.axis)
        left, right = APART * place, APART * (place + 1)
        up, down = (i + 2) % 3, (i + 1) % 3
        items.append(Curve([left, right], [-float(i), -float(i)], role=0))
        items.append(Curve([left, right], [-float(up), -float(down)], role=1))
        angle = worded("{angle} about " + turn.axis, angle=(turn.angle, Angle))
        items.append(Label(0.5 * (left + right), -2.55, angle))
    x = Axis("", ends=(-0.7, APART * len(chain) + 0.5))
    panel = Panel(x, Axis("", ends=(-2.9, 0.9)), tuple(items), equal=True, bare=True)
    return Picture((panel,), "configuration graph", subtitle=subtitle)
