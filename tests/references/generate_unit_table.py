"""Write `dynamics_cli/core/units/table.py` from pint's definitions, exactly.

    python tests/references/generate_unit_table.py

Every factor is computed by pint in rational arithmetic from the expression in `UNITS`; pint's 50-digit π is taken out
again as a whole power. Which names are common enough for the table, and where this program means something else than
pint by a name (`DIFFERENCES`, each with its reason), is stated here and nowhere else.
"""

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

TARGET = Path(__file__).resolve().parents[2] / "dynamics_cli" / "core" / "units" / "table.py"
BASES = ("meter", "gram", "second", "kelvin", "ampere", "mole", "candela", "radian")
PINT_PI = Fraction("3.1415926535897932384626433832795028841971693993751")

# An expression may end in `above N`: the SI value at its zero.
# symbol | expression for pint | names | tag | description
# A name may be followed by `:s` (takes the prefix symbols k, M, m, …), `:w` (takes the prefix words kilo, mega, …)
# and `+other` (also reads as the unit `other`, where that is what is wanted). A description with a semicolon
# is that of a unit with several definitions: the one used, and the others' names. It is reported with every reading.
UNITS = """
rad | radian | rad:s radian:w radians:w rads | | radian
deg | degree | deg degs degree degrees ° arcdeg | | degree of arc
arcmin | arcminute | arcmin arcminute arcminutes ′ | | minute of arc
arcsec | arcsecond | arcsec arcsecond arcseconds ″ | | second of arc
grad | grade | grad grads gon gons gradian gradians | | gradian, 1/400 of a turn
rev | turn | rev revs revolution revolutions turn turns | | turn
rpm | turn / minute | rpm RPM | | revolution per minute
rps | turn / second | rps | | revolution per second
dps | degree / second | dps | | degree per second
cycle | 1 | cycle cycles | | pure number: cycle/s is Hz
% | 0.01 | % percent pct | | hundredth
‰ | 0.001 | ‰ permille | | thousandth
ppm | 1e-6 | ppm | | millionth
m | meter | m:s meter:w meters:w metre:w metres:w | | metre
in | inch | in inch inches | | inch, 25.4 mm
ft | foot | ft foot feet | | foot
yd | yard | yd yds yard yards | | yard
mi | mile | mi mile miles | | statute mile
nmi | nautical_mile | nmi nautical_mile nautical_miles | | nautical mile, 1852 m
survey_foot | 1200 / 3937 * meter | survey_foot survey_feet US_survey_foot US_survey_feet ftUS sft | | US survey foot, 1200/3937 m; retired in 2022, the foot is now 0.3048 m
survey_mile | 5280 * 1200 / 3937 * meter | survey_mile survey_miles US_survey_mile US_survey_miles | | US survey mile, 5280 survey feet; retired in 2022
au | astronomical_unit | au astronomical_unit astronomical_units | | astronomical unit, 149597870700 m
100km | 100 * kilometer | 100km | | hundred kilometres, as in L/100km
100mi | 100 * mile | 100mi | | hundred miles, as in gal/100mi
thou | thou | thou thous | | thousandth of an inch
mil | thou | mil mils | | thousandth of an inch
\u00b5in | 1e-6 * inch | \u00b5in \u03bcin uin microinch microinches | | millionth of an inch
micron | 1e-6 * meter | micron microns | | micrometre
\u00c5 | 1e-10 * meter | \u00c5 \u212b angstrom angstroms | | ångström
fathom | 6 * foot | fathom fathoms | | fathom, 6 ft
rod | 33 / 2 * foot | rod rods | | rod, 16.5 ft
chain | 66 * foot | chain chains | | chain, 66 ft
furlong | 660 * foot | furlong furlongs | | furlong, 660 ft
league | 3 * mile | league leagues | | league, 3 mi
hand | 4 * inch | hand hands | | hand, 4 in
acre | 43560 * foot ** 2 | acre acres | | acre, 43560 ft²
ha | hectare | ha hectare hectares | | hectare
sqft | foot ** 2 | sqft sq_ft | | square foot
sqin | inch ** 2 | sqin sq_in | | square inch
sqyd | yard ** 2 | sqyd sq_yd | | square yard
sqmi | mile ** 2 | sqmi sq_mi | | square mile
cuft | foot ** 3 | cuft cu_ft | | cubic foot
cuin | inch ** 3 | cuin cu_in cid CID | | cubic inch
cuyd | yard ** 3 | cuyd cu_yd | | cubic yard
L | liter | L:s l:s ℓ:s liter:w liters:w litre:w litres:w | | litre
cc | centimeter ** 3 | cc | | cubic centimetre
gal | gallon | gal gals gallon gallons | | US gallon; the imperial one is imp_gal
US_gal | gallon | US_gal USgal US_gallon US_gallons gal_US | | US gallon, 231 in³
qt | quart | qt qts quart quarts | | US quart; the imperial one is imperial_quart, the dry one dry_quart
pt | pint | pt pts pint pints | | US pint; the imperial one is imperial_pint, the dry one dry_pint
cup | cup | cup cups | | US cup; the imperial one is imperial_cup, a metric cup 250 mL
floz | fluid_ounce | floz fl_oz fluid_ounce fluid_ounces | | US fluid ounce; the imperial one is imperial_fluid_ounce
tbsp | tablespoon | tbsp tablespoon tablespoons | | US tablespoon; a metric one is 15 mL
tsp | teaspoon | tsp teaspoon teaspoons | | US teaspoon; a metric one is 5 mL
imp_gal | imperial_gallon | imp_gal imperial_gallon imperial_gallons gal_imp gal_UK UK_gal UK_gallon UK_gallons | | imperial gallon
imp_pt | imperial_pint | imp_pt imperial_pint imperial_pints UK_pint UK_pints | | imperial pint
imp_floz | imperial_fluid_ounce | imp_floz imp_fl_oz imperial_fluid_ounce imperial_fluid_ounces UK_floz UK_fl_oz | | imperial fluid ounce
mpg | mile / gallon | mpg MPG mpg_US US_mpg | | mile per US gallon; the imperial one is imp_mpg
imp_mpg | mile / imperial_gallon | imp_mpg mpg_imp mpg_UK UK_mpg | | mile per imperial gallon
bbl | barrel | bbl bbls barrel barrels | | US barrel, 31.5 gal; others are oil_bbl (petroleum, 42 gal) and beer_bbl
oil_bbl | oil_barrel | oil_bbl oil_bbls oil_barrel oil_barrels | | petroleum barrel, 42 US gal
bushel | bushel | bushel bushels bu | | US bushel; the imperial one is imperial_bushel
peck | peck | peck pecks | | US peck; the imperial one is imperial_peck
s | second | s:s sec:s secs second:w seconds:w | | second
min | minute | min mins minute minutes | | minute
h | hour | h hr hrs hour hours | | hour
d | day | d day days | | day
week | week | week weeks | | week
fortnight | fortnight | fortnight fortnights | | fortnight
month | month | month months | | twelfth of a Julian year, 30.4375 d; otherwise write days, such as 30 d
year | year | year years yr yrs | | Julian year, 365.25 d; others are gregorian_year, tropical_year, 365 d
mph | mile / hour | mph MPH | | mile per hour
kph | kilometer / hour | kph KPH kmh kmph | | kilometre per hour
fps | foot / second | fps | | foot per second
fpm | foot / minute | fpm FPM | | foot per minute
DP | 1 / inch | DP | | diametral pitch, teeth per inch
knot | knot | knot knots kn kt kts | | knot, 1852 m/h
gn | g_0 | gn g_n g_0 g0 gee gees | | standard gravity, 9.80665 m/s^2
Gal | galileo | Gal galileo | | galileo, 1 cm/s²
g | gram | g:s+gn gram:w grams:w gramme:w grammes:w | | gram
t | metric_ton | t tonne tonnes metric_ton metric_tons | | tonne, 1000 kg
lbm | pound | lbm lb+lbf lbs+lbf pound+lbf pounds+lbf pound_mass | | pound-mass
ozm | ounce | ozm oz+ozf ounce+ozf ounces+ozf | | avoirdupois ounce, a mass
slug | slug | slug slugs | | slug, 1 lbf·s²/ft
slinch | slinch | slinch slinches blob blobs | | slinch, 1 lbf·s²/in
stone | stone | stone stones st | | stone, 14 lb
gr | grain | gr grain grains | | grain
ct | carat | ct carat carats | | metric carat
cwt | hundredweight | cwt hundredweight | | US hundredweight, 100 lb; the British one of 112 lb is long_hundredweight
ton | ton | ton tons | | short ton, 2000 lb; others are long_ton (2240 lb) and t (1000 kg)
short_ton | short_ton | short_ton short_tons US_ton US_tons | | short ton, 2000 lb
long_ton | long_ton | long_ton long_tons UK_ton UK_tons imperial_ton imperial_tons | | long ton, 2240 lb
N | newton | N:s newton:w newtons:w | | newton
lbf | force_pound | lbf lbfs pound_force pounds_force force_pound | | pound-force
ozf | force_ounce | ozf ounce_force ounces_force force_ounce | | ounce-force
kip | kip | kip kips klbf | | thousand pounds-force
tonf | force_ton | tonf ton_force short_ton_force | | short ton-force, 2000 lbf; others are UK_force_ton and tf
kgf | force_kilogram | kgf kp kilopond kiloponds kilogram_force | | kilogram-force
gf | force_gram | gf gram_force pond | | gram-force
tf | force_metric_ton | tf tonne_force metric_ton_force | | tonne-force
dyn | dyne | dyn dyne dynes | | dyne
pdl | poundal | pdl poundal poundals | | poundal
J | joule | J:s joule:w joules:w | energy | joule
cal | calorie | cal:s calorie:w calories:w | energy | thermochemical calorie, 4.184 J; another is cal_it (4.1868 J)
BTU | british_thermal_unit | BTU BTUs Btu btu | energy | British thermal unit, 1055.056 J (ISO); others: Btu_it, Btu_th
therm | therm | therm therms | energy | therm, 105.5056 MJ; the US one of 105.4804 MJ is US_therm
Wh | watt_hour | Wh:s watt_hour:w watt_hours:w watthour:w watthours:w | energy | watt-hour
eV | electron_volt | eV:s electron_volt:w electron_volts:w electronvolt:w electronvolts:w | energy | electronvolt
erg | erg | erg ergs | energy | erg
ftlb | foot * force_pound | ftlb ftlbf ftlbs ft_lb ft_lbf foot_pound foot_pounds | | foot-pound, torque or energy
inlb | inch * force_pound | inlb inlbf inlbs in_lb in_lbf inch_pound inch_pounds | | inch-pound, torque or energy
Nm | newton * meter | Nm:s newton_meter newton_meters newton_metre newton_metres | torque | newton-metre
Nmm | newton * millimeter | Nmm | torque | newton-millimetre
lbft | foot * force_pound | lbft lbfft lb_ft lbf_ft pound_foot pound_feet | torque | pound-foot
lbin | inch * force_pound | lbin lbfin lb_in lbf_in pound_inch pound_inches | torque | pound-inch
W | watt | W:s watt:w watts:w | | watt
hp | horsepower | hp HP bhp BHP horsepower horsepowers | | horsepower, 550 ft·lbf/s; others: PS, electrical_horsepower
boiler_horsepower | boiler_horsepower | boiler_horsepower | | 33475 BTU/h, 9810.555 W; otherwise write 9809.5 W
refrigeration_ton | 200 * Btu / minute | refrigeration_ton TR ton_of_refrigeration tons_of_refrigeration | | 12000 BTU/h; or write 12000 Btu_it/h
PS | metric_horsepower | PS CV metric_hp hp_metric metric_horsepower | | metric horsepower, 75 kgf·m/s
Pa | pascal | Pa:s pascal:w pascals:w | | pascal
bar | bar | bar:s bars bara bar_abs bar_absolute | | bar
psi | psi | psi:s | | pound-force per square inch
psia | psi | psia psi_abs psi_absolute | | pound-force per square inch, absolute
psig | psi above 101325 | psig psi_gauge psi_gage | | psi above 1 atm (101325 Pa); a difference is in psi
barg | bar above 101325 | barg bar_gauge bar_g | | bar above 1 atm (101325 Pa); a difference is in bar
kPag | kilopascal above 101325 | kPag | | kPa above 1 atm (101325 Pa); a difference is in kPa
MPag | megapascal above 101325 | MPag | | MPa above 1 atm (101325 Pa); a difference is in MPa
ksi | ksi | ksi | | kip per square inch
psf | force_pound / foot ** 2 | psf | | pound-force per square foot
ksf | kip / foot ** 2 | ksf | | kip per square foot
tsf | force_ton / foot ** 2 | tsf | | short ton-force per square foot
Msi | 1000 * ksi | Msi | | million pounds-force per square inch
plf | force_pound / foot | plf | | pound-force per foot
klf | kip / foot | klf | | kip per foot
atm | atm | atm atms atmosphere atmospheres | | standard atmosphere
at | technical_atmosphere | at technical_atmosphere | | technical atmosphere, 1 kgf/cm²
torr | torr | torr Torr | | torr, 1/760 atm
mHg | mHg | mHg:s | | metre of mercury
inHg | inHg | inHg | | inch of mercury, conventional (0 °C); at 60 °F it is inch_Hg_60F
mH2O | mH2O | mH2O:s | | metre of water
inH2O | inH2O | inH2O inWC in_wc inWG in_wg | | inch of water, conventional (4 °C); at 60 °F it is inch_H2O_60F
ftH2O | ftH2O | ftH2O | | foot of water
Hz | hertz | Hz:s hertz:w | | hertz, 1/s
K | kelvin | K:s kelvin:w kelvins:w | | kelvin
degC | degC | degC °C ℃ celsius Celsius degreeC deg_C degrees_C degree_celsius degrees_celsius | | degree Celsius
degF | degF | degF °F ℉ fahrenheit Fahrenheit degreeF deg_F degrees_F degree_fahrenheit degrees_fahrenheit | | degree Fahrenheit
degR | degR | degR °R rankine Rankine degreeR R | | degree Rankine
delta_degC | delta_degC | delta_degC Δ°C deltaC delta_C | | Celsius degree of difference
delta_degF | delta_degF | delta_degF Δ°F deltaF delta_F | | Fahrenheit degree of difference
A | ampere | A:s ampere:w amperes:w amp:w amps:w | | ampere
Ah | ampere_hour | Ah:s ampere_hour ampere_hours | | ampere-hour
C | coulomb | C:s+degC coulomb:w coulombs:w | | coulomb
V | volt | V:s volt:w volts:w | | volt
ohm | ohm | ohm:sw ohms:sw \u03a9:s \u2126:s | | ohm
S | siemens | S:s siemens:w | | siemens
F | farad | F:s+degF farad:w farads:w | | farad
H | henry | H:s henry:w henries:w henrys:w | | henry
Wb | weber | Wb:s weber:w webers:w | | weber
T | tesla | T:s tesla:w teslas:w | | tesla
mol | mole | mol:s mole:w moles:w | | mole
lbmol | 453.59237 * mole | lbmol lbmols lb_mol pound_mole pound_moles | | pound-mole, 453.59237 mol
cd | candela | cd:s candela:w candelas:w | | candela
P | poise | P:s poise:w | | poise
St | stokes | St:s stokes:w | | stokes
gpm | gallon / minute | gpm GPM | | US gallon per minute; the imperial one is imp_gal/min
cfm | foot ** 3 / minute | cfm CFM | | cubic foot per minute
cfs | foot ** 3 / second | cfs CFS | | cubic foot per second
pcf | pound / foot ** 3 | pcf | | pound-mass per cubic foot; a weight density is in lbf/ft^3
pci | pound / inch ** 3 | pci | | pound-mass per cubic inch; a weight density is in lbf/in^3
lpm | liter / minute | lpm | | litre per minute
"""  # noqa: E501

