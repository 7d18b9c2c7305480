"""Approach from exit motion and from a recorded ΔV: references, exact motion reproduced, turned frames, refusals."""

import json
import math
import random
import statistics
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.conventions import Axes, ByMass
from dynamics_cli.impact.inverse.judgement import chance
from dynamics_cli.impact.inverse.records import (
    Departing,
    ExitVelocity,
    InverseResult,
    KnownContact,
    RestAfter,
    TurningAfter,
)
from dynamics_cli.impact.inverse.task import by_momentum, by_rest, by_spins, least_squares
from dynamics_cli.impact.planar.bodies import ByInertia, Lever
from dynamics_cli.impact.recorded import pulse as pulses
from dynamics_cli.impact.recorded.records import Partner, Recorder, RecordResult
from dynamics_cli.impact.recorded.task import by_headings, by_restitution, head_on
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.tracked import Tracked

REFERENCE = json.loads((Path(__file__).parent / "evidence.json").read_text(encoding="utf-8"))["cases"]
# A fit of a matrix of condition below 100 loses two digits of sixteen; a difference of speeds likewise.
CLOSE = 1e-12
# χ² of residuals of a thousandth of what they are differences of.
SMALL_DIFFERENCE = 1e-9
# Derivatives by differences of 1e-6.
FITTED = 1e-9
DEGREE = math.pi / 180.0


def value(result: Any, address: str) -> float:
    for part in address.replace("[", ".").replace("]", "").split("."):
        result = result[int(part)] if part.isdigit() else getattr(result, part)
    return float(result)


def hold(result: Any, name: str, tolerance: float = CLOSE) -> None:
    for address, text in REFERENCE[name].items():
        loose = SMALL_DIFFERENCE if address in ("chi_squared", "probability", "slip_after") else tolerance
        assert value(result, address) == pytest.approx(float(text), rel=loose, abs=1e-12), (name, address)


EXITS = {
    "agreeing": (((11.2, 0.2), -0.5), ((4.9, 9.9), -2.7)),
    "contradicting": (((9.1, 3.6), 1.3), ((6.0, 6.4), -2.4)),
}


def both(exits: str = "agreeing", spread: float = 0.0, headings: bool = True) -> dict[str, Departing]:
    vehicles = {}
    for key, mass, inertia, lever, (velocity, spin), heading, sigma in zip(
        ("first", "second"), (1500.0, 1200.0), (2500.0, 1800.0), ((1.8, -0.3), (-0.7, 0.9)), EXITS[exits],
        (0.0, 0.5 * math.pi), (0.3, 0.4), strict=True,
    ):  # fmt: skip
        vehicles[key] = Departing(
            ByMass(mass),
            ExitVelocity(velocity),
            ByInertia(inertia),
            Lever(lever),
            spin,
            heading if headings else None,
            0.0,
            velocity_sigma=0.5,
            spin_sigma=sigma,
            heading_sigma=spread * DEGREE,
        )
    return vehicles


def rests() -> dict[str, Departing]:
    vehicles = {}
    for key, mass, inertia, lever, rest, drag, heading in zip(
        ("first", "second"), (1500.0, 1200.0), (2500.0, 1800.0), ((1.8, -0.3), (-0.7, 0.9)),
        ((12.9, 0.8), (5.9, 12.1)), (0.5, 0.45), (0.0, 0.5 * math.pi), strict=True,
    ):  # fmt: skip
        vehicles[key] = Departing(
            ByMass(mass), RestAfter(rest, drag), ByInertia(inertia), Lever(lever), approach_heading=heading,
            rest_sigma=0.5,
        )  # fmt: skip
    return vehicles


