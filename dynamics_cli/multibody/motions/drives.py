"""Prescribed motions of joints."""

from dynamics_cli.errors import require
from dynamics_cli.multibody.bodies.records import Drive
from dynamics_cli.multibody.bodies.system import COUNTS, System
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.expressions.laws import law_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    # place, rate and second derivative at a time
    Law = Callable[[float], tuple[float, float, float]]


class Drives:
    """The driven joints of a system, by the places of their speeds."""

    def __init__(self, system: System) -> None:
        self.system = system
        self.laws: dict[int, Law] = {}
        for drive in system.scene.drives:
            k = system.body_link(drive.body)
            body = next((body for body in system.bodies if body.name == drive.body), None)
            single = body is not None and sum(COUNTS[body.joint]) == 1
            require(single, "the joint of {body} does not have one angle or one slide: it cannot be driven",
                    body=drive.body, code="drive", hint="drive revolute or prismatic joints")  # fmt: skip
            link = system.tree.links[k]
            require(link.first not in self.laws, "{body} is driven twice", body=drive.body, code="drive")
            self.laws[link.first] = _law(drive, system.turning[link.first], system.coordinates[link.place])
        self.coordinates = {link.first: link.place for link in system.tree.links}
        for place in self.laws:
            system.placed[place] = system.moving[place] = True
        self.place(0.0)

    def laws_at(self, time: float) -> "list[tuple[int, tuple[float, float, float]]]":
        """Place, rate and second derivative of every driven joint."""
        return [(place, law(time)) for place, law in self.laws.items()]

    def conditions(self, time: float, scales: "list[float]") -> "list[list[float]]":
        """Conditions on the rates of the speeds, in units of these scales."""
        out = []
        for place, (_, _, second) in self.laws_at(time):
            row = [0.0] * (len(scales) + 1)
            row[place], row[-1] = 1.0, second / scales[place]
            out.append(row)
        return out

    def place(self, time: float) -> None:
        """Put the driven joints where their laws have them."""
        coordinates, speeds = list(self.system.coordinates), list(self.system.speeds)
        for place, (at, rate, _) in self.laws_at(time):
            coordinates[self.coordinates[place]] = at
            speeds[place] = rate
        self.system.at(coordinates, speeds)


def _law(drive: Drive, turning: bool, start: float) -> "Law":
    formula = drive.angle_law if turning else drive.slide_law
    wrong = (drive.slide_law, drive.velocity) if turning else (drive.angle_law, drive.speed)
    require(not any(wrong), "the drive of {body} has a law of the wrong kind", body=drive.body, code="drive",
            hint="speed or angle_law for a revolute joint, velocity or slide_law for a prismatic one")  # fmt: skip
    constant = drive.speed if turning else drive.velocity
    require(formula is None or not constant, "the drive of {body} has two laws", body=drive.body, code="drive",
            hint="give one of them")  # fmt: skip
    if formula is None:
        return lambda t: (start + constant * t, constant, 0.0)
    law = law_of(formula, (), ("t",))

    def at(time: float) -> "tuple[float, float, float]":
        value: Any = law(t=Jet.variable(time, 2))
        parts = value.parts if isinstance(value, Jet) else (value, 0.0, 0.0)
        return parts[0], parts[1], 2.0 * parts[2]

    return at