# Names that some release of pint from 0.25.1 on reads otherwise, and why this program does not follow.
DIFFERENCES = {
    "cycle": "an oscillation is not an angle: cycle/s is Hz, and Hz is not rad/s",
    "cycles": "as cycle",
    "mil": "in machine work a mil is 0.001 in; pint's is an angle",
    "mils": "as mil",
    "PS": "Pferdestärke on every data sheet; pint reads petasiemens",
    "rads": "radians, as many write them; pint reads the absorbed dose",
    "Nm": "newton-metre, as everybody writes it; pint up to 0.25 reads the textile number-metre",
    "R": "degree Rankine; pint reads the molar gas constant",
    "chain": "66 international feet, as NIST Handbook 44 has it since 2023; pint up to 0.25 has survey feet",
    "chains": "as chain",
    "rod": "as chain",
    "rods": "as chain",
    "fathom": "as chain",
    "fathoms": "as chain",
    "furlong": "as chain",
    "furlongs": "as chain",
    "league": "as chain",
    "leagues": "as chain",
    "acre": "as chain",
    "acres": "as chain",
    "pct": "percent; pint reads picocarat",
    "TR": "ton of refrigeration, as makers of chillers write it; pint reads a million million molar gas constants",
    "kmph": "kilometre per hour; pint reads thousand miles per hour",
    "ftlb": "foot-pound; pint reads femto-troy-pound",
    "ftlbs": "as ftlb",
    "amps": "amperes; pint reads attometre per second",
    "cfm": "cubic foot per minute; pint reads centifermi",
}

