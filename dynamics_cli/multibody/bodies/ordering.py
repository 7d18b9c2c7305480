"""Bodies by name, in an order in which each stands after the one that carries it."""

from dynamics_cli.errors import UsageError
from dynamics_cli.multibody.bodies.records import GROUND

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


def ordered(names: "Sequence[str]", parents: "Sequence[str]") -> "list[int]":
    """Places of the bodies in an order in which each stands after its parent, otherwise as typed.

    Raises UsageError for two bodies of one name, an unknown parent, or bodies that carry each other in a circle.
    """
    for k, name in enumerate(names):
        if name == GROUND:
            raise UsageError("a body is called ground", code="name", hint="ground is what carries the first body")
        if name in names[:k]:
            raise UsageError(f"two bodies are called {name}", code="name", hint="give each body a name of its own")
    place = {name: k for k, name in enumerate(names)}
    for name, parent in zip(names, parents, strict=True):
        if parent != GROUND and parent not in place:
            raise UsageError(
                f"{name} is carried by {parent}, which is no body of the scene",
                code="unknown-parent",
                hint="bodies are " + ", ".join((GROUND, *(other for other in names if other != name))),
            )
    order: list[int] = []
    done = {GROUND}
    left = list(range(len(names)))
    while left:
        ready = [k for k in left if parents[k] in done]
        if not ready:
            raise UsageError(
                "bodies carry each other in a circle: " + " on ".join(_circle(names, parents, place, left[0])),
                code="circle",
                hint="let one of them be carried by ground, and close the loop by an entry of loops",
            )
        # the first of those that can stand: siblings keep the order typed, and each branch stays together
        k = ready[0]
        order.append(k)
        done.add(names[k])
        left.remove(k)
    return order


def _circle(names: "Sequence[str]", parents: "Sequence[str]", place: "dict[str, int]", start: int) -> "list[str]":
    seen = [names[start]]
    while True:
        name = parents[place[seen[-1]]]
        if name in seen:
            return [*seen[seen.index(name) :], name]
        seen.append(name)
