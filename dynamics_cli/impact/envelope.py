"""ΔV over a region of restitution and friction: what an impact can have done when neither is known well."""

from dynamics_cli.errors import require
from dynamics_cli.impact.bodies import RigidBody, RigidTarget, Solid, cross, solid
from dynamics_cli.impact.conventions import AXES, Axes, direction_of
from dynamics_cli.impact.diagnostics import require_finite
from dynamics_cli.impact.laws import LAW, ON_THE_PATH, Law, Meeting
from dynamics_cli.impact.planar import meeting_of
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularSpeed,
    Count,
    Energy,
    Friction,
    Gravity,
    PlanarPosition,
    Ratio,
    Restitution,
    RoadSpeed,
    Text,
)
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Rounding of the path on arrays, relative to the impulse; det K is known without cancellation.
ROUNDING = 2e-14
POINTS_MOST = 100_000_000


@record
class DeltaVRange:
    """Least and greatest ΔV of one body over the region, and where.

    Parameters
    ----------
    least : RoadSpeed
        Least ΔV [m/s].
    greatest : RoadSpeed
        Greatest ΔV [m/s].
    least_restitution : Ratio
        Restitution where it is least [-].
    least_friction : Ratio
        Friction where it is least [-].
    greatest_restitution : Ratio
        Restitution where it is greatest [-].
    greatest_friction : Ratio
        Friction where it is greatest [-].
    """

    least: RoadSpeed
    greatest: RoadSpeed
    least_restitution: Ratio
    least_friction: Ratio
    greatest_restitution: Ratio
    greatest_friction: Ratio


@record
class SpinRange:
    """Least and greatest change of spin of one body over the region.

    Parameters
    ----------
    least : AngularSpeed
        Least change, with its sign [rad/s].
    greatest : AngularSpeed
        Greatest change, with its sign [rad/s].
    """

    least: AngularSpeed
    greatest: AngularSpeed


@record
class EnvelopePoint:
    """One point of the region.

    Parameters
    ----------
    restitution : Ratio
        Restitution [-].
    friction : Ratio
        Friction [-].
    first_delta_v : RoadSpeed
        ΔV of the first body; zero of a fixed one [m/s].
    second_delta_v : RoadSpeed
        ΔV of the second body; zero of a fixed one [m/s].
    impulse_ratio : Ratio
        Tangential over normal impulse [-].
    energy_lost : Energy
        Kinetic energy lost [J].
    """

    restitution: Ratio
    friction: Ratio
    first_delta_v: RoadSpeed
    second_delta_v: RoadSpeed
    impulse_ratio: Ratio
    energy_lost: Energy


@record
class Envelope:
    """ΔV over a region of restitution and friction.

    Parameters
    ----------
    first_delta_v : DeltaVRange
        ΔV of the first body.
    second_delta_v : DeltaVRange
        ΔV of the second body; none of a fixed one.
    first_spin_change : SpinRange
        Change of spin of the first body.
    second_spin_change : SpinRange
        Change of spin of the second body; none of a fixed one.
    least_energy_lost : Energy
        Least energy lost [J].
    greatest_energy_lost : Energy
        Greatest energy lost [J].
    law : Text
        The law.
    points : Count
        Points of the region that were calculated.
    refused : Count
        Points where the law has no answer or gains energy; they are left out.
    slip_share : Ratio
        Share of the points where friction is fully used: slip never stops or the ratio is at its limit [-].
    map : Columns of EnvelopePoint
        A coarse map of the region; refused points are left out.
    """

    first_delta_v: DeltaVRange
    second_delta_v: DeltaVRange | None
    first_spin_change: SpinRange
    second_spin_change: SpinRange | None
    least_energy_lost: Energy
    greatest_energy_lost: Energy
    law: Text
    points: Count
    refused: Count
    slip_share: Ratio
    map: Columns[EnvelopePoint]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


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
    Extremes are those of the grid: exact at its points, and at the ends of the region, where they mostly lie.

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
    region = _Region(meeting, law, e, mu)
    region.scan(one, two, inward)
    require(region.good > 0, f"{law}: no point of the region has an answer", code="no-push", hint="--law stronge")
    return _report(region, one, two, inward, map_points)


