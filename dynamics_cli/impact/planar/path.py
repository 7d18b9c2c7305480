"""The closed-form path of a planar impact with friction (Routh, Keller): slip, then stick or reversed slip, to its end.

Everything is in the contact's frame: u = (u_t, u_n) is the velocity of body 1 relative to body 2 there, the normal
points at body 1, so u_n < 0 approaches; p = (p_t, p_n) acts on body 1 and u grows by K p, K = [[k_t, k_x], [k_x, k_n]].
Every function takes single numbers, arrays and tracked numbers.
"""

from dynamics_cli.numerics.elementary import absolute, maximum, multiply_add, sqrt, where
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record


@record
class Mobility:
    """Change of velocity at the contact per impulse: the matrix K and its determinant."""

    tangential: Annotated[float, "k_t, tangential velocity per tangential impulse [1/kg]."]
    coupling: Annotated[float, "k_x, normal velocity per tangential impulse and the other way round [1/kg]."]
    normal: Annotated[float, "k_n, normal velocity per normal impulse [1/kg]."]
    determinant: Annotated[float, "k_t k_n − k_x², above zero [1/kg²]."]


@record
class Path:
    """The end of an impact, and its history."""

    normal: Annotated[float, "Normal impulse p_n [N·s]."]
    tangential: Annotated[float, "Tangential impulse p_t [N·s]."]
    compression: Annotated[float, "Normal impulse at the greatest compression [N·s]."]
    first_slip: Annotated[float, "Normal impulse while the first slip lasted [N·s]."]
    normal_after: Annotated[float, "u_n at the end [m/s]."]
    tangential_after: Annotated[float, "u_t at the end; exactly zero after stick [m/s]."]
    compression_work: Annotated[
        float, "Work of the normal force until the greatest compression, as a positive number [J]."
    ]
    restitution_work: Annotated[float, "Work it gave back [J]."]
    friction_work: Annotated[float, "Work that friction turned into heat [J]."]
    ended_first: Annotated[bool, "Whether the impact ended within the first slip."]
    sticks: Annotated[bool, "Whether friction can hold the contact once the slip has stopped."]
    slopes: Annotated[
        tuple[float, float], "Friction impulse per normal impulse in the first phase and in the second [-]."
    ]

    @property
    def normal_lost(self) -> float:
        """Energy that the normal force did not return."""
        return self.compression_work - self.restitution_work


def sign(x: float) -> float:
    """−1, 0 or 1, as a plain number."""
    return where(x > 0.0, 1.0, where(x < 0.0, -1.0, 0.0))


def determinant(tangential: float, coupling: float, normal: float) -> float:
    """k_t k_n − k_x², rounded as if in twice the precision, from K alone."""
    product = coupling * coupling
    lost = multiply_add(coupling, coupling, -product)
    return multiply_add(tangential, normal, -product) - lost


def travel(k: Mobility, slip: float, approach: float, friction: float, restitution: float, law: str) -> Path:
    """Follow the path from (u_t, u_n) = (`slip`, `approach`) to the end that Newton, Poisson or Stronge sets.

    Phase 1 keeps the direction of the first slip, p_t = −μ sgn(u_t) p_n, until u_t = 0; phase 2 sticks where
    |k_x| ≤ μ k_t and otherwise slips the other way. u_n is linear in p_n, with a different slope in each phase.

    References
    ----------
    J. B. Keller, Impact with friction, J. Appl. Mech. 53 (1986); W. J. Stronge, Impact Mechanics (2000).
    """
    sense = sign(slip)
    ratio = -friction * sense
    change = multiply_add(ratio, k.tangential, k.coupling)
    slope = multiply_add(ratio, k.coupling, k.normal)
    stops = (sense * change < 0.0) & (friction > 0.0)
    lasts = ((sense != 0.0) & (sense * change >= 0.0)) | (friction == 0.0)
    first = where(stops, -slip / where(stops, change, 1.0), 0.0)

    size = absolute(k.coupling)
    excess = multiply_add(-friction, k.tangential, size)
    sticks = excess <= 0.0
    over = where(sticks, 0.0, excess)
    side = sign(k.coupling)
    # a sum of positive terms, where k_n + k_x c would cancel
    later = (k.determinant + size * over) / k.tangential
    late_ratio = where(sticks, -k.coupling / k.tangential, -friction * side)

    turned = multiply_add(slope, first, approach)
    inside = lasts | (turned >= 0.0)
    safe = where(inside, slope, 1.0)
    straight = -approach / safe
    compression = where(inside, straight, first - turned / later)
    # before the turn both speeds are negative: nothing cancels
    bent = where(inside, 1.0, 0.5 * (turned * (turned / later) - (approach + turned) * first))
    work = where(inside, 0.5 * approach * (approach / safe), bent)
    total = (1.0 + restitution) * straight
    ended = inside & (lasts | (total <= first))
    if law == "newton":
        after = -restitution * approach
        beyond = -multiply_add(restitution, approach, turned) / later
        half = 0.5 * after
        back = where(inside, 0.5 * turned * (turned / safe) + 0.5 * (turned + after) * beyond, half * (after / later))
    elif law == "poisson":
        beyond = where(inside, total - first, (1.0 + restitution) * compression - first)
        rest = restitution * compression
        after = where(inside, multiply_add(later, beyond, turned), later * rest)
        back = where(inside, 0.5 * turned * (turned / safe) + 0.5 * (turned + after) * beyond, 0.5 * after * rest)
    else:
        # work left at the turn, e²|W| − u_n²/(2n), as a product
        aim = -restitution * approach
        work_left = (0.5 / safe) * maximum(-multiply_add(restitution, approach, turned), 0.0) * (aim + turned)
        start = where(inside, maximum(turned, 0.0), 0.0)
        square = multiply_add(2.0 * later, work_left, start * start)
        runs = inside & (square > 0.0)
        speed = sqrt(where(runs, square, 1.0))
        root = 2.0 * work_left / where(runs, start + speed, 1.0)
        pace = restitution * sqrt(2.0 * bent / later)
        beyond = where(inside, where(runs, root, 0.0), pace - turned / later)
        after = where(inside, where(runs, speed, 0.0), later * pace)
        back = restitution * restitution * work
    after = where(ended, -restitution * approach, after)
    back = where(ended, restitution * restitution * work, back)
    beyond = where(ended, 0.0, beyond)
    along = where(ended, total, first)
    drift = where(ended, multiply_add(change, along, slip), side * over * beyond)
    dragged = where(ended, slip + drift, slip)
    rubbed = -0.5 * (ratio * along * dragged + late_ratio * beyond * where(ended, 0.0, drift))
    return Path(
        normal=along + beyond,
        tangential=ratio * along + late_ratio * beyond,
        compression=compression,
        first_slip=along,
        normal_after=after,
        tangential_after=drift,
        compression_work=work,
        restitution_work=back,
        friction_work=rubbed,
        ended_first=ended,
        sticks=sticks,
        slopes=(ratio, late_ratio),
    )
