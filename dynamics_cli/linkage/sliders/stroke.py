"""Over a whole turn of a slider-crank: stroke, dead centres, time ratio, and where the slider is fastest."""

from math import pi, tau

from dynamics_cli.numerics.elementary import absolute, asin, atan2, pi_beside, sqrt, where
from dynamics_cli.numerics.number import decides, plain
from dynamics_cli.numerics.roots import sign_change
from dynamics_cli.numerics.turns import turned
from dynamics_cli.records import Choice
from dynamics_cli.sampling import drawing, kept

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Step of the difference at the largest speed.
STEP = 1e-4
# Newton's steps from the mean of samples.
NEWTON = 6


class End(Choice):
    """Side of the crank pin on which the slider is."""

    names = ("right", "left")
    aliases = {"+": "right", "-": "left", "−": "left"}  # noqa: RUF012


RIGHT = End("right")


def stroke_of(a: float, b: float, e: float, side: float) -> "dict[str, Any]":
    """Stroke, dead centres and time ratio of a crank that turns fully; of samples where every one does.

    A slider on the left (side −1) is the mirror image: crank angles are 180° less those on the right.
    """
    size = absolute(e)
    full = b > a + size
    if not (full if decides(full) else full.all()):  # type: ignore[attr-defined]
        return {}
    pi = pi_beside(a, b, e)
    far = sqrt((b + a - size) * (b + a + size))
    near = sqrt((b - a - size) * (b - a + size))
    stroke = 4.0 * a * b / (far + near)
    lead = atan2(size * stroke, far * near + e * e)
    return {
        "stroke": stroke,
        "time_ratio": (pi + lead) / (pi - lead),
        "outer_at": 0.5 * (1.0 - side) * pi + side * atan2(e, far),
        "inner_at": 0.5 * (1.0 + side) * pi + side * atan2(e, near),
        "largest_rod_angle": asin((a + size) / b),
    }


def slopes_at(a: float, b: float, e: float, side: float, turn: "tuple[float, float]") -> "tuple[float, float]":
    """dx/dθ and d²x/dθ²."""
    height = e - a * turn[1]
    reach = side * sqrt((b - height) * (b + height))
    lean = -(a * turn[0] / reach)
    bend = (a * turn[1] + lean * lean * height) / reach
    return -(a * turn[1]) - lean * height, -(a * turn[0]) - lean * lean * reach - bend * height


def fastest(a: float, b: float, e: float, side: float, speed: "float | None") -> "dict[str, Any]":
    """The largest |dx/dθ| of a crank that turns fully, where the acceleration vanishes, and its angle.

    Of samples that of the first ones' mean lengths is found once, and Newton's steps lead from it to each one's own.
    """
    if not drawing():
        low, curve = _nominal(plain(a), plain(b), plain(e), side)
    else:
        side = 1.0 if _mean(side) >= 0.0 else -1.0
        low, curve = kept().get("fastest") or kept().setdefault("fastest", _nominal(_mean(a), _mean(b), _mean(e), side))
    angle = low + 0.0 * (a + b + e)
    for _ in range(NEWTON if drawing() else 1):
        # one step of Newton carries bounds and derivatives by the lengths into the angle
        slope, bend = slopes_at(a, b, e, side, turned(angle))
        angle = angle - bend / curve
    fields = {"top_slope": absolute(slope), "top_at": angle}
    return fields if speed is None else fields | {"top_speed": absolute(slope) * absolute(speed)}


def _nominal(a: float, b: float, e: float, side: float) -> "tuple[float, float]":
    """The angle of the largest |dx/dθ| of one mechanism, and the third derivative of x there.

    It is in the quick stroke, where the acceleration vanishes once: for a slider on the right and e ≤ 0 in the upper
    half of the turn, other mechanisms are mirror images. The cosine is found, so that no step takes a sine.
    """
    low = -absolute(e)

    def bend(cosine: float) -> float:
        return slopes_at(a, b, low, 1.0, (cosine, sqrt((1.0 - cosine) * (1.0 + cosine))))[1]

    cosine = sign_change(bend, -sqrt((b - a + low) * (b - a - low)) / (b - a), 1.0)
    angle = atan2(sqrt((1.0 - cosine) * (1.0 + cosine)), cosine)
    angle = where(e > 0.0, tau - angle, angle)
    if side < 0.0:
        angle = where(e > 0.0, pi + tau - angle, pi - angle)
    ahead, behind = (slopes_at(a, b, e, side, turned(angle + step))[1] for step in (STEP, -STEP))
    return angle, (ahead - behind) / (2.0 * STEP)


def _mean(length: float) -> float:
    """The mean of samples; one number as it is."""
    return float(length.mean()) if getattr(length, "ndim", 0) else length  # type: ignore[attr-defined]