# Prefixed names that pint reads otherwise.
PREFIXED_DIFFERENCES = {
    "hbar": "hectobar, by the rule for bar; pint reads the reduced Planck constant",
    "mcd": "millicandela, by the rule for cd; pint reads a microday",
    "PS": "see above",
}

SYMBOL_PREFIXES = {
    **{"q": -30, "r": -27, "y": -24, "z": -21, "a": -18, "f": -15, "p": -12, "n": -9, "u": -6},
    **{"\u00b5": -6, "\u03bc": -6, "m": -3, "c": -2, "d": -1, "da": 1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12},
    **{"P": 15, "E": 18, "Z": 21, "Y": 24, "R": 27, "Q": 30},
}
WORD_PREFIXES = {
    **{"quecto": -30, "ronto": -27, "yocto": -24, "zepto": -21, "atto": -18, "femto": -15, "pico": -12, "nano": -9},
    **{"micro": -6, "milli": -3, "centi": -2, "deci": -1, "deca": 1, "deka": 1, "hecto": 2, "kilo": 3, "mega": 6},
    **{"giga": 9, "tera": 12, "peta": 15, "exa": 18, "zetta": 21, "yotta": 24, "ronna": 27, "quetta": 30},
}


class Definition(NamedTuple):
    """A unit in SI, exactly: number · factor · π^pi + offset."""

    factor: Fraction
    pi: int
    dimension: tuple[int, ...]
    offset: Fraction


