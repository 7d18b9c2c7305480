"""ΔV over a region of restitution and friction: possible outcomes of an impact when neither is known well."""

from dynamics_cli.errors import (
    require,
    worded,
)
from dynamics_cli.impact.conventions import AXES, Axes, direction_of
from dynamics_cli.impact.diagnostics import require_finite
from dynamics_cli.impact.planar.bodies import RigidBody, RigidTarget, Solid, solid
from dynamics_cli.impact.planar.envelope_records import DeltaVRange, Envelope, EnvelopePoint, SpinRange
from dynamics_cli.impact.planar.impact import meeting_of
from dynamics_cli.impact.planar.laws import LAW, Law
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Count,
    Friction,
    Gravity,
    PlanarPosition,
    Ratio,
    Restitution,
    RoadSpeed,
)
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.planar.envelope_bounds import Extreme
    from dynamics_cli.impact.planar.envelope_grid import Region

    Array = NDArray[Any]

UNIT_ROUNDOFF = 2.0**-53
POINTS_MOST = 100_000_000
# Points along a side for samples of uncertain inputs.
FEWER = 128


def _require_region(
    ends: "tuple[tuple[float, float], tuple[float, float]]", points: tuple[int, int], map_points: int
) -> None:
    """Refuse an inverted region, or one with too few or too many points; restitution first, then friction."""
    require(
        all(least <= greatest for least, greatest in ends),
        "the lower ends of the region lie above its upper ends",
        code="region",
    )
    require(min(*points, map_points) >= 1, "a region has at least one point along each side", code="region")
    for (least, greatest), count, side in zip(ends, points, ("restitution", "friction"), strict=True):
        require(
            least == greatest or min(count, map_points) >= 2,
            "one point along {side} cannot cover it from {least:6} to {greatest:6}",
            side=side,
            least=(least, Ratio),
            greatest=(greatest, Ratio),
            code="region",
            hint="two points or more, also for the map, or equal ends of {side}",
        )
    count = points[0] * points[1]
    require(
        count <= POINTS_MOST, "{count:3} points are more than a hundred million", count=(count, Ratio), code="region"
    )


