"""Advice on a mesh: jamming, overlaps, contact cut short, and the remedies."""

from dynamics_cli.errors import worded
from dynamics_cli.gear.mesh.profile_contact import Path
from dynamics_cli.gear.single.flanks import ToothForm
from dynamics_cli.quantities import Ratio, Size
from dynamics_cli.records import Advice

# Angles and shares within this are rounding.
EXACT = 1e-12
# An overlap below this share of a module counts as contact.
OVERLAP = 1e-6


def tip_notes(first: ToothForm, second: ToothForm, distance: float) -> tuple[Advice, ...]:
    """Note that the tips are left at full height where `gear pair` shortens them."""
    rack1, rack2 = first.cutter, second.cutter
    if rack1 is None or rack2 is None:
        return ()
    change = distance - first.module * (rack1.pitch_radius + rack2.pitch_radius + rack1.shift + rack2.shift)
    if change > -1e-9 * first.module:
        return ()
    tips = [2.0 * (form.tip + change) for form in (first, second)]
    message = worded(
        "the tips are full height; gear pair shortens them by {change:6} to keep the tip clearance",
        change=(-change, Size),
    )
    remedy = worded(
        'give --first-tip-diameter "{first:9}" --second-tip-diameter "{second:9}"',
        first=(tips[0], Size),
        second=(tips[1], Size),
    )
    return (Advice("full-tips", message, "note", remedy),)


def advice(
    path: Path,
    ratio: float,
    backlash: float,
    gaps: "dict[str, float]",
    clearances: tuple[float, float],
    first: ToothForm,
) -> tuple[Advice, ...]:
    """Faults of a mesh, and contact that ends elsewhere than at the tips."""
    advices = []
    if ratio < 1.0:
        text = worded(
            "the contact ratio is {ratio:6}: contact is lost between one pair of teeth and the next",
            ratio=(ratio, Ratio),
        )
        remedy = "bring the gears closer together, or give them longer teeth"
        advices.append(Advice("open-mesh", text, "serious", remedy))
    if backlash < -EXACT:
        text = worded("the teeth are {backlash:6} too thick along the line of action", backlash=(-backlash, Size))
        advices.append(Advice("jam", text, "serious", "raise the centre distance, or lower the profile shifts"))
    for where, gap in gaps.items():
        if gap < -OVERLAP * first.module:
            text = worded("{where}: the profiles overlap by {gap:6}", where=where, gap=(-gap, Size))
            advices.append(Advice("interference", text, "serious", "shorten the tips"))
    for which, clearance in zip(("gear 1", "gear 2"), clearances, strict=True):
        if clearance < 0.0:
            text = worded(
                "the tips of {which} reach {clearance:6} into the root circle",
                which=which,
                clearance=(-clearance, Size),
            )
            advices.append(Advice("tip-clearance", text, "serious", "shorten the tips"))
    for lost, where in (
        (path.start - path.tip_start, "contact is lost over {lost:6}: the tip of gear 2 reaches below gear 1's"),
        (path.tip_end - path.end, "contact is lost over {lost:6}: the tip of gear 1 reaches past gear 2's"),
    ):
        if lost > EXACT:
            advices.append(Advice("clipped", worded(where + " form circle", lost=(lost, Size))))
    return tuple(advices)


def tips_meet(overlap: float) -> tuple[Advice, ...]:
    """Advice that tips cut into flanks off the line of action."""
    message = worded(
        "off the line of action the tips overlap the flanks they pass by {overlap:6}", overlap=(overlap, Size)
    )
    return (Advice("tip-interference", message, "serious", "shorten the tips, or make the tooth numbers differ more"),)
