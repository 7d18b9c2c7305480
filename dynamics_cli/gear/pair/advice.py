"""Advice on a pair of gears: interference, contact ratio, overlap, and the remedies."""

from math import ceil

from dynamics_cli.errors import worded
from dynamics_cli.gear.pair.engagement import Engagement
from dynamics_cli.gear.pair.interference import PROFILES, Verdict
from dynamics_cli.gear.pair.shift_split import pointed_diameter
from dynamics_cli.gear.single.limits import least_shift
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Ratio, Size
from dynamics_cli.records import Advice

# What each verdict of `interference.verdicts` means, the two gears in its order of naming.
INTERFERENCE = {
    "involute": "the {tip} gear's tip passes the {root} gear's base circle, by {overlap} along the path of contact",
    "root": "the {tip} gear's tip passes the end of the {root} gear's involute, by {overlap} along the path of contact",
    "tip clearance": "the {tip} gear's tip circle overlaps the {root} gear's root circle by {overlap}",
    "profiles": "the {tip} gear's tip overlaps the {root} gear's fillet by {overlap}",
    "trochoid": "the tips of pinion and ring overlap by {overlap} (trochoid interference)",
    "trimming": "the pinion does not pass radially into the ring: the teeth overlap by {overlap} (trimming)",
}


def pair_advice(
    mesh: Engagement, transverse: float, backlash: float, interference: tuple[Verdict, ...], thinned: tuple[float, ...]
) -> tuple[Advice, ...]:
    """Advice on what is wrong with a pair, or close to it."""
    advice = [*_interference(mesh, interference), *_contact_ratio(mesh, transverse)]
    if plain(backlash) < 0.0 and plain(backlash) < -1e-12 * plain(mesh.first.module):
        advice.append(
            Advice(
                "no-backlash", worded("the teeth overlap by {backlash}", backlash=(-plain(backlash), Size)), "serious"
            )
        )
    if plain(mesh.angle) < 0.02:
        message = worded(
            "the working pressure angle is only {angle}: a small change of the profile shifts changes the centre "
            "distance many times as much",
            angle=(plain(mesh.angle), Angle),
        )
        advice.append(Advice("flat-action", message))
    return (*advice, *_pointed(mesh, thinned))


def _interference(mesh: Engagement, verdicts: tuple[Verdict, ...]) -> "list[Advice]":
    """One piece of advice for each verdict that is not free."""
    # Where the cut profiles were examined, they decide whether a tip that passes the other's involute overlaps.
    examined = [verdict.free for verdict in verdicts if verdict.kind.startswith(PROFILES)]
    mild = ("root", "trimming", *(("involute",) if examined else ()))
    advice = []
    for verdict in verdicts:
        if verdict.free:
            continue
        name = next(name for name in INTERFERENCE if verdict.kind.startswith(name))
        order = ("second", "first") if verdict.kind.find("second") < verdict.kind.find("first") else ("first", "second")
        template = INTERFERENCE[name]
        if name in ("involute", "root") and examined and all(examined):
            template += "; the teeth do not overlap, but contact " + (
                "begins late" if order[0] == "second" else "ends early"
            )
        message = worded(template, tip=order[0], root=order[1], overlap=(-plain(verdict.margin), Size))
        remedy = "change the profile shifts, shorten the tips, or choose other tooth numbers"
        if name == "trimming":
            remedy = "assemble the pinion along its axis"
        elif name in ("involute", "root"):
            remedy = _without_undercut(mesh, order[1]) or remedy
        advice.append(Advice("interference", message, "caution" if name in mild else "serious", remedy))
    return advice


def _without_undercut(mesh: Engagement, root: str) -> str | None:
    """The shift at which the rack no longer undercuts the gear: no external mate reaches as deep as a rack."""
    gear, mate = (mesh.first, mesh.second) if root == "first" else (mesh.second, mesh.first)
    if gear.internal or mate.internal or plain(gear.shift) >= plain(least_shift(gear)):
        return None
    shift = ceil(1e3 * plain(least_shift(gear))) / 1e3
    return worded("give the {root} gear a profile shift of {shift} or more", root=root, shift=(shift, Ratio))


def _contact_ratio(mesh: Engagement, transverse: float) -> "list[Advice]":
    if plain(transverse) >= 1.0:
        return []
    message = worded(
        "the transverse contact ratio is {transverse:6}, below 1: contact is lost between one pair of teeth and the "
        "next, over {missing:6} of the path",
        transverse=(plain(transverse), Ratio),
        missing=(plain(mesh.first.base_pitch * (1.0 - transverse)), Size),
    )
    remedy = "use more teeth, a longer addendum or a smaller pressure angle"
    return [
        Advice("contact-ratio", message, "caution" if plain(mesh.first.helix_angle) else "serious", remedy),
    ]


def _pointed(mesh: Engagement, thinned: tuple[float, ...]) -> tuple[Advice, ...]:
    """Advice where thinned teeth end in a point."""
    pointed = []
    for gear, thinning in zip((mesh.first, mesh.second), thinned, strict=True):
        end = pointed_diameter(gear, thinning)
        if end is not None and abs(plain(end) - plain(gear.tip_diameter)) <= 1e-12 * abs(plain(end)):
            message = worded(
                "the thinned {teeth} teeth end in a point at {diameter:6} diameter: contact ends there",
                teeth=abs(gear.teeth),
                diameter=(abs(plain(end)), Size),
            )
            pointed.append(
                Advice("pointed", message, "serious", "thin these teeth less, and those of the other gear more")
            )
    return tuple(pointed)
