"""Smallest cams for limits: extremes of closed forms."""

from dynamics_cli.accuracy.cases import Case

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row

FILES = ("cam_geometry.json", "cam_design.json")
ADDRESSES = ("base_radius", "offset", "start_radius", "roller_distance")


def certified(case: Case) -> "Callable[[], tuple[dict[str, float], float | None]]":
    """The program's own, from the line of the program to the size."""
    from dynamics_cli.cam.program.reading import Program
    from dynamics_cli.cam.sizing import records, size

    tree = case.inputs["follower"]
    follower = getattr(records, tree["record"])(**{key: float(value) for key, value in tree.items() if key != "record"})
    limits = {key: float(value) for key, value in case.inputs.items() if key.endswith(("_limit", "_radius"))}

    def answer() -> "tuple[dict[str, float], float | None]":
        sized = size.size(Program(), program=case.inputs["program"], follower=follower, **limits)  # type: ignore[arg-type]
        assert sized.numerics is not None
        sizes = {name: getattr(sized, name, None) for name in ADDRESSES}
        return {name: value for name, value in sizes.items() if value is not None}, sized.numerics.bounds[0].bound

    return answer


def compare(comparing: "Comparing") -> "list[Row]":
    """Errors in shares of the pitch curve's least radius."""

    def answer(errors: "Errors", case: Case, prepare: "Any", _: int) -> "Callable[[], Any]":
        call = prepare(case)
        sizes, bound = call()
        size = abs(float(case.results.get("start_radius", case.results["base_radius"])))
        for address, text in case.results.items():
            if address in sizes:
                stated = bound * abs(sizes[address]) / size if bound is not None and address == "base_radius" else None
                errors.note(f"{case.name}: {address}", abs(sizes[address] - float(text)) / size, stated)
        return call  # type: ignore[no-any-return]

    methods = (("extremes of interpolants (chosen)", certified),)
    return comparing.rows(methods, comparing.cases(*FILES, task="size"), answer)
