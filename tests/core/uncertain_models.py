"""Models and random problems for tests and benchmarks of uncertainty: hand-written numpy, standing in for families."""

from collections.abc import Callable
from typing import Any

import numpy as np

from dynamics_cli.core.inputs.uncertain.distributions import (
    Distribution,
    Lognormal,
    Normal,
    StudentT,
    Triangular,
    Truncated,
    Uniform,
)

G = 9.80665
Function = Callable[[dict[str, Any]], Any]


def model_of(function: Function) -> Callable[[dict[str, Any]], tuple[dict[str, Any], Any]]:
    """A model of one result (or a dictionary of them) for the engine."""

    def model(x: dict[str, Any]) -> tuple[dict[str, Any], Any]:
        made = function(x)
        return (made if isinstance(made, dict) else {"result": made}), None

    return model


def skid(x: dict[str, Any]) -> Any:
    """Speed from a skid of length d on a slope θ."""
    return np.sqrt(2.0 * G * x["d"] * (x["mu"] * np.cos(x["theta"]) + np.sin(x["theta"])))


def momentum(x: dict[str, Any]) -> Any:
    """Speeds before a two-car collision from the paths after it: approach angles a, departure angles b, speeds u."""
    px = x["m1"] * x["u1"] * np.cos(x["b1"]) + x["m2"] * x["u2"] * np.cos(x["b2"])
    py = x["m1"] * x["u1"] * np.sin(x["b1"]) + x["m2"] * x["u2"] * np.sin(x["b2"])
    det = np.sin(x["a2"] - x["a1"])
    v1 = (px * np.sin(x["a2"]) - py * np.cos(x["a2"])) / (x["m1"] * det)
    v2 = (py * np.cos(x["a1"]) - px * np.sin(x["a1"])) / (x["m2"] * det)
    return {"v1": v1, "v2": v2}


