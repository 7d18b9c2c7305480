"""Measuring: round trips, both sides of every limit, tolerances, identification, refusals."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.measure.identify import SpanRead, identify
from dynamics_cli.gear.measure.measurement import Measurements, measure
from dynamics_cli.gear.measure.pins import standard_pins
from dynamics_cli.gear.pitch import NormalCircularPitch, NormalDiametralPitch, NormalModule, TransverseModule
from dynamics_cli.gear.single.gear import Sign

MM = 1e-3
M3 = NormalModule(3 * MM)
TEETH = st.integers(18, 250)
SHIFT = st.floats(-0.1, 0.5)
HELIX = st.sampled_from([0.0, 0.1, 0.3, 0.6, 0.9])


def all_of(answer: Measurements) -> None:
    assert answer.span is not None
    assert answer.pins is not None
    assert answer.chordal is not None


@given(TEETH, SHIFT, HELIX)
def test_every_size_gives_its_shift_back(teeth: int, x: float, beta: float) -> None:
    first = measure(teeth=teeth, pitch=M3, profile_shift=x, helix_angle=beta)
    all_of(first)
    back = measure(
        teeth=teeth,
        pitch=M3,
        profile_shift=x,
        helix_angle=beta,
        over=first.span.over,
        pin=first.pins.pin,
        measured_span=first.span.span,
        measured_pins=first.pins.size,
        measured_chord=first.chordal.thickness,
    )
    for found in (back.from_span, back.from_pins, back.from_chord):
        assert found is not None
        assert found.profile_shift == pytest.approx(x, abs=1e-12 * teeth)
        assert found.thickness_deviation == pytest.approx(0.0, abs=1e-12 * teeth * MM)
    assert all(check.passed for check in back.checks)


@given(TEETH, st.floats(-0.12e-3, -0.01e-3), HELIX)
def test_tolerances_are_the_sizes_of_the_thinner_gear(teeth: int, allowance: float, beta: float) -> None:
    """A tooth thinner by E is the tooth of a shift smaller by E/(2 m tan α); spans shrink by E cos α_n exactly."""
    whole = measure(teeth=teeth, pitch=M3, helix_angle=beta, lower_allowance=allowance)
    all_of(whole)
    x = allowance / (2 * 3 * MM * math.tan(math.radians(20)))
    thin = measure(
        teeth=teeth,
        pitch=M3,
        helix_angle=beta,
        profile_shift=x,
        over=whole.span.over,
        pin=whole.pins.pin,
        tip_diameter=2 * (teeth * 1.5 * MM / math.cos(beta) + 3 * MM),
    )
    assert whole.span.span_lower == pytest.approx(thin.span.span, rel=1e-13)
    assert whole.span.span_lower - whole.span.span == pytest.approx(allowance * math.cos(math.radians(20)), rel=1e-9)
    assert whole.pins.size_lower == pytest.approx(thin.pins.size, rel=1e-13)
    assert whole.chordal.thickness_lower == pytest.approx(thin.chordal.thickness, rel=1e-12)
    assert whole.constant_chord.thickness_lower == pytest.approx(thin.constant_chord.thickness, rel=1e-12)
    assert whole.span.span_upper is None


@given(TEETH, SHIFT)
def test_sizes_of_one_gear_in_four_pitches(teeth: int, x: float) -> None:
    wanted = measure(teeth=teeth, pitch=M3, profile_shift=x, over=None)
    for pitch in (NormalDiametralPitch(1 / (3 * MM)), NormalCircularPitch(3 * MM * math.pi), TransverseModule(3 * MM)):
        other = measure(teeth=teeth, pitch=pitch, profile_shift=x)
        assert other.span.span == pytest.approx(wanted.span.span, rel=1e-14)
        assert other.normal_thickness == pytest.approx(wanted.normal_thickness, rel=1e-14)


@given(TEETH, SHIFT, st.sampled_from([2.0, 0.5, 25.4]))
def test_sizes_scale(teeth: int, x: float, factor: float) -> None:
    one = measure(teeth=teeth, pitch=M3, profile_shift=x, pin=5.2 * MM if teeth > 24 else None)
    two = measure(teeth=teeth, pitch=NormalModule(3 * MM * factor), profile_shift=x, pin=one.pins.pin * factor)
    assert two.span.span == pytest.approx(factor * one.span.span, rel=1e-13)
    assert two.pins.size == pytest.approx(factor * one.pins.size, rel=1e-13)


@pytest.mark.parametrize("beta", [1e-3, 1e-5, 1e-8, -1e-8, -1e-3])
def test_a_spur_gear_is_met_from_both_hands_of_helix(beta: float) -> None:
    spur, helical = (measure(teeth=31, pitch=M3, helix_angle=angle, pin=5.5 * MM) for angle in (0.0, beta))
    assert helical.pins.size == pytest.approx(spur.pins.size, rel=2 * beta * beta + 1e-14)
    assert helical.span.span == pytest.approx(spur.span.span, rel=2 * beta * beta + 1e-14)
    assert helical.pins.ideal_pin == pytest.approx(spur.pins.ideal_pin, rel=20 * beta * beta + 1e-12)


def test_the_ideal_pin_touches_where_it_should() -> None:
    for teeth, x, beta in ((24, 0.4, 0.0), (31, -0.1, 0.3), (100, 0.2, 0.8)):
        ideal = measure(teeth=teeth, pitch=M3, profile_shift=x, helix_angle=beta).pins.ideal_pin
        touched = measure(teeth=teeth, pitch=M3, profile_shift=x, helix_angle=beta, pin=ideal).pins
        wanted = teeth * 3 * MM / math.cos(beta) + 2 * x * 3 * MM
        assert touched.contact_diameter == pytest.approx(wanted, rel=1e-13)


def test_odd_teeth_lose_the_cosine_of_half_a_pitch() -> None:
    odd = measure(teeth=31, pitch=M3, pin=5.5 * MM).pins
    assert odd.size - 5.5 * MM == pytest.approx(odd.centre_diameter * math.cos(math.pi / 62), rel=1e-14)
    even = measure(teeth=32, pitch=M3, pin=5.5 * MM).pins
    assert even.size - 5.5 * MM == pytest.approx(even.centre_diameter, rel=1e-14)
    inside = measure(teeth=61, pitch=M3, pin=5.0 * MM, internal=True).pins
    assert inside.size + 5.0 * MM == pytest.approx(inside.centre_diameter * math.cos(math.pi / 122), rel=1e-14)


def test_signs_of_an_internal_shift() -> None:
    """ISO's negative shift is KHK's positive one: outwards, with thinner teeth."""
    iso = measure(teeth=60, pitch=M3, internal=True, profile_shift=-0.3)
    khk = measure(teeth=60, pitch=M3, internal=True, profile_shift=0.3, shift_sign=Sign("khk"))
    assert iso.pins == khk.pins
    assert iso.normal_thickness < math.pi / 2 * 3 * MM
    assert iso.pins.size > measure(teeth=60, pitch=M3, internal=True, pin=iso.pins.pin).pins.size


def test_the_limits_of_a_span_are_the_form_circle_and_the_tips() -> None:
    """The least and greatest k that serve are those whose neighbours do not."""
    for teeth, x in ((24, 0.4), (60, 0.0), (17, 0.2)):
        serving = []
        for over in range(1, teeth):
            try:
                found = measure(teeth=teeth, pitch=M3, profile_shift=x, over=over).span
            except InadmissibleError:
                continue
            assert found.contact_diameter <= (teeth + 2 + 2 * x) * 3 * MM * (1 + 1e-15)
            serving.append(over)
        assert serving == list(range(serving[0], serving[-1] + 1))
        assert measure(teeth=teeth, pitch=M3, profile_shift=x).span.over in serving


def test_the_limits_of_a_pin() -> None:
    """Pins between the least and the greatest serve, just beyond they do not, and the refusal names the diameter."""

    def serves(pin: float) -> str:
        try:
            measure(teeth=24, pitch=M3, profile_shift=0.4, pin=pin)
        except InadmissibleError as error:
            return error.message
        return ""

    sizes = [MM * (3.0 + 0.01 * step) for step in range(0, 1500, 3)]
    words = [serves(size) for size in sizes]
    good = [index for index, text in enumerate(words) if not text]
    assert good == list(range(good[0], good[-1] + 1))
    assert "does not protrude" in words[good[0] - 1] or "below the form diameter" in words[good[0] - 1]
    assert "beyond the tip diameter" in words[good[-1] + 1]
    with pytest.raises(InadmissibleError, match="inv α_K would be -"):
        measure(teeth=24, pitch=M3, pin=2 * MM)


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"teeth": 2}, "teeth"),
        ({"teeth": 24, "over": 9}, "span-off-flank"),
        ({"teeth": 24, "over": 1}, "span-off-flank"),
        ({"teeth": 24, "over": 0}, "span-off-flank"),
        ({"teeth": 60, "internal": True, "helix_angle": 0.3, "over": 5}, "span-off-flank"),
        ({"teeth": 24, "pin": 3 * MM}, "pin-off-flank"),
        ({"teeth": 24, "pin": 12 * MM}, "pin-off-flank"),
        ({"teeth": 24, "pin": 0.0}, "pin"),
        ({"teeth": 24, "lower_allowance": 1 * MM, "upper_allowance": 0.0}, "allowances"),
        ({"teeth": 24, "measured_pins": 80 * MM}, "pin"),
        ({"teeth": 24, "measured_pins": 20 * MM, "pin": 5 * MM}, "pin-off-flank"),
        ({"teeth": 24, "measured_chord": 80 * MM}, "chord"),
        ({"teeth": 24, "profile_shift": -5.0}, "no-flank"),
        ({"teeth": 6, "profile_shift": 2.0}, "pointed"),
        ({"teeth": 24, "tip_diameter": 60 * MM}, "no-flank"),
        ({"teeth": 24, "internal": True}, "tip-inside-base"),
        ({"teeth": 24, "pressure_angle": 1.5}, "pressure-angle"),
        ({"teeth": 24, "helix_angle": 1.55}, "helix-angle"),
    ],
)
def test_what_cannot_be_measured_is_refused(arguments: dict, code: str) -> None:
    with pytest.raises(InadmissibleError) as caught:
        measure(pitch=M3, **arguments)
    assert caught.value.code == code


def test_what_was_not_asked_for_is_left_out_with_a_reason() -> None:
    answer = measure(teeth=60, pitch=M3, internal=True, helix_angle=0.3)
    assert answer.span is None
    assert [one.result for one in answer.advice if one.result] == ["span"]


def test_a_narrow_helical_gear_is_pointed_out() -> None:
    wide = measure(teeth=31, pitch=M3, helix_angle=0.5, face_width=40 * MM)
    narrow = measure(teeth=31, pitch=M3, helix_angle=0.5, face_width=wide.span.least_face_width * 0.999)
    assert "narrow-face" not in {one.code for one in wide.advice}
    assert "narrow-face" in {one.code for one in narrow.advice}


@pytest.mark.parametrize("near", [0.3, 0.77, 1.728, 1.97, 3.21, 5.18, 11.9, 17.3])
def test_standard_pins_come_nearest_first_and_are_round(near: float) -> None:
    sizes = [1e3 * size for _, size in zip(range(8), standard_pins(near * MM), strict=False)]
    away = [abs(size - near) for size in sizes]
    assert away == sorted(away)
    assert all(float(f"{size:.1f}") == pytest.approx(size, rel=1e-15) for size in sizes)


@given(
    st.sampled_from([1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0]),
    st.integers(20, 120),
    st.floats(-0.1, 0.6),
    st.sampled_from([20.0]),
)
def test_a_gear_that_was_measured_is_known_again(module: float, teeth: int, x: float, alpha: float) -> None:
    pitch = NormalModule(module * MM)
    first = measure(teeth=teeth, pitch=pitch, profile_shift=x, pressure_angle=math.radians(alpha))
    reads = []
    for over in (first.span.over - 1, first.span.over, first.span.over + 1):
        try:
            found = measure(teeth=teeth, pitch=pitch, profile_shift=x, pressure_angle=math.radians(alpha), over=over)
        except InadmissibleError:
            continue
        reads.append(SpanRead(over, round(found.span.span, 6)))
    assume(len(reads) > 1)
    best = identify(
        teeth=teeth, spans=tuple(reads), tip_diameter=(teeth + 2 + 2 * x) * module * MM, reading=5e-6
    ).candidates[0]
    assert best.size == f"module {module:g}"
    assert math.degrees(best.pressure_angle) == pytest.approx(alpha)
    assert best.profile_shift == pytest.approx(x, abs=3e-3)


@pytest.mark.parametrize(("pitch", "alpha"), [(8, 14.5), (8, 20.0), (12, 20.0), (5, 25.0), (32, 20.0)])
def test_inch_gears_are_known_by_their_diametral_pitch(pitch: int, alpha: float) -> None:
    module = 25.4 / pitch
    sizes = NormalDiametralPitch(pitch / 0.0254)
    first = measure(teeth=40, pitch=sizes, pressure_angle=math.radians(alpha))
    reads = tuple(
        SpanRead(k, measure(teeth=40, pitch=sizes, pressure_angle=math.radians(alpha), over=k).span.span)
        for k in (first.span.over, first.span.over + 1)
    )
    found = identify(teeth=40, spans=reads, tip_diameter=42 * module * MM, reading=5e-6)
    assert found.candidates[0].size == f"{pitch} DP"
    assert math.degrees(found.candidates[0].pressure_angle) == pytest.approx(alpha)
    assert all(check.passed for check in found.checks)


@pytest.mark.parametrize(
    ("teeth", "tip_diameter", "size", "fitting"),
    [
        (20, 44e-3, "module 2", 1),
        (20, 2.75 * 25.4e-3, "8 DP", 1),
        (33, 87.45e-3, "module 2.5", 1),  # turned 0.05 mm small
        (20, 45.2e-3, "module 2", 0),  # shifted by 0.3
    ],
)
def test_a_tip_diameter_alone_names_the_module(teeth: int, tip_diameter: float, size: str, fitting: int) -> None:
    found = identify(teeth=teeth, tip_diameter=tip_diameter)
    assert (found.candidates[0].size, found.fitting) == (size, fitting)
    assert found.candidates[0].pressure_angle is None
    assert found.advice[0].code == "tip-alone"


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"teeth": 20, "tip_diameter": 10.0}, "no-candidate"),
        ({"teeth": 2, "spans": (SpanRead(3, 0.02),)}, "teeth"),
        ({"teeth": 24, "spans": ()}, "spans"),
        ({"teeth": 24, "spans": (SpanRead(3, 0.02),)}, "spans"),
        ({"teeth": 24, "spans": (SpanRead(3, 0.02), SpanRead(3, 0.02))}, "spans"),
        ({"teeth": 24, "spans": (SpanRead(3, 0.03), SpanRead(4, 0.02))}, "spans"),
        ({"teeth": 24, "spans": (SpanRead(3, 0.02397), SpanRead(4, 0.03283), SpanRead(5, 0.0428))}, "spans"),
        ({"teeth": 24, "spans": (SpanRead(0, 0.02), SpanRead(4, 0.03))}, "spans"),
        ({"teeth": 24, "spans": (SpanRead(3, 0.02), SpanRead(4, 3.0))}, "no-candidate"),
        ({"teeth": 24, "spans": (SpanRead(3, 0.02), SpanRead(4, 0.03)), "reading": 0.0}, "reading"),
        ({"teeth": 24, "spans": (SpanRead(3, 0.02), SpanRead(4, 0.03)), "count": 0}, "count"),
    ],
)
def test_readings_that_identify_nothing_are_refused(arguments: dict, code: str) -> None:
    with pytest.raises(InadmissibleError) as caught:
        identify(**arguments)
    assert caught.value.code == code


@pytest.mark.parametrize("internal", [False, True])
def test_an_allowance_greater_than_the_tooth_is_refused(internal: bool) -> None:
    thickness = 0.5 * math.pi * 0.002
    kept = -0.5 * thickness
    measure(teeth=72, pitch=NormalModule(0.002), internal=internal, lower_allowance=kept)
    for upper, lower in ((-1.01 * thickness, None), (0.0, -1.01 * thickness)):
        with pytest.raises(InadmissibleError, match="removes more than"):
            measure(
                teeth=72,
                pitch=NormalModule(0.002),
                internal=internal,
                upper_allowance=upper,
                lower_allowance=lower,
            )


@pytest.mark.parametrize(
    "reading",
    [
        {"measured_span": 60e-3, "over": 3},
        {"measured_span": 1e-3, "over": 3},
        {"measured_pins": 120e-3, "pin": 5e-3},
        {"measured_chord": 9e-3},
    ],
)
def test_a_reading_that_no_gear_gives_is_refused(reading: dict) -> None:
    with pytest.raises(InadmissibleError, match="would mean a profile shift of") as refused:
        measure(teeth=24, pitch=NormalModule(3e-3), **reading)
    assert refused.value.code == "measured"


def test_a_reading_of_a_thick_tooth_is_taken_up_to_where_its_tips_are_pointed() -> None:
    """The span of a gear is read back for every shift below the pointed one, here 1.4."""
    for shift in (-0.5, 0.0, 1.0, 1.3):
        nominal = measure(teeth=24, pitch=NormalModule(3e-3), over=4).span
        size = nominal.span + 6e-3 * shift * math.sin(math.radians(20.0))
        read = measure(teeth=24, pitch=NormalModule(3e-3), over=4, measured_span=size)
        assert read.from_span.profile_shift == pytest.approx(shift, abs=1e-12)


def test_teeth_thinned_for_backlash_do_not_turn_a_metric_gear_into_an_inch_gear() -> None:
    # W₃ is 19.291 mm without backlash
    found = identify(teeth=24, spans=(SpanRead(3, 0.0192),), tip_diameter=0.065)
    assert found.candidates[0].size == "module 2.5"
    assert math.degrees(found.candidates[0].pressure_angle) == pytest.approx(20.0)
