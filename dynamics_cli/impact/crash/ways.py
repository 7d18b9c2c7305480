"""Phases of the vehicles before and after the impact: speeds calculated back along them, and forward as a check."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import direction_of
from dynamics_cli.impact.crash.results import BeforeImpact, Course
from dynamics_cli.impact.crash.scene import CrashScene, Ground, grounds, named, phases
from dynamics_cli.impact.crash.spinning import Spinning
from dynamics_cli.impact.diagnostics import balance
from dynamics_cli.impact.slide.task import spin_advice
from dynamics_cli.numerics.elementary import maximum, sqrt, summed
from dynamics_cli.numerics.road.drag import drag_advice
from dynamics_cli.numerics.road.leg import Leg
from dynamics_cli.numerics.road.phases import Phase, legs
from dynamics_cli.numerics.road.slide import SurfaceCrossed, crossed_back
from dynamics_cli.records import Advice, Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[float, float]

BRAKING = ("build-up", "braking")


class After:
    """A vehicle's slide from the impact to where it ends."""

    def __init__(self, scene: CrashScene, side: str, gravity: float) -> None:
        given = getattr(scene, side)
        self.side = side
        self.grounds: tuple[Ground, ...] = grounds(scene, side)
        self.surfaces: tuple[SurfaceCrossed, ...] = ()
        self.speed: float | None = given.exit_speed
        self.end_speed: float = given.end_speed
        self.gravity = gravity
        self.work: float = 0.0
        self.spinning: Spinning | None = None
        if given.slide is not None:
            self.spinning = Spinning(scene, side, gravity)
            self.speed = self.spinning.speed
            self.work = 0.5 * self.spinning.speed * self.spinning.speed / gravity
        elif self.grounds:
            require(
                given.exit_speed is None,
                "{side}: the exit speed is given, and the slide after the impact determines it too",
                code="twice",
                hint="leave one of them out",
                side=side,
            )
            names = [f"{side}.after[{index}]: " for index in range(len(self.grounds))]
            self.surfaces, self.work = crossed_back(self.grounds, self.end_speed, gravity, names)
            self.speed = self.surfaces[0].entry_speed

    @property
    def distance(self) -> float:
        """Length of the slide; straight to the rest of one with spin."""
        if self.spinning is not None:
            return self.spinning.distance
        total: float = summed([surface.distance for surface in self.surfaces])
        return total

    def rows(self, name: str, mass: float, scene: CrashScene) -> "list[Course]":
        """Its surfaces as rows of the course."""
        parts = getattr(scene, self.side).after
        if self.spinning is not None:
            assert self.speed is not None
            energy = mass * (self.gravity * self.work)
            name_of = getattr(scene, self.side).slide.surface
            what = f"slide with spin, {name_of}" if name_of else "slide with spin"
            row = Course(name, what, self.speed, 0.0 * self.speed, self.spinning.time, self.distance, energy)
            return [row]
        return [
            Course(
                name, f"slide, {part.surface}" if part.surface else "slide", surface.entry_speed, surface.exit_speed,
                surface.time, surface.distance, mass * (self.gravity * surface.drag_factor * surface.distance),
            )
            for part, surface in zip(parts, self.surfaces, strict=True)
        ]  # fmt: skip

    def forward(self, name: str) -> tuple[Check, ...]:
        """Check by sliding forward from the speed after the impact: the end must be the measured one."""
        if not self.surfaces:
            return ()
        assert self.speed is not None
        left = self.speed * self.speed
        for surface in self.surfaces:
            left = left - 2.0 * self.gravity * surface.drag_factor * surface.distance
        beyond = (left - self.end_speed * self.end_speed) / (2.0 * self.gravity * self.surfaces[-1].drag_factor)
        reached = self.distance + beyond
        return balance(f"{name} slides forward to its rest", reached, self.distance, reached)

    def advice(self) -> tuple[Advice, ...]:
        """Advice on implausible surfaces."""
        notes: tuple[Advice, ...] = () if self.spinning is None else spin_advice(self.spinning.spin)
        for index, ground in enumerate(self.grounds):
            notes += drag_advice(ground.friction, ground.grade, ground.braking, f"{self.side}.after[{index}]: ")
        return notes


