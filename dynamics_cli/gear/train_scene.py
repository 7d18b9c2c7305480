"""What a gear train is made of, however it is written: shafts, meshes and what is done with the shafts."""

from itertools import pairwise
from math import gcd

from dynamics_cli.errors import require
from dynamics_cli.quantities import Count, Module, Positive, ShaftSpeed, Text, Torque
from dynamics_cli.records import record

GROUND = "frame"
_GROUND_NAMES = ("", "frame", "ground", "housing")


@record
class Mesh:
    """Two gears in mesh, each on a shaft of its own, their axes held by the frame or by a carrier.

    Parameters
    ----------
    first : Text
        The shaft of the first gear.
    first_teeth : Count
        Its number of teeth (threads of a worm).
    second : Text
        The shaft of the second gear.
    second_teeth : Count
        Its number of teeth.
    internal : bool
        Whether the second gear is an internal gear (teeth inwards, ISO 21771: z₂ < 0).
    carrier : Text
        The shaft that carries the axes of the gears; the frame when it is left out.
    """

    first: Text
    first_teeth: Count
    second: Text
    second_teeth: Count
    internal: bool = False
    carrier: Text = GROUND

    @property
    def teeth(self) -> tuple[int, int]:
        """The numbers of teeth, an internal gear's negative."""
        return self.first_teeth, -self.second_teeth if self.internal else self.second_teeth


@record
class Stages:
    """A train whose axes the frame holds, stage after stage.

    Parameters
    ----------
    stages : Text
        Tooth numbers: `:` between gears in mesh, a comma between gears on one shaft; `20:60, 18:54` is a compound
        train, `20:35:60` has an idler, `20:-72` an internal gear. The shafts are called 1, 2, 3 …
    """

    stages: Text

    def meshes(self) -> tuple[Mesh, ...]:
        """The meshes in order."""
        found: list[Mesh] = []
        shaft = 1
        text = self.stages.replace("×", ":").replace("x", ":").replace(" ", "").replace(";", ",")
        for stage in text.split(","):
            teeth = [_whole(word, stage) for word in stage.split(":")]
            require(len(teeth) > 1, f"{stage!r} is no stage: write two tooth numbers, as in 20:60", code="stage")
            for one, other in pairwise(teeth):
                found.append(_external_first(str(shaft), one, str(shaft + 1), other))
                shaft += 1
        return tuple(found)


def _whole(word: str, stage: str) -> int:
    digits = word[1:] if word[:1] in ("-", "−") else word
    require(
        digits.isascii() and digits.isdigit() and len(digits) < 10 and int(digits) > 0,
        f"{word or stage!r} is not a number of teeth",
        code="teeth",
        hint="write stages as 20:60, 18:54",
    )
    return int(digits) if digits == word else -int(digits)


def _external_first(first: str, teeth: int, second: str, other: int) -> Mesh:
    require(teeth > 0 or other > 0, f"two internal gears, {teeth} and {other}, cannot mesh", code="two-internal-gears")
    if teeth < 0:
        return Mesh(second, other, first, -teeth, internal=True)
    return Mesh(first, teeth, second, abs(other), internal=other < 0)


@record
class Planetary:
    """A sun and a ring with planets between them on a carrier; the shafts are sun, planet, ring and carrier.

    Parameters
    ----------
    sun : Count
        Teeth of the sun.
    ring : Count
        Teeth of the ring (an internal gear, its number written positive).
    planet : Count
        Teeth of the planet that meets the sun; (ring − sun)/2 when left out.
    stepped : Count
        Teeth of the second gear of a stepped planet, which meets the ring.
    planets : Count
        Number of planets.
    addendum : Positive
        Height of the planets' teeth above their pitch circle, in modules.
    module : Module
        Module of the sun's mesh, for lengths.
    """

    sun: Count
    ring: Count
    planet: Count | None = None
    stepped: Count | None = None
    planets: Count = 3
    addendum: Positive = 1.0
    module: Module | None = None

    @property
    def planet_teeth(self) -> tuple[int, int]:
        """Teeth of the planet where it meets the sun and where it meets the ring."""
        if self.planet is None:
            require(self.stepped is None, "a stepped planet needs the teeth of both its gears", code="planet")
            require(
                self.ring - self.sun >= 2,
                "a ring of {0} teeth has no room for a planet about a sun of {1}",
                self.ring,
                self.sun,
                code="no-planet",
            )
            require(
                (self.ring - self.sun) % 2 == 0,
                "(ring − sun)/2 = {0}/2 is not whole: the planet is not settled by sun and ring",
                self.ring - self.sun,
                code="planet",
                hint=f"give --planet {(self.ring - self.sun) // 2} and shift the profiles, or change one gear",
            )
            half = (self.ring - self.sun) // 2
            return half, half
        return self.planet, self.planet if self.stepped is None else self.stepped

    def meshes(self) -> tuple[Mesh, ...]:
        """The two meshes of one planet; the others repeat them."""
        inner, outer = self.planet_teeth
        return (
            Mesh("sun", self.sun, "planet", inner, carrier="carrier"),
            Mesh("planet", outer, "ring", self.ring, internal=True, carrier="carrier"),
        )

    @property
    def steps(self) -> int:
        """How many evenly spread places about the sun can take a planet (all planets cut alike)."""
        inner, outer = self.planet_teeth
        return (self.sun * outer + self.ring * inner) // gcd(inner, outer)


@record
class Network:
    """Any train, by its meshes.

    Parameters
    ----------
    meshes : tuple of Mesh
        The meshes; several equal planets count once.
    """

    meshes: tuple[Mesh, ...]


@record
class Shaft:
    """What is known of a shaft.

    Parameters
    ----------
    name : Text
        The shaft.
    speed : ShaftSpeed
        Its speed [rad/s].
    torque : Torque
        The torque put on it from outside [N*m].
    """

    name: Text
    speed: ShaftSpeed | None = None
    torque: Torque | None = None


def settled(name: str) -> str:
    """A shaft's name; the frame's many names are one."""
    plain = name.strip().lower()
    return GROUND if plain in _GROUND_NAMES else plain