class TestInverse:
    def test_momentum_alone(self) -> None:
        hold(by_momentum(**both()), "momentum")

    def test_spins_alone(self) -> None:
        result = by_spins(**both(headings=False))
        hold(result, "spins")
        assert result.first.verdict is not None
        assert result.degrees_of_freedom == 0

    @pytest.mark.parametrize("exits", ["agreeing", "contradicting"])
    @pytest.mark.parametrize(("spread", "words"), [(0.0, "headings exact"), (2.0, "headings within 2 deg")])
    def test_least_squares(self, exits: str, spread: float, words: str) -> None:
        result = least_squares(**both(exits, spread), normal=20.0 * DEGREE)
        hold(result, f"{'both' if exits == 'agreeing' else exits}, {words}")
        assert result.degrees_of_freedom == 2
        codes = {one.code for one in result.advice}
        assert ("contradiction" in codes) == (exits == "contradicting" and not spread)
        assert ("odd-restitution" in codes) == (exits == "contradicting")
        assert ("odd-friction" in codes) == (exits == "contradicting" and not spread)
        sizes = [abs(one.residual) for one in result.residuals]
        assert sizes == sorted(sizes, reverse=True)
        assert sum(size * size for size in sizes) == pytest.approx(result.chi_squared)

    def test_rest_positions(self) -> None:
        """The page's case, whose generator drives the impact forward by a linear system and differentiates it."""
        result = by_rest(**rests(), normal=20.0 * DEGREE, contact=KnownContact(0.1, -0.45))
        hold(result, "rest positions", FITTED)
        assert result.degrees_of_freedom == 2
        assert {one.code for one in result.advice} == {"turned-far"}
        assert result.least_certain == "the first faster and the second slower by 0.37 of it"

    def test_what_is_uncertain_of_contact_and_drag_is_a_measurement(self) -> None:
        vehicles = {key: Departing(**{**one.__dict__, "drag_sigma": 0.05}) for key, one in rests().items()}
        known = KnownContact(0.1, -0.45, 0.05, 0.1)
        exact = by_rest(**rests(), normal=20.0 * DEGREE, contact=KnownContact(0.1, -0.45))
        result = by_rest(**vehicles, normal=20.0 * DEGREE, contact=known)
        assert result.degrees_of_freedom == 2
        assert len(result.residuals) == 8
        for one, other in zip((result.first, result.second), (exact.first, exact.second), strict=True):
            assert one.speed_sigma > 1.3 * other.speed_sigma  # type: ignore[operator]

    def test_rest_positions_through_slides_that_turn(self) -> None:
        """Two cars driven through an impact and their slides are given back their speeds."""
        from dynamics_cli.impact.slide.records import Separation
        from dynamics_cli.impact.slide.task import slide

        wheels = {"front_axle": 1.2, "rear_axle": 1.4, "track": 1.5, "braking": 0.05, "left_front": 1.0}
        exact = by_rest(**rests(), normal=20.0 * DEGREE, contact=KnownContact(0.1, -0.45))
        vehicles = {}
        for key, given_ in rests().items():
            after = getattr(exact, key)
            gyration = (given_.turning.inertia / given_.bulk.mass) ** 0.5  # type: ignore[union-attr]
            heading = given_.approach_heading
            x, y = after.exit_velocity
            end = slide(motion=Separation(math.hypot(x, y), math.atan2(y, x), after.exit_spin), friction=0.7,
                        radius_of_gyration=gyration, nose=heading, **wheels)  # fmt: skip
            turning = TurningAfter(end.rest_position, end.rest_heading, 0.7, **wheels)
            vehicles[key] = Departing(**{**given_.__dict__, "motion": turning, "nose": heading})
        result = by_rest(**vehicles, normal=20.0 * DEGREE, contact=KnownContact(0.1, -0.45))
        assert result.degrees_of_freedom == 4
        assert result.first.approach_speed == pytest.approx(exact.first.approach_speed, 1e-4)
        assert result.second.approach_speed == pytest.approx(exact.second.approach_speed, 1e-4)
        assert result.chi_squared == pytest.approx(0.0, abs=1e-4)

    def test_rest_positions_that_no_approach_leads_to(self) -> None:
        vehicles = rests()
        away = Departing(**{**vehicles["first"].__dict__, "motion": RestAfter((4.0, 9.0), 0.5)})
        with pytest.raises(InadmissibleError, match=r"is off by \d+ standard deviations"):
            by_rest(first=away, second=vehicles["second"], normal=20.0 * DEGREE, contact=KnownContact(0.1, -0.45))
        with pytest.raises(InadmissibleError, match="restitution and ratio of impulses is not given"):
            by_rest(**vehicles, normal=20.0 * DEGREE)

    def test_the_probability_of_one_degree_of_freedom(self) -> None:
        for square, text in REFERENCE["chance"].items():
            assert chance(float(square), 1) == pytest.approx(float(text), rel=1e-13)

    @given(
        st.floats(-3.0, 3.0),
        st.floats(3.0, 40.0),
        st.floats(3.0, 40.0),
        st.floats(-8000, 8000),
        st.just(0.0) | st.floats(1e-6, 3.0),
    )
    @settings(max_examples=40, deadline=None, derandomize=True)
    def test_exact_motion_is_reproduced_in_any_frame(
        self, turn: float, one: float, two: float, across: float, spread: float
    ) -> None:
        impulse = complex(-6000.0, across)
        frame = complex(math.cos(turn), math.sin(turn))
        speeds, masses, inertias = (one, two), (1500.0, 1200.0), (2500.0, 1800.0)
        levers, headings = (complex(1.8, -0.3), complex(-0.7, 0.9)), (0.0, 1.5)
        vehicles, lost = [], 0.0
        for k, sense in enumerate((1.0, -1.0)):
            before = speeds[k] * complex(math.cos(headings[k]), math.sin(headings[k]))
            after = before + sense * impulse / masses[k]
            spin = sense * (levers[k].conjugate() * impulse).imag / inertias[k]
            lost += masses[k] * (abs(before) ** 2 - abs(after) ** 2) - inertias[k] * spin**2
            after, lever = after * frame, levers[k] * frame
            vehicles.append(
                Departing(
                    ByMass(masses[k]),
                    ExitVelocity((after.real, after.imag)),
                    ByInertia(inertias[k]),
                    Lever((lever.real, lever.imag)),
                    spin,
                    headings[k] + turn,
                    0.0,
                    0.5,
                    0.3,
                    spread * DEGREE,
                )
            )
        assume(lost > 100.0)
        result = least_squares(first=vehicles[0], second=vehicles[1])
        assert result.first.approach_speed == pytest.approx(one, rel=1e-9)
        assert result.second.approach_speed == pytest.approx(two, rel=1e-9)
        assert result.energy_lost == pytest.approx(0.5 * lost, rel=1e-8, abs=1e-6)
        assert abs(complex(*result.impulse) - impulse * frame) < 1e-6
        assert all(check.passed for check in result.checks)

    def test_one_unknown_heading_is_found(self) -> None:
        vehicles = both()
        loose = Departing(**{**vehicles["second"].__dict__, "approach_heading": None})
        result = least_squares(first=vehicles["first"], second=loose)
        assert result.degrees_of_freedom == 1
        assert result.second.approach_heading == pytest.approx(0.5 * math.pi, abs=0.05)

    def test_uncertain_headings_cost_certainty(self) -> None:
        exact, spread = least_squares(**both()), least_squares(**both(spread=2.0))
        assert spread.first.speed_sigma > exact.first.speed_sigma  # type: ignore[operator]

    def test_speeds_scatter_as_stated(self) -> None:
        chance_of = random.Random(20)
        truth = least_squares(**both(spread=2.0))
        gaps, squares = [], []
        for _ in range(400):
            vehicles = []
            for key, one in both(spread=2.0).items():
                fitted = getattr(truth, key)
                velocity = tuple(chance_of.gauss(part, 0.5) for part in fitted.exit_velocity)
                changes = {
                    "motion": ExitVelocity(velocity),  # type: ignore[arg-type]
                    "exit_spin": chance_of.gauss(fitted.exit_spin, one.spin_sigma),  # type: ignore[arg-type]
                    "approach_heading": chance_of.gauss(fitted.approach_heading, 2.0 * DEGREE),
                }
                vehicles.append(Departing(**{**one.__dict__, **changes}))
            try:
                result = least_squares(first=vehicles[0], second=vehicles[1])
            except InadmissibleError:  # one in a thousand contradicts itself
                continue
            gaps.append((result.first.approach_speed - truth.first.approach_speed) / truth.first.speed_sigma)  # type: ignore[operator]
            squares.append(result.chi_squared)
        assert len(gaps) >= 395
        # standard errors of 400: 3.5 % of a deviation, 5 % of the mean of two degrees of freedom
        assert statistics.pstdev(gaps) == pytest.approx(1.0, abs=0.1)
        assert statistics.fmean(squares) == pytest.approx(2.0, abs=0.3)

    def test_contradiction_gives_no_answer(self) -> None:
        vehicles = both()
        wrong = Departing(**{**vehicles["second"].__dict__, "exit_spin": 2.7})
        with pytest.raises(InadmissibleError, match="second exit spin is off") as caught:
            least_squares(first=vehicles["first"], second=wrong)
        assert caught.value.code == "contradiction"

    @pytest.mark.parametrize(
        ("function", "changes", "code"),
        [
            (by_momentum, {"approach_heading": 3.0}, "undetermined"),
            (by_momentum, {"approach_heading": -0.5 * math.pi}, "backwards"),
            (by_momentum, {"approach_heading": None}, "not-enough"),
            (by_spins, {"arm": Lever((-1.79, 0.3))}, "undetermined"),
            (by_spins, {"approach_spin": None}, "not-enough"),
            (least_squares, {"velocity_sigma": None}, "no-sigma"),
            (least_squares, {"velocity_sigma": 0.0}, "no-sigma"),
        ],
    )
    def test_refusals(self, function: Any, changes: dict[str, Any], code: str) -> None:
        vehicles = both()
        second = Departing(**{**vehicles["second"].__dict__, **changes})
        with pytest.raises(InadmissibleError) as caught:
            function(first=vehicles["first"], second=second)
        assert caught.value.code == code

    def test_a_normal_the_other_way_would_pull(self) -> None:
        with pytest.raises(InadmissibleError, match="pull"):
            least_squares(**both(), normal=math.pi)

    def test_the_smallest_model_answers(self) -> None:
        plain = [
            *("impact", "inverse", "--first-mass", "1500 kg", "--first-exit-velocity", "11.2, 0.2 m/s"),
            *("--second-mass", "1200 kg", "--second-exit-velocity", "4.9, 9.9 m/s"),
        ]
        headings = ["--first-approach-heading", "0 deg", "--second-approach-heading", "90 deg"]
        document = answer(*plain, *headings)
        assert document["model"]["name"].startswith("momentum alone")
        refused = run(*plain)
        assert refused.status == 3
        assert "spins decide" in refused.err

    def test_compass_headings(self) -> None:
        turned = both()
        flipped = {}
        for key, one in turned.items():
            heading = 0.5 * math.pi - one.approach_heading  # type: ignore[operator]
            flipped[key] = Departing(**{**one.__dict__, "approach_heading": heading, "heading_sigma": 2.0 * DEGREE})
        from dynamics_cli.impact.conventions import Axes

        seen = least_squares(**flipped, axes=Axes("compass"))
        same = least_squares(**both(spread=2.0))
        assert seen.first.approach_speed == pytest.approx(same.first.approach_speed, rel=1e-12)
        assert seen.second.approach_heading == pytest.approx(0.5 * math.pi - same.second.approach_heading)
        assert isinstance(seen, InverseResult)


