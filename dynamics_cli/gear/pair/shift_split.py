"""From the inputs to an engagement: the centre distance from the shifts, or the shifts from the centre distance."""

from dynamics_cli.errors import require
from dynamics_cli.gear.pair.engagement import (
    Engagement,
    angle_at,
    at_tight_distance,
    needed_shift,
    reference_distance,
    require_partners,
    specific_sliding,
    tight_involute,
)
from dynamics_cli.gear.rounding import bare
from dynamics_cli.gear.single.gear import Gear, require_circles
from dynamics_cli.gear.single.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import absolute, cos
from dynamics_cli.numerics.involute import inverse_involute, involute
from dynamics_cli.numerics.number import like, plain
from dynamics_cli.numerics.roots import sign_change
from dynamics_cli.quantities import Ratio, Size
from dynamics_cli.records import Choice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.gear.pair.records import Mate

ROUNDING = 1e-15


class Split(Choice):
    """How the sum of profile shifts is divided between two gears."""

    names = ("equal", "by-teeth", "first", "second", "balanced-sliding")
    aliases = {"half": "equal", "pinion": "first", "gear": "second", "wheel": "second", "sliding": "balanced-sliding"}  # noqa: RUF012


class Tips(Choice):
    """Whether the tips are shortened to keep the tip clearance of the rack."""

    names = ("clearance", "full")
    aliases = {"shortened": "clearance", "khk": "clearance", "nominal": "full"}  # noqa: RUF012


def engaged(
    first: Gear, second: Gear, mate1: "Mate", mate2: "Mate", centre_distance: float | None, split: str, tips: str
) -> tuple[Engagement, float | None]:
    """The gears with their final shifts and tips at their centre distance, and the change k of the tips."""
    require_partners(first, second)
    if centre_distance is None:
        mesh = at_tight_distance(first, second)
        return _tipped(mesh, mate1, mate2, tips)
    distance = -centre_distance if second.internal else centre_distance
    angle = angle_at(first, second, distance)
    if mate1.profile_shift is not None and mate2.profile_shift is not None:
        tight = tight_involute(first, second)
        return _tipped(Engagement(first, second, distance, angle, tight), mate1, mate2, tips)
    total = needed_shift(first, second, angle)
    if mate1.profile_shift is not None:
        shifts = mate1.profile_shift, total - mate1.profile_shift
    elif mate2.profile_shift is not None:
        shifts = total - second.shift, second.shift
    else:
        shifts = _divided(first, second, distance, angle, total, split, (mate1, mate2, tips))
    shifted = Engagement(first.shifted(shifts[0]), second.shifted(shifts[1]), distance, angle, involute(angle))
    return _tipped(shifted, mate1, mate2, tips)


def _divided(
    first: Gear, second: Gear, distance: float, angle: float, total: float, split: str, mates: "tuple[Mate, Mate, str]"
) -> tuple[float, float]:
    if split == "first":
        return total, 0.0 * total
    if split == "second":
        return 0.0 * total, total
    if split == "by-teeth":
        shift = total * (first.teeth / (first.teeth + second.teeth))
        return shift, total - shift
    if split == "balanced-sliding":
        shift = _balanced(first, second, distance, angle, total, mates)
        return shift, total - shift
    return 0.5 * total, 0.5 * total


def _balanced(
    first: Gear, second: Gear, distance: float, angle: float, total: float, scheme: "tuple[Mate, Mate, str]"
) -> float:
    """x₁ with equal maximum sliding of both gears: ζ₁ at A equals ζ₂ at E."""

    def difference(
        shift: float, gear1: Gear, gear2: Gear, a: float, alpha: float, total_x: float, mates: "tuple[Mate, Mate, str]"
    ) -> float:
        mesh = Engagement(gear1.shifted(shift), gear2.shifted(total_x - shift), a, alpha, 0.0)
        mesh, _ = _tipped(mesh, *mates, check=False)
        end = 0.5 * mesh.first.base_diameter * mesh.first.tip_roll
        start = mesh.line - 0.5 * mesh.second.base_diameter * mesh.second.tip_roll
        # where a path reaches a base circle its sliding is unbounded
        at_start = specific_sliding(mesh, start)[0] if plain(start) > 0.0 else -1e9 + 1e12 * start
        at_end = specific_sliding(mesh, end)[1] if plain((mesh.line - end) * mesh.ratio) > 0.0 else -1e9
        return at_end - at_start  # type: ignore[operator]

    doubles = *(bare(gear1) for gear1 in (first, second, distance, angle, total)), (*map(bare, scheme[:2]), scheme[2])
    grid = [-1.0 + 0.05 * k for k in range(61)]
    values: list[float | None] = []
    for shift in grid:
        try:
            values.append(difference(shift, *doubles))
        except ArithmeticError:
            values.append(None)
        except Exception as error:
            if getattr(error, "status", None) != 3:
                raise
            values.append(None)
    for low, high, a, b in zip(grid, grid[1:], values, values[1:], strict=False):
        if a is not None and b is not None and a > 0.0 >= b and max(abs(a), abs(b)) < 1e3:
            root = sign_change(lambda shift: difference(shift, *doubles), low, high)
            slope = (difference(root + 1e-5, *doubles) - difference(root - 1e-5, *doubles)) / 2e-5
            start: float = like(root, total)
            return start - difference(start, first, second, distance, angle, total, scheme) / slope
    require(
        False,
        "no profile shift of the first gear between -1 and 2 balances the sliding",
        code="no-balance",
        hint="choose another split",
    )
    return total


