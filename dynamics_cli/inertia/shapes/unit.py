"""What a shape says of itself: its measure, and mass centre and second moments for a mass of one."""

from dynamics_cli.inertia.lump import Lump, scaled, symmetric

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Vector

# Numbers of half and quarter circles, of which subtraction would cost digits.
PI = 3.141592653589793
FOUR_THIRDS_OVER_PI = 0.4244131815783876  # 4/(3π)
TWO_OVER_PI = 0.6366197723675814  # 2/π
HALF_RING = 0.09471526543064891  # 1/2 − 4/π²
QUARTER_RING = -0.08697484838556041  # 1/π − 4/π²
HALF_DISK = 0.06987345130251063  # 1/4 − 16/(9π²)
QUARTER_DISK = -0.020971605605594034  # 1/(2π) − 16/(9π²)


class Unit:
    """A shape of mass one in its own frame: `measure` is its volume, area or length."""

    __slots__ = ("centroid", "measure", "second")

    def __init__(
        self,
        measure: float,
        centroid: "Vector",
        xx: float,
        yy: float,
        zz: float,
        xy: float = 0.0,
        yz: float = 0.0,
        zx: float = 0.0,
    ) -> None:
        # dividing by one changes no bit and counts a rounding: that of the constants in the formulas, of π above all
        self.measure = measure / 1.0 / 1.0
        self.centroid = (centroid[0] / 1.0, centroid[1] / 1.0, centroid[2] / 1.0)
        self.second = symmetric(xx / 1.0, yy / 1.0, zz / 1.0, xy / 1.0, yz / 1.0, zx / 1.0)

    def lump(self, mass: float) -> Lump:
        """The shape with a mass."""
        return Lump(mass, self.centroid, scaled(mass, self.second))


CENTRE: "Vector" = (0.0, 0.0, 0.0)
