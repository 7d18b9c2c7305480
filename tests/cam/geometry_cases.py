"""Random cams, and the reference cases of geometry, as the tests take them."""

import json
import random
from math import pi
from typing import Any

import numpy as np

from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.reading import Program

LAWS = (
    "cycloidal",
    "3-4-5",
    "4-5-6-7",
    "modified-sine",
    "modified-trapezoid",
    "5-6-7-8-9",
    "harmonic",
    "double-harmonic",
)
NOTHING = Program()
CYCLE = "rise 10 mm in 90 deg modified-sine; dwell 90 deg; return in 90 deg cycloidal; dwell"
STEEP = "rise 20 mm in 45 deg cycloidal; dwell 90 deg; return in 45 deg cycloidal; dwell"
SWING = "rise 15 deg in 120 deg 3-4-5; dwell 60 deg; return in 120 deg 3-4-5; dwell"


def cases(task: str = "profile") -> list[dict[str, Any]]:
    path = DATA / "cam_geometry.json"
    return [case for case in json.loads(path.read_text(encoding="utf-8"))["cases"] if case["task"] == task]


def follower_of(tree: dict[str, str]) -> Any:
    """The follower of a reference case."""
    return getattr(followers, tree["record"])(**{k: float(v) for k, v in tree.items() if k != "record"})


def random_program(chance: random.Random, *, swing: bool = False) -> str:
    """A rise, a dwell, a return and a dwell."""
    up, down = chance.randint(40, 140), chance.randint(40, 140)
    amount = f"{chance.uniform(3, 20):.3f} deg" if swing else f"{chance.uniform(2, 25):.3f} mm"
    top = chance.randint(1, 70)
    return (
        f"rise {amount} in {up} deg {chance.choice(LAWS)}; dwell {top} deg; "
        f"return in {down} deg {chance.choice(LAWS)}; dwell"
    )


def random_follower(chance: random.Random, kind: str) -> Any:
    """A follower of sizes a designer would try."""
    base, radius = chance.uniform(0.02, 0.06), chance.uniform(0.003, 0.012)
    if kind == "roller":
        return followers.Roller(base, radius, chance.uniform(-0.4, 0.4) * base)
    if kind == "knife":
        return followers.KnifeEdge(base, chance.uniform(-0.4, 0.4) * base)
    if kind == "flat":
        return followers.FlatFace(base)
    pivot = chance.uniform(0.09, 0.13)
    if kind == "rocker":
        return followers.OscillatingFlat(0.5 * base, pivot, chance.uniform(-0.003, 0.01))
    return followers.OscillatingRoller(base, radius, chance.uniform(0.8, 1.0) * pivot, pivot)


SWINGING = ("arm", "rocker")
KINDS = ("roller", "knife", "flat", "arm", "rocker")


def by_rays(geometry: Geometry, motion: Any, count: int = 1200) -> tuple[float, float, float]:
    """Area, perimeter and polar moment from the first follower that each ray from the axis meets."""
    theta = np.linspace(0.0, 2.0 * pi, 4000, endpoint=False)
    turn = np.exp(-1j * geometry.turn * theta)
    level = geometry.start + motion.at(theta, 0)[0]
    rays = np.linspace(-pi, pi, count, endpoint=False)
    radius = np.empty(count)
    for index, ray in enumerate(np.exp(1j * rays)):
        away = ray * (1j * turn if geometry.flat else (geometry.follower.offset + 1j * level) * turn).conj()
        with np.errstate(all="ignore"):
            if geometry.flat:
                reach = np.where(away.real > 0.0, level / away.real, np.inf)
            else:
                under = geometry.roller**2 - away.imag**2
                reach = np.where((under > 0.0) & (away.real > 0.0), away.real - np.sqrt(under), np.inf)
        radius[index] = reach.min()
    step = 2.0 * pi / count
    slope = (np.roll(radius, -1) - radius) / step
    middle = 0.5 * (np.roll(radius, -1) + radius)
    return (
        float(0.5 * step * (radius**2).sum()),
        float(step * np.hypot(middle, slope).sum()),
        float(0.25 * step * (radius**4).sum()),
    )