def recorder(**more: Any) -> Recorder:
    fields = {
        "bulk": ByMass(1500.0),
        "delta_v_longitudinal": -44.6 / 3.6,
        "delta_v_lateral": 7.2 / 3.6,
        "spin_change": 1.9,
        "module": (-0.4, 0.1),
        "nose": 12.0 * DEGREE,
        "approach_speed": 13.2,
        "turning": ByInertia(2600.0),
        "arm": Lever((1.9, 0.15)),
    }
    return Recorder(**{**fields, **more})


def partner(**more: Any) -> Partner:
    fields = {
        "bulk": ByMass(1200.0),
        "approach_heading": 140.0 * DEGREE,
        "turning": ByInertia(1900.0),
        "arm": Lever((-1.8, -0.3)),
    }
    return Partner(**{**fields, **more})


def by_e(low: float, high: float, **more: Any) -> RecordResult:
    scene = {"first": recorder(), "second": partner(), "normal": 12.0 * DEGREE, **more}
    return by_restitution(least_restitution=low, greatest_restitution=high, **scene)


class TestRecord:
    @pytest.mark.parametrize("e", [0.0, 0.1, 0.2])
    def test_restitution(self, e: float) -> None:
        result = by_e(e, e)
        hold(result, f"record, e {e:g}", 1e-11)
        codes = {one.code for one in result.advice}
        assert "spin-differs" in codes
        assert ("slip-reversed" in codes) == (e == 0.2)
        assert all(check.passed for check in result.checks)

    def test_limits_are_those_of_the_record_and_of_restitution(self) -> None:
        result = by_e(0.0, 0.2, tolerance=0.0)
        assert result.second.approach_speed_low == pytest.approx(by_e(0.2, 0.2).second.approach_speed)
        assert result.second.approach_speed_high == pytest.approx(by_e(0.0, 0.0).second.approach_speed)
        wide = by_e(0.0, 0.2)
        assert wide.first.delta_v_high == pytest.approx(1.1 * wide.first.delta_v.magnitude)
        assert wide.closing_speed_high == pytest.approx(1.1 * 1.1 / 1.0 * wide.closing_speed)  # type: ignore[operator]

    def test_headings(self) -> None:
        scene = {"first": recorder(), "second": partner(exit_heading=82.0 * DEGREE)}
        result = by_headings(**scene)
        hold(result, "record, headings")
        assert result.verdict == "good"
        implied = by_headings(**scene, normal=12.0 * DEGREE)
        forward = by_e(implied.restitution, implied.restitution)  # type: ignore[arg-type]
        assert forward.second.approach_speed == pytest.approx(result.second.approach_speed, rel=1e-12)
        gap = by_headings(**scene, normal=12.0 * DEGREE, least_restitution=0.2, greatest_restitution=0.3)
        assert "restitution-differs" in {one.code for one in gap.advice}

    @pytest.mark.parametrize("e", [0.0, 0.1, 0.2])
    def test_in_line(self, e: float) -> None:
        one, two = Recorder(ByMass(1500.0), -27.0 / 3.6), Partner(ByMass(1200.0))
        result = head_on(first=one, second=two, least_restitution=e, greatest_restitution=e)
        hold(result, f"in line, e {e:g}")

    def test_in_line_with_levers(self) -> None:
        one = Recorder(
            ByMass(1500.0), -27.0 / 3.6, turning=ByInertia(1500.0 * 1.4**2), arm=Lever((2.0, 0.3)), approach_speed=14.0
        )
        two = Partner(ByMass(1200.0), turning=ByInertia(1200.0 * 1.35**2), arm=Lever((-2.0, 0.9)))
        result = head_on(first=one, second=two, least_restitution=0.1, greatest_restitution=0.1)
        hold(result, "in line, levers")
        # against the first's 14 m/s the other adds the rest of the closing speed
        assert result.second.approach_speed == pytest.approx(
            float(REFERENCE["in line, levers"]["closing_speed"]) - 14.0
        )
        assert result.second.approach_heading == pytest.approx(math.pi)

    @pytest.mark.parametrize("axes", ["mathematical", "compass", "sae", "iso"])
    def test_a_force_straight_back_has_a_heading_of_half_a_turn(self, axes: str) -> None:
        """Doubles and tracked numbers differed by the sign of a zero: −180 beside 180 degrees."""
        nose = 0.5 * math.pi if axes == "compass" else 0.0
        results = [
            head_on(
                first=Recorder(ByMass(mass), -7.5, nose=nose), second=Partner(ByMass(1200.0)),
                least_restitution=0.0, greatest_restitution=0.2, axes=Axes(axes),
            )
            for mass in (1500.0, Tracked.inputs([1500.0])[0])
        ]  # fmt: skip
        headings = [plain(result.impulse_heading) for result in results]
        assert headings[0] == headings[1] == pytest.approx(-0.5 * math.pi if axes == "compass" else math.pi)
        assert plain(results[0].first.delta_v.pdof) == plain(results[1].first.delta_v.pdof) == 0.0

    def test_struck_from_behind_the_other_drove_ahead(self) -> None:
        one, two = Recorder(ByMass(1500.0), -2.0, approach_speed=20.0), Partner(ByMass(1200.0))
        result = head_on(first=one, second=two, least_restitution=0.0, greatest_restitution=0.2)
        assert result.second.approach_heading == pytest.approx(0.0)
        assert result.second.approach_speed == pytest.approx(20.0 - result.closing_speed)  # type: ignore[operator]
        assert result.second.approach_speed_low < result.second.approach_speed  # type: ignore[operator]
        assert result.second.approach_speed < result.second.approach_speed_high  # type: ignore[operator]

    @given(st.floats(-3.0, 3.0))
    @settings(max_examples=15, deadline=None, derandomize=True)
    def test_a_turned_frame_changes_nothing(self, turn: float) -> None:
        def turned(x: float, y: float) -> Lever:
            return Lever((x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)))

        first = recorder(nose=12.0 * DEGREE + turn, arm=turned(1.9, 0.15))
        second = partner(approach_heading=140.0 * DEGREE + turn, arm=turned(-1.8, -0.3))
        result = by_e(0.1, 0.1, first=first, second=second, normal=12.0 * DEGREE + turn)
        wanted = float(REFERENCE["record, e 0.1"]["second.approach_speed"])
        assert result.second.approach_speed == pytest.approx(wanted, rel=1e-11)

    @pytest.mark.parametrize(("change", "bound"), [(0.25, False), (0.3, True)])
    def test_a_pulse_cut_short_is_a_lower_bound(self, change: float, bound: bool) -> None:
        codes = {one.code for one in by_e(0.0, 0.2, final_change=change).advice}
        assert ("lower-bound" in codes) == bound

    @pytest.mark.parametrize(
        ("changes", "code"),
        [
            ({"normal": None}, "no-normal"),
            ({"normal": 192.0 * DEGREE}, "pull"),
            ({"first": recorder(approach_speed=None)}, "not-enough"),
            ({"first": recorder(spin_change=None)}, "no-spin-change"),
            ({"first": recorder(turning=None)}, "half-turning"),
            ({"first": recorder(delta_v_longitudinal=0.0, delta_v_lateral=0.0, module=(0.0, 0.0))}, "no-impact"),
            ({"second": partner(approach_heading=100.0 * DEGREE)}, "undetermined"),
            ({"first": recorder(approach_speed=60.0)}, "backwards"),
            ({"tolerance": 1.0}, "tolerance"),
        ],
    )
    def test_refusals(self, changes: dict[str, Any], code: str) -> None:
        with pytest.raises(InadmissibleError) as caught:
            by_e(0.0, 0.2, **changes)
        assert caught.value.code == code

    def test_a_range_of_restitution_is_demanded(self) -> None:
        outcome = run("impact", "record", "--first-mass", "1500 kg", "--first-delta-v-longitudinal", "-27 km/h",
                      "--second-mass", "1200 kg")  # fmt: skip
        assert outcome.status == 3
        assert "--least-restitution 0" in outcome.err


