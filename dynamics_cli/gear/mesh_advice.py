"""What is said of a mesh: what jams, overlaps, or is cut off, and what mends it."""

from dynamics_cli.gear.contact import Path
from dynamics_cli.gear.flanks import ToothForm
from dynamics_cli.records import Advice

# Angles and shares within this are rounding.
EXACT = 1e-12
# An overlap below this share of a module is none.
OVERLAP = 1e-6


def tip_notes(first: ToothForm, second: ToothForm, distance: float) -> tuple[Advice, ...]:
    """Say so when the tips are left at full height where `gear pair` shortens them."""
    one, two = first.cutter, second.cutter
    if one is None or two is None:
        return ()
    change = distance - first.module * (one.pitch_radius + two.pitch_radius + one.shift + two.shift)
    if change > -1e-9 * first.module:
        return ()
    tips = [2e3 * (form.tip + change) for form in (first, second)]
    return (
        Advice(
            "full-tips",
            f"the tips are full height; gear pair shortens them by {-1e3 * change:.6g} mm to keep the tip clearance",
            "note",
            f'for its tips --first-tip-diameter "{tips[0]:.9g} mm" --second-tip-diameter "{tips[1]:.9g} mm"',
        ),
    )


def advice(
    path: Path,
    ratio: float,
    backlash: float,
    gaps: "dict[str, float]",
    clearances: tuple[float, float],
    first: ToothForm,
) -> tuple[Advice, ...]:
    """What is wrong with a mesh, or has an end other than the tips'."""
    found = []
    if ratio < 1.0:
        found.append(
            Advice(
                "open-mesh",
                f"the contact ratio is {ratio:.6g}: between one pair of teeth and the next nothing is in contact",
                "serious",
                "bring the gears closer together, or give them higher teeth",
            )
        )
    if backlash < -EXACT:
        found.append(
            Advice(
                "jam",
                f"the teeth are {-1e3 * backlash:.6g} mm too thick along the line of action",
                "serious",
                "raise the centre distance, or lower the profile shifts",
            )
        )
    for where, gap in gaps.items():
        if gap < -OVERLAP * first.module:
            found.append(
                Advice(
                    "interference",
                    f"{where}: the profiles overlap by {-1e3 * gap:.6g} mm",
                    "serious",
                    "shorten the tips",
                )
            )
    for which, clearance in zip(("gear 1", "gear 2"), clearances, strict=True):
        if clearance < 0.0:
            message = f"the tips of {which} reach {-1e3 * clearance:.6g} mm into the root circle"
            found.append(Advice("tip-clearance", message, "serious", "shorten the tips"))
    if path.start > path.tip_start + EXACT:
        lost = 1e3 * (path.start - path.tip_start)
        found.append(
            Advice(
                "clipped", f"the tip of gear 2 meets no involute for {lost:.6g} mm: it is below gear 1's form circle"
            )
        )
    if path.end < path.tip_end - EXACT:
        lost = 1e3 * (path.tip_end - path.end)
        found.append(
            Advice("clipped", f"the tip of gear 1 meets no involute for {lost:.6g} mm: it is past gear 2's form circle")
        )
    return tuple(found)


def tips_meet(overlap: float) -> tuple[Advice, ...]:
    """That tips trim flanks off the line of action."""
    message = f"off the line of action the tips overlap the flanks they pass by {1e3 * overlap:.6g} mm"
    return (Advice("tip-interference", message, "serious", "shorten the tips, or make the tooth numbers differ more"),)
