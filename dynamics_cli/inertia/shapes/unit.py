"""The unit form of a shape: its measure, and mass centre and second moments for a mass of 1 kg."""

from dynamics_cli.inertia.bodies.mass_moments import Lump, scaled, symmetric
from dynamics_cli.numerics.exact.constants import Constant

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Vector

# Constants of half and quarter circles whose subtraction would cost digits.
PI = Constant("3.141592653589793238462643383279502884197169399375105820974944592307816")
FIFTH = Constant("0.2")
FOUR_THIRDS = Constant("1.333333333333333333333333333333333333333333333333333333333333333333333")
TWO_THIRDS = Constant("0.6666666666666666666666666666666666666666666666666666666666666666666667")
# 4/(3π), 2/π
FOUR_THIRDS_OVER_PI = Constant("0.4244131815783875620503567023267049654252257219745505299937795841570581")
TWO_OVER_PI = Constant("0.6366197723675813430755350534900574481378385829618257949906693762355872")
# 1/2 − 4/π², 1/π − 4/π², 1/4 − 16/(9π²), 1/(2π) − 16/(9π²)
HALF_RING = Constant("0.09471526543064891422448214716108944438256490131101380461756387242330752")
QUARTER_RING = Constant("-0.08697484838556041423775032609388183154851580720807329788710143945889889")
HALF_DISK = Constant("0.06987345130251062854421428762715086417002884502711724649669505441035890")
QUARTER_DISK = Constant("-0.02097160560559403568690194900033477379551150923242630475563760153074431")


class Unit:
    """A shape with a mass of 1 kg in its own frame: `measure` is its volume, area or length."""

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
        # dividing by one changes no bit but counts a rounding, for the constants in the formulas, above all π
        self.measure = measure / 1.0 / 1.0
        self.centroid = (centroid[0] / 1.0, centroid[1] / 1.0, centroid[2] / 1.0)
        self.second = symmetric(xx / 1.0, yy / 1.0, zz / 1.0, xy / 1.0, yz / 1.0, zx / 1.0)

    def lump(self, mass: float) -> Lump:
        """The shape with a mass."""
        return Lump(mass, self.centroid, scaled(mass, self.second))


CENTRE: "Vector" = (0.0, 0.0, 0.0)
