"""Writes coords.json: points in the other systems of coordinates, to 40 digits.

Angles come from arc cosines at 1,400 digits and from the argument of a complex exponential; the program uses atan2.
Run: python tests/references/generate_coords_references.py [FILE]. The same bytes every time.
"""

import json
import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from mpmath import mp, mpf

DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
DIGITS = 1400
Point = tuple[float, float, float]


def between(along: Any, whole: Any, side: Any) -> Any:
    """The angle from an axis of a vector with a component along it, on the positive or negative side."""
    if whole == 0:
        return mpf(0)
    angle = mp.acos(along / whole)
    return -angle if side < 0 else angle


def principal(theta: Any, off_axis: Any) -> Any:
    """Within (−π, π]; −180 degrees, which reads as the double nearest −π, is 180 degrees."""
    if theta == -mpf(PI):
        return theta + 2 * mp.pi
    return mpf(0) if off_axis == 0 else mp.arg(mp.expj(theta))


def from_cartesian(x: Any, y: Any, z: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    r, rho = mp.sqrt(x * x + y * y), mp.sqrt(x * x + y * y + z * z)
    theta = between(x, r, y)
    return {"r": r, "theta": theta, "z": z}, {"rho": rho, "phi": between(z, rho, 1), "theta": theta}


def from_cylindrical(r: Any, theta: Any, z: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    turned = r * mp.expj(theta)
    rho = mp.sqrt(r * r + z * z)
    spherical = {"rho": rho, "phi": between(z, rho, 1), "theta": principal(theta, r)}
    return {"x": turned.real, "y": turned.imag, "z": z}, spherical


def from_spherical(rho: Any, phi: Any, theta: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    meridian = rho * mp.expj(phi)
    r, z = meridian.imag, meridian.real
    turned = r * mp.expj(theta)
    return {"x": turned.real, "y": turned.imag, "z": z}, {"r": r, "theta": principal(theta, r), "z": z}


SOURCES = {
    "cartesian": (("x", "y", "z"), from_cartesian, ("cylindrical", "spherical")),
    "cylindrical": (("r", "theta", "z"), from_cylindrical, ("cartesian", "spherical")),
    "spherical": (("rho", "phi", "theta"), from_spherical, ("cartesian", "cylindrical")),
}
PI = 3.141592653589793
TINY, LEAST, HUGE = 1e-300, 5e-324, 1e300


def cartesian(generator: random.Random) -> Iterator[tuple[str, Point]]:
    for _ in range(20):
        x, y, z = (generator.uniform(-10.0, 10.0) for _ in range(3))
        yield "ordinary", (x, y, z)
    for _ in range(20):
        x, y, z = (generator.choice((-1, 1)) * 10.0 ** generator.uniform(-300, 300) for _ in range(3))
        yield "hard", (x, y, z)
    yield from (("ordinary", point) for point in [(3.0, 1.0, 4.0), (1.0, 2.0, 5.0)])
    for point in [
        (0.0, 0.0, 0.0),
        (0.0, 0.0, 2.0),
        (0.0, 0.0, -2.0),
        (-1.0, 0.0, 0.0),
        (-1.0, -1e-300, 1.0),
        (-1.0, 1e-17, 1.0),
        (1e-20, 0.0, 1.0),
        (1e-20, 1e-20, -1.0),
        (1.0, 1.0, 1e-20),
        (LEAST, LEAST, LEAST),
        (3 * LEAST, -4 * LEAST, 0.0),
        (7e-310, -3e-312, 5e-309),
        (TINY, TINY, TINY),
        (HUGE, -HUGE, HUGE),
        (1e308, 1e308, 1e308),
        (TINY, HUGE, 1.0),
        (TINY, TINY, -HUGE),
        (1e-170, 1e-170, 1e-160),
        (1e170, 1e170, -1e160),
    ]:
        yield "hard", point


def cylindrical(generator: random.Random) -> Iterator[tuple[str, Point]]:
    for _ in range(20):
        yield "ordinary", (generator.uniform(0.0, 10.0), generator.uniform(-PI, PI), generator.uniform(-10.0, 10.0))
    yield "ordinary", (4.0, 0.5235987755982988, 2.0)
    for point in [
        (0.0, 0.4, 1.0),
        (0.0, 0.4, 0.0),
        (1.0, PI, 0.0),
        (1.0, -PI, 0.0),
        (1.0, 4.0, 1.0),
        (1.0, -400.5, 1.0),
        (1.0, 1e22, 1.0),
        (1.0, 6.283185307179586, 1.0),
        (1e-20, 1.0, -1.0),
        (LEAST, 1.0, LEAST),
        (TINY, 1e-300, TINY),
        (HUGE, 2.0, -HUGE),
        (1e-300, 1.5707963267948966, 1e300),
    ]:
        yield "hard", point


def spherical(generator: random.Random) -> Iterator[tuple[str, Point]]:
    for _ in range(20):
        yield "ordinary", (generator.uniform(0.0, 10.0), generator.uniform(0.0, PI), generator.uniform(-PI, PI))
    yield "ordinary", (7.0, 0.7853981633974483, 1.0471975511965976)
    for point in [
        (0.0, 0.4, 1.0),
        (2.0, 0.0, 1.0),
        (2.0, PI, 1.0),
        (2.0, 1e-300, 1.0),
        (2.0, 1.5707963267948966, -3.0),
        (2.0, 1.0, -PI),
        (2.0, 1.0, 7.0),
        (2.0, 1.0, -1e5),
        (TINY, 1e-10, 2.0),
        (LEAST, 1.0, 1.0),
        (HUGE, 1e-300, 1e-300),
        (1e308, 3.0, -3.0),
    ]:
        yield "hard", point


def generate() -> Iterator[dict[str, Any]]:
    mp.dps = DIGITS
    points = {"cartesian": cartesian, "cylindrical": cylindrical, "spherical": spherical}
    for source, (names, convert, targets) in SOURCES.items():
        for kind, point in points[source](random.Random(source)):
            inputs = {name: repr(value) for name, value in zip(names, point, strict=True)}
            for target, results in zip(targets, convert(*map(mpf, point)), strict=True):
                texts = {name: mp.nstr(value, 40) for name, value in results.items()}
                task = f"{source}_to_{target}"
                yield {"task": task, "kind": kind, "name": f"{task} {point}", "inputs": inputs, "results": texts}


def main(target: Path) -> None:
    about = "Written by generate_coords_references.py: coordinates as doubles, results to 40 digits."
    lines = [json.dumps(case) for case in generate()]
    text = f'{{"about": {json.dumps(about)},\n"cases": [\n' + ",\n".join(lines) + "\n]}\n"
    target.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "coords.json")
