"""Rise laws: peak factors, where they occur, and continuity."""

from math import inf

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.normalised import Law, law_named
from dynamics_cli.cam.laws.peaks import DERIVATIVES, continuity, extremes, peak, peak_bound
from dynamics_cli.cam.laws.rounded_points import rounding_advice
from dynamics_cli.cam.laws.selection import Condition, SplinePoint, area_checks, chosen
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Annotated,
    Fraction,
    Ratio,
    Text,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record


@record
class Peaks:
    """Peak factors of one law: factors of lift/span, lift/span² and lift/span³."""

    law: Annotated[Text, "Its name."]
    velocity: Annotated[Ratio | None, "C_v, peak velocity; absent where it is infinite."]
    velocity_at: Annotated[Ratio, "Where it first occurs, as a share of the span."]
    acceleration: Annotated[Ratio | None, "C_a, peak acceleration; absent where it is infinite."]
    acceleration_at: Annotated[Ratio, "Where first."]
    jerk: Annotated[Ratio | None, "C_j, peak jerk; absent where it is infinite."]
    jerk_at: Annotated[Ratio, "Where first."]
    jerk_inside: Annotated[Ratio, "Maximum finite jerk, apart from where the acceleration jumps."]
    continuity: Annotated[Text, "C0 to C4: the highest derivative without a jump between rest and rest."]
    jumps: Annotated[Text, "Which derivative jumps first, and where."]
    also: Annotated[Text, "Other names, including those of VDI 2143."]


@record
class LawTable:
    """Laws and their peak factors."""

    laws: Annotated[tuple[Peaks, ...], "One row for each law."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def laws(
    *,
    law: Annotated[LawName | None, "One law; all named laws if left out."] = None,
    shares: Annotated[
        tuple[Ratio, ...], "Shares b, c, d of sine, constant and cosine acceleration of scca, e.g. 0.25, 0.5, 0.25."
    ] = (),
    constant: Annotated[
        Fraction | None, "Share of the rise at constant velocity, of modified-constant-velocity or scca, e.g. 50 %."
    ] = None,
    conditions: Annotated[
        tuple[Condition, ...],
        "Conditions that a polynomial is to meet: as many values as it has coefficients, up to degree 9.",
    ] = (),
    points: Annotated[
        tuple[SplinePoint, ...], "Points a clamped cubic spline goes through between (0, 0) and (1, 1)."
    ] = (),
    start_velocity: Annotated[Ratio, "Slope of a spline at its start."] = 0.0,
    end_velocity: Annotated[Ratio, "Slope of a spline at its end."] = 0.0,
) -> LawTable:
    """Rise laws with their peak factors, where the peaks are, and how smooth the rise is between rest and rest.

    Equation
    --------
    v = C_v h/β, a = C_a h/β², j = C_j h/β³ at the peaks, for lift h over the span β.

    Returns
    -------
    LawTable
        A row for each law.

    Raises
    ------
    InadmissibleError
        When shares do not sum to 1, or conditions fix no polynomial.

    Notes
    -----
    A peak is infinite where the derivative below it jumps; half rises continue at full speed at one end, which does
    not count as a jump. Places are bisected to the last bit.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 and 16.11 to 16.14; the peak factors
    as published for the standard laws of cam design.

    Examples
    --------
    >>> row = laws(law=LawName("cycloidal")).laws[0]
    >>> round(row.velocity, 6), round(row.acceleration, 6), round(row.jerk, 6)
    (2.0, 6.283185, 39.478418)
    """
    if law is None:
        require(
            not (shares or conditions or points or constant),
            "shares, conditions and points need the law that they belong to",
            code="law",
            hint="name it: --law scca, --law polynomial, --law spline",
        )
        named = [law_named(name) for name in LawName.names if name not in ("scca", "polynomial", "spline")]
        selected = sorted(named, key=lambda entry: -continuity(entry)[0])
    else:
        selected = [chosen(law, shares, constant, conditions, points, start_velocity, end_velocity)]
    rows = tuple(_peaks(entry) for entry in selected)
    bounds = tuple(
        ErrorBound(f"laws[{i}].{name}", peak_bound(law_, order))
        for i, (row, law_) in enumerate(zip(rows, selected, strict=True))
        for order, name in enumerate(DERIVATIVES[1:4], 1)
        if getattr(row, name) is not None
    )
    checks = [check for entry in selected for check in area_checks(entry)]
    worst = max(check.value or 0.0 for check in checks)
    return LawTable(
        rows,
        checks=(Check("areas under velocity and acceleration", worst <= 1e-12, worst, 1e-12),),
        advice=(*_infinite_rows(rows), *(advice for entry in selected for advice in rounding_advice(entry))),
        numerics=Numerics("closed form; peaks bisected to the last bit", bounds),
    )


def _infinite_rows(rows: "tuple[Peaks, ...]") -> "tuple[Advice, ...]":
    """Why a peak is missing: where it is, the derivative below it jumps. Of a list of laws that is said once."""
    if len(rows) > 1:
        message = "a peak that is missing is infinite: the derivative before it jumps"
        return (Advice("infinite-peaks", message, "note", result="laws"),)
    return tuple(
        Advice(
            "infinite-" + DERIVATIVES[order],
            f"{row.law}: the {DERIVATIVES[order]} has no maximum: {row.jumps.replace(' at', ' jumps at')}",
            "note",
            result=f"laws[{i}].{DERIVATIVES[order]}",
        )
        for i, row in enumerate(rows)
        for order in (2, 3)
        if getattr(row, DERIVATIVES[order]) is None
    )


def _peaks(law: Law) -> Peaks:
    values = [peak(law, order) for order in (1, 2, 3)]
    order, where = continuity(law)
    jumps = "" if where is None else f"{DERIVATIVES[order + 1]} at {where:.6g}"
    tops = [None if top == inf else top for top, _ in values]
    return Peaks(
        law.name,
        tops[0], values[0][1],
        tops[1], values[1][1],
        tops[2], values[2][1],
        max(abs(value) for _, value in extremes(law, 3)),
        f"C{order}" if order >= 0 else "none",
        jumps,
        ", ".join(alias for alias, name in LawName.aliases.items() if name == law.name),
    )  # fmt: skip
