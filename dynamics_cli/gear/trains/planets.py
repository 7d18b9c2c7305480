"""Assembly of a planetary set: possible places of the planets, and the gaps between them."""

from math import pi, sin

from dynamics_cli.errors import require, worded
from dynamics_cli.gear.trains.scene import Planetary
from dynamics_cli.numerics.exact.rational import lowest, nearest, written
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Ratio, Text
from dynamics_cli.records import Advice, record


@record
class Assembly:
    """The assembly of the planets."""

    equal_spacing: Annotated[bool, "Whether the planets can be spread evenly."]
    deciding_number: Annotated[
        Text,
        "(z_sun·z_outer + z_ring·z_inner)/(N·gcd) of the planets' teeth, exact; whole when even spacing is possible.",
    ]
    least_step: Annotated[Angle, "The smallest angle between two places that can take a planet [rad]."]
    places: Annotated[tuple[Text, ...], "The places nearest to even spacing, as exact shares of a turn."]
    largest_shift: Annotated[Angle, "How far the farthest planet is from its even place [rad]."]
    neighbour_clearance: Annotated[Ratio | None, "Gap between the tip circles of the closest neighbours, in modules."]
    neighbour_gap: Annotated[Coordinate | None, "The same as a length [m]."]
    most_planets: Annotated[int, "Maximum number of planets."]
    centre_mismatch: Annotated[
        Ratio, "Centre distance of the ring's mesh less that of the sun's, both without profile shift, in modules."
    ]


def basic_ratio(arrangement: Planetary) -> str:
    """ω_sun/ω_ring with the carrier held, exact."""
    inner, outer = arrangement.planet_teeth
    return written((-arrangement.ring * inner, arrangement.sun * outer))


def planetary_assembly(arrangement: Planetary) -> Assembly:
    """Places for the planets and the gaps between them; refuses planets that touch."""
    count, steps = arrangement.planets, arrangement.steps
    inner, outer = arrangement.planet_teeth
    require(count > 0, "a planetary set has one planet at least", code="planets")
    require(
        count <= steps,
        "{count} planets are more than the {steps} possible places",
        count=count,
        steps=steps,
        code="planets-touch",
    )
    # nearest whole number of steps to each evenly spaced place, halves downwards
    chosen = [(2 * index * steps + count - 1) // (2 * count) for index in range(count)]
    gaps = [(after - angle) % steps or steps for angle, after in zip(chosen, chosen[1:] + chosen[:1], strict=True)]
    shifts = [abs(place * count - index * steps) for index, place in enumerate(chosen)]
    narrowest = 2.0 * pi * min(gaps) / steps
    distance = 0.5 * (arrangement.sun + inner)
    tip = max(inner, outer) + 2.0 * arrangement.addendum
    most = _most(distance, tip)
    clearance = 2.0 * distance * sin(0.5 * narrowest) - tip if count > 1 else None
    require(
        clearance is None or clearance > 0.0,
        "planets touch: their tip circles overlap by {overlap:6} modules at the closest pair",
        overlap=(0.0 if clearance is None else -clearance, Ratio),
        most=most,
        inner=inner,
        sun=arrangement.sun,
        code="planets-touch",
        hint="at most {most} planets of {inner} teeth fit about a sun of {sun}",
    )
    module = arrangement.module
    return Assembly(
        equal_spacing=steps % count == 0,
        deciding_number=written((steps, count)),
        least_step=2.0 * pi / steps,
        places=tuple(written(lowest(place, steps)) for place in chosen),
        largest_shift=2.0 * pi * nearest((max(shifts), count * steps)),
        neighbour_clearance=clearance,
        neighbour_gap=None if module is None or clearance is None else clearance * module,
        most_planets=most,
        centre_mismatch=0.5 * (arrangement.ring - outer - arrangement.sun - inner),
    )


def _most(distance: float, tip: float) -> int:
    """The greatest N for which 2 a sin(π/N) exceeds the tip diameter."""
    count = 1
    while 2.0 * distance * sin(pi / (count + 1)) > tip:
        count += 1
    return count


def assembly_advice(arrangement: Planetary) -> tuple[Advice, ...]:
    """Even spacing that is not possible, and centre distances that profile shift must bring together."""
    advice = []
    steps, count = arrangement.steps, arrangement.planets
    inner, outer = arrangement.planet_teeth
    if steps % count:
        number = written((steps, count))
        most = planetary_assembly(arrangement).most_planets
        fits = ", ".join(str(n) for n in range(2, 9) if steps % n == 0 and n <= most) or "no small number of"
        simple = inner == outer
        ring = _nearest_ring(arrangement) if simple else None
        formula = "(z_sun + z_ring)/N" if simple else "(z_sun·z_outer + z_ring·z_inner)/(N·gcd)"
        message = worded(
            "{what} = {number} is not whole: {count} planets cannot be spread evenly; the places shown are the "
            "nearest possible",
            what=formula,
            number=number,
            count=count,
        )
        remedy = f"{fits} planets fit evenly" + (f"; or a ring of {ring} teeth" if ring else "")
        advice.append(Advice("uneven-planets", message, remedy=remedy))
    mismatch = arrangement.ring - outer - arrangement.sun - inner
    if mismatch and inner == outer:
        advice.append(
            Advice(
                "centre-distances-differ",
                worded(
                    "without profile shift the centre distances of sun and ring differ by {mismatch:6} modules",
                    mismatch=(0.5 * mismatch, Ratio),
                ),
                "caution" if abs(mismatch) <= 2 else "serious",
                remedy=worded(
                    "shift the profiles, or give the planet {teeth:6} teeth",
                    teeth=((arrangement.ring - arrangement.sun) / 2, Ratio),
                ),
            )
        )
    return tuple(advice)


def _nearest_ring(arrangement: Planetary) -> int | None:
    """The nearest ring that spaces the planets evenly without contact, or None within a fifth of its teeth."""
    sun, ring, count = arrangement.sun, arrangement.ring, arrangement.planets
    for step in range(1, max(ring // 5, 2 * count) + 1):
        for candidate in (ring - step, ring + step):
            if (sun + candidate) % count or (arrangement.planet is None and (candidate - sun) % 2):
                continue
            planet = (candidate - sun) // 2 if arrangement.planet is None else arrangement.planet
            gap = (sun + planet) * sin(pi / count) - planet - 2.0 * arrangement.addendum
            if candidate > planet > 0 and gap > 0.0:
                return candidate
    return None


def place_angle(place: str) -> float:
    """The angle of a place written as a share of a turn."""
    top, _, bottom = place.partition("/")
    return 2.0 * pi * int(top) / int(bottom or "1")
