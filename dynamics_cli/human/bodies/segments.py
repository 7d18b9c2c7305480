"""The task `segments`: mass, mass centre and moments of inertia of the segments of a body."""

from dynamics_cli.errors import UsageError, require, worded
from dynamics_cli.human.bodies.person import (
    CustomSegment,
    Height,
    Lengths,
    body_mass_index,
    de_leva,
    ends_of,
    provenance,
)
from dynamics_cli.human.bodies.tables import DEMPSTER, DEMPSTER_WINTER, ZATSIORSKY, Segment, SegmentTable, Sex
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Annotated, Count, Fraction, Inertia, Length, Mass, Ratio, Text
from dynamics_cli.records import Advice, Check, record

# A table that misses the whole by more is a table with a mistake; up to here it is what a dissection lost.
SUM_TOLERANCE = 0.05
OBESE = 35.0


@record
class SegmentProperties:
    """One segment of the body."""

    name: Annotated[Text, "The segment."]
    ends: Annotated[Text | None, "Between which points its length is measured."]
    count: Annotated[Count, "How many of it a body has; the numbers are of one."]
    mass: Annotated[Mass, "Its mass [kg]."]
    share: Annotated[Fraction, "Its share of the body's mass [-]."]
    length: Annotated[Length | None, "Its length [m]."]
    centroid_share: Annotated[Fraction | None, "Its mass centre from the first end, over its length [-]."]
    centroid: Annotated[Length | None, "Its mass centre from the first end [m]."]
    front_back: Annotated[Inertia | None, "Moment of inertia about its centre and the front-back axis [kg*m^2]."]
    left_right: Annotated[Inertia | None, "Moment of inertia about its centre and the left-right axis [kg*m^2]."]
    lengthwise: Annotated[Inertia | None, "Moment of inertia about its long axis [kg*m^2]."]


