"""Forces on a cam: extremes of interpolants, beside a table of one degree, refined or not."""

from dynamics_cli.accuracy.alternatives.cam.sampling import refined, sampled
from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.measure import Errors

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.alternatives.cam.sampling import Curves, Extremes
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.forces.loads import Load

    Stated = dict[str, tuple[float, float | None]]
    Answer = Callable[[dict[str, Any]], Stated]

FILES = ("cam_forces.json", "cam_found.json")


def given(case: Case) -> "dict[str, Any]":
    """The task's arguments, as records."""
    from dynamics_cli.cam.forces import records
    from dynamics_cli.cam.geometry import followers
    from dynamics_cli.cam.program.reading import Program

    arguments: dict[str, Any] = {"scene": Program(), "rotation": followers.Rotation(case.inputs["rotation"])}
    for name, tree in case.inputs.items():
        if name == "shaft_speed":
            arguments[name] = float(tree)
        elif name == "program":
            arguments[name] = tree
        elif name == "contact":
            arguments[name] = records.Contact(width=float(tree["width"]))
        elif name in ("train", "follower"):
            values = {key: float(value) for key, value in tree.items() if key != "record"}
            arguments[name] = getattr(records if name == "train" else followers, tree["record"])(**values)
    return arguments


def certified(arguments: "dict[str, Any]") -> "Stated":
    """The program's own: every extreme with its bound."""
    from dynamics_cli.cam.forces.forces import force

    rest = dict(arguments)
    forces = force(rest.pop("scene"), count=2, **rest)
    assert forces.numerics is not None
    out: Stated = {}
    for bound in forces.numerics.bounds:
        value = getattr(forces, bound.result)
        out[bound.result] = value, bound.bound * abs(value) if bound.relative else bound.bound
    return out


def _curves(arguments: "dict[str, Any]") -> "tuple[Any, Callable[..., dict[str, Any]]]":
    """The motion, and every quantity by the textbook's formulas from lift, velocity and acceleration."""
    import numpy as np

    from dynamics_cli.cam.forces.loads import load_of
    from dynamics_cli.cam.geometry.contact import Geometry
    from dynamics_cli.cam.program.reading import motion_of

    motion = motion_of(arguments["scene"], arguments["program"])
    load_: Load = load_of(arguments["train"], motion, arguments["shaft_speed"])
    follower, contact = arguments.get("follower"), arguments.get("contact")
    geometry = None if follower is None else Geometry(follower, arguments["rotation"])
    pivot = getattr(follower, "pivot_distance", 0.0)

    def curves(s: "Any", s1: "Any", s2: "Any") -> "dict[str, Any]":
        pressing = load_.force(s, s2)
        name = "arm_torque" if load_.arm else "force"
        slowed = np.where(s2 < 0.0, -load_.inertia * s2 / (load_.rate * s + load_.steady), 0.0)
        out = {name: pressing, "torque": pressing * s1, "jump_speed": np.nan_to_num(slowed)}
        if geometry is None:
            return out
        touch = geometry.touch(s, s1, s2)
        if load_.arm:
            (x, y), (nx, ny) = touch.point, touch.normal
            normal = pressing / (y * nx - (x - pivot) * ny)
        else:
            normal = pressing / np.cos(touch.pressure_angle)
        out["contact_force"] = normal
        if contact is not None:
            bend = 1.0 / touch.radius if geometry.flat else 1.0 / (1.0 / touch.curvature - geometry.roller)
            out["stress"] = normal * (bend + (0.0 if geometry.flat else 1.0 / geometry.roller))
        return out

    return motion, curves


def _told(rows: "Extremes", arguments: "dict[str, Any]") -> "Stated":
    """Results from the least and greatest of every curve."""
    from math import inf, pi, sqrt

    out: Stated = {}
    for name, (low, high) in rows.items():
        if name == "jump_speed":
            out[name] = (1.0 / sqrt(high) if high > 0.0 else inf), None
        elif name == "stress":
            contact = arguments["contact"]
            give = 2.0 * (1.0 - contact.cam_poisson * contact.cam_poisson) / contact.cam_modulus
            out[name] = sqrt(max(high, 0.0) / (pi * contact.width * give)), None
        else:
            out[f"least_{name}"], out[f"greatest_{name}"] = (low, None), (high, None)
    return out


def by_samples(search: "Callable[[Curves, Any], Extremes]") -> "Answer":
    """The textbook's table of lift, velocity and acceleration."""

    def answer(arguments: "dict[str, Any]") -> "Stated":
        motion, curves = _curves(arguments)
        return _told(search(curves, motion), arguments)

    return answer


METHODS: "tuple[tuple[str, Answer], ...]" = (
    ("extremes of interpolants (chosen)", certified),
    ("360 samples", by_samples(sampled)),
    ("64 steps a zone and golden sections", by_samples(refined)),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method on every case; errors in shares of the larger of the two extremes."""
    import numpy as np

    def answer(errors: "Errors", case: Case, function: "Answer", _: int) -> "Callable[[], Stated]":
        arguments = given(case)
        counted(errors, case, function(arguments))
        return lambda: function(arguments)

    with np.errstate(all="ignore"):
        return comparing.rows(METHODS, comparing.cases(*FILES, task="force"), answer)


def counted(errors: Errors, case: Case, forces: "Stated") -> None:
    """Extremes in shares of the larger magnitude of the two, speeds of themselves, stresses as the radii they tell."""
    from decimal import Decimal

    for address, text in case.results.items():
        value, bound = forces[address]
        size = abs(float(text))
        for end, other in (("least_", "greatest_"), ("greatest_", "least_")):
            if address.startswith(end):
                size = max(size, abs(float(case.results[address.replace(end, other, 1)])))
        if address == "stress":
            size /= _radius_share(case, size)
        error = float(abs(Decimal(value) - Decimal(text))) / size
        errors.note(f"{case.name}: {address}", error, None if bound is None else bound / size)


def _radius_share(case: Case, stress: float) -> float:
    """Radius of contact that a stress tells, as a share of roller or base circle: next to a cusp it is left over."""
    from math import pi

    from dynamics_cli.cam.forces.records import STEEL, STEEL_RATIO

    give = 2.0 * (1.0 - STEEL_RATIO * STEEL_RATIO) / STEEL
    width, follower = float(case.inputs["contact"]["width"]), case.inputs["follower"]
    least, most = (float(case.results[f"{end}_contact_force"]) for end in ("least", "greatest"))
    # at the sharpest place a follower is pressed least; one that would leave the cam is not
    force = least if least > 0.0 else most
    radius = force / (pi * width * give * stress * stress)
    return min(1.0, radius / float(follower.get("roller_radius", follower["base_radius"])))
