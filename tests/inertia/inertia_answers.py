"""What the program answers to the reference cases of bodies, bare and with its bounds."""

from collections.abc import Callable, Iterable
from math import inf
from typing import Any

from dynamics_cli.accuracy.cases import Case, build, flat, leaves
from dynamics_cli.accuracy.catalogue import groups
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.inertia.assembly import assembly, compare
from dynamics_cli.inertia.shapes.task import shape as of_shape
from dynamics_cli.inertia.tensors.tensor import tensor as of_tensor
from dynamics_cli.inertia.tensors.torque import torque
from dynamics_cli.numerics.tracked import Tracked


def arguments(case: Case, numbers: Iterable[Any] | None = None) -> dict[str, Any]:
    """What a case gives to its task, with other numbers in place of its floats."""
    return build(case.inputs, iter(leaves(case.inputs) if numbers is None else numbers), groups("inertia"))


def bounded(case: Case, function: Callable[..., Any]) -> Any:
    """The answer with the rounding bounds that a command states."""

    def call(numbers: Iterable[Any]) -> Any:
        return function(**arguments(case, numbers))

    doubles = list(leaves(case.inputs))
    answer = call(Tracked.inputs(doubles))
    tighten(answer, doubles, call)
    return answer


def shape(*, shape: Any, amount: Any) -> Any:
    return of_shape(shape, amount=amount)


def body(*, scene: Any) -> Any:
    return assembly.body(scene)


def both(*, scene: Any) -> Any:
    return compare.compare(scene)


def tensor(**given: Any) -> Any:
    return of_tensor(**given)


FUNCTIONS: dict[str, Callable[..., Any]] = {
    "shape": shape, "body": body, "compare": both, "tensor": tensor, "torque": torque,
}  # fmt: skip


def both_stated(case: Case) -> dict[str, Any]:
    """Two assemblies compared, with the bound of the angle between their axes, which carries none itself."""
    answer = bounded(case, both)
    results = flat(answer)
    bounds = {bound.result: bound.bound for bound in answer.numerics.bounds}
    return results | {
        name: Tracked(results[name], bounds.get(name, inf), ()) for name in ("axes_angle",) if name in results
    }