class Before:
    """A vehicle's phases before the impact, back from its speed there."""

    def __init__(self, scene: CrashScene, side: str, speed: float, gravity: float) -> None:
        self.side = side
        self.phases: tuple[Phase, ...] = phases(scene, side)
        self.legs: list[Leg] = []
        if self.phases:
            whose = named(getattr(scene, side), side)
            self.legs = legs(self.phases, gravity, start=None, end=speed, whose=whose)
        self.impact_speed = speed
        self.gravity = gravity

    @property
    def start_speed(self) -> float:
        """Speed at the start; without phases the speed into the impact."""
        return self.legs[0].start if self.legs else self.impact_speed

    @property
    def work(self) -> float:
        """Work per mass of all phases against the motion."""
        return summed([_shed(leg) for leg in self.legs]) if self.legs else 0.0

    def summary(self, scene: CrashScene, heading: "float | None") -> BeforeImpact | None:
        """Speeds and places at its start and where it begins to brake."""
        if not self.legs:
            return None
        brake = next((index for index, leg in enumerate(self.legs) if leg.kind in BRAKING), None)
        distance = summed([leg.distance for leg in self.legs])
        braking: tuple[Any, Any, Any] = (None, None, None)
        if brake is not None:
            rest = self.legs[brake:]
            braking = rest[0].start, summed([leg.duration for leg in rest]), summed([leg.distance for leg in rest])
        limit = scene.speed_limit
        return BeforeImpact(
            self.legs[0].start, summed([leg.duration for leg in self.legs]), distance,
            None if heading is None else along(scene, heading, -distance), *braking,
            impact_speed_at_limit=None if limit is None or brake is None else self._from(limit, brake),
        )  # fmt: skip

    def _from(self, limit: float, brake: int) -> float:
        """Speed into the impact from another speed where it begins to brake, with the same work of the brakes."""
        begin = self.legs[brake].start
        shed = (begin - self.impact_speed) * (begin + self.impact_speed)
        return sqrt(maximum(limit * limit - shed, 0.0))

    def rows(self, name: str, mass: float) -> "list[Course]":
        """Its phases as rows of the course."""
        return [
            Course(name, leg.kind, leg.start, leg.end, leg.duration, leg.distance, mass * _shed(leg))
            for leg in self.legs
        ]

    def forward(self, name: str) -> tuple[Check, ...]:
        """Check by driving forward from the start: it must reach the impact with the calculated speed."""
        if not self.legs:
            return ()
        speed = self.legs[0].start
        for leg, following in zip(self.legs, [*self.legs[1:], None], strict=True):
            gained = leg.rate * leg.duration
            speed = speed + (0.5 * gained if leg.kind == "build-up" else gained)
            if leg.kind == "waiting" and following is not None:
                # a walking speed is assumed to be reached at once
                speed = following.start
        return balance(f"{name} drives forward into the impact", speed, self.impact_speed, self.legs[0].start)

    def advice(self) -> tuple[Advice, ...]:
        """Advice on implausible phases."""
        notes: tuple[Advice, ...] = ()
        for index, phase in enumerate(self.phases):
            if phase.friction is not None:
                notes += drag_advice(phase.friction, phase.grade, phase.braking, f"{self.side}.before[{index}]: ")
        return notes


def _shed(leg: Leg) -> float:
    """Work per mass of a phase: deceleration times distance; for a build-up integrated over time."""
    if leg.kind == "build-up":
        lost = 0.5 * leg.rate * leg.duration
        return -lost * (leg.start + 0.5 * lost)
    return -leg.rate * leg.distance


def along(scene: CrashScene, heading: float, distance: float) -> "Pair":
    """The point at a distance along a heading from the point of impact."""
    x, y = direction_of(heading, scene.axes)
    return scene.impact.point[0] + distance * x, scene.impact.point[1] + distance * y
