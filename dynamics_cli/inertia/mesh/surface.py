"""What is reported of the surface of a mesh, beside the mass properties of what it bounds."""

from dynamics_cli.quantities import Area, Count, PartPosition, Ratio, Text, Volume
from dynamics_cli.records import Choice, record


class LengthUnit(Choice):
    """The unit of length of a file that does not say it."""

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
    """What is wrong with a surface, counted.

    Parameters
    ----------
    vertices : Count
        Different corners.
    edges : Count
        Different edges.
    shells : Count
        Pieces that hang together by edges.
    open_edges : Count
        Edges of one triangle only.
    clashing_edges : Count
        Edges of two triangles or more, gone along unequally often each way: beside a flipped triangle, for one.
    flipped : Count
        Triangles turned against most of their piece.
    duplicated : Count
        Triangles that have the corners of an earlier one.
    degenerate : Count
        Triangles with two equal corners, or three on a line.
    places : tuple of Text
        Where the first few of each are, in the file's numbers; triangles are counted from 1.
    """

    vertices: Count
    edges: Count
    shells: Count
    open_edges: Count
    clashing_edges: Count
    flipped: Count
    duplicated: Count
    degenerate: Count
    places: tuple[Text, ...]


@record
class Surface:
    """The surface that was read.

    Parameters
    ----------
    form : Text
        The form of the file.
    triangles : Count
        Number of triangles.
    area : Area
        Area of the surface [m^2].
    closed : Text
        Whether every edge is met by one the other way.
    closure : Ratio
        Length of the vector sum of all triangle areas over their sum: 0 for a closed surface, and for some open ones.
    low : PartPosition
        Least coordinates [m].
    high : PartPosition
        Greatest coordinates [m].
    quantisation : Volume
        Standard deviation of the volume from rounding corners to single precision, by order of magnitude [m^3].
    faults : Faults
        The diagnosis, when asked for.
    """

    form: Text
    triangles: Count
    area: Area
    closed: Text
    closure: Ratio
    low: PartPosition
    high: PartPosition
    quantisation: Volume | None = None
    faults: Faults | None = None
