"""The report of a mesh's surface, in addition to the mass properties of the body."""

from dynamics_cli.quantities import Annotated, Area, Count, PartPosition, Ratio, Text, Volume
from dynamics_cli.records import Choice, record


class LengthUnit(Choice):
    """The unit of length of a file that does not state it."""

    names = ("m", "mm", "cm", "um", "in", "ft")
    aliases = {"inch": "in", "metre": "m", "millimetre": "mm", "µm": "um", "μm": "um", "foot": "ft"}  # noqa: RUF012

    @property
    def ratio(self) -> tuple[float, float]:
        """Metres of one unit, as a fraction of whole numbers."""
        return {
            "m": (1.0, 1.0),
            "mm": (1.0, 1e3),
            "cm": (1.0, 1e2),
            "um": (1.0, 1e6),
            "in": (254.0, 1e4),
            "ft": (3048.0, 1e4),
        }[str(self)]


@record
class Faults:
    """Counts of a surface's faults."""

    vertices: Annotated[Count, "Different corners."]
    edges: Annotated[Count, "Different edges."]
    shells: Annotated[Count, "Connected pieces of the surface."]
    open_edges: Annotated[Count, "Edges of one triangle only."]
    clashing_edges: Annotated[
        Count,
        "Edges of two triangles or more that run in the same direction, as beside a flipped triangle.",
    ]
    flipped: Annotated[Count, "Triangles turned against most of their piece."]
    duplicated: Annotated[Count, "Triangles that have the corners of an earlier one."]
    repeated: Annotated[Count, "Duplicated triangles of the same orientation, which count twice."]
    degenerate: Annotated[Count, "Triangles with two equal corners, or three on a line."]
    crossing: Annotated[Count, "Triangles that an edge of another one passes through."]
    within: Annotated[
        Count,
        "Triangles of a closed surface within what the others bound: overlapping solids, an inner shell facing "
        "outwards.",
    ]
    against: Annotated[
        Count, "Triangles of a closed surface that bound from the wrong side: a shell inside out, or outside its solid."
    ]
    pairs: Annotated[Count, "Pairs of neighbouring triangles that were checked."]
    places: Annotated[
        tuple[Text, ...], "Where the first few of each are, in the file's coordinates; triangles are counted from 1."
    ]


@record
class Surface:
    """The surface that was read."""

    form: Annotated[Text, "Format of the file."]
    triangles: Annotated[Count, "Number of triangles."]
    area: Annotated[Area, "Area of the surface [m^2]."]
    closed: Annotated[Text, "Whether every edge has a neighbour of the opposite direction."]
    closure: Annotated[
        Ratio,
        "Length of the vector sum of all triangle areas over their sum: 0 for a closed surface, and for some open "
        "ones.",
    ]
    low: Annotated[PartPosition, "Minimum coordinates [m]."]
    high: Annotated[PartPosition, "Maximum coordinates [m]."]
    examined: Annotated[Text, "Whether crossings and overlaps were checked."]
    quantisation: Annotated[
        Volume | None,
        "Standard deviation of the volume from rounding corners to single precision, by order of magnitude [m^3].",
    ] = None
    faults: Annotated[
        Faults | None, "The diagnosis: always done where few triangles are near each other, else with --diagnose."
    ] = None
