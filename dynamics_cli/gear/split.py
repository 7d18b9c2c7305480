"""From what was given to an engagement: the centre distance from the shifts, or the shifts from the centre distance."""

from dynamics_cli.errors import require
from dynamics_cli.gear.engagement import (
    Engagement,
    angle_at,
    at_tight_distance,
    needed_shift,
    reference_distance,
    require_partners,
    specific_sliding,
    tight_involute,
    with_shift,
)
from dynamics_cli.gear.gear import Gear, require_circles
from dynamics_cli.gear.limits import bare, bisect, plain
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.records import Choice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.gear.pair_data import Mate

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
    first: Gear,
    second: Gear,
    one: "Mate",
    two: "Mate",
    centre_distance: float | None,
    split: str,
    tips: str,
) -> tuple[Engagement, float | None]:
    """The gears with their final shifts and tips at their centre distance, and the change k of the tips."""
    require_partners(first, second)
    if centre_distance is None:
        mesh = at_tight_distance(first, second)
        return _tipped(mesh, one, two, tips)
    distance = -centre_distance if second.internal else centre_distance
    angle = angle_at(first, second, distance)
    if one.profile_shift is not None and two.profile_shift is not None:
        tight = inverse_involute(tight_involute(first, second))
        return _tipped(Engagement(first, second, distance, angle, tight), one, two, tips)
    total = needed_shift(first, second, angle)
    if one.profile_shift is not None:
        shifts = one.profile_shift, total - one.profile_shift
    elif two.profile_shift is not None:
        shifts = total - second.shift, second.shift
    else:
        shifts = _divided(first, second, distance, angle, total, split, (one, two, tips))
    made = Engagement(with_shift(first, shifts[0]), with_shift(second, shifts[1]), distance, angle, angle)
    return _tipped(made, one, two, tips)


def _divided(
    first: Gear,
    second: Gear,
    distance: float,
    angle: float,
    total: float,
    split: str,
    given: "tuple[Mate, Mate, str]",
) -> tuple[float, float]:
    if split == "first":
        return total, 0.0 * total
    if split == "second":
        return 0.0 * total, total
    if split == "by-teeth":
        own = total * (first.teeth / (first.teeth + second.teeth))
        return own, total - own
    if split == "balanced-sliding":
        own = _balanced(first, second, distance, angle, total, given)
        return own, total - own
    return 0.5 * total, 0.5 * total


def _balanced(
    first: Gear, second: Gear, distance: float, angle: float, total: float, given: "tuple[Mate, Mate, str]"
) -> float:
    """x₁ at which both gears slide alike where each slides most: ζ₁ at A equals ζ₂ at E."""

    def difference(shift: float, one: Gear, two: Gear, a: float, alpha: float, both: float) -> float:
        mesh = Engagement(with_shift(one, shift), with_shift(two, both - shift), a, alpha, alpha)
        mesh, _ = _tipped(mesh, *given, check=False)
        end = 0.5 * mesh.first.base_diameter * mesh.first.tip_roll
        start = mesh.line - 0.5 * mesh.second.base_diameter * mesh.second.tip_roll
        # where a path reaches a base circle its sliding has no bound
        at_start = specific_sliding(mesh, start)[0] if plain(start) > 0.0 else -1e9 + 1e12 * start
        at_end = specific_sliding(mesh, end)[1] if plain((mesh.line - end) * mesh.ratio) > 0.0 else -1e9
        return at_end - at_start  # type: ignore[operator]

    own = bare(first), bare(second), plain(distance), plain(angle), plain(total)
    grid = [-1.0 + 0.05 * k for k in range(61)]
    values: list[float | None] = []
    for shift in grid:
        try:
            values.append(difference(shift, *own))
        except ArithmeticError:
            values.append(None)
        except Exception as error:
            if getattr(error, "status", None) != 3:
                raise
            values.append(None)
    for low, high, a, b in zip(grid, grid[1:], values, values[1:], strict=False):
        if a is not None and b is not None and a > 0.0 >= b and max(abs(a), abs(b)) < 1e3:
            found = bisect(lambda shift: difference(shift, *own), low, high)
            slope = (difference(found + 1e-5, *own) - difference(found - 1e-5, *own)) / 2e-5
            return found - difference(found, first, second, distance, angle, total) / slope
    require(
        False,
        "no profile shift of the first gear between -1 and 2 balances the sliding",
        code="no-balance",
        hint="choose another split",
    )
    return total


def _tipped(
    mesh: Engagement, one: "Mate", two: "Mate", tips: str, check: bool = True
) -> tuple[Engagement, float | None]:
    """The engagement with its tips as they are: given, shortened, or as the rack leaves them."""
    first, second = mesh.first, mesh.second
    change = None
    if tips == "clearance":
        shifted = reference_distance(first, second) + first.module * (first.shift + second.shift)
        change = (mesh.centre_distance - shifted) / first.module
        # at the reference distance what is left is rounding
        if plain(change) >= -ROUNDING * abs(plain(mesh.centre_distance)) / plain(first.module):
            change = None
    if check and change is not None:
        require(
            first.rack.addendum + first.rack.dedendum + change > 0.0,
            "this centre distance, with profile shifts that sum to {0:.6g}, shortens the tips by {1:.6g} modules: "
            "no tooth is left",
            plain(first.shift + second.shift),
            -plain(change),
            code="no-tooth",
            hint="bring the gears closer together, or take more teeth or a larger module",
        )
    made = []
    for gear, mate in ((first, one), (second, two)):
        own = with_shift(gear, gear.shift, 0.0 if change is None else change)
        if mate.tip_diameter is not None:
            bare_tip = with_shift(gear, gear.shift).tip_diameter
            wanted = -mate.tip_diameter if gear.internal else mate.tip_diameter
            own = with_shift(gear, gear.shift, 0.5 * (wanted - bare_tip) / gear.module)
        if check:
            require_circles(own)
            thickness = own.tip_thickness
            require(
                thickness >= 0.0,
                "the teeth of the gear of {0} are pointed below their tips at {1:.6g} mm diameter",
                abs(gear.teeth),
                1e3 * plain(absolute(own.tip_diameter)),
                code="pointed",
                hint="lower its profile shift, or give a smaller tip diameter",
            )
        made.append(own)
    both_given = one.tip_diameter is not None and two.tip_diameter is not None
    shortened = Engagement(made[0], made[1], mesh.centre_distance, mesh.angle, mesh.tight_angle)
    return shortened, None if both_given else change
