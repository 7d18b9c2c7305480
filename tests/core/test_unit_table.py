"""The generated table: it is what its generator writes, and every name in it means what pint means by it."""

import importlib.util
import sys
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from dynamics_cli.core import units
from dynamics_cli.core.unit_table import NAMES, UNITS

GENERATOR = Path(__file__).resolve().parents[1] / "references" / "generate_unit_table.py"


def load_generator() -> ModuleType:
    specification = importlib.util.spec_from_file_location("generate_unit_table", GENERATOR)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    sys.modules[specification.name] = module
    specification.loader.exec_module(module)
    return module


generator = load_generator()
ENTRIES = list(generator.entries())
WRITTEN = [(name, entry) for entry in ENTRIES for name, _, _ in entry.names]


@pytest.fixture(scope="module")
def pint_registry() -> Any:
    return generator.registry()


def meaning(unit: units.Unit) -> tuple[Any, ...]:
    return Fraction(unit.numerator, unit.denominator), unit.pi, unit.dimension, Fraction(*unit.offset)


def meaning_in_pint(registry: Any, name: str) -> tuple[Any, ...] | None:
    return tuple(generator.define(registry, name)) if registry.parse_unit_name(name) else None


def test_regenerating_gives_the_same_bytes() -> None:
    assert generator.generate().encode() == generator.TARGET.read_bytes()


def test_every_name_means_what_pint_means_but_for_the_listed_differences(pint_registry: Any) -> None:
    different = set()
    for name, _ in WRITTEN:
        theirs = meaning_in_pint(pint_registry, name)
        if theirs is not None and theirs != meaning(units.lookup(name)[0]):
            different.add(name)
    assert different <= set(generator.DIFFERENCES)
    # Newer releases of pint have come round to these.
    settled = {name for name, reason in generator.DIFFERENCES.items() if "0.25" in reason or reason == "as chain"}
    assert set(generator.DIFFERENCES) - different <= settled


def test_names_that_pint_lacks_mean_what_their_expression_means(pint_registry: Any) -> None:
    own = 0
    for name, entry in WRITTEN:
        if meaning_in_pint(pint_registry, name) is None:
            own += 1
            assert meaning(units.lookup(name)[0]) == tuple(generator.define(pint_registry, entry.expression)), name
    assert own > 40


def test_every_prefixed_name_is_its_power_of_ten_and_agrees_with_pint(pint_registry: Any) -> None:
    tables = {"s": generator.SYMBOL_PREFIXES, "w": generator.WORD_PREFIXES}
    agreed, different = 0, set()
    for entry in ENTRIES:
        for name, flags, _ in entry.names:
            factor, pi, dimension, offset = meaning(units.lookup(name)[0])
            for prefix, exponent in (item for flag in flags for item in tables[flag].items()):
                ours = meaning(units.lookup(prefix + name)[0])
                if prefix + name != "PS":
                    assert ours == (factor * Fraction(10) ** exponent, pi, dimension, offset), prefix + name
                theirs = meaning_in_pint(pint_registry, prefix + name)
                agreed += theirs == ours
                if theirs not in (None, ours) and name not in generator.DIFFERENCES:
                    different.add(prefix + name)
    assert different <= set(generator.PREFIXED_DIFFERENCES)
    assert agreed > 2400


def test_the_table_is_whole() -> None:
    lines = UNITS.strip().splitlines()
    symbols = [line[1 : line.index("|")] for line in lines]
    assert len(symbols) == len(set(symbols)) == len(ENTRIES)
    named = {symbol for word in NAMES.split() for symbol in word.split("|")[1].split("+")}
    assert named == set(symbols)
    assert len(NAMES.split()) > 400
    for line in lines:
        fields = line[1:].split("|")
        assert len(fields) == 8
        assert fields[6] in ("", "energy", "torque")
        numerator, denominator = int(fields[1]), int(fields[2])
        assert numerator > 0
        assert denominator > 0
        assert units.lowest(numerator, denominator) == (numerator, denominator)


def test_only_temperatures_have_a_shifted_zero() -> None:
    shifted = {symbol for symbol, _, unit, _ in units.all_units() if units.is_offset(unit)}
    assert shifted == {"degC", "degF"}


@pytest.mark.parametrize(
    ("name", "factor"),
    [
        # International yard and pound agreement 1959; CGPM 1901; exact by definition.
        ("in", Fraction(254, 10000)),
        ("mi", Fraction(1609344, 1000)),
        ("nmi", Fraction(1852)),
        ("lbm", Fraction(45359237, 10**8)),
        ("lbf", Fraction(45359237, 10**8) * Fraction(980665, 10**5)),
        ("slug", Fraction(45359237, 10**8) * Fraction(980665, 10**5) / Fraction(3048, 10**4)),
        ("hp", 550 * Fraction(45359237, 10**8) * Fraction(980665, 10**5) * Fraction(3048, 10**4)),
        ("PS", 75 * Fraction(980665, 10**5)),
        ("gal", 231 * Fraction(254, 10000) ** 3),
        ("mil", Fraction(254, 10**7)),
        ("acre", 43560 * Fraction(3048, 10**4) ** 2),
        ("eV", Fraction(1602176634, 10**28)),
    ],
)
def test_definitions_by_hand(name: str, factor: Fraction) -> None:
    unit = units.lookup(name)[0]
    assert Fraction(unit.numerator, unit.denominator) == factor
