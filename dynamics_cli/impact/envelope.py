"""ΔV over a region of restitution and friction: what an impact can have done when neither is known well."""

from dynamics_cli.errors import require
from dynamics_cli.impact.bodies import RigidBody, RigidTarget, Solid, solid
from dynamics_cli.impact.conventions import AXES, Axes, direction_of
from dynamics_cli.impact.diagnostics import require_finite
from dynamics_cli.impact.envelope_records import DeltaVRange, Envelope, EnvelopePoint, SpinRange
from dynamics_cli.impact.laws import LAW, ON_THE_PATH, Law
from dynamics_cli.impact.planar import meeting_of
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Count,
    Friction,
    Gravity,
    PlanarPosition,
    Restitution,
    RoadSpeed,
)
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.envelope_bounds import ExactContact, Extreme

    Array = NDArray[Any]

UNIT_ROUNDOFF = 2.0**-53
POINTS_MOST = 100_000_000
# Points that doubles cannot tell from an extreme, which are calculated in 60 digits.
MOST_NEAR = 40


def envelope(
    *,
    first: RigidBody,
    second: RigidTarget,
    normal: Angle,
    least_restitution: Restitution = 0.0,
    greatest_restitution: Restitution = 1.0,
    least_friction: Friction = 0.0,
    greatest_friction: Friction = 1.0,
    restitution_points: Count = 1000,
    friction_points: Count = 1000,
    map_points: Count = 5,
    law: Law = LAW,
    contact_point: PlanarPosition | None = None,
    closing_speed: RoadSpeed | None = None,
    axes: Axes = AXES,
    gravity: Gravity = STANDARD_GRAVITY,
) -> Envelope:
    """ΔV of a planar impact over a region of restitution and friction, a million points unless told otherwise.

    Equation
    --------
    As `impact planar` at every point of the grid; ΔV = |p|/m.

    Parameters
    ----------
    first : RigidBody
        The first body.
    second : RigidTarget
        The second body, or a fixed barrier.
    normal : Angle
        Direction of the contact normal from the first body to the second, counted like a heading [rad].
    least_restitution : Restitution
        Lower end of restitution [-].
    greatest_restitution : Restitution
        Upper end of restitution [-].
    least_friction : Friction
        Lower end of friction [-].
    greatest_friction : Friction
        Upper end of friction [-].
    restitution_points : Count
        Points along restitution, both ends among them.
    friction_points : Count
        Points along friction, both ends among them.
    map_points : Count
        Points along each side of the coarse map that is written out.
    law : Law
        What ends the impact: stronge, newton, poisson, brach or kudlich-slibar.
    contact_point : PlanarPosition
        Where the bodies touch, when bodies are placed by their centres [m].
    closing_speed : RoadSpeed
        Normal speed of approach at the contact, where it is known better than the velocities tell [m/s].
    axes : Axes
        Axes of vectors, headings and spins: mathematical, compass, sae or iso.
    gravity : Gravity
        Acceleration of gravity, for bodies given by weight [m/s^2].

    Returns
    -------
    Envelope
        Ranges of ΔV, spins and energy, where they are reached, and a coarse map.

    Raises
    ------
    InadmissibleError
        As `impact planar`, when the region is empty or turned round, or no point of it has an answer.

    Notes
    -----
    Extremes are those of the grid: exact at its points, and at the ends of the region, where they mostly lie. Doubles
    find their places, 60 digits their values; the bound is mostly that another point errs in doubles.

    References
    ----------
    As `impact planar`.

    Examples
    --------
    >>> from dynamics_cli.impact.bodies import ByGyration, Lever
    >>> from dynamics_cli.impact.conventions import ByMass, ByVelocity, Fixed
    >>> ball = RigidBody(ByMass(1.0), ByGyration(0.5), Lever((0.0, -1.0)), ByVelocity((1.0, -2.0)))
    >>> found = envelope(first=ball, second=RigidTarget(Fixed(True)), normal=-1.5707963267948966)
    >>> round(found.first_delta_v.least, 12), found.points
    (2.0, 1000000)
    """
    import numpy as np

    from dynamics_cli.impact.envelope_bounds import ExactContact

    require(law != "all", "an envelope is of one law", code="one-law", hint="--law stronge")
    require(
        least_restitution <= greatest_restitution and least_friction <= greatest_friction,
        "the region is turned round: its lower ends lie above its upper ones",
        code="region",
    )
    sizes = restitution_points, friction_points, map_points
    require(min(sizes) >= 1, "a region has at least one point along each side", code="region")
    for least, greatest, points, side in (
        (least_restitution, greatest_restitution, restitution_points, "restitution"),
        (least_friction, greatest_friction, friction_points, "friction"),
    ):
        require(
            least == greatest or min(points, map_points) >= 2,
            f"one point along {side} cannot cover it from " + "{0:.6g} to {1:.6g}",
            least,
            greatest,
            code="region",
            hint=f"two points or more, also for the map, or equal ends of {side}",
        )
    require(
        restitution_points * friction_points <= POINTS_MOST,
        "{0:.3g} points are more than a hundred million",
        restitution_points * friction_points,
        code="region",
    )
    one = solid(first, contact_point, axes, gravity, "the first body")
    two = solid(second, contact_point, axes, gravity, "the second body")
    towards = direction_of(normal, axes)
    inward = -towards[0], -towards[1]
    meeting = meeting_of(one, two, inward, closing_speed, 0.0, 0.0, 1.0)
    size = max(absolute(meeting.approach), absolute(meeting.slip))
    require_finite(8.0 * size * size / meeting.mobility.normal, "the energy of the impact")
    e = np.linspace(least_restitution, greatest_restitution, restitution_points)
    mu = np.linspace(least_friction, greatest_friction, friction_points)
    exact = ExactContact(first, second, normal, contact_point, closing_speed, axes, gravity)
    region = _Region(exact, law, e, mu)
    region.scan()
    require(region.good > 0, f"{law}: no point of the region has an answer", code="no-push", hint="--law stronge")
    return _report(region, one, two, map_points)


