"""Springs with dampers between points of two bodies, or of a body and the ground."""

from dynamics_cli.errors import require
from dynamics_cli.multibody.bodies.records import Spring
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.trees.newton_euler import back, sweep
from dynamics_cli.numerics.vectors import add, cross, dot, length, scale, subtract, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.numerics.trees.newton_euler import Motion, Wrench
    from dynamics_cli.numerics.trees.tree import Pose, Tree
    from dynamics_cli.numerics.vectors import Vector

ZERO = (0.0, 0.0, 0.0)


class PointSpring:
    """One spring: it pulls its ends together with k·(l − free length) + c·l̇."""

    def __init__(self, spring: Spring, number: int, links: "tuple[int, int]") -> None:
        self.number, self.links = number, links
        require(self.links[0] != self.links[1], "spring {number} joins {body} to itself", number=number,
                body=spring.first, code="spring", hint="name two bodies; ground is the other by default")  # fmt: skip
        self.at = spring.first_at, spring.second_at
        self.stiffness, self.damping = spring.stiffness, spring.damping
        self.given = spring.free_length
        self.free = 0.0

    def begin(self, ground: "Sequence[Pose]") -> None:
        """Without a free length given, take the one that it has here."""
        self.free = length(self.way(ground)) if self.given is None else self.given

    def way(self, ground: "Sequence[Pose]") -> "Vector":
        """From the first end to the second, in ground axes."""
        return subtract(self.end(ground, 1), self.end(ground, 0))

    def energy(self, ground: "Sequence[Pose]") -> float:
        """What is stored in it."""
        stretch = length(self.way(ground)) - self.free
        return 0.5 * self.stiffness * stretch * stretch

    def storing(self, ground: "Sequence[Pose]", motions: "Sequence[Motion]") -> float:
        """The rate of that energy."""
        way = self.way(ground)
        along = dot(way, subtract(self._velocity(ground, motions, 1), self._velocity(ground, motions, 0)))
        size = length(way)
        return self.stiffness * (along - self.free * along / size if self.free else along)

    def opening(self, ground: "Sequence[Pose]", motions: "Sequence[Motion]") -> float:
        """The rate of its length."""
        way = self.way(ground)
        size = length(way)
        return dot(way, subtract(self._velocity(ground, motions, 1), self._velocity(ground, motions, 0))) / size

    def wrenches(self, ground: "Sequence[Pose]", motions: "Sequence[Motion] | None") -> "list[tuple[int, Wrench]]":
        """Forces and moments on the links at its ends, in their own axes about their origins."""
        way = self.way(ground)
        size = length(way)
        if not plain(self.free) and not plain(self.damping):
            pull = scale(self.stiffness, way)
        else:
            require(size > 0.0, "the ends of spring {number} have met: its force has no direction", number=self.number,
                    code="spring", hint="move one of its points, or give it no free length and no damping")  # fmt: skip
            tension = self.stiffness * (size - self.free)
            if motions is not None and plain(self.damping):
                tension = tension + self.damping * self.opening(ground, motions)
            pull = scale(tension / size, way)
        out = []
        for k, point, sign in zip(self.links, self.at, (1.0, -1.0), strict=True):
            if k >= 0:
                force = back(ground[k][0], scale(sign, pull))
                out.append((k, (force, cross(point, force))))
        return out

    def end(self, ground: "Sequence[Pose]", side: int) -> "Vector":
        """The place of its first or second end."""
        k, point = self.links[side], self.at[side]
        return add(ground[k][1], times(ground[k][0], point)) if k >= 0 else point

    def _velocity(self, ground: "Sequence[Pose]", motions: "Sequence[Motion]", side: int) -> "Vector":
        k, point = self.links[side], self.at[side]
        if k < 0:
            return ZERO
        omega, _, velocity, _ = motions[k]
        return times(ground[k][0], add(velocity, cross(omega, point)))


def spring_wrenches(
    springs: "Sequence[PointSpring]", tree: "Tree", frames: "Sequence[Pose]", ground: "Sequence[Pose]",
    speeds: "Sequence[float]",
) -> "list[tuple[int, Wrench]]":  # fmt: skip
    """Forces and moments of all springs between points, in a state."""
    damped = any(plain(spring.damping) for spring in springs)
    motions = sweep(tree, frames, speeds) if damped else None
    return [wrench for spring in springs for wrench in spring.wrenches(ground, motions)]
