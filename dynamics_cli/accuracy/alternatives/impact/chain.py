"""A chain of bodies: velocities pair by pair and the contact problem by LAPACK, and as physics engines iterate it."""

from itertools import pairwise

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    # Velocities after, impulses between neighbours, collisions or rounds.
    Answer = tuple[list[float], list[float], int]

# Closing speeds below this share of the greatest are rounding.
NOTHING = 1e-12
MOST = 20_000


def _closing(speeds: "list[float]") -> "list[float]":
    return [one - other for one, other in pairwise(speeds)]


def _by_differences(
    bodies: "Any", restitution: float, law: str, pairs: "Callable[..., Answer]", at_once: "Callable[..., Answer]"
) -> "dict[str, float]":
    """Every law's velocities; ΔV and energies as differences."""
    masses, before = [one.mass for one in bodies], [one.velocity for one in bodies]
    ratios = [restitution if one.restitution is None else one.restitution for one in bodies[:-1]]
    energy = sum(0.5 * m * v * v for m, v in zip(masses, before, strict=True))
    results = {"momentum": sum(m * v for m, v in zip(masses, before, strict=True))}
    place = 0
    asked = {"sequential": (pairs,), "simultaneous": (at_once,)}.get(law, (pairs, at_once))
    for index, method in enumerate(asked):
        after, impulses, rounds = method(masses, before, ratios)
        left = sum(0.5 * m * v * v for m, v in zip(masses, after, strict=True))
        results |= {f"laws[{index}].energy_lost": energy - left, f"laws[{index}].collisions": float(rounds)}
        for number, (old, new) in enumerate(zip(before, after, strict=True)):
            row = f"bodies[{place}]"
            results |= {f"{row}.body": number + 1.0, f"{row}.velocity": new, f"{row}.delta_v": new - old}
            if number < len(impulses):
                results[f"{row}.impulse_to_next"] = impulses[number]
            place += 1
    return results


def _pair_by_pair(masses: "list[float]", before: "list[float]", ratios: "list[float]") -> "Answer":
    """The pair that closes fastest first, w = (m₁v₁ + m₂v₂ ∓ …)/(m₁ + m₂)."""
    speeds, impulses = list(before), [0.0] * len(ratios)
    least = NOTHING * max(map(abs, before))
    for count in range(MOST):
        closing = _closing(speeds)
        fastest = max(closing)
        if fastest <= least:
            return speeds, impulses, count
        k = closing.index(fastest)
        m, n, v, w, e = masses[k], masses[k + 1], speeds[k], speeds[k + 1], ratios[k]
        speeds[k] = (m * v + n * w - n * e * (v - w)) / (m + n)
        speeds[k + 1] = (m * v + n * w + m * e * (v - w)) / (m + n)
        impulses[k] += n * (speeds[k + 1] - w)
    raise ArithmeticError


def _contacts(masses: "list[float]") -> "Any":
    """K: by how much unit impulses open every contact."""
    import numpy as np

    weights = 1.0 / np.array(masses)
    inner = -weights[1:-1]
    return np.diag(weights[:-1] + weights[1:]) + np.diag(inner, 1) + np.diag(inner, -1)


def _rounds(
    masses: "list[float]", before: "list[float]", ratios: "list[float]", plastic: "Callable[[Any, Any], Any]"
) -> "Answer":
    """All contacts at one moment: impulses that stop the closing, e times as much again, until no pair closes."""
    import numpy as np

    k, speeds, total = _contacts(masses), np.array(before), np.zeros(len(ratios))
    least, weights = NOTHING * np.abs(speeds).max(), 1.0 / np.array(masses)
    for count in range(200):
        closing = speeds[:-1] - speeds[1:]
        if closing.max() <= least:
            return speeds.tolist(), total.tolist(), count
        impulse = (1.0 + np.array(ratios)) * plastic(k, closing)
        total += impulse
        speeds += weights * (np.concatenate([[0.0], impulse]) - np.concatenate([impulse, [0.0]]))
    raise ArithmeticError


def _active(k: "Any", closing: "Any") -> "Any":
    """K·c − u ≥ 0, c ≥ 0: contacts that would close are added to those that act, each time by `numpy.linalg.solve`."""
    import numpy as np

    acting = closing > 0.0
    for _ in range(len(closing) + 1):
        impulses = np.zeros(len(closing))
        impulses[acting] = np.linalg.solve(k[np.ix_(acting, acting)], closing[acting])
        more = ~acting & (k @ impulses < closing - 1e-14 * np.abs(closing).max())
        if not more.any():
            break
        acting |= more
    return impulses


def by_velocities(*, bodies: "Any", restitution: float, law: str) -> "dict[str, float]":
    """Pairs by the textbook's velocities; all contacts at once by an active set and `numpy.linalg.solve`."""
    return _by_differences(bodies, restitution, law, _pair_by_pair, lambda m, v, e: _rounds(m, v, e, _active))
