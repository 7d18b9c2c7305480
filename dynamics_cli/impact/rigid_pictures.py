"""Pictures of impacts of rigid bodies: the scene, velocities, Routh's impulse diagram, hodographs."""

import math

from dynamics_cli.impact.conventions import AXES, direction_of
from dynamics_cli.impact.planar.bodies import Solid, solid
from dynamics_cli.impact.planar.impact import meeting_of
from dynamics_cli.impact.planar.path import travel
from dynamics_cli.impact.scene_pictures import collision, names_of, north_of, on_page, upward, velocities
from dynamics_cli.impact.spatial.bodies import frame_about, mobility, unit
from dynamics_cli.impact.spatial.hodograph import STRIDE, series, value
from dynamics_cli.impact.spatial.hodograph import reach as reach_of
from dynamics_cli.impact.spatial.impact import approach
from dynamics_cli.impact.spatial.impact import solid as solid_in_space
from dynamics_cli.impact.spatial.straight_slip import Slip, X, Y, rates_along, settled
from dynamics_cli.impact.vehicle_outlines import LENGTH
from dynamics_cli.pictures import Arrow, Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Friction, Impulse, Length, RoadSpeed, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[float, float]

# A lighter body is drawn by its mass centre, not as a vehicle.
LIGHTEST_VEHICLE = 300.0
POINTS = 24
PLANAR = "planar impact: velocities before (dashed) and after"


def planar(
    result: "Any",
    *,
    first: "Any",
    second: "Any",
    normal: float,
    friction: float,
    contact: "Any",
    contact_point: "Pair | None" = None,
    closing_speed: "float | None" = None,
    axes: "Any" = AXES,
    gravity: float = 9.80665,
    **_: "Any",
) -> Picture:
    """The bodies and the impulse, velocities before and after on one scale, and the path of the impulse."""
    body = solid(first, contact_point, axes, gravity, "the first body")
    two = solid(second, contact_point, axes, gravity, "the second body")
    towards = direction_of(normal, axes)
    inward = -towards[0], -towards[1]
    m = meeting_of(body, two, inward, closing_speed, friction, contact.restitution, 1.0)
    at, towards, impulse = (
        on_page(vector, axes) for vector in ((0.0, 0.0) if contact_point is None else contact_point, towards,
                                             result.impulse)
    )  # fmt: skip
    names = names_of(first, second)
    body, two = (
        Solid(one.mass, one.inertia, on_page(one.lever, axes), on_page(one.velocity, axes), one.spin,
              on_page(one.nose, axes)) for one in (body, two)
    )  # fmt: skip
    before = [body.velocity, two.velocity]
    after = [on_page(one.velocity, axes) for one in (result.first, result.second)]
    contact_detail = _bodies((body, two), at, towards, impulse, names, upward(axes))
    centres = [(at[0] - vehicle.lever[0], at[1] - vehicle.lever[1]) for vehicle in (body, two)]
    heavy = [vehicle.mass is not None and vehicle.mass >= LIGHTEST_VEHICLE for vehicle in (body, two)]
    drawn = 0
    if two.mass is None and heavy[0] and math.hypot(*body.lever) <= LENGTH:
        drawn = 1
    elif all(heavy) and math.dist(*centres) <= LENGTH:
        drawn = 2
    routh = _routh(m, result, result.law)
    if not drawn:
        return Picture(
            (contact_detail, velocities(names, before, after, axes=axes, kind=RoadSpeed), routh), PLANAR, columns=2
        )
    wall = _wall(at, towards) if drawn == 1 else ()
    noses = (body.nose, two.nose)[:drawn]
    scene = collision(
        names[:drawn], noses, before[:drawn], after[:drawn], north_of(axes), centres[:drawn], (7.2, 3.9), wall
    )
    return Picture((scene, contact_detail, routh), PLANAR, columns=2, scene=True)


