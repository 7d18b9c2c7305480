"""Distances of a mesh between points of both outlines."""

from math import acos, pi

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def mesh_by_polygons(points: int = 101, shown: int = 3, **given: "Any") -> "dict[str, float]":
    """Distances from the roots between points: both outlines within a micrometre a metre of module, turned in steps."""
    import numpy as np

    from dynamics_cli.gear import options
    from dynamics_cli.gear.mesh.mesh import forms_of, without_backlash
    from dynamics_cli.gear.mesh.profile_contact import half_play, path_of_contact
    from dynamics_cli.gear.single.flanks import flank
    from dynamics_cli.gear.single.rack import FULL_DEPTH

    distance = given.pop("centre_distance", None)
    usual = {
        "profile": options.RACK_A, "shift_sign": options.ISO, "pressure_angle": FULL_DEPTH, "helix_angle": 0.0,
        "addendum_factor": None, "dedendum_factor": None, "root_radius_factor": None,
        "first_tip_diameter": None, "second_tip_diameter": None,
    }  # fmt: skip
    first, second = forms_of(**{**usual, **given})
    if first.internal or second.internal:
        raise ArithmeticError
    apart = without_backlash(first, second) if distance is None else distance
    play = max(half_play(first, second, path_of_contact(first, second, apart)), 0.0)
    found = {}
    for name, one, two, turned in (
        ("first_in_second", first, second, play),
        ("second_in_first", second, first, play * second.teeth / first.teeth),
    ):
        if apart - one.tip > two.form:
            continue
        chain = flank(two, 1e-4 * two.module)
        below = chain.joint + 1
        root = chain.radius[:below] * np.exp(1j * (pi / two.teeth - chain.angle[:below]))
        half = one.half_angle(one.roll(one.tip))
        reach = acos(min((one.tip**2 + apart**2 - two.tip**2) / (2.0 * one.tip * apart), 1.0)) + half
        turns = np.linspace(-reach, reach, 1001)[:, None]
        edge = (apart - one.tip * np.exp(1j * (turns + half))) * np.exp(1j * (turns * one.teeth / two.teeth - turned))
        found[name] = float(
            min(apart - one.tip - two.root, *(np.abs(edge - root).min(), np.abs(edge.conj() - root).min()))
        )
    return found
