"""Rise laws by themselves: peak factors, where they occur, and continuity."""

from math import inf

from dynamics_cli.cam.choosing import Condition, SplinePoint, area_checks, chosen
from dynamics_cli.cam.laws import Law, LawName, law_named
from dynamics_cli.cam.peaks import DERIVATIVES, continuity, extremes, peak, peak_bound
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Fraction,
    Ratio,
    Text,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record


@record
class Peaks:
    """Peak factors of one law: what lift/span, lift/span² and lift/span³ are multiplied by.

    Parameters
    ----------
    law : Text
        Its name.
    velocity : Ratio
        C_v, greatest velocity; none where it is infinite.
    velocity_at : Ratio
        Where first, as a share of the span.
    acceleration : Ratio
        C_a, greatest acceleration; none where it is infinite.
    acceleration_at : Ratio
        Where first.
    jerk : Ratio
        C_j, greatest jerk; none where it is infinite.
    jerk_at : Ratio
        Where first.
    jerk_inside : Ratio
        Greatest finite jerk, apart from where the acceleration jumps.
    continuity : Text
        C0 to C4: the highest derivative without a jump between rest and rest.
    jumps : Text
        Which derivative jumps first, and where.
    also : Text
        Other names, those of VDI 2143 among them.
    """

    law: Text
    velocity: Ratio | None
    velocity_at: Ratio
    acceleration: Ratio | None
    acceleration_at: Ratio
    jerk: Ratio | None
    jerk_at: Ratio
    jerk_inside: Ratio
    continuity: Text
    jumps: Text
    also: Text


@record
class LawTable:
    """Laws and their peak factors.

    Parameters
    ----------
    laws : tuple of Peaks
        One row for each law.
    """

    laws: tuple[Peaks, ...]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def laws(
    *,
    law: LawName | None = None,
    shares: tuple[Ratio, ...] = (),
    constant: Fraction | None = None,
    conditions: tuple[Condition, ...] = (),
    points: tuple[SplinePoint, ...] = (),
    start_velocity: Ratio = 0.0,
    end_velocity: Ratio = 0.0,
) -> LawTable:
    """Rise laws with their peak factors, where the peaks are, and how smooth the rise is between rest and rest.

    Equation
    --------
    v = C_v h/β, a = C_a h/β², j = C_j h/β³ at the peaks, for lift h over the span β.

    Parameters
    ----------
    law : LawName
        One law; all named laws when not given.
    shares : tuple of Ratio
        Shares b, c, d of sine, constant and cosine acceleration of scca.
    constant : Fraction
        Share of the rise at constant velocity, of modified-constant-velocity or scca.
    conditions : tuple of Condition
        What a polynomial is to meet; as many values as it has coefficients, to degree 9.
    points : tuple of SplinePoint
        Points a clamped cubic spline goes through between (0, 0) and (1, 1).
    start_velocity : Ratio
        Slope of a spline at its start.
    end_velocity : Ratio
        Slope of a spline at its end.

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
    A peak is infinite where the derivative below it jumps; half rises go on at full speed at one end, which counts as
    no jump there. Places are bisected to the last bit.

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
            "shares, conditions and points belong to one law",
            code="law",
            hint="name it: --law scca, --law polynomial, --law spline",
        )
        named = [law_named(name) for name in LawName.names if name not in ("scca", "polynomial", "spline")]
        found = sorted(named, key=lambda one: -continuity(one)[0])
    else:
        found = [chosen(law, shares, constant, conditions, points, start_velocity, end_velocity)]
    rows = tuple(_peaks(one) for one in found)
    bounds = tuple(
        ErrorBound(f"laws[{i}].{name}", peak_bound(law_, order))
        for i, (row, law_) in enumerate(zip(rows, found, strict=True))
        for order, name in enumerate(DERIVATIVES[1:4], 1)
        if getattr(row, name) is not None
    )
    checks = [check for one in found for check in area_checks(one)]
    worst = max(check.value or 0.0 for check in checks)
    return LawTable(
        rows,
        checks=(Check("areas under velocity and acceleration", worst <= 1e-12, worst, 1e-12),),
        advice=_infinite_rows(rows),
        numerics=Numerics("closed form; peaks bisected to the last bit", bounds),
    )


def _infinite_rows(rows: "tuple[Peaks, ...]") -> "tuple[Advice, ...]":
    """Why a peak is missing: where it is, the derivative below it jumps."""
    return tuple(
        Advice(
            "infinite-" + DERIVATIVES[order],
            f"{row.law}: the {DERIVATIVES[order]} has no greatest value: {row.jumps.replace(' at', ' jumps at')}",
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
