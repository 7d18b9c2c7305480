"""Inputs and results of a chain of bodies."""

from dynamics_cli.quantities import Annotated, Count, Energy, Impulse, Mass, Restitution, Speed, Text
from dynamics_cli.records import Advice, Check, Choice, Numerics, record


class ChainLaw(Choice):
    """Law for the impact of a chain of touching bodies.

    sequential: one pair at a time, the pair that closes fastest first, until none closes. simultaneous: impulses at all
    contacts at one moment until none closes, and e times as much again (Moreau); repeated while a pair closes.
    all: both, side by side.
    """

    names = ("all", "sequential", "simultaneous")
    aliases = {"pairs": "sequential", "newton": "simultaneous"}  # noqa: RUF012


@record
class Body:
    """A body of the chain."""

    mass: Annotated[Mass, "Its mass [kg]."]
    velocity: Annotated[Speed, "Velocity along the line, positive from the first body to the last [m/s]."] = 0.0
    restitution: Annotated[
        Restitution | None, "Restitution with the next body, where it differs from that of the chain [-]."
    ] = None


@record
class AfterChain:
    """A body after the impact, by one law."""

    law: Annotated[Text, "Name of the law."]
    body: Annotated[Count, "Number of the body, from 1."]
    velocity: Annotated[Speed, "Velocity after [m/s]."]
    delta_v: Annotated[Speed, "Change of velocity, from its impulses over its mass [m/s]."]
    impulse_to_next: Annotated[Impulse | None, "Impulse on the next body; none for the last [N·s]."]


@record
class LawAnswer:
    """Answer of one law for all bodies."""

    law: Annotated[Text, "Name of the law."]
    energy_lost: Annotated[Energy, "Energy lost [J]."]
    collisions: Annotated[
        Count,
        "Collisions of single pairs, or rounds of all contacts at one moment, counted until they no longer "
        "change any digit of a result.",
    ]


@record
class ChainResult:
    """Answers of the laws."""

    momentum: Annotated[Impulse, "Momentum of all, which stays [N·s]."]
    laws: Annotated[tuple[LawAnswer, ...], "One for each law that has an answer."]
    bodies: Annotated[tuple[AfterChain, ...], "The bodies in order, for each law."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