def envelope(
    *,
    first: Annotated[RigidBody, "The first body."],
    second: Annotated[RigidTarget, "The second body, or a fixed barrier."],
    normal: Annotated[
        Angle, "Direction of the contact normal from the first body to the second, counted like a heading [rad]."
    ],
    least_restitution: Annotated[Restitution, "Lower end of restitution [-]."] = 0.0,
    greatest_restitution: Annotated[Restitution, "Upper end of restitution [-]."] = 1.0,
    least_friction: Annotated[Friction, "Lower end of friction [-]."] = 0.0,
    greatest_friction: Annotated[Friction, "Upper end of friction [-]."] = 1.0,
    restitution_points: Annotated[Count, "Points along restitution, both ends among them."] = 1000,
    friction_points: Annotated[Count, "Points along friction, both ends among them."] = 1000,
    map_points: Annotated[Count, "Points along each side of the coarse map that is written out."] = 5,
    law: Annotated[Law, "Law that ends the impact: stronge, newton, poisson, brach or kudlich-slibar."] = LAW,
    contact_point: Annotated[
        PlanarPosition | None, "Where the bodies touch, when bodies are placed by their centres [m]."
    ] = None,
    closing_speed: Annotated[
        RoadSpeed | None,
        "Normal speed of approach at the contact, where it is known better than the velocities tell [m/s].",
    ] = None,
    axes: Annotated[Axes, "Axes of vectors, headings and spins: mathematical, compass, sae or iso."] = AXES,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> Envelope:
    """ΔV of a planar impact over a region of restitution and friction, a million points by default.

    Equation
    --------
    As `impact planar` at every point of the grid; ΔV = |p|/m.

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
    give their places, many digits their values; the bound is mostly the error of doubles at other points.

    References
    ----------
    As `impact planar`.

    Examples
    --------
    >>> from dynamics_cli.impact.planar.bodies import ByGyration, Lever
    >>> from dynamics_cli.impact.conventions import ByMass, ByVelocity, Fixed
    >>> ball = RigidBody(ByMass(1.0), ByGyration(0.5), Lever((0.0, -1.0)), ByVelocity((1.0, -2.0)))
    >>> result = envelope(first=ball, second=RigidTarget(Fixed(True)), normal=-1.5707963267948966)
    >>> round(result.first_delta_v.least, 12), result.points
    (2.0, 1000000)
    """
    import numpy as np

    from dynamics_cli.impact.planar.envelope_bounds import ExactContact
    from dynamics_cli.impact.planar.envelope_grid import Region

    require(law != "all", "an envelope is for one law", code="one-law", hint="--law stronge")
    ends = (least_restitution, greatest_restitution), (least_friction, greatest_friction)
    _require_region(ends, (restitution_points, friction_points), map_points)
    body = solid(first, contact_point, axes, gravity, "the first body")
    two = solid(second, contact_point, axes, gravity, "the second body")
    towards = direction_of(normal, axes)
    inward = -towards[0], -towards[1]
    meeting = meeting_of(body, two, inward, closing_speed, 0.0, 0.0, 1.0)
    size = max(absolute(meeting.approach), absolute(meeting.slip))
    require_finite(8.0 * size * size / meeting.mobility.normal, "the energy of the impact")
    if drawing():
        restitution_points, friction_points = min(restitution_points, FEWER), min(friction_points, FEWER)
    e = np.linspace(least_restitution, greatest_restitution, restitution_points)
    mu = np.linspace(least_friction, greatest_friction, friction_points)
    exact = ExactContact(first, second, normal, contact_point, closing_speed, axes, gravity)
    region = Region(exact, law, e, mu)
    region.scan()
    require(
        region.good > 0,
        "{law}: no point of the region has an answer",
        law=str(law),
        code="no-push",
        hint="--law stronge",
    )
    return _report(region, body, two, map_points)


def _map(region: "Region", first: Solid, second: Solid, map_points: int) -> "Columns[EnvelopePoint]":
    """The answers on a coarse grid of the region."""
    import numpy as np

    # a side of zero extent has one place on the map: more would repeat its rows
    e, mu = (np.linspace(s[0], s[-1], map_points if s[0] < s[-1] else 1) for s in (region.e, region.mu))
    pn, pt, lost = region.answer(mu[:, None], e)
    good = pn == pn
    size = np.sqrt(pn * pn + pt * pt)[good]
    grid_mu, grid_e = np.broadcast_arrays(mu[:, None], e)
    return Columns(
        EnvelopePoint,
        restitution=grid_e[good],
        friction=grid_mu[good],
        first_delta_v=size / first.mass if first.mass is not None else 0.0 * size,
        second_delta_v=size / second.mass if second.mass is not None else 0.0 * size,
        impulse_ratio=(pt / pn)[good],
        energy_lost=lost[good],
    )


def _report(region: "Region", first: Solid, second: Solid, map_points: int) -> Envelope:
    total = region.e.size * region.mu.size
    refused = total - region.good
    advice: tuple[Advice, ...] = ()
    if refused:
        text = worded(
            "{law} has no answer or gains energy at {refused} of {total} points; they are left out",
            law=str(region.law),
            refused=refused,
            total=total,
        )
        advice = (Advice("law-inadmissible", text, "caution", remedy="--law stronge has an answer everywhere"),)
    extremes = region.extremes()
    bodies = {"first": first, "second": second}
    ranges = {name: _delta_v_range(extremes["size"], body) for name, body in bodies.items()}
    spins = {name: _spin_range(extremes.get(name), sense) for name, sense in (("first", 1.0), ("second", -1.0))}
    least, greatest = extremes["lost"]
    checks: tuple[Check, ...] = ()
    if region.law == "stronge":
        scale = max(abs(greatest.value), 1e-300)
        checks = (Check("no energy is gained", least.value >= -1e-12 * scale, max(-least.value / scale, 0.0), 1e-12),)
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
        map=_map(region, first, second, map_points),
        checks=checks,
        advice=advice,
        numerics=Numerics(
            "closed-form path at every point of a grid, extremes in many digits", _bounds(extremes, bodies)
        ),
    )


def _delta_v_range(extremes: "tuple[Extreme, Extreme]", body: Solid) -> DeltaVRange | None:
    if body.mass is None:
        return None
    low, high = extremes
    return DeltaVRange(
        least=low.value / body.mass,
        greatest=high.value / body.mass,
        least_restitution=low.place[1],
        least_friction=low.place[0],
        greatest_restitution=high.place[1],
        greatest_friction=high.place[0],
    )


def _spin_range(extremes: "tuple[Extreme, Extreme] | None", way: float) -> SpinRange | None:
    if extremes is None:
        return None
    ends = sorted(way * end.value for end in extremes)
    return SpinRange(ends[0], ends[1])


def _bounds(extremes: "dict[str, tuple[Extreme, Extreme]]", bodies: dict[str, Solid]) -> tuple[ErrorBound, ...]:
    """Bounds of the extremes; ΔV is divided by the mass, which may be rounded, and rounded once more."""
    low, high = extremes["lost"]
    rows = [("least_energy_lost", low.value, low.error), ("greatest_energy_lost", high.value, high.error)]
    for name, body in bodies.items():
        if body.mass is not None:
            for end, size in zip(("least", "greatest"), extremes["size"], strict=True):
                error = size.error + 2.0 * UNIT_ROUNDOFF * size.value
                rows.append((f"{name}_delta_v.{end}", size.value, error))
        if name in extremes:
            ends = extremes[name] if name == "first" else extremes[name][::-1]
            rows += [
                (f"{name}_spin_change.{end}", extreme.value, extreme.error)
                for end, extreme in zip(("least", "greatest"), ends, strict=True)
            ]
    return tuple(
        ErrorBound(name, error / abs(value)) if value else ErrorBound(name, error, relative=False)
        for name, value, error in rows
    )