class Entry(NamedTuple):
    """One line of `UNITS`: names with their prefix flags and their second reading."""

    symbol: str
    expression: str
    names: tuple[tuple[str, str, str], ...]
    tag: str
    description: str


def entries() -> Iterator[Entry]:
    """Read the lines of `UNITS`."""
    for line in UNITS.strip().splitlines():
        symbol, expression, names, tag, description = (field.strip() for field in line.split("|"))
        yield Entry(symbol, expression, tuple(_name(name) for name in names.split()), tag, description)


def _name(text: str) -> tuple[str, str, str]:
    text, _, other = text.partition("+")
    name, _, flags = text.partition(":")
    return name, flags, other


def registry() -> Any:
    """Build pint's registry in rational arithmetic."""
    import pint

    return pint.UnitRegistry(non_int_type=Fraction)


def without_pi(factor: Fraction) -> tuple[Fraction, int]:
    """Write a factor as rational · π^k, with the k that leaves the shortest rational."""

    def height(power: int) -> int:
        rest = factor / PINT_PI**power
        return rest.numerator.bit_length() + rest.denominator.bit_length()

    power = min((0, 1, -1, 2, -2), key=height)
    return factor / PINT_PI**power, power


def define(ureg: Any, expression: str) -> Definition:
    """Take one unit from pint, in kg rather than pint's root gram."""
    expression, _, above = expression.partition(" above ")
    name = ureg.parse_unit_name(expression)
    if name:
        factor, root = ureg.get_root_units(ureg.UnitsContainer({name[0][0] + name[0][1]: 1}))
    else:
        quantity = ureg.Quantity(ureg.parse_expression(expression))
        factor, root = ureg.get_root_units(quantity.units)
        factor *= quantity.magnitude
    powers = {str(name): int(power) for name, power in root._units.items()}
    dimension = tuple(powers.pop(base, 0) for base in BASES)
    if powers:
        raise ValueError(f"{expression}: {powers} is no dimension of ours")
    factor, pi = without_pi(Fraction(factor) / Fraction(1000) ** dimension[1])
    offset = Fraction(getattr(ureg._units[name[0][1]].converter, "offset", 0)) if name else Fraction(0)
    offset += Fraction(above or 0)
    return Definition(factor, pi, dimension, offset)


