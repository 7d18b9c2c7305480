"""The second pass in many digits gives the reference's own digits of every shipped body: no constant is rounded."""

from decimal import Decimal, localcontext

import pytest
from inertia_answers import FUNCTIONS, arguments

from dynamics_cli.accuracy.cases import flat, leaves, load
from dynamics_cli.inertia.assembly.assembly import Assembly, body
from dynamics_cli.inertia.assembly.parts import Part
from dynamics_cli.inertia.bodies.amount import OfMass
from dynamics_cli.inertia.bodies.principal import principal, principal_of_many_digits
from dynamics_cli.inertia.bodies.properties import Axes
from dynamics_cli.inertia.shapes.unit import PI
from dynamics_cli.numerics import arcs
from dynamics_cli.numerics.eigen3.jacobi_digits import eigen_of_many_digits
from dynamics_cli.numerics.exact.constants import Constant
from dynamics_cli.numerics.exact.many_digits import CONTEXT, ManyDigits, run

CASES = load("inertia_bodies.json")


def many(*values: float) -> list[ManyDigits]:
    return ManyDigits.inputs(values)


@pytest.mark.parametrize("task", FUNCTIONS)
def test_every_result_is_the_reference_to_its_digits(task: str) -> None:
    """References have 40 digits and are of another method; what is small beside the rest has fewer of its own."""
    count = 0
    for case in (case for case in CASES if case.task == task):
        numbers = ManyDigits.inputs(leaves(case.inputs))
        given = arguments(case, numbers)
        found = flat(run(lambda given=given: FUNCTIONS[task](**given)))
        with localcontext(CONTEXT):
            largest = max(abs(Decimal(text)) for text in case.results.values())
            for name, text in case.results.items():
                own, true = found[name], Decimal(text)
                exact = own.exact if isinstance(own, ManyDigits) else Decimal(own)
                assert isinstance(own, ManyDigits) or exact == true, (case.name, name)
                room = max(Decimal("1e-36") * abs(true), Decimal("1e-37") * largest)
                assert abs(exact - true) <= room, (case.name, name)
                count += 1
    assert count > 25


def test_constants_keep_their_digits_beside_many_and_are_doubles_beside_doubles() -> None:
    assert PI * 2.0 == 2.0 * PI == 6.283185307179586
    assert float(Constant("0.2")) == 0.2
    (two,) = many(2.0)
    with localcontext(CONTEXT):
        assert str((0.5 * PI * two).exact).startswith("3.14159265358979323846264338327950288419716939937510")
        assert str((PI * PI * two).exact).startswith("19.73920880217871723766898199975230227")
        assert (Constant("0.2") * two).exact == Decimal("0.4")
        assert abs(PI.beside(two).exact * 2 - (PI * two).exact) < Decimal("1e-57")
    assert type(PI.beside(1.0)) is float


@pytest.mark.parametrize("x", [1e-12, 0.9e-3, 1.1e-3, 1.4, 1.6, 3.0])
def test_arcs_have_many_digits_on_both_sides_of_the_switch(x: float) -> None:
    from mpmath import mp, mpf
    from mpmath import sin as sine

    with mp.workdps(120):
        true = 1 - sine(mpf(x)) / mpf(x), (1 + sine(2 * mpf(x)) / (2 * mpf(x))) / 2 - (sine(mpf(x)) / mpf(x)) ** 2
        found = run(lambda: (arcs.one_less_sinc(*many(x)), arcs.cosine_variance(*many(x))))
        for own, reference in zip(found, true, strict=True):
            assert abs(mpf(str(own.exact)) - reference) <= mpf(10) ** -44 * reference


@pytest.mark.parametrize("grade", [1.0, 1e-9, 1e-30, 0.0])
def test_eigenvalues_and_vectors_of_many_digits(grade: float) -> None:
    doubles = (2.0, 0.3 * grade, -0.1), (0.3 * grade, 3.0 * grade, 0.2 * grade), (-0.1, 0.2 * grade, 1.0)
    rows = tuple(many(*row) for row in doubles)
    values, vectors = run(lambda: eigen_of_many_digits(rows))
    assert values[0] >= values[1] >= values[2]
    with localcontext(CONTEXT):
        for value, vector in zip(values, vectors, strict=True):
            for row, part in zip(rows, vector, strict=True):
                image = sum((x * y for x, y in zip(row, vector, strict=True)), ManyDigits(Decimal(0)))
                assert abs((image - value * part).exact) < Decimal("1e-56")


@pytest.mark.parametrize("second", [(3.0, 2.0, 1.0), (2.0, 2.0, 1.0), (3.0, 1.0, 1.0), (1.0, 1.0, 1.0)])
def test_axes_are_those_of_the_doubles(second: tuple[float, float, float]) -> None:
    a, b, c = second
    turned = ((a, 0.0, 0.0), (0.0, 0.5 * (b + c), 0.5 * (b - c)), (0.0, 0.5 * (b - c), 0.5 * (b + c)))
    near = principal(turned)
    found = run(lambda: principal_of_many_digits(tuple(tuple(many(*row)) for row in turned)))  # type: ignore[arg-type]
    assert found.degeneracy == near.degeneracy
    for own, other in zip(found.axes, near.axes, strict=True):
        assert [getattr(x, "value", x) for x in own] == pytest.approx(other, abs=1e-15)


def test_moments_about_principal_axes_are_about_those_shown() -> None:
    """They are doubles, beside which a product of inertia is not nothing, as it is about the true ones."""
    part = Part(amount=OfMass(mass=many(3.0)[0]), position=tuple(many(0.1, 0.2, 0.3)))  # type: ignore[arg-type]
    parts = (part, Part(amount=OfMass(mass=2.0)))
    with pytest.raises(ArithmeticError, match="doubles only"):
        run(lambda: body(Assembly(parts=parts), axes=Axes("principal")))
    assert isinstance(run(lambda: body(Assembly(parts=parts))).moments.xx, ManyDigits)


def test_a_mesh_has_no_many_digits() -> None:
    part = Part(mesh="any.stl", amount=OfMass(mass=many(1.0)[0]))  # type: ignore[arg-type]
    with pytest.raises(ArithmeticError, match="doubles only"):
        body(Assembly(parts=(part,)))
