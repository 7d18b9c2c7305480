"""The commands `convert`, `units` and `coords`."""

from dynamics_cli.core.answering.task import Family, Model, Task

TABLE = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, table 1.7.1; constants of SI and US"
LISTS = "dynamics_cli.convert.unit_lists"


def _list(
    name: str, summary: str, function: str, table: str, source: str, *examples: str, headline: str = "", shown: str = ""
) -> Task:
    model = Model("exact unit table", f"{LISTS}:{function}", source=source, method="look-up")
    return Task(
        name,
        summary,
        model,
        examples=examples,
        table=table,
        arrays=False,
        tracked=False,
        digits=17,
        headline=(*headline.split(), shown or table),
        listing=True,
    )


FAMILIES = {
    "convert": Family(
        "convert",
        "Convert a quantity to other units, exactly.",
        Task(
            "",
            "Convert a quantity to one or several units, correctly rounded.",
            Model(
                "exact unit table",
                "dynamics_cli.convert.conversion:convert",
                source=TABLE,
                formula=(
                    "{results.value|y} = {inputs.value|x}·{factor|k} + {offset|b} (exactly {exact_value|y})",
                    "{results.value|y} = {inputs.value|x}·{factor|k} (exactly {exact_value|y})",
                    "{results.value|y} = f({inputs.value|x}) (exactly {exact_value|y})",
                ),
                assumptions=("lb is a mass or a force, as the target unit requires", "a conversion rounds once"),
                method="exact rational arithmetic",
            ),
            headline=("value:-", "values:-"),
            columns=True,
            examples=(
                "dynamics convert 60 mph ft/s km/h",
                "dynamics convert \"6'2 1/2\\\"\" cm",
                "dynamics convert 60 mph ft/s",
                'dynamics convert "60 mph to m/s"',
                'dynamics convert "1.8796 m" "ft;in"',
                "dynamics convert 30 mpg L/100km",
                "dynamics convert 150 lbf kg --weight",
                'dynamics convert --rows messy.csv --column "speed=m/s" --column "mass=kg"',
            ),
            arrays=False,
            tracked=False,
            digits=17,
        ),
    ),
    "units": Family(
        "units",
        "List, show and search units; the book's conversion table.",
        _list(
            "list", "List the common units, all or of one kind.", "list_units", "units", TABLE,
            'dynamics units list --kind torque',
        ),
        _list(
            "show", "Show what a unit means, exactly, and what it converts to.", "show_unit", "readings", TABLE,
            "dynamics units show slug",
        ),
        _list(
            "search", "Search units by any part of a name or kind.", "search_units", "units", TABLE,
            "dynamics units search mile",
        ),
        _list(
            "table", "Print a published conversion table beside the exact factors.", "book_table", "rows",
            "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, table 1.7.1",
            "dynamics units table josephs-huston --table rows --format csv",
            headline="misprints inexact",
            shown="rows: as printed, beside the exact factors | from_unit, to_unit, printed, factor",
        ),
    ),
    "coords": Family(
        "coords",
        "Cartesian, cylindrical and spherical coordinates.",
        Task(
            "",
            "Convert a point between Cartesian, cylindrical and spherical coordinates.",
            Model(
                "the book's coordinates",
                "dynamics_cli.convert.coordinates:coords",
                source="Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6",
                formula="x = r·cosθ = ρ·sinφ·cosθ, y = r·sinθ = ρ·sinφ·sinθ, z = ρ·cosφ",
                assumptions=("φ is measured from the z-axis, θ in the x–y plane from x",),
            ),
            headline=(
                "x", "y", "rho: distance from the origin ρ", "phi: angle from the z-axis φ",
                "r: distance from the axis r", "theta: angle in the x–y plane θ", "z",
            ),
            examples=(
                "dynamics coords 3 1 4 --from cartesian --into spherical",
                'dynamics coords "4 m" "30 deg" "2 m" --from cylindrical --into cartesian',
            ),
            arrays=False,
            tracked=False,
        ),
    ),
}  # fmt: skip