class _Region:
    """The grid, gone through in blocks; keeps extremes only."""

    def __init__(self, meeting: Meeting, law: str, e: "Array", mu: "Array") -> None:
        self.meeting = meeting
        self.law = str(law)
        self.e = e
        self.mu = mu
        self.good = 0
        self.full = 0
        self.least: dict[str, tuple[float, int, int]] = {}
        self.greatest: dict[str, tuple[float, int, int]] = {}

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

    def scan(self, one: Solid, two: Solid, inward: "tuple[float, float]") -> None:
        """Go through all points."""
        import numpy as np

        rows = max(1, 16384 // self.e.size)
        turns = [_turn(body, inward) for body in (one, two)]
        for start in range(0, self.mu.size, rows):
            mu = self.mu[start : start + rows, None]
            pn, pt, lost = self.answer(mu, self.e)
            good = pn == pn
            count = int(np.count_nonzero(good))
            if not count:
                continue
            self.good += count
            self.full += int(np.count_nonzero(np.abs(pt) >= (1.0 - 1e-14) * (mu * pn)))
            found = {"square": pn * pn + pt * pt, "lost": lost}
            for name, turn in zip(("first", "second"), turns, strict=True):
                if turn is not None:
                    found[name] = turn[0] * pn + turn[1] * pt
            for name, values in found.items():
                self._keep(name, values if count == good.size else np.where(good, values, np.nan), start)

    def _keep(self, name: str, values: "Array", start: int) -> None:
        import numpy as np

        for store, find, better in ((self.least, np.nanargmin, -1.0), (self.greatest, np.nanargmax, 1.0)):
            index = int(find(values))
            value = float(values.flat[index])
            if name not in store or better * value > better * store[name][0]:
                row, column = divmod(index, self.e.size)
                store[name] = value, start + row, column


def _turn(body: Solid, inward: "tuple[float, float]") -> "tuple[float, float] | None":
    """Change of spin per unit of p_n and of p_t, as it acts on this body when it acts on the first."""
    if body.inertia is None:
        return None
    across = -inward[1], inward[0]
    return cross(body.lever, inward) / body.inertia, cross(body.lever, across) / body.inertia


def _report(region: _Region, one: Solid, two: Solid, inward: "tuple[float, float]", map_points: int) -> Envelope:
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
    ranges = {name: _delta_v_range(region, body) for name, body in (("first", one), ("second", two))}
    bounds = tuple(
        ErrorBound(f"{name}_delta_v.{end}", ROUNDING)
        for name in ("first", "second") if ranges[name] is not None for end in ("least", "greatest")
    )  # fmt: skip
    greatest = region.greatest["lost"][0]
    checks: tuple[Check, ...] = ()
    if region.law == "stronge":
        least = region.least["lost"][0]
        scale = max(abs(greatest), 1e-300)
        checks = (Check("energy never gained", least >= -1e-12 * scale, max(-least / scale, 0.0), 1e-12),)
    return Envelope(
        first_delta_v=ranges["first"],  # type: ignore[arg-type]
        second_delta_v=ranges["second"],
        first_spin_change=_spin_range(region, "first", 1.0),  # type: ignore[arg-type]
        second_spin_change=_spin_range(region, "second", -1.0),
        least_energy_lost=region.least["lost"][0],
        greatest_energy_lost=greatest,
        law=region.law,
        points=total,
        refused=refused,
        slip_share=region.full / region.good,
        map=points,
        checks=checks,
        advice=advice,
        numerics=Numerics("closed-form path at every point of a grid", bounds),
    )


def _delta_v_range(region: _Region, body: Solid) -> DeltaVRange | None:
    if body.mass is None:
        return None
    low, high = region.least["square"], region.greatest["square"]
    return DeltaVRange(
        least=low[0] ** 0.5 / body.mass,
        greatest=high[0] ** 0.5 / body.mass,
        least_restitution=float(region.e[low[2]]),
        least_friction=float(region.mu[low[1]]),
        greatest_restitution=float(region.e[high[2]]),
        greatest_friction=float(region.mu[high[1]]),
    )


def _spin_range(region: _Region, name: str, way: float) -> SpinRange | None:
    if name not in region.least:
        return None
    ends = sorted((way * region.least[name][0], way * region.greatest[name][0]))
    return SpinRange(ends[0], ends[1])
