"""Linear recursions over many steps by doubling instead of step by step."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Steps that differ by less, relatively, differ by the rounding of their times.
EVEN = 1e-9


def even(steps: "Any") -> bool:
    """Whether all steps are one but for rounding."""
    return bool(np.ptp(steps) <= EVEN * steps[0])


def followed(states: "Any", factor: "Any") -> "Any":
    """x₀ = s₀, x_k = A·x_{k−1} + s_k of states (…, steps, size), by a pass for each power of two of the steps.

    After the pass with A^m every state holds what the 2m states up to it give.
    """
    reached = 1
    while reached < states.shape[-2]:
        states[..., reached:, :] += states[..., :-reached, :] @ np.swapaxes(factor, -1, -2)
        factor, reached = factor @ factor, 2 * reached
    return states