def unit_line(entry: Entry, definition: Definition) -> str:
    """Write the line of one unit: symbol, numerator, denominator, power of π, dimension, offset, tag, description."""
    factor, pi, dimension, offset = definition
    short = ",".join(map(str, dimension)).removesuffix(",0,0,0,0,0")
    shift = f"{offset.numerator}/{offset.denominator}" if offset else ""
    fields = (f"={entry.symbol}", factor.numerator, factor.denominator, pi, short, shift, entry.tag, entry.description)
    return "|".join(map(str, fields))


def packed(words: list[str], width: int = 110) -> Iterator[str]:
    """Fill lines with words, each followed by one space."""
    line = ""
    for word in words:
        if len(line) + len(word) + 1 > width:
            yield line
            line = ""
        line += word + " "
    yield line


def prefix_lines(prefixes: dict[str, int]) -> Iterator[str]:
    """Fill lines with `prefix|exponent` words."""
    return packed([f"{prefix}|{exponent}" for prefix, exponent in prefixes.items()])


def literal(name: str, lines: Iterator[str], ending: str = "") -> str:
    """Write one string constant over many source lines; the first character is the separator before the first word."""
    body = "".join(f'    "{line}{ending}"\n' for line in lines)
    first = "\\n" if ending else " "
    return f'{name} = (\n    "{first}"\n{body})\n'


