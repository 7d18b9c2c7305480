"""Densities of common materials at room temperature, with source and range of grades."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Density, Text
from dynamics_cli.records import record

EN_STEEL = "EN 1993-1-2, 3.2.2"
EN_STAINLESS = "EN 10088-1, physical properties"
EN_ALUMINIUM = "EN 1999-1-1, 3.2.5"
HANDBOOK = "typical of handbooks and makers' sheets"
ELEMENT = "density of the element, CRC Handbook of Chemistry and Physics"
POLYMER = "typical of unfilled grades by ISO 1183"

# name: density [kg/m³], the least and the greatest of common grades [kg/m³], source
TABLE: dict[str, tuple[float, float, float, str]] = {
    "steel": (7850.0, 7750.0, 7900.0, EN_STEEL),
    "stainless-304": (7900.0, 7900.0, 8000.0, EN_STAINLESS),
    "stainless-316": (8000.0, 7950.0, 8030.0, EN_STAINLESS),
    "stainless-430": (7700.0, 7700.0, 7750.0, EN_STAINLESS),
    "stainless-17-4ph": (7800.0, 7750.0, 7810.0, EN_STAINLESS),
    "duplex-2205": (7800.0, 7800.0, 7830.0, EN_STAINLESS),
    "grey-iron": (7200.0, 6600.0, 7400.0, "EN 1561, EN-GJL-250"),
    "ductile-iron": (7100.0, 7000.0, 7300.0, "EN 1563, EN-GJS-400 to 700"),
    "aluminium": (2700.0, 2640.0, 2850.0, EN_ALUMINIUM),
    "aluminium-2024": (2780.0, 2770.0, 2790.0, HANDBOOK),
    "aluminium-6061": (2700.0, 2690.0, 2710.0, HANDBOOK),
    "aluminium-7075": (2810.0, 2800.0, 2820.0, HANDBOOK),
    "titanium": (4506.0, 4500.0, 4540.0, ELEMENT),
    "titanium-6al-4v": (4430.0, 4410.0, 4450.0, HANDBOOK),
    "magnesium": (1740.0, 1740.0, 1850.0, ELEMENT),
    "brass": (8500.0, 8400.0, 8750.0, HANDBOOK),
    "bronze": (8800.0, 7400.0, 8900.0, HANDBOOK),
    "copper": (8960.0, 8890.0, 8960.0, ELEMENT),
    "nickel": (8908.0, 8800.0, 8908.0, ELEMENT),
    "zinc": (7134.0, 6600.0, 7140.0, ELEMENT),
    "lead": (11340.0, 11300.0, 11350.0, ELEMENT),
    "tungsten": (19300.0, 19250.0, 19350.0, ELEMENT),
    "abs": (1050.0, 1020.0, 1080.0, POLYMER),
    "pa6": (1130.0, 1120.0, 1150.0, POLYMER),
    "pa66": (1140.0, 1130.0, 1160.0, POLYMER),
    "pc": (1200.0, 1190.0, 1220.0, POLYMER),
    "peek": (1300.0, 1260.0, 1320.0, POLYMER),
    "pet": (1380.0, 1330.0, 1400.0, POLYMER),
    "pla": (1240.0, 1210.0, 1250.0, POLYMER),
    "pmma": (1190.0, 1170.0, 1200.0, POLYMER),
    "pom": (1410.0, 1390.0, 1430.0, POLYMER),
    "pp": (905.0, 890.0, 915.0, POLYMER),
    "hdpe": (950.0, 940.0, 970.0, POLYMER),
    "ptfe": (2160.0, 2100.0, 2200.0, POLYMER),
    "pvc": (1400.0, 1300.0, 1450.0, POLYMER),
    "rubber": (920.0, 910.0, 1250.0, "natural rubber, unfilled; filled mixes are denser"),
    "carbon-epoxy": (1600.0, 1500.0, 1620.0, "laminate of 60 % fibre by volume, by the rule of mixtures"),
    "glass": (2500.0, 2480.0, 2520.0, "EN 572-1, soda lime glass"),
    "concrete": (2400.0, 2000.0, 2600.0, "EN 1991-1-1, table A.1: 24 kN/m³, EN 206: 2000 to 2600"),
    "reinforced-concrete": (2500.0, 2100.0, 2700.0, "EN 1991-1-1, table A.1: 1 kN/m³ more"),
    "softwood-c24": (420.0, 350.0, 500.0, "EN 338, mean of class C24"),
    "hardwood-d30": (640.0, 530.0, 700.0, "EN 338, mean of class D30"),
    "plywood": (650.0, 460.0, 720.0, HANDBOOK),
    "water": (998.2, 997.0, 1000.0, "IAPWS-95 at 20 °C and 101.325 kPa"),
    "seawater": (1025.0, 1020.0, 1030.0, "35 g/kg of salt at 15 °C"),
    "ice": (917.0, 916.0, 920.0, "at 0 °C"),
}
OTHER_NAMES = {
    "aluminum": "aluminium",
    "carbon-steel": "steel",
    "stainless": "stainless-304",
    "stainless-steel": "stainless-304",
    "1.4301": "stainless-304",
    "1.4401": "stainless-316",
    "cast-iron": "grey-iron",
    "gray-iron": "grey-iron",
    "ti-6al-4v": "titanium-6al-4v",
    "6061": "aluminium-6061",
    "7075": "aluminium-7075",
    "2024": "aluminium-2024",
    "nylon": "pa66",
    "acetal": "pom",
    "delrin": "pom",
    "acrylic": "pmma",
    "polycarbonate": "pc",
    "teflon": "ptfe",
    "polypropylene": "pp",
    "polyethylene": "hdpe",
    "wood": "softwood-c24",
    "oak": "hardwood-d30",
}


@record
class Material:
    """One material."""

    name: Annotated[Text, "Its name in `--material`."]
    density: Annotated[Density, "The density used [kg/m^3]."]
    least: Annotated[Density, "The lowest of common grades [kg/m^3]."]
    greatest: Annotated[Density, "The highest of common grades [kg/m^3]."]
    source: Annotated[Text, "Its source."]


@record
class Materials:
    """The table of materials."""

    materials: Annotated[tuple[Material, ...], "One row for each material."]


def density_of(name: str) -> float:
    """The density of a material by its name, in any case and with spaces or underscores for hyphens [kg/m³]."""
    return TABLE[_key(name)][0]


def _key(name: str) -> str:
    key = name.strip().lower().replace("_", "-").replace(" ", "-")
    key = OTHER_NAMES.get(key, key)
    if key not in TABLE:
        from difflib import get_close_matches

        names = (*TABLE, *OTHER_NAMES)
        near = [other for other in names if key[:3] and other.startswith(key[:3])] or get_close_matches(key, names)
        require(
            False,
            "the table has no material {read}",
            code="material",
            hint=f"there is {', '.join(near)}" if near else "dynamics inertia materials lists them; or give a density",
            read=repr(name),
        )
    return key


def materials(*, name: Annotated[Text, "One material; all if left out."] = "") -> Materials:
    """Densities of common materials, each with its source and the range of common grades.

    Returns
    -------
    Materials
        Name, density, range and source of each.

    Raises
    ------
    InadmissibleError
        When the table has no material of that name.

    Notes
    -----
    A density from a table is uncertain by its range, more than any other error of a mass computed from it: weigh the
    part, or write the density of the grade with its uncertainty.

    Examples
    --------
    >>> materials(name="steel").materials[0].density
    7850.0
    """
    keys = (_key(name),) if name else tuple(TABLE)
    return Materials(tuple(Material(key, *TABLE[key]) for key in keys))