def surfaces(x: dict[str, Any]) -> Any:
    """Skid over several surfaces: distance, friction and grade of each."""
    total: Any = 0.0
    for i in range(len(x) // 3):
        grade = x[f"G{i}"]
        total = total + x[f"d{i}"] * (x[f"mu{i}"] + grade) / np.sqrt(1.0 + grade * grade)
    return np.sqrt(2.0 * G * total)


def impact(x: dict[str, Any]) -> Any:
    """Velocity change in a planar impact with friction: sliding or sticking, whichever the cone allows (a kink)."""
    pt, _, _, pn = _impulse(x)
    return np.hypot(pn, pt) / x["m"]


def impact_along(x: dict[str, Any]) -> Any:
    """Tangential velocity change of the contact: the least of two functions of different inputs, a kink of 90°."""
    pt, kt, kx, pn = _impulse(x)
    return kt * pt + kx * pn + 0.0 * x["ut"]


def impact_rest(x: dict[str, Any]) -> Any:
    """Sliding speed left after the impact: zero with a probability of its own (an atom)."""
    pt, kt, kx, pn = _impulse(x)
    return np.maximum(x["ut"] + kt * pt + kx * pn, 1e-12)


def _impulse(x: dict[str, Any]) -> Any:
    kt, kn, kx = 1.0 / x["m"] + x["rn"] ** 2 / x["J"], 1.0 / x["m"] + x["rt"] ** 2 / x["J"], -x["rt"] * x["rn"] / x["J"]
    pn = (1.0 + x["e"]) * x["un"] / kn
    stick = (-x["ut"] - kx * pn) / kt
    return np.clip(stick, -x["mu"] * pn, x["mu"] * pn), kt, kx, pn


def cam(x: dict[str, Any]) -> Any:
    """Largest pressure angle of a cycloidal rise (offset follower), radians."""
    slope = 2.0 * x["h"] / x["beta"]
    return np.arctan((slope - x["eps"]) / (np.sqrt(x["r"] ** 2 - x["eps"] ** 2) + 0.5 * x["h"]))


def cam_without_offset(x: dict[str, Any]) -> Any:
    """The same of a radial follower."""
    return np.arctan(2.0 * x["h"] / x["beta"] / (x["r"] + 0.5 * x["h"]))


def gear(x: dict[str, Any]) -> Any:
    """Centre distance of a profile-shifted pair by the involute function, one Newton step from each side."""
    inv = np.tan(x["alpha"]) - x["alpha"] + 2.0 * np.tan(x["alpha"]) * x["x"] / x["z"]
    a = np.cbrt(3.0 * inv)
    for _ in range(6):
        a = a - (np.tan(a) - a - inv) / np.tan(a) ** 2
    return 0.5 * x["m"] * x["z"] * np.cos(x["alpha"]) / np.cos(a)


def mixed20(x: dict[str, Any]) -> Any:
    """Twenty inputs: a product of powers and a sum under a root."""
    values = list(x.values())
    product: Any = 1.0
    for i, v in enumerate(values[:10]):
        product = product * v ** (0.3 + 0.05 * i)
    total: Any = 0.0
    for v in values[10:]:
        total = total + v * v
    return product * np.sqrt(total)


SKID = {"mu": Normal(0.72, 0.04), "d": Normal(38.5, 0.6), "theta": Normal(-0.03, 0.005)}
DEG = np.pi / 180.0
MOMENTUM = {
    "m1": Normal(1500.0, 30.0), "m2": Normal(1200.0, 30.0), "u1": Normal(8.0, 0.4), "u2": Normal(11.0, 0.5),
    "a1": Normal(0.0, DEG), "a2": Normal(85.0 * DEG, DEG), "b1": Normal(35.0 * DEG, 1.5 * DEG), "b2": Normal(50.0 * DEG, 1.5 * DEG),  # noqa: E501
}  # fmt: skip
SURFACES: dict[str, Distribution] = {}
for _i in range(4):
    SURFACES[f"d{_i}"] = Normal(10.0 + 3.0 * _i, 0.3)
    SURFACES[f"mu{_i}"] = Normal(0.75 - 0.1 * _i, 0.05)
    SURFACES[f"G{_i}"] = Normal(-0.03 + 0.02 * _i, 0.006)
TOLERANCES = {
    "h": Uniform(0.0119, 0.0121),
    "beta": Uniform(1.5, 1.55),
    "r": Uniform(0.0395, 0.0405),
    "eps": Uniform(0.003, 0.004),
}
IMPACT = {
    "m": Normal(1500.0, 50.0), "J": Normal(2500.0, 150.0), "rn": Normal(1.8, 0.1), "rt": Normal(0.5, 0.1), "e": Uniform(0.05, 0.3),  # noqa: E501
    "mu": Normal(0.45, 0.08), "un": Normal(9.0, 0.5), "ut": Normal(16.0, 1.0),
}  # fmt: skip
GEAR = {
    "alpha": Uniform(19.8 * DEG, 20.2 * DEG),
    "x": Normal(0.5, 0.02),
    "z": Normal(41.0, 1e-9),
    "m": Triangular(2.99, 3.0, 3.01),
}


def mixed20_inputs() -> dict[str, Distribution]:
    made: dict[str, Distribution] = {}
    for i in range(20):
        c = 1.0 + 0.1 * i
        made[f"x{i}"] = (
            Normal(c, 0.05 * c), Uniform(0.9 * c, 1.1 * c), Triangular(0.9 * c, c, 1.15 * c), Lognormal(c, 0.06 * c),
        )[i % 4]  # fmt: skip
    return made


def any_distribution(rng: np.random.Generator, mean: float, std: float) -> Distribution:
    """A distribution of some kind about that mean and deviation."""
    kind = int(rng.integers(6))
    if kind == 0:
        return Normal(mean, std)
    if kind == 1:
        return Uniform(mean - 1.7 * std, mean + 1.7 * std)
    if kind == 2:
        return Triangular(mean - 2.2 * std, mean + rng.uniform(-1.0, 1.0) * std, mean + 2.4 * std)
    if kind == 3 and mean > 0.0:
        return Lognormal(mean, std)
    if kind == 4:
        return Truncated(mean, 1.3 * std, mean - 2.0 * std, mean + 2.5 * std)
    return StudentT((mean + std * rng.standard_normal(int(rng.integers(6, 12)))).tolist())


def random_skid(rng: np.random.Generator, *, mixed: bool) -> dict[str, Distribution]:
    centres = {"mu": (rng.uniform(0.35, 0.9), rng.uniform(0.01, 0.06)), "d": (rng.uniform(8.0, 80.0), rng.uniform(0.1, 1.5)),  # noqa: E501
               "theta": (rng.uniform(-0.06, 0.06), rng.uniform(0.001, 0.01))}  # fmt: skip
    return {k: any_distribution(rng, m, s) if mixed else Normal(m, s) for k, (m, s) in centres.items()}


def random_momentum(rng: np.random.Generator) -> dict[str, Distribution]:
    angle = rng.uniform(30.0, 150.0) * DEG
    return {
        "m1": Normal(rng.uniform(900, 2500), rng.uniform(10, 60)), "m2": Normal(rng.uniform(900, 2500), rng.uniform(10, 60)),  # noqa: E501
        "u1": Normal(rng.uniform(5, 15), rng.uniform(0.2, 0.8)), "u2": Normal(rng.uniform(5, 15), rng.uniform(0.2, 0.8)),  # noqa: E501
        "a1": Normal(0.0, rng.uniform(0.3, 2.0) * DEG), "a2": Normal(angle, rng.uniform(0.3, 2.0) * DEG),
        "b1": Normal(rng.uniform(0.2, 0.6) * angle, rng.uniform(0.5, 2.0) * DEG),
        "b2": Normal(rng.uniform(0.4, 0.8) * angle, rng.uniform(0.5, 2.0) * DEG),
    }  # fmt: skip
