"""Advice on a pair of gears: interference, contact ratio, overlap, and the remedies."""

from dynamics_cli.errors import worded
from dynamics_cli.gear.pair.engagement import Engagement
from dynamics_cli.gear.pair.interference import PROFILES, Verdict
from dynamics_cli.gear.pair.shift_split import pointed_diameter
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Ratio, Size
from dynamics_cli.records import Advice


def pair_advice(
    mesh: Engagement, transverse: float, backlash: float, interference: tuple[Verdict, ...], thinned: tuple[float, ...]
) -> tuple[Advice, ...]:
    """Advice on what is wrong with a pair, or close to it."""
    # where no exact roots were looked at, a tip that passes the other's involute counts as an overlap
    short = ("root", "trimming") + (("involute",) if any(v.kind.startswith(PROFILES) for v in interference) else ())
    advice = [
        Advice(
            "interference",
            worded("{kind}: overlap of {margin}", kind=verdict.kind, margin=(-plain(verdict.margin), Size)),
            "caution" if verdict.kind.startswith(short) else "serious",
            "assemble the pinion along its axis"
            if verdict.kind.startswith("trimming")
            else "change the profile shifts, shorten the tips, or choose other tooth numbers",
        )
        for verdict in interference
        if not verdict.free
    ]
    if plain(transverse) < 1.0:
        advice.append(
            Advice(
                "contact-ratio",
                worded(
                    "the transverse contact ratio is {transverse:6}, below 1: contact is lost between one pair of "
                    "teeth and the next",
                    transverse=(plain(transverse), Ratio),
                ),
                "serious" if plain(mesh.first.helix_angle) == 0.0 else "caution",
                worded(
                    "the path of contact lacks {missing}",
                    missing=(plain(mesh.first.base_pitch * (1.0 - transverse)), Size),
                ),
            )
        )
    if plain(backlash) < 0.0 and plain(backlash) < -1e-12 * plain(mesh.first.module):
        advice.append(
            Advice(
                "no-backlash", worded("the teeth overlap by {backlash}", backlash=(-plain(backlash), Size)), "serious"
            )
        )
    if plain(mesh.angle) < 0.02:
        message = worded(
            "the working pressure angle is only {angle}: small changes of the profile shifts change the "
            "centre distance by a large "
            "factor",
            angle=(plain(mesh.angle), Angle),
        )
        advice.append(Advice("flat-action", message))
    return (*advice, *_pointed(mesh, thinned))


def _pointed(mesh: Engagement, thinned: tuple[float, ...]) -> tuple[Advice, ...]:
    """Say so where thinned teeth end in a point."""
    pointed = []
    for gear, thinning in zip((mesh.first, mesh.second), thinned, strict=True):
        end = pointed_diameter(gear, thinning)
        if end is not None and abs(plain(end) - plain(gear.tip_diameter)) <= 1e-12 * abs(plain(end)):
            message = worded(
                "the thinned teeth of the gear of {teeth} end in a point at {diameter:6} diameter: the contact "
                "ends there",
                teeth=abs(gear.teeth),
                diameter=(abs(plain(end)), Size),
            )
            pointed.append(
                Advice("pointed", message, "serious", "thin its teeth less, or share it with the other gear")
            )
    return tuple(pointed)