def pointed_diameter(gear: Gear, thinning: float) -> float | None:
    """Where both flanks of a thinned tooth meet (ISO 21771): inv α_p = ψ_b − A_sn/(m_n z); None if they do not meet.

    The tip land of the unthinned tooth has been checked before.
    """
    half = gear.base_half_angle - thinning / gear.module / gear.teeth
    if plain(thinning) <= 0.0 or plain(half) <= 0.0:
        return None
    return gear.base_diameter / cos(inverse_involute(half))


def _require_thickness(gear: Gear, thinning: float) -> None:
    """Refuse a thinning that leaves no tooth where the involute begins; the reference circle may be elsewhere."""
    if plain(thinning) <= 0.0:
        return
    roll = gear.roll(gear.root_diameter) if gear.internal else gear.junction.roll
    most = gear.module * gear.teeth * (gear.base_half_angle - roll_less_arc(roll))
    require(
        thinning < most,
        "a thinning of {thinning:6} is too large: the teeth vanish at {most:6}",
        most=(plain(most), Size),
        thinning=(plain(thinning), Size),
        code="thinning",
        hint="thinning is a small allowance for backlash, such as 0.05 mm",
    )


def _tipped(
    mesh: Engagement, mate1: "Mate", mate2: "Mate", tips: str, check: bool = True
) -> tuple[Engagement, float | None]:
    """The engagement with its tips as given, shortened, or as cut by the rack."""
    first, second = mesh.first, mesh.second
    change = None
    if tips == "clearance":
        shifted = reference_distance(first, second) + first.module * (first.shift + second.shift)
        change = (mesh.centre_distance - shifted) / first.module
        # at the reference distance the remainder is rounding
        if plain(change) >= -ROUNDING * abs(plain(mesh.centre_distance)) / plain(first.module):
            change = None
    if check and change is not None:
        require(
            first.rack.addendum + first.rack.dedendum + change > 0.0,
            "at this centre distance, with profile shifts that add up to {shifts:6}, the tips are shortened by "
            "{change:6} modules: more than the whole tooth",
            shifts=(plain(first.shift + second.shift), Ratio),
            change=(-plain(change), Ratio),
            code="no-tooth",
            hint="bring the gears closer together, or take more teeth or a larger module",
        )
    gears = []
    for gear, mate in ((first, mate1), (second, mate2)):
        tipped = gear.shifted(gear.shift, 0.0 if change is None else change)
        if mate.tip_diameter is not None:
            tipped = gear.tipped(mate.tip_diameter)
        if check:
            require_circles(tipped)
            thickness = tipped.tip_thickness
            require(
                thickness >= 0.0,
                "the {teeth} teeth are pointed before they reach the tip diameter of {diameter:6}",
                teeth=abs(gear.teeth),
                diameter=(plain(absolute(tipped.tip_diameter)), Size),
                code="pointed",
                hint="lower the profile shift, or give a smaller tip diameter",
            )
            _require_thickness(tipped, mate.thinning)
        point = pointed_diameter(tipped, mate.thinning)
        if point is not None and plain(point) < plain(tipped.tip_diameter):
            tipped = gear.shifted(gear.shift, tipped.tip_change + 0.5 * (point - tipped.tip_diameter) / gear.module)
        gears.append(tipped)
    both_given = mate1.tip_diameter is not None and mate2.tip_diameter is not None
    shortened = Engagement(gears[0], gears[1], mesh.centre_distance, mesh.angle, mesh.tight)
    return shortened, None if both_given else change
