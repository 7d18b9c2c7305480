"""What a chain of bodies is given and what its laws say."""

from dynamics_cli.quantities import Count, Energy, Impulse, Mass, Restitution, Speed, Text
from dynamics_cli.records import Advice, Check, Choice, Numerics, record


class ChainLaw(Choice):
    """How a chain of touching bodies shares an impact.

    sequential: one pair at a time, the pair that closes fastest first, until none closes. simultaneous: all contacts at
    one moment are pushed until none closes, and e times as much again (Moreau); once more while a pair closes.
    all: both, side by side.
    """

    names = ("all", "sequential", "simultaneous")
    aliases = {"pairs": "sequential", "newton": "simultaneous"}  # noqa: RUF012


@record
class Body:
    """A body of the chain.

    Parameters
    ----------
    mass : Mass
        Its mass [kg].
    velocity : Speed
        Velocity along the line, positive from the first body to the last [m/s].
    restitution : Restitution
        Restitution with the next body, where it is not that of the chain [-].
    """

    mass: Mass
    velocity: Speed = 0.0
    restitution: Restitution | None = None


@record
class AfterChain:
    """A body after the impact, by one law.

    Parameters
    ----------
    law : Text
        Name of the law.
    body : Count
        Which body, from 1.
    velocity : Speed
        Velocity after [m/s].
    delta_v : Speed
        Change of velocity, from its impulses over its mass [m/s].
    impulse_to_next : Impulse
        Impulse on the next body; none for the last [N·s].
    """

    law: Text
    body: Count
    velocity: Speed
    delta_v: Speed
    impulse_to_next: Impulse | None


@record
class LawAnswer:
    """What one law says of all bodies.

    Parameters
    ----------
    law : Text
        Name of the law.
    energy_lost : Energy
        Energy lost [J].
    collisions : Count
        Collisions of single pairs, or rounds of all contacts at one moment; ever slower ones are counted until they
        change no digit of a result.
    """

    law: Text
    energy_lost: Energy
    collisions: Count


@record
class ChainFound:
    """What the laws say.

    Parameters
    ----------
    momentum : Impulse
        Momentum of all, which stays [N·s].
    laws : tuple[LawAnswer, ...]
        One for each law that has an answer.
    bodies : tuple[AfterChain, ...]
        The bodies in order, for each law.
    """

    momentum: Impulse
    laws: tuple[LawAnswer, ...]
    bodies: tuple[AfterChain, ...]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
