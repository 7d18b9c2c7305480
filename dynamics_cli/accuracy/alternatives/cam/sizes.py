"""Smallest cams for limits: extremes of closed forms, beside the same forms over samples."""

from dynamics_cli.accuracy.cases import Case

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row

    Answer = Callable[[Case], Callable[[], tuple[dict[str, float], float | None]]]

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


def _nearest(a: float, b: float, rise: float, back: float) -> float:
    """The offset e at which max(a − e·rise, b + e·back) is nearest to the axis: where they meet, or a foot on one."""
    meeting = (a - b) / (rise + back)
    first, second = a * rise / (1.0 + rise * rise), -b * back / (1.0 + back * back)
    if first <= meeting:
        return first
    return max(second, meeting)


def sampled(case: Case) -> "Callable[[], tuple[dict[str, float], float | None]]":
    """The construction of Flocke, and R + s + s″ of a flat face, with the largest of 360 samples."""

    def answer() -> "tuple[dict[str, float], float | None]":
        import numpy as np

        from dynamics_cli.cam.program.reading import Program, motion_of

        theta = np.arange(360) * (2.0 * np.pi / 360)
        s, s1, s2 = motion_of(Program(), case.inputs["program"]).at(theta, 2)
        given, follower = case.inputs, case.inputs["follower"]
        if follower["record"] == "FlatFace":
            return {"base_radius": max(float(given["least_radius"]) - float((s + s2).min()), 0.0)}, None
        rise, back = (1.0 / np.tan(float(given[name])) for name in ("rise_limit", "return_limit"))
        a, b = float((s1 * rise - s).max()), float((-s1 * back - s).max())
        offset = float(follower["offset"]) if "offset" in follower else _nearest(a, b, rise, back)
        start = float(np.hypot(max(a - offset * rise, b + offset * back), offset))
        radius = start - float(follower["roller_radius"])
        return {"start_radius": start, "offset": offset, "base_radius": radius}, None

    return answer


METHODS: "tuple[tuple[str, Answer], ...]" = (("extremes of interpolants (chosen)", certified), ("360 samples", sampled))


def _constructed(case: Case) -> bool:
    """Whether the graphical construction answers a case: sliding followers, and no curvature but under a flat face."""
    kind = case.inputs["follower"]["record"]
    return kind == "FlatFace" or (kind in ("KnifeEdge", "Roller") and "least_radius" not in case.inputs)


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method on every size it answers; errors in shares of the pitch curve's least radius."""

    def answer(errors: "Errors", case: Case, prepare: "Any", _: int) -> "Callable[[], Any] | None":
        if prepare is not certified and not _constructed(case):
            return None
        call = prepare(case)
        sizes, bound = call()
        size = abs(float(case.results.get("start_radius", case.results["base_radius"])))
        for address, text in case.results.items():
            if address in sizes:
                stated = bound * abs(sizes[address]) / size if bound is not None and address == "base_radius" else None
                errors.note(f"{case.name}: {address}", abs(sizes[address] - float(text)) / size, stated)
        return call  # type: ignore[no-any-return]

    return comparing.rows(METHODS, comparing.cases(*FILES, task="size"), answer)