@record
class Segments:
    """The segments of a body."""

    mass: Annotated[Mass, "Sum of the segments [kg]."]
    sum: Annotated[Fraction, "What the table's shares add up to, before any rescaling [-]."]
    rescaled: Annotated[Text | None, "What was rescaled, and by how much."]
    segments: Annotated[tuple[SegmentProperties, ...], "The segments."]
    table: Annotated[Text, "Where the table comes from, and whom it stands for."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def segments(
    *,
    mass: Annotated[Mass, "Mass of the body, e.g. 75 kg."],
    sex: Annotated[Sex | None, "Male or female: which part of the table."] = None,
    segment_table: Annotated[
        SegmentTable, "Table: de-leva (men and women, with moments), dempster-winter, dempster, zatsiorsky (men)."
    ] = SegmentTable("de-leva"),  # noqa: B008
    size: Annotated[Lengths | Height, "Lengths of segments, or the height."] = Lengths(),  # noqa: B008
    customs: Annotated[tuple[CustomSegment, ...] | None, "A table of your own in place of a published one."] = None,
    normalise: Annotated[bool, "Scale the masses so that they add up to the body's."] = False,
) -> Segments:
    """Masses, mass centres and moments of inertia of the segments of a human body, from a published table.

    Equation
    --------
    m_i = share_i·m, centroid at c_i·L_i from the first end, I = m_i·(r·L_i)² about the mass centre.

    Returns
    -------
    Segments
        The segments, what the table adds up to, and where it comes from.

    Raises
    ------
    InadmissibleError
        When a length is not above zero, or the shares of a table add up to less than 95 % or more than 105 %.

    Notes
    -----
    Numbers are of one segment of a pair. A length says between which points it is measured; a mass centre in percent
    means nothing without them.

    References
    ----------
    de Leva, Adjustments to Zatsiorsky-Seluyanov's segment inertia parameters, J. Biomechanics 29, 1996, table 4;
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 20.2 and 20.3.

    Examples
    --------
    >>> thigh = segments(mass=75.0, sex=Sex("male")).segments[5]
    >>> thigh.name, round(thigh.mass, 12)
    ('thigh', 10.62)
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass), code="mass")
    lengths = size.by_name
    if customs:
        rows, counts = _of_customs(customs), [custom.count for custom in customs]
    else:
        rows = _rows(segment_table, sex, lengths, mass, size)
        counts = [row.count for row in rows]
    whole = sum((count * row.share for count, row in zip(counts, rows, strict=True)), 0.0 * mass)
    require(
        (whole > 1.0 - SUM_TOLERANCE) & (whole < 1.0 + SUM_TOLERANCE),
        "the shares of the table add up to {sum:6}: a body of {mass} would have {total:6}", sum=(whole, Ratio),
        mass=(mass, Mass), total=(whole * mass, Mass), code="table-sum",
        hint="check the table: the shares of all segments, both sides counted, must add up to 1",
    )  # fmt: skip
    factor = 1.0 / whole if normalise else 1.0
    answers = tuple(
        _properties(row, count, mass, factor, lengths.get(row.name)) for row, count in zip(rows, counts, strict=True)
    )
    return Segments(
        mass=whole * factor * mass,
        sum=whole,
        rescaled=worded("all masses divided by {sum:7}", sum=(whole, Ratio)) if normalise else None,
        segments=answers,
        table="a table given with the call" if customs else provenance(segment_table, sex),
        checks=_checks(answers),
        advice=_advice(whole, mass, size, lengths, rows, normalise=normalise),
    )


def _rows(
    table: "SegmentTable", sex: "Sex | None", lengths: "dict[str, float]", mass: float,
    size: "Lengths | Height",
) -> "list[Segment]":  # fmt: skip
    if table == "de-leva":
        return de_leva(sex, lengths, ends_of(size))
    if sex == "female":
        raise UsageError(
            f"the table {table} stands for men alone", code="sex", parameter="sex",
            hint="take --segment-table de-leva, which has a part for women",
        )  # fmt: skip
    if table == "dempster-winter":
        return list(DEMPSTER_WINTER)
    if table == "dempster":
        return list(DEMPSTER)
    if not isinstance(size, Height):
        raise UsageError(
            "the regression of Zatsiorsky and Seluyanov takes the height beside the mass", code="missing",
            parameter="height", hint='give --height, e.g. --height "1.75 m"',
        )  # fmt: skip
    return [
        Segment(name, "", (constant + slope * mass + rise * (100.0 * size.height)) / mass)
        for name, constant, slope, rise in ZATSIORSKY
    ]


def _of_customs(customs: "tuple[CustomSegment, ...]") -> "list[Segment]":
    return [
        Segment(row.name, "", row.share, row.centroid, row.front_back, row.left_right, row.lengthwise)
        for row in customs
    ]


def _properties(row: Segment, count: int, mass: float, factor: float, length: "float | None") -> SegmentProperties:
    segment_mass = row.share * factor * mass

    def moment(radius: "float | None") -> "float | None":
        return None if radius is None or length is None else segment_mass * ((radius * length) * (radius * length))

    return SegmentProperties(
        name=row.name,
        ends=row.ends or None,
        count=count,
        mass=segment_mass,
        share=row.share * factor,
        length=length,
        centroid_share=row.centroid,
        centroid=None if row.centroid is None or length is None else row.centroid * length,
        front_back=moment(row.front_back),
        left_right=moment(row.left_right),
        lengthwise=moment(row.lengthwise),
    )


def _checks(answers: "tuple[SegmentProperties, ...]") -> "tuple[Check, ...]":
    """No mass below zero, and moments that a body can have: none above the sum of the other two."""
    least = min(float(plain(answer.mass)) for answer in answers)
    checks = [Check("masses above zero", least > 0.0, least)]
    for answer in answers:
        moments = answer.front_back, answer.left_right, answer.lengthwise
        known = sorted(float(plain(moment)) for moment in moments if moment is not None)
        if len(known) == 3:
            excess = known[2] - known[0] - known[1]
            checks.append(Check(f"moments of the {answer.name}", excess <= 1e-12 * known[2], excess, 0.0))
    return tuple(checks)


def _advice(
    whole: float, mass: float, size: "Lengths | Height", lengths: "dict[str, float]", rows: "list[Segment]", *,
    normalise: bool,
) -> "tuple[Advice, ...]":  # fmt: skip
    advice = []
    if abs(float(plain(whole)) - 1.0) > 1e-3 and not normalise:
        words = worded(
            "the segments add up to {sum:6} of the body's mass, {lost} from it", sum=(whole, Ratio),
            lost=(absolute(whole - 1.0) * mass, Mass),
        )  # fmt: skip
        advice.append(Advice("table-sum", words, severity="note", remedy="--normalise scales the masses to the body's"))
    if isinstance(size, Height):
        index = body_mass_index(mass, size.height)
        if float(plain(index)) > OBESE:
            words = worded("a body mass index of {index:3} kg/m² is outside the sample of the table",
                           index=(index, Ratio))  # fmt: skip
            advice.append(Advice("sample", words, remedy="measure, or take a table made for such persons"))
        if not lengths and any(row.centroid is not None for row in rows):
            advice.append(Advice(
                "lengths", "a height alone gives no lengths: mass centres stand as shares, moments are left out",
                severity="note", remedy="give lengths, or --proportion with a source of yours",
            ))  # fmt: skip
    unused = sorted(set(lengths) - {row.name for row in rows} - {"shoulder"})
    if unused:
        remedy = "--trunk-ends parts divides the trunk" if {"upper trunk", "lower trunk"} & {*unused} else ""
        message = f"not in this table: the length of {', '.join(unused)}"
        advice.append(Advice("unused", message, severity="note", remedy=remedy))
    return tuple(advice)