def test_the_references_are_those_of_their_generator() -> None:
    from references import generate_impact_evidence_references as generator

    assert json.loads(generator.text())["cases"] == REFERENCE


def pulse(**given: Any) -> pulses.Pulse:
    """A pulse by its samples and the other inputs."""
    table = {name: given.pop(name) for name in ("longitudinal", "lateral", "yaw_rate", "interval") if name in given}
    return pulses.pulse(recorded=pulses.PulseTable(**table), **given)


class TestPulse:
    @staticmethod
    def haversine(count: int) -> dict[str, Any]:
        """The pulse of the reference: 0.12 s, its yaw rate rising as its integral."""
        times = [0.12 * index / count for index in range(count + 1)]
        parts = [t / 0.12 - math.sin(2.0 * math.pi * t / 0.12) / (2.0 * math.pi) for t in times]
        return {
            "longitudinal": tuple(-44.6 / 3.6 * part for part in parts),
            "lateral": tuple(7.2 / 3.6 * part for part in parts),
            "yaw_rate": tuple(1.9 * part for part in parts),
            "interval": 0.12 / count,
        }

    @pytest.mark.parametrize(("count", "close"), [(12, 2e-3), (120, 2e-5)])
    def test_the_turn_of_the_car_is_taken_out(self, count: int, close: float) -> None:
        reference = {name: float(text) for name, text in REFERENCE["pulse"].items()}
        result = pulse(**self.haversine(count))
        assert result.delta_v_longitudinal == pytest.approx(reference["along"], abs=close * 12.5)
        assert result.delta_v_lateral == pytest.approx(reference["across"], abs=close * 12.5)
        assert result.turned == pytest.approx(reference["turn"], abs=close)
        assert result.direction_shift == pytest.approx(reference["shift"], abs=close)
        assert result.delta_v == pytest.approx(math.hypot(44.6, 7.2) / 3.6)

    def test_a_pulse_that_had_not_ended(self) -> None:
        whole = (0.0, -1.0, -4.0, -8.0, -9.0, -9.0, -9.0)
        assert pulse(longitudinal=whole).final_change == 0.0
        cut = pulse(longitudinal=whole[:4])
        assert cut.final_change == 7.0
        assert cut.advice[0].code == "lower-bound"
        assert cut.greatest_acceleration == pytest.approx(400.0)
        assert pulse(longitudinal=whole).duration == pytest.approx(0.04)
        # a change of exactly the resolution is shown by the record
        assert pulse(longitudinal=(0.0, -3.0, -3.25), resolution=0.25).duration == pytest.approx(0.02)
        assert pulse(longitudinal=(0.0, -3.0, -3.25), resolution=0.26).duration == pytest.approx(0.01)

    def test_tyres_and_limits(self) -> None:
        result = pulse(longitudinal=(0.0, -5.0, -5.0), friction=0.7, interval=0.12)
        assert result.tyres == pytest.approx(0.7 * 9.80665 * 0.12)
        assert (result.delta_v_low, result.delta_v_high) == pytest.approx((4.5, 5.5))

    @pytest.mark.parametrize(
        ("tables", "words"),
        [
            ({"longitudinal": (1.0,)}, "1 samples"),
            ({"longitudinal": (0.0, 0.0)}, "stays zero"),
            ({"longitudinal": (0.0, 1.0), "yaw_rate": (0.0, 0.1, 0.2)}, "yaw rate has 3 samples"),
            ({"longitudinal": (0.0, 1.0), "interval": 0.0}, "some time apart"),
        ],
    )
    def test_refusals(self, tables: dict[str, Any], words: str) -> None:
        with pytest.raises(InadmissibleError, match=words):
            pulse(**tables)

    def test_a_file_says_what_a_list_does(self, tmp_path: Path) -> None:
        file = tmp_path / "pulse.csv"
        file.write_text("time[ms],longitudinal[mph],yaw_rate[deg/s]\n0,0,0\n10,-4,3\n20,-9,8\n30,-12,12\n40,-12,13\n")
        named = answer("impact", "pulse", "--file", str(file))["results"]
        columns = "--longitudinal", "0, -4, -9, -12, -12 mph", "--yaw-rate", "0, 3, 8, 12, 13 deg/s"
        listed = answer("impact", "pulse", *columns)["results"]
        for name in ("delta_v", "delta_v_lateral", "time", "greatest_acceleration", "direction_shift"):
            assert named[name]["value"] == pytest.approx(listed[name]["value"], rel=1e-12)