class _Region:
    """The grid, gone through in blocks; keeps the places of extremes only."""

    def __init__(self, exact: "ExactContact", law: str, e: "Array", mu: "Array") -> None:
        self.exact = exact
        self.meeting = exact.rounded()
        self.turns = exact.rounded_turns()
        self.law = str(law)
        self.e = e
        self.mu = mu
        self.rows = max(1, 16384 // e.size)
        self.good = 0
        self.full = 0
        self.least: dict[str, tuple[float, int, int]] = {}
        self.greatest: dict[str, tuple[float, int, int]] = {}
        # the extremes of every block of the grid, by quantity and end
        self.blocks: dict[tuple[str, bool], list[tuple[int, float]]] = {}

    def answer(self, mu: "Array", e: "Array") -> "tuple[Array, Array, Array]":
        """p_n, p_t and energy lost; NaN where the law has no answer."""
        import numpy as np

        from dynamics_cli.impact.path_arrays import impulses, ratio_impulses

        m, k = self.meeting, self.meeting.mobility
        function = impulses if self.law in ON_THE_PATH else ratio_impulses
        pn, pt = function(k.tangential, k.coupling, k.normal, k.determinant, m.slip, m.approach, mu, e, law=self.law)
        kx = k.coupling
        # beside points with an answer there may be points of any size without one
        with np.errstate(all="ignore"):
            lost = -pn * (m.approach + 0.5 * k.normal * pn + kx * pt) - pt * (m.slip + 0.5 * k.tangential * pt)
        if self.law != "stronge":
            gains = lost < -1e-12 * (np.abs(pn * m.approach) + np.abs(pt * m.slip))
            pn = np.where(gains, np.nan, pn)
        return pn, pt, lost

    def found(self, pn: "Array", pt: "Array", lost: "Array") -> "dict[str, Array]":
        """The quantities whose extremes are sought; the square of the impulse for its size."""
        found = {"size": pn * pn + pt * pt, "lost": lost}
        for name, turn in zip(("first", "second"), self.turns, strict=True):
            if turn is not None:
                found[name] = turn[0] * pn + turn[1] * pt
        return found

    def scan(self) -> None:
        """Go through all points."""
        import numpy as np

        for start in range(0, self.mu.size, self.rows):
            mu = self.mu[start : start + self.rows, None]
            pn, pt, lost = self.answer(mu, self.e)
            good = pn == pn
            count = int(np.count_nonzero(good))
            if not count:
                continue
            self.good += count
            self.full += int(np.count_nonzero(np.abs(pt) >= (1.0 - 1e-14) * (mu * pn)))
            for name, values in self.found(pn, pt, lost).items():
                self._keep(name, values if count == good.size else np.where(good, values, np.nan), start)

    def at(self, mu: float, e: float) -> dict[str, float]:
        """The same in doubles at one point; nothing where the law has no answer."""
        import numpy as np

        pn, pt, lost = self.answer(np.array([mu]), np.array([e]))
        if pn[0] != pn[0]:
            return {}
        made = {name: float(values[0]) for name, values in self.found(pn, pt, lost).items()}
        return {**made, "size": made["size"] ** 0.5}

    def extremes(self) -> "dict[str, tuple[Extreme, Extreme]]":
        """Least and greatest of every quantity, with their bounds."""
        from dynamics_cli.impact.envelope_bounds import Extremes

        found = Extremes(self.exact, self.law, self.at)
        places = {(row, column) for store in (self.least, self.greatest) for _, row, column in store.values()}
        corners = {(row, column) for row in (0, self.mu.size - 1) for column in (0, self.e.size - 1)}
        found.learn(self._point(*place) for place in places | corners if self.at(*self._point(*place)))
        missed = found.missed()
        left = {}
        for name, room in missed.items():
            for greatest in (False, True):
                near = self._near(name, greatest, found.end(name, greatest=greatest, missed=0.0).value, room)
                left[name, greatest] = room if near is None else 0.0
                found.learn(near or ())
        return {
            name: (
                found.end(name, greatest=False, missed=left[name, False]),
                found.end(name, greatest=True, missed=left[name, True]),
            )
            for name in missed
        }

    def _point(self, row: int, column: int) -> tuple[float, float]:
        return float(self.mu[row]), float(self.e[column])

    def _near(self, name: str, greatest: bool, value: float, room: float) -> "list[tuple[float, float]] | None":
        """The points that may be beyond the extreme for all that doubles tell; None where they are many."""
        import numpy as np

        way = 1.0 if greatest else -1.0
        # of the impulse the square was kept
        limit = way * value - 2.0 * room
        bar = limit if name != "size" else way * (way * limit) ** 2 if way * limit > 0.0 else -np.inf
        found: list[tuple[float, float]] = []
        for start, best in self.blocks[name, greatest]:
            if way * best < bar:
                continue
            mu = self.mu[start : start + self.rows, None]
            pn, pt, lost = self.answer(mu, self.e)
            values = np.where(pn == pn, self.found(pn, pt, lost)[name], np.nan)
            with np.errstate(invalid="ignore"):
                rows, columns = np.nonzero(way * values >= bar)
            if len(found) + rows.size > MOST_NEAR:
                return None
            found += [
                self._point(start + row, column) for row, column in zip(rows.tolist(), columns.tolist(), strict=True)
            ]
        return found

    def _keep(self, name: str, values: "Array", start: int) -> None:
        import numpy as np

        for store, find, better in ((self.least, np.nanargmin, -1.0), (self.greatest, np.nanargmax, 1.0)):
            index = int(find(values))
            value = float(values.flat[index])
            self.blocks.setdefault((name, better > 0.0), []).append((start, value))
            if name not in store or better * value > better * store[name][0]:
                row, column = divmod(index, self.e.size)
                store[name] = value, start + row, column


def _report(region: _Region, one: Solid, two: Solid, map_points: int) -> Envelope:
    import numpy as np

    total = region.e.size * region.mu.size
    # a side without extent has one place on the map: more would repeat its rows
    e, mu = (np.linspace(s[0], s[-1], map_points if s[0] < s[-1] else 1) for s in (region.e, region.mu))
    pn, pt, lost = region.answer(mu[:, None], e)
    good = pn == pn
    size = np.sqrt(pn * pn + pt * pt)[good]
    grid_mu, grid_e = np.broadcast_arrays(mu[:, None], e)
    points = Columns(
        EnvelopePoint,
        restitution=grid_e[good],
        friction=grid_mu[good],
        first_delta_v=size / one.mass if one.mass is not None else 0.0 * size,
        second_delta_v=size / two.mass if two.mass is not None else 0.0 * size,
        impulse_ratio=(pt / pn)[good],
        energy_lost=lost[good],
    )
    refused = total - region.good
    advice: tuple[Advice, ...] = ()
    if refused:
        text = f"{region.law} has no answer or gains energy at {refused} of {total} points; they are left out"
        advice = (Advice("law-inadmissible", text, "caution", mend="--law stronge answers everywhere"),)
    found = region.extremes()
    bodies = {"first": one, "second": two}
    ranges = {name: _delta_v_range(found["size"], body) for name, body in bodies.items()}
    spins = {name: _spin_range(found.get(name), way) for name, way in (("first", 1.0), ("second", -1.0))}
    least, greatest = found["lost"]
    checks: tuple[Check, ...] = ()
    if region.law == "stronge":
        scale = max(abs(greatest.value), 1e-300)
        checks = (Check("energy never gained", least.value >= -1e-12 * scale, max(-least.value / scale, 0.0), 1e-12),)
    return Envelope(
        first_delta_v=ranges["first"],  # type: ignore[arg-type]
        second_delta_v=ranges["second"],
        first_spin_change=spins["first"],  # type: ignore[arg-type]
        second_spin_change=spins["second"],
        least_energy_lost=least.value,
        greatest_energy_lost=greatest.value,
        law=region.law,
        points=total,
        refused=refused,
        slip_share=region.full / region.good,
        map=points,
        checks=checks,
        advice=advice,
        numerics=Numerics("closed-form path at every point of a grid, extremes in 60 digits", _bounds(found, bodies)),
    )


def _delta_v_range(found: "tuple[Extreme, Extreme]", body: Solid) -> DeltaVRange | None:
    if body.mass is None:
        return None
    low, high = found
    return DeltaVRange(
        least=low.value / body.mass,
        greatest=high.value / body.mass,
        least_restitution=low.place[1],
        least_friction=low.place[0],
        greatest_restitution=high.place[1],
        greatest_friction=high.place[0],
    )


def _spin_range(found: "tuple[Extreme, Extreme] | None", way: float) -> SpinRange | None:
    if found is None:
        return None
    ends = sorted(way * end.value for end in found)
    return SpinRange(ends[0], ends[1])


def _bounds(found: "dict[str, tuple[Extreme, Extreme]]", bodies: dict[str, Solid]) -> tuple[ErrorBound, ...]:
    """Those of the extremes; ΔV is divided by the mass, which may be rounded, and rounded once more."""
    low, high = found["lost"]
    made = [("least_energy_lost", low.value, low.error), ("greatest_energy_lost", high.value, high.error)]
    for name, body in bodies.items():
        if body.mass is not None:
            for end, size in zip(("least", "greatest"), found["size"], strict=True):
                error = size.error + 2.0 * UNIT_ROUNDOFF * size.value
                made.append((f"{name}_delta_v.{end}", size.value, error))
        if name in found:
            ends = found[name] if name == "first" else found[name][::-1]
            made += [
                (f"{name}_spin_change.{end}", one.value, one.error)
                for end, one in zip(("least", "greatest"), ends, strict=True)
            ]
    return tuple(
        ErrorBound(name, error / abs(value)) if value else ErrorBound(name, error, relative=False)
        for name, value, error in made
    )
