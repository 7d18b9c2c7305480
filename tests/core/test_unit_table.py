"""The generated table: it is what its generator writes, and every name in it means what pint means by it."""

import importlib.util
import sys
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from dynamics_cli.core.units import conversion, lookup, names
from dynamics_cli.core.units.table import NAMES, UNITS
from dynamics_cli.core.units.unit import Unit, conformable

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


def meaning(unit: Unit) -> tuple[Any, ...]:
    return Fraction(unit.numerator, unit.denominator), unit.pi, unit.dimension, Fraction(*unit.offset)


def meaning_in_pint(registry: Any, name: str) -> tuple[Any, ...] | None:
    return tuple(generator.define(registry, name)) if registry.parse_unit_name(name) else None


def test_regenerating_gives_the_same_bytes() -> None:
    assert generator.generate().encode() == generator.TARGET.read_bytes()


def test_every_name_means_what_pint_means_but_for_the_listed_differences(pint_registry: Any) -> None:
    different = set()
    for name, _ in WRITTEN:
        theirs = meaning_in_pint(pint_registry, name)
        if theirs is not None and theirs != meaning(lookup.lookup(name)[0]):
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
            assert meaning(lookup.lookup(name)[0]) == tuple(generator.define(pint_registry, entry.expression)), name
    assert own > 40


def test_every_prefixed_name_is_its_power_of_ten_and_agrees_with_pint(pint_registry: Any) -> None:
    tables = {"s": generator.SYMBOL_PREFIXES, "w": generator.WORD_PREFIXES}
    agreed, different = 0, set()
    for entry in ENTRIES:
        for name, flags, _ in entry.names:
            factor, pi, dimension, offset = meaning(lookup.lookup(name)[0])
            for prefix, exponent in (item for flag in flags for item in tables[flag].items()):
                ours = meaning(lookup.lookup(prefix + name)[0])
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
        assert conversion.lowest(numerator, denominator) == (numerator, denominator)


def test_only_temperatures_and_gauge_pressures_have_a_shifted_zero() -> None:
    shifted = {symbol for symbol, _, unit, _ in names.all_units() if conversion.is_offset(unit)}
    assert shifted == {"degC", "degF", "psig", "barg", "kPag", "MPag"}


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
    unit = lookup.lookup(name)[0]
    assert Fraction(unit.numerator, unit.denominator) == factor


@pytest.mark.parametrize(
    ("name", "other"),
    [
        # ISO 80000-5 and NIST SP 811, appendix B: units with several definitions
        ("BTU", ("Btu_it", Fraction("1055.05585262"))), ("BTU", ("Btu_th", Fraction(23722880951, 22500000))),
        ("therm", ("US_therm", Fraction(105480400))), ("cal", ("cal_it", Fraction("4.1868"))),
        ("year", ("gregorian_year", Fraction(31556952))), ("hp", ("electrical_horsepower", Fraction(746))),
        ("hp", ("PS", Fraction("735.49875"))), ("barrel", ("oil_bbl", 42 * 231 * Fraction(254, 10000) ** 3)),
        ("gal", ("imp_gal", Fraction("0.00454609"))), ("ton", ("long_ton", 2240 * Fraction(45359237, 10**8))),
        ("cwt", ("long_hundredweight", 112 * Fraction(45359237, 10**8))), ("pt", ("dry_pint", None)),
        ("qt", ("imperial_quart", 2 * Fraction("0.00056826125"))), ("tonf", ("UK_force_ton", None)),
        ("bushel", ("imperial_bushel", 8 * Fraction("0.00454609"))), ("inH2O", ("inch_H2O_60F", None)),
        ("floz", ("imperial_fluid_ounce", Fraction("0.0000284130625"))), ("inHg", ("inch_Hg_60F", None)),
        ("kcal", ("cal_it", None)),
    ],
)  # fmt: skip
def test_a_unit_of_several_definitions_names_the_one_used_and_the_others(
    name: str, other: tuple[str, Fraction | None]
) -> None:
    (note,) = lookup.parse_unit(name).notes
    assert f"{other[0]}" in note
    assert note.startswith(name)
    found = lookup.parse_unit(other[0])
    assert conformable(found, lookup.parse_unit(name))
    assert other[1] in (None, Fraction(found.numerator, found.denominator))


def test_every_unit_that_a_description_names_exists() -> None:
    for symbol, _, unit, description in names.all_units():
        _, several, others = description.partition("; ")
        named = [word.strip(",()") for word in others.split() if "_" in word]
        assert several or not lookup.lookup(symbol)[0].notes
        assert all(conformable(lookup.parse_unit(word), unit) for word in named)
