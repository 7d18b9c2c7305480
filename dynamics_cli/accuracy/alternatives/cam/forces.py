"""Forces on a cam: extremes."""

from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.measure import Errors

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

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


def compare(comparing: "Comparing") -> "list[Row]":
    """Errors in shares of the larger of the two extremes."""

    def answer(errors: "Errors", case: Case, function: "Answer", _: int) -> "Callable[[], Stated]":
        arguments = given(case)
        counted(errors, case, function(arguments))
        return lambda: function(arguments)

    methods = (("extremes of interpolants (chosen)", certified),)
    return comparing.rows(methods, comparing.cases(*FILES, task="force"), answer)


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
    """Radius of contact from a stress, as a share of roller or base circle: next to a cusp it is left over."""
    from math import pi

    from dynamics_cli.cam.forces.records import STEEL, STEEL_RATIO

    give = 2.0 * (1.0 - STEEL_RATIO * STEEL_RATIO) / STEEL
    width, follower = float(case.inputs["contact"]["width"]), case.inputs["follower"]
    least, most = (float(case.results[f"{end}_contact_force"]) for end in ("least", "greatest"))
    # at the sharpest place a follower is pressed least; one that would leave the cam is not
    force = least if least > 0.0 else most
    radius = force / (pi * width * give * stress * stress)
    return min(1.0, radius / float(follower.get("roller_radius", follower["base_radius"])))