def _bodies(
    bodies: "tuple[Any, Any]", at: "Pair", towards: "Pair", impulse: "Pair", names: "tuple[str, str]", up: str
) -> Panel:
    """The mass centres with their levers and headings, the tangent at the contact, and the impulse on each."""
    levers = [body.lever for body in bodies if body.mass is not None]
    size = max([math.hypot(*lever) for lever in levers] or [1.0]) or 1.0
    items: list[Any] = []
    for role, (body, name) in enumerate(zip(bodies, names, strict=True)):
        if body.mass is None:
            continue
        centre = at[0] - body.lever[0], at[1] - body.lever[1]
        nose = 0.4 * size * body.nose[0], 0.4 * size * body.nose[1]
        ends = [centre[0], centre[0] + nose[0]], [centre[1], centre[1] + nose[1]]
        items.append(Curve(*ends, style="thin", role=role))
        items += [
            Curve([centre[0], at[0]], [centre[1], at[1]], style="dotted", role=role),
            Mark(*centre, name, role=role),
        ]
    tangent = -towards[1] * size, towards[0] * size
    ends = [at[0] - tangent[0], at[0] + tangent[0]], [at[1] - tangent[1], at[1] + tangent[1]]
    items.append(Curve(*ends, style="dashed", role=6))
    items.append(Mark(ends[0][1], ends[1][1], "tangent", (4.0, 0.0), dot=False))
    scale = 0.5 * size / (math.hypot(*impulse) or 1.0)
    for role, sense in ((0, -1.0), (1, 1.0)):
        dx, dy = sense * scale * impulse[0], sense * scale * impulse[1]
        items.append(Arrow(*at, dx, dy, "", role))
    return Panel(Axis("x", Length), Axis(up, Length), tuple(items), "contact: levers, tangent and impulses", equal=True)


def _wall(at: "Pair", towards: "Pair") -> "list[Curve]":
    """A barrier along the tangent at the contact, hatched on its far side."""
    along = -towards[1], towards[0]
    reach = [(-1.0 + 0.1 * nth) * LENGTH for nth in range(21)]
    items = [
        Curve(
            [at[0] + part * along[0] for part in (reach[0], reach[-1])],
            [at[1] + part * along[1] for part in (reach[0], reach[-1])],
            style="thick", role=6,
        )
    ]  # fmt: skip
    for part in reach[1:]:
        foot = at[0] + part * along[0], at[1] + part * along[1]
        ends = [0.45 * (towards[axis] - along[axis]) for axis in (0, 1)]
        items.append(Curve([foot[0], foot[0] + ends[0]], [foot[1], foot[1] + ends[1]], style="thin", role=6))
    return items


def _routh(m: "Any", result: "Any", law: str) -> Panel:
    """Impulses on the second body: path, limits of friction, lines of greatest compression and of no slip."""
    k = m.mobility
    top = 1.15 * result.normal_impulse
    limit = m.friction * top
    items: list[Any] = [
        Curve([0.0, top], [0.0, limit], "limits of friction", style="thin", role=6),
        Curve([0.0, top], [0.0, -limit], style="thin", role=6),
    ]
    wide = 1.3 * max(limit, abs(result.tangential_impulse), 0.05 * top)
    # u_n = 0 and u_t = 0 are straight lines in the plane of impulses
    for label, slope, along, shift, role in (
        ("greatest compression", k.normal, k.coupling, m.approach, 2),
        ("no slip", k.coupling, k.tangential, m.slip, 3),
    ):
        ends = _line(slope, along, shift, top, wide)
        if ends is not None:
            items.append(Curve(*ends, label, style="dashed", role=role))
    points = [(0.0, 0.0)]
    if law in ("stronge", "newton", "poisson"):
        path = travel(k, m.slip, m.approach, m.friction, m.restitution, law)
        points.append((path.first_slip, path.slopes[0] * path.first_slip))
    points.append((result.normal_impulse, result.tangential_impulse))
    items += [Curve([p for p, _ in points], [q for _, q in points], "impulse", role=0), Mark(*points[-1], "end")]
    x, y = Axis("normal impulse", Impulse), Axis("tangential impulse", Impulse)
    return Panel(x, y, tuple(items), f"impulse diagram, {law}")


def _line(a: float, b: float, c: float, top: float, wide: float) -> "tuple[list[float], list[float]] | None":
    """The part of a·p_n + b·p_t + c = 0 within 0 ≤ p_n ≤ top, |p_t| ≤ wide."""
    crossings = []
    if b != 0.0:
        crossings += [(p, -(a * p + c) / b) for p in (0.0, top)]
    if a != 0.0:
        crossings += [(-(b * q + c) / a, q) for q in (-wide, wide)]
    inside = sorted(
        {(p, q) for p, q in crossings if -1e-9 * top <= p <= top * (1.0 + 1e-9) and abs(q) <= wide * (1.0 + 1e-9)}
    )
    if len(inside) < 2:
        return None
    return [inside[0][0], inside[-1][0]], [inside[0][1], inside[-1][1]]


