"""The elements of a gear train in any notation: shafts, meshes and given speeds and torques."""

from itertools import pairwise
from math import gcd

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Count, Module, Positive, ShaftSpeed, Text, Torque
from dynamics_cli.records import record

GROUND = "frame"
_GROUND_NAMES = ("", "frame", "ground", "housing")


@record
class Mesh:
    """Two gears in mesh, each on its own shaft, their axes held by the frame or by a carrier."""

    first: Annotated[Text, "The shaft of the first gear."]
    first_teeth: Annotated[Count, "Its number of teeth (threads of a worm), e.g. 24."]
    second: Annotated[Text, "The shaft of the second gear."]
    second_teeth: Annotated[Count, "Its number of teeth, e.g. 60."]
    internal: Annotated[bool, "Whether the second gear is an internal gear (teeth inwards, ISO 21771: z₂ < 0)."] = False
    carrier: Annotated[Text, "The shaft that carries the axes of the gears; the frame when it is left out."] = GROUND

    @property
    def teeth(self) -> tuple[int, int]:
        """The numbers of teeth, an internal gear's negative."""
        return self.first_teeth, -self.second_teeth if self.internal else self.second_teeth


@record
class Stages:
    """A train with fixed axes, stage after stage."""

    stages: Annotated[
        Text,
        "Tooth numbers: `:` between gears in mesh, a comma between gears on one shaft; `20:60, 18:54` is a "
        "compound train, `20:35:60` has an idler, `20:-72` an internal gear. The shafts are called 1, 2, 3 …",
    ]

    def meshes(self) -> tuple[Mesh, ...]:
        """The meshes in order."""
        meshes: list[Mesh] = []
        shaft = 1
        text = self.stages.translate({**dict.fromkeys(map(ord, "×x/"), ":"), **dict.fromkeys(map(ord, ";,"), " ")})
        for stage in ":".join(part.strip() for part in text.split(":")).split() or [""]:
            teeth = [_whole(word, stage) for word in stage.split(":")]
            require(
                len(teeth) > 1,
                "read the stage {stage}, wanted two tooth numbers as in 20:60",
                stage=repr(stage),
                code="stage",
            )
            for first, second in pairwise(teeth):
                meshes.append(_external_first(str(shaft), first, str(shaft + 1), second))
                shaft += 1
        return tuple(meshes)


def _whole(word: str, stage: str) -> int:
    digits = word[1:] if word[:1] in ("-", "−") else word
    require(
        digits.isascii() and digits.isdigit() and len(digits) < 10 and int(digits) > 0,
        "{word} is not a number of teeth",
        word=repr(word or stage),
        code="teeth",
        hint="write stages as 20:60, 18:54",
    )
    return int(digits) if digits == word else -int(digits)


def _external_first(first: str, teeth: int, second: str, other: int) -> Mesh:
    require(
        teeth > 0 or other > 0,
        "two internal gears, {teeth} and {other}, cannot mesh",
        teeth=teeth,
        other=other,
        code="two-internal-gears",
    )
    if teeth < 0:
        return Mesh(second, other, first, -teeth, internal=True)
    return Mesh(first, teeth, second, abs(other), internal=other < 0)


@record
class Planetary:
    """A sun and a ring with planets between them on a carrier; the shafts are sun, planet, ring and carrier."""

    sun: Annotated[Count, "Teeth of the sun, e.g. 24."]
    ring: Annotated[Count, "Teeth of the ring (an internal gear, its number written positive), e.g. 72."]
    planet: Annotated[
        Count | None, "Teeth of the planet that meshes with the sun; (ring − sun)/2 if left out, e.g. 24."
    ] = None
    stepped: Annotated[
        Count | None, "Teeth of the second gear of a stepped planet, which meshes with the ring, e.g. 18."
    ] = None
    planets: Annotated[Count, "Number of planets."] = 3
    addendum: Annotated[Positive, "Height of the planets' teeth above their pitch circle, in modules."] = 1.0
    module: Annotated[Module | None, "Module of the sun's mesh, for lengths."] = None

    @property
    def planet_teeth(self) -> tuple[int, int]:
        """Teeth of the planet where it meets the sun and where it meets the ring."""
        if self.planet is None:
            require(self.stepped is None, "a stepped planet needs the teeth of both its gears", code="planet")
            require(
                self.ring - self.sun >= 2,
                "a ring of {ring} teeth has no space for a planet beside a sun of {sun}",
                ring=self.ring,
                sun=self.sun,
                code="no-planet",
            )
            require(
                (self.ring - self.sun) % 2 == 0,
                "(ring − sun)/2 = {difference}/2 is not whole: sun and ring do not determine the planet",
                difference=self.ring - self.sun,
                planet=(self.ring - self.sun) // 2,
                less=self.ring - 1,
                more=self.ring + 1,
                code="planet",
                hint="take a ring of {less} or {more} teeth, or give --planet {planet} and shift the profiles",
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
        """Number of evenly spaced places about the sun that can take a planet (all planets cut alike)."""
        inner, outer = self.planet_teeth
        return (self.sun * outer + self.ring * inner) // gcd(inner, outer)


@record
class Network:
    """Any train, by its meshes."""

    meshes: Annotated[tuple[Mesh, ...], "The meshes; several equal planets count once."]


@record
class Shaft:
    """The givens of a shaft."""

    name: Annotated[Text, "The shaft."]
    speed: Annotated[ShaftSpeed | None, "Its speed [rad/s]."] = None
    torque: Annotated[Torque | None, "The torque put on it from outside, e.g. 12 N*m [N*m]."] = None


def settled(name: str) -> str:
    """A shaft's name as written; all names of the frame are equivalent, in any capitals."""
    stripped = name.strip()
    return GROUND if stripped.lower() in _GROUND_NAMES else stripped