def test_a_degree_of_the_worst_heading() -> None:
    """Verdicts of each vehicle against differences of the answers themselves."""
    made = by_momentum(**both())
    for key, one in (("first", made.first), ("second", made.second)):
        assert one.worst_heading is not None
        side, _, which = one.worst_heading.partition(".")
        ends = []
        for sign in (0.5, -0.5):
            vehicles = both()
            old = vehicles[side]
            fields = dict(old.__dict__)
            if which == "approach_heading":
                fields[which] += sign * DEGREE
            else:
                turn = complex(math.cos(sign * DEGREE), math.sin(sign * DEGREE))
                velocity = complex(*old.motion.exit_velocity) * turn  # type: ignore[union-attr]
                fields["motion"] = ExitVelocity((velocity.real, velocity.imag))
            vehicles[side] = Departing(**fields)
            ends.append(getattr(by_momentum(**vehicles), key).approach_speed)
        assert one.per_degree == pytest.approx(abs(ends[0] - ends[1]), 1e-3)
        assert one.heading_tolerance == pytest.approx(0.1 * one.approach_speed / one.per_degree * DEGREE)
    record: dict[str, Any] = {
        "first": Recorder(ByMass(1500.0), -8.0, approach_speed=14.0),
        "second": Partner(ByMass(1200.0), approach_heading=2.9),
        "least_restitution": 0.0, "greatest_restitution": 0.2, "normal": 0.2,
    }  # fmt: skip
    result = by_restitution(**record)
    assert result.worst_heading == "second.approach_heading"
    speeds = [
        by_restitution(
            **{**record, "second": Partner(ByMass(1200.0), approach_heading=2.9 + sign * DEGREE)}
        ).second.approach_speed
        for sign in (0.5, -0.5)
    ]
    assert result.per_degree == pytest.approx(abs(speeds[0] - speeds[1]), 1e-3)  # type: ignore[operator]