def spatial(
    result: "Any",
    *,
    first: "Any",
    second: "Any",
    normal: "tuple[float, float, float]",
    friction: float,
    contact_point: "Any" = None,
    gravity: float = 9.80665,
    **_: "Any",
) -> Picture:
    """Velocities seen from above, before and after, and the hodograph of the slip."""
    x, y, z = unit(normal)
    bodies = (
        solid_in_space(first, contact_point, gravity, "the first body"),
        solid_in_space(second, contact_point, gravity, "the second body"),
    )
    frame = frame_about((-x, -y, -z))
    before = approach(bodies, frame)
    k = mobility(bodies, frame)
    path, impulses = _hodograph(k, before, friction, result.slip_impulse)
    slip_axes = Axis("slip along the first tangent", Speed), Axis("slip along the second tangent", Speed)
    hodograph: list[Any] = [
        Curve([a for a, _, _ in path], [b for _, b, _ in path], "slip", role=0),
        Mark(before[0], before[1], "before"),
        Mark(0.0, 0.0, "no slip"),
    ]
    speeds = Curve(impulses, [c for _, _, c in path], "normal velocity", role=1)
    panels = (
        velocities(
            names_of(first, second),
            [body.velocity[:2] for body in bodies],
            [result.first.velocity[:2], result.second.velocity[:2]],
            "seen from above, before (dashed) and after",
        ),
        Panel(*slip_axes, tuple(hodograph), "hodograph", equal=True),
        Panel(Axis("normal impulse", Impulse), Axis("normal velocity", Speed), (speeds,), "while it slips"),
    )
    return Picture(panels, "impact in space", columns=2)


def _hodograph(
    k: "Any", before: "tuple[float, float, float]", friction: float, until: float
) -> "tuple[list[tuple[float, float, float]], list[float]]":
    """Slip and normal velocity over the normal impulse, until the first slip ends."""
    state = [*before, 0.0, 0.0, 0.0, 0.0, 0.0]
    path, impulses = [before], [0.0]
    for _ in range(200):
        if friction == 0.0 or math.hypot(state[X], state[Y]) <= 1e-9 * (abs(before[0]) + abs(before[1])):
            break
        settled_direction = settled(k, friction, Slip(state))
        if settled_direction is not None:
            _, growth, slope = rates_along(k, settled_direction, friction)
            speed = state[X] * settled_direction[0] + state[Y] * settled_direction[1]
            more = min(until - state[3], -speed / growth if growth < 0.0 else math.inf)
            speed += growth * more
            path.append((speed * settled_direction[0], speed * settled_direction[1], state[2] + slope * more))
            impulses.append(state[3] + more)
            break
        coefficients = series(k, friction, state, POINTS)
        step = reach_of(coefficients, POINTS, STRIDE)
        for part in range(1, 9):
            state = [value(one, step * part / 8.0) for one in coefficients]
            if state[3] > until:
                return path, impulses
            path.append((state[X], state[Y], state[2]))
            impulses.append(state[3])
    return path, impulses


def scene(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """Velocities of a scene seen from above, before and after."""
    after = [result.first.velocity, result.second.velocity]
    changes = [result.first.delta_v, result.second.delta_v]
    before = [
        v if c is None else tuple(a - b for a, b in zip(v, c, strict=True)) for v, c in zip(after, changes, strict=True)
    ]
    title = "seen from above, before (dashed) and after"
    panel = velocities(("first", "second"), [v[:2] for v in before], [v[:2] for v in after], title)
    return Picture((panel,), "impact")


def envelope(result: "Any", **_: "Any") -> Picture:
    """ΔV of the first body over friction, a curve for each restitution of the map."""
    columns = {name: result.map.arrays[name].tolist() for name in result.map.row.fields}
    panels = []
    for name, body in (("first_delta_v", "first"), ("second_delta_v", "second")):
        if not any(columns[name]):
            continue
        items = []
        for restitution in sorted(set(columns["restitution"])):
            points = [
                (mu, dv)
                for e, mu, dv in zip(columns["restitution"], columns["friction"], columns[name], strict=True)
                if e == restitution
            ]
            items.append(Curve([mu for mu, _ in points], [dv for _, dv in points], f"e = {restitution:.3g}"))
        panels.append(Panel(Axis("friction", Friction), Axis(f"ΔV of the {body} body", RoadSpeed), tuple(items)))
    return Picture(tuple(panels), "ΔV over a region")
