"""Every orient task against 40-digit references: errors within stated bounds, bounds within reason, arrays alike."""

from functools import cache
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from dynamics_cli import cli
from dynamics_cli.accuracy.cases import Case, build, flat, leaves, load
from dynamics_cli.accuracy.questions import groups_of
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.numerics.tracked import Tracked

CASES = load("orient.json")
TASKS = {task.models[0].function.partition(":")[2]: task for task in cli.family("orient").tasks.values()}
GROUPS = {name: cls for task in TASKS.values() for name, cls in groups_of(task).items()}
HALF_ULP = mpf(2) ** -53
# Half last bits of what one rounding of the inputs does, which no answer exceeds (6.6 measured).
MOST = 8.0
# What a reference of 40 digits leaves open.
REFERENCE = mpf(10) ** -39
EVERY = pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.task} {case.name}")

# The answers printed with the equations, checked apart from this generator: task, case, address, value.
PRINTED = [
    ("convert", "O1 matrix", "quaternion[1]", "0.5"),
    ("convert", "O2 to xyz", "quaternion[0]", "0.87851220604992011475"),
    ("convert", "O2 to xyz", "quaternion[3]", "0.29688290455629101404"),
    ("convert", "O4 near a half turn", "quaternion[1]", "0.33333333333333333"),
    ("convert", "O12 constant rate", "quaternion[0]", "0.29555112749297824749"),
    ("convert", "O12 constant rate", "quaternion[3]", "-0.76596558013579285383"),
    ("rates", "O5", "angular_velocity[2]", "-0.00260604299770061991323"),
    ("rates", "O5", "angular_acceleration[0]", "0.6890908234585853864202"),
    ("rates", "O5", "body_angular_velocity[1]", "0.09280661126829023805009"),
    ("rates", "O5", "body_angular_acceleration[2]", "-0.06653731667116275690272"),
    ("rates", "O6", "angular_speed", "52.734166686418730106"),
    ("rates", "O6", "angular_acceleration_size", "63.392739261104915428"),
    ("rolling", "O7 cone on a plane", "first.angular_velocity[0]", "-5.4949548389092445575"),
    ("rolling", "O7 cone on a plane", "first.angular_acceleration[1]", "-10.989909677818489115"),
    ("disk", "O8", "centre_velocity[2]", "0.14"),
    ("disk", "O8", "centre_acceleration[0]", "0.15373066958946423164"),
    ("disk", "O8", "centre_acceleration[1]", "1.322125"),
    ("disk", "O8", "centre_acceleration[2]", "-2.4919825191808590201"),
    ("disk", "O8", "contact_acceleration[2]", "2.7279800219209817373"),
    ("bearing", "O9", "rolling_radius", "0.035294167535348353368"),
    ("screw", "O10", "travel", "0.34681136857570673926"),
    ("screw", "O10", "point[2]", "-0.021341657289318394022"),
    ("joint", "O13", "ratio", "0.96578519864473661860"),
]
IN_DEGREES = [
    ("convert", "O2 to xyz", "rotation_angle", "57.073181492604892299"),
    ("convert", "O2 to xyz", "euler_angles[2]", "35.169129767203256294"),
    ("convert", "O2 to zxz", "euler_angles[0]", "-172.17599258890334928"),
    ("convert", "O11 matrix of four decimals", "euler_angles[1]", "19.998857299098652738"),
    ("convert", "O2 to xyz", "euler_angles[0]", "-43.690498071688037594"),
    ("convert", "O2 to xyz", "euler_angles[1]", "-5.4221321701251992953"),
    ("convert", "O2 to zxz", "euler_angles[1]", "43.958207002617775463"),
    ("convert", "O2 to zxz", "euler_angles[2]", "-150.47984836514501256"),
    ("convert", "O11 matrix of four decimals", "euler_angles[0]", "29.999089178209670648"),
    ("convert", "O11 matrix of four decimals", "euler_angles[2]", "10.000527629214851867"),
    ("screw", "O10", "rotation_angle", "111.89111756587103461"),
    ("joint", "O13", "output_angle", "53.994785181213467961"),
]


def call(case: Case, numbers: Any) -> Any:
    return TASKS[case.task].models[0].call()(**build(case.inputs, iter(numbers), GROUPS))


@cache
def measured(case: Case) -> list[tuple[str, Any, Any, Any]]:
    """Address, true error, stated bound, and what one rounding of the inputs does, of every result."""
    mp.dps = 60
    numbers = list(leaves(case.inputs))
    answer = call(case, Tracked.inputs(numbers))
    tighten(answer, numbers, lambda others: call(case, others))
    tracked, plain = flat(answer), flat(call(case, numbers))
    found = []
    for address, text in case.results.items():
        own = tracked[address]
        own = own if isinstance(own, Tracked) else Tracked(own, 0.0, (0.0,) * len(numbers))
        assert own.value == plain[address], address
        reference = mpf(text)
        error = max(abs(mpf(own.value) - reference) - REFERENCE * abs(reference), mpf(0))
        reach = sum(abs(slope * number) for slope, number in zip(own.slopes, numbers, strict=True) if number)
        found.append((address, error, mpf(own.error), max(abs(reference), mpf(reach)) if reference else mpf(0)))
    return found


@EVERY
def test_every_bound_holds_and_is_tight(case: Case) -> None:
    for address, error, bound, reach in measured(case):
        assert error <= bound, (address, float(error), float(bound))
        assert bound <= 100 * max(error, HALF_ULP * reach, mpf(1e-14)), (address, float(error), float(bound))


@EVERY
def test_errors_are_those_of_rounded_inputs(case: Case) -> None:
    # what vanishes is measured by the largest beside it
    size = max(reach for _, _, _, reach in measured(case))
    for address, error, _, reach in measured(case):
        assert error <= MOST * HALF_ULP * (reach or size), (address, float(error))


def deep(answer: Any) -> dict[str, Any]:
    """Every number of an answer, those of matrices too."""
    found: dict[str, Any] = {}
    for name, value in flat(answer).items():
        found |= {f"{name}[{k}]": x for k, x in enumerate(value)} if isinstance(value, tuple) else {name: value}
    return found


@EVERY
def test_arrays_give_the_bits_of_scalars(case: Case) -> None:
    numbers = list(leaves(case.inputs))
    scales = (1.0, 1.0 + 2e-4, 1.0 - 3e-5)
    together = deep(call(case, [np.array([number * scale for scale in scales]) for number in numbers]))
    for row, scale in enumerate(scales):
        single = deep(call(case, [number * scale for number in numbers]))
        for address, value in together.items():
            assert np.broadcast_to(value, (3,))[row] == single[address], address


def value_of(task: str, name: str, address: str) -> Any:
    [case] = [case for case in CASES if (case.task, case.name) == (task, name)]
    return mpf(case.results[address])


@pytest.mark.parametrize(("task", "name", "address", "printed"), [*PRINTED, *IN_DEGREES])
def test_the_references_are_the_printed_values(task: str, name: str, address: str, printed: str) -> None:
    """To 1e-13: those were printed for exact inputs, degrees and decimals, and ours are for their doubles."""
    mp.dps = 40
    value = value_of(task, name, address)
    value = mp.degrees(value) if (task, name, address, printed) in IN_DEGREES else value
    assert abs(value - mpf(printed)) <= mpf(10) ** -13 * max(1, abs(value))
