"""Rows for methods that answer whole bodies: each error is a share of the number, or of the largest one of its kind.

A coordinate, a product of inertia or a difference may pass through zero; what its error costs is told by the largest
coordinate, by the moments, or by what the difference is of.
"""

from decimal import Decimal

from dynamics_cli.accuracy.measure import DIGITS, REFERENCE, Errors, results_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

UNIT_ROUNDOFF = Decimal(2.0**-53)
MOMENTS = ("moments.", "principal_moments.")
# Whose largest number an error is a share of, by the beginning of the address.
KIN: "dict[str, tuple[str, ...]]" = {
    "products": MOMENTS,
    "centroid": ("centroid",),
    "greatest_product": MOMENTS,
    "mass_difference": ("first_mass",),
    "x": ("x", "y", "gyration.polar"),
    "y": ("x", "y", "gyration.polar"),
    "centroidal.ixy": ("centroidal.",),
    "about_origin.ixy": ("about_origin.",),
}
# Numbers that are shares or angles, and differences of those: of one and more.
SHARES = ("slack", "axes_angle", "tensor_distance", "principal.angle")


class Way:
    """A method: `prepare` makes the call that answers a case by a record, or by results by address.

    `stated` gives the same results with their bounds, where these are more than the call itself gives.
    """

    def __init__(
        self, name: str, prepare: "Callable[[Case], Callable[[], Any]]", stated: "Callable[[Case], Any] | None" = None
    ) -> None:
        self.name = name
        self.prepare = prepare
        self.stated = stated


def scale(address: str, sizes: "dict[str, Decimal]") -> Decimal:
    """What the error of a result is a share of."""
    own = sizes[address]
    if address in SHARES:
        return own + 1
    for start, kin in KIN.items():
        if address.startswith(start):
            own = max(size for name, size in sizes.items() if name.startswith(kin))
    if address.startswith(("centroid[", "centroid_")):
        own = max(own, _gyration(sizes))
    if address.startswith(MOMENTS):
        # below a rounding of the largest moment there is nothing but rounding
        own = max(own, UNIT_ROUNDOFF * max(size for name, size in sizes.items() if name.startswith(MOMENTS)))
    if address.startswith("moments["):
        # a row of two bodies and their difference; products beside the moments
        row, _, which = address.partition(".")
        rows = (row,) if int(row[8:-1]) > 5 else tuple(f"moments[{k}]" for k in range(6))
        both = [max(sizes[f"{one}.{body}"] for one in rows) for body in ("first", "second")]
        own = sum(both) if which == "difference" else max(both)  # type: ignore[assignment]
    return own or Decimal(1)


def _gyration(sizes: "dict[str, Decimal]") -> Decimal:
    """The radius of gyration about the principal axis of the greatest moment; unit density where no mass is told."""
    mass = next(sizes[name] for name in ("mass", "volume", "area", "first_mass") if name in sizes)
    moment = next(sizes[name] for name in ("principal_moments.third", "moments[8].first") if name in sizes)
    return DIGITS.sqrt(DIGITS.divide(moment, mass))


def rows_of(comparing: "Comparing", cases: "Sequence[Case]", methods: "Sequence[Way]") -> "list[Row]":
    """A row for every method over the cases."""
    return comparing.rows([(way.name, way) for way in methods], cases, _answer, most=20, shared=True)


def _answer(errors: Errors, case: "Case", method: "Any", index: int) -> "Callable[[], Any]":
    way = method if isinstance(method, Way) else Way("", method)
    call = way.prepare(case)
    count(errors, case, results_of(way.stated(case) if way.stated else call()), index)
    return call


def count(errors: Errors, case: "Case", results: "dict[str, Any]", index: int) -> None:
    """Count the results of a case that a method gives, with the bounds that it states."""
    true = {name: Decimal(text) for name, text in case.results.items()}
    sizes = {name: value.copy_abs() for name, value in true.items()}
    shown = {name: results[name] for name in true if name in results}
    values = {name: Decimal(getattr(value, "value", value)) for name, value in shown.items()}
    if not values or not all(value.is_finite() for value in values.values()):
        raise ArithmeticError
    for name, value in values.items():
        error = DIGITS.subtract(value, true[name]).copy_abs()
        error = max(DIGITS.subtract(error, DIGITS.multiply(sizes[name], REFERENCE)), Decimal(0))
        whole = scale(name, sizes)
        bound = getattr(shown[name], "error", None)
        stated = None if bound is None else float(DIGITS.divide(Decimal(bound), whole))
        errors.note(f"{case.name}: {name}", float(DIGITS.divide(error, whole)), stated)
        errors.found[f"{index} {name}"] = errors.relative[-1]