def generate() -> str:
    """Write the whole module as text."""
    ureg = registry()
    units, names, seen = [], [], set()
    for entry in entries():
        units.append(unit_line(entry, define(ureg, entry.expression)))
        for name, flags, other in entry.names:
            if name in seen:
                raise ValueError(f"{name} is listed twice")
            seen.add(name)
            names.append(f"{name}|{entry.symbol}{'+' if other else ''}{other}|{flags}")
    return (
        '"""The common units, exactly: generated by tests/references/generate_unit_table.py; do not edit.\n\n'
        "Three strings that are searched, not parsed: a dict of this size would cost start-up time.\n"
        "`NAMES` holds ` name|symbol|prefixes ` (`lb|lbm+lbf|` reads as either), `UNITS` holds\n"
        "`=symbol|numerator|denominator|power of pi|dimension|offset|tag|description` lines, the dimension over\n"
        "length, mass, time, temperature, current, amount, luminosity and angle, SI value = number * factor + offset.\n"
        '"""\n\n'
        + literal("NAMES", packed(names))
        + "\n"
        + literal("UNITS", iter(units), "\\n")
        + "\n"
        + literal("SYMBOL_PREFIXES", prefix_lines(SYMBOL_PREFIXES))
        + "\n"
        + literal("WORD_PREFIXES", prefix_lines(WORD_PREFIXES))
    )


if __name__ == "__main__":
    TARGET.write_text(generate(), encoding="utf-8")
