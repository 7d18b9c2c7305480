"""Shapes, assemblies, tensors: the program's functions with their bounds, and parts summed as textbooks do."""

from functools import cache
from math import inf

from dynamics_cli.accuracy.alternatives.inertia.mesh import named
from dynamics_cli.accuracy.alternatives.inertia.table import Way, rows_of
from dynamics_cli.accuracy.cases import build, flat, leaves

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

    import numpy as np

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    Array = np.ndarray[Any, np.dtype[Any]]

FILE = "inertia_bodies.json"


@cache
def _groups() -> "dict[str, type]":
    from dynamics_cli.accuracy.catalogue import groups

    return groups("inertia")


def arguments(case: "Case", numbers: "Iterable[Any] | None" = None) -> "dict[str, Any]":
    """What a case gives to its task, with other numbers in place of its floats."""
    return build(case.inputs, iter(leaves(case.inputs) if numbers is None else numbers), _groups())  # type: ignore[no-any-return]


def bounded(case: "Case", function: "Callable[..., Any]") -> "Any":
    """The answer with the rounding bounds that a command states."""
    from dynamics_cli.core.answering.tightening import tighten
    from dynamics_cli.numerics.tracked import Tracked

    def call(numbers: "Iterable[Any]") -> "Any":
        return function(**arguments(case, numbers))

    doubles = list(leaves(case.inputs))
    answer = call(Tracked.inputs(doubles))
    tighten(answer, doubles, call)
    return answer


def own(name: str, function: "Callable[..., Any]", stated: "Callable[[Case], Any] | None" = None) -> Way:
    """The program's own function of a case's inputs."""

    def prepare(case: "Case") -> "Callable[[], Any]":
        given = arguments(case)
        return lambda: function(**given)

    return Way(f"{name} (chosen)", prepare, stated or (lambda case: bounded(case, function)))


def shape(*, shape: "Any", amount: "Any") -> "Any":
    """One shape."""
    from dynamics_cli.inertia.shapes.task import shape as one

    return one(shape, amount=amount)


def body(*, scene: "Any") -> "Any":
    """An assembly."""
    from dynamics_cli.inertia.assembly.assembly import body as one

    return one(scene)


def both(*, scene: "Any") -> "Any":
    """Two assemblies compared."""
    from dynamics_cli.inertia.assembly.compare import compare as one

    return one(scene)


def both_stated(case: "Case") -> "dict[str, Any]":
    """Two assemblies compared, with the bound of the angle between their axes, which carries none itself."""
    from dynamics_cli.numerics.tracked import Tracked

    answer = bounded(case, both)
    results = flat(answer)
    bounds = {bound.result: bound.bound for bound in answer.numerics.bounds}
    return results | {
        name: Tracked(results[name], bounds.get(name, inf), ()) for name in ("axes_angle",) if name in results
    }


def tensor(**given: "Any") -> "Any":
    """A given tensor."""
    from dynamics_cli.inertia.tensors.tensor import tensor as one

    return one(**given)


def groups(case: "Any") -> "dict[str, Any]":
    """What a case gives, or what has been made of it already."""
    return {"scene": case.scene} if hasattr(case, "scene") else arguments(case)


def placed(case: "Any") -> "list[tuple[float, Array, Array]]":
    """Mass, mass centre and tensor about it of every part, in the axes of the assembly."""
    import numpy as np

    from dynamics_cli.inertia.assembly.parts import Walk
    from dynamics_cli.numerics.orientation.rotations import IDENTITY

    walk = Walk()
    walk.into(groups(case)["scene"].parts, "", (0.0, 0.0, 0.0), IDENTITY, 1.0)
    found = []
    for leaf in walk.leaves:
        turn, second = np.array(leaf.rotation), np.array(leaf.lump.second)
        inner = np.trace(second) * np.eye(3) - second
        centre = np.array(leaf.origin) + turn @ np.array(leaf.lump.centroid)
        found.append((leaf.sign * leaf.lump.mass, centre, leaf.sign * (turn @ inner @ turn.T)))
    return found


def transport(mass: float, d: "Array") -> "Array":
    """What the parallel axis theorem adds: m (d²·1 − d dᵀ)."""
    import numpy as np

    return mass * (d @ d * np.eye(3) - np.outer(d, d))  # type: ignore[no-any-return]


def _middle(parts: "list[tuple[float, Array, Array]]") -> "tuple[float, Array]":
    """Mass and mass centre."""
    import numpy as np

    mass = sum(part[0] for part in parts)
    return mass, np.sum([m * c for m, c, _ in parts], axis=0) / mass


def from_origin(case: "Any") -> "Callable[[], dict[str, Any]]":
    """The textbook: tensors summed about the origin, I = I₀ − m (c²·1 − c cᵀ) at the end, LAPACK."""
    import numpy as np

    def answer() -> "dict[str, Any]":
        parts = placed(case)
        mass, centre = _middle(parts)
        whole = np.sum([inner + transport(m, c) for m, c, inner in parts], axis=0) - transport(mass, centre)
        return {"mass": mass} | _results(centre, whole, np.linalg.eigvalsh(whole))

    return answer


def from_centre(case: "Any") -> "Callable[[], dict[str, Any]]":
    """The mass centre first, each tensor moved to it, LAPACK."""
    import numpy as np

    def answer() -> "dict[str, Any]":
        parts = placed(case)
        mass, centre = _middle(parts)
        whole = np.sum([inner + transport(m, c - centre) for m, c, inner in parts], axis=0)
        return {"mass": mass} | _results(centre, whole, np.linalg.eigvalsh(whole))

    return answer


def _results(centre: "Array", whole: "Array", moments: "Array") -> "dict[str, Any]":
    results = named(0.0, centre.tolist(), whole.tolist(), moments.tolist(), shell=False)
    return {name: value for name, value in results.items() if name != "volume"}


ASSEMBLY = (
    own("second moments from a part on, again in the principal axes, Jacobi", body),
    Way("tensors about the mass centre, LAPACK", from_centre),
    Way("tensors about the origin, parallel axes at the end, LAPACK", from_origin),
)


def compare_assemblies(comparing: "Comparing") -> "list[Row]":
    """Assemblies of parts and holes."""
    return rows_of(comparing, comparing.cases(FILE, task="body"), ASSEMBLY)
