"""Which assembly of a linkage its scene means, by `sides` and `near`; refusals with the list or the gap."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.linkages.dyads import Assembly
    from dynamics_cli.numerics.linkages.system import System
LISTED = 8


def require_driven(system: "System") -> None:
    """Refuse scenes with too few drivers for their pins."""
    missing = system.size - len(system.rows)
    require(
        missing <= 0,
        "the linkage still has {count} degrees of freedom with its drivers held: give {count} more drivers",
        count=missing,
        code="under-driven",
        hint="add [[drivers]], or links and pins that are missing",
    )


def assembled(system: "System") -> "tuple[list[Assembly], bool]":
    """All assemblies, and whether Newton's method was needed; a refusal with the gap where there is none."""
    from dynamics_cli.numerics.linkages.dyads import Assembler

    walk = Assembler(system)
    possible = walk.all()
    surplus = len(system.rows) - system.size
    gap, what = walk.gap
    require(
        bool(possible) or gap != float("inf"),
        "the linkage cannot be placed: its links depend on each other in a way that leaves no solution",
        code="no-assembly",
    )
    require(
        bool(possible),
        "the linkage cannot be closed at this position of its drivers: {what} miss by {gap}"
        + (", with {surplus} more conditions than it can keep" if surplus > 0 else ""),
        what=what,
        gap=(gap * system.scale, Size),
        surplus=surplus,
        code="cannot-be-closed",
        hint="change a length by that much there, or move the driver",
    )
    return possible, walk.newton


def chosen(system: "System", possible: "list[Assembly]", listed: bool) -> "Assembly":
    """The assembly chosen by the scene; a refusal with the list if it does not choose."""
    wanted = {side.pin: str(side.side) for side in system.scene.sides}
    decided = {pin for one in possible for pin, _ in one.words}
    for pin in wanted:
        require(
            pin in decided or pin in system.place or pin in system.shapes,
            "sides name {pin}, which the scene does not have",
            hint="pins are {known}",
            known=", ".join(system.unknown),
            pin=repr(pin),
            code="side",
        )
        require(
            pin in decided or not any(one.solution for one in possible),
            "the side of {pin} selects none of these assemblies, which Newton's method found: see --assemblies",
            pin=repr(pin),
            code="side",
            hint="select one by [[near]] with a pin and its approximate position",
        )
    fits = [one for one in possible if all(wanted.get(pin, word) == word for pin, word in one.words)]
    require(
        bool(fits),
        "no assembly has those sides; there is: {list}",
        list="; ".join(one.text for one in possible[:LISTED]),
        code="no-assembly",
    )
    near = {one.pin: complex(*one.at) / system.scale for one in system.scene.near}
    if near and len(fits) > 1:
        fits = [min(fits, key=lambda one: sum(abs(one.at[pin] - at) for pin, at in near.items() if pin in one.at))]
    named = all(one.words for one in fits) and len({one.words for one in fits}) == len(fits)
    require(
        len(fits) == 1 or listed,
        "{count} assemblies are possible and the scene does not say which: {list}",
        count=len(fits),
        list="; ".join(one.text for one in fits[:LISTED]) if named else "see --assemblies",
        code="which-assembly",
        hint="add [[sides]] with pin and side to the scene, or [[near]] with a pin and roughly where it is"
        if named
        else "add [[near]] to the scene, with a pin and roughly where it is",
    )
    return fits[0]
