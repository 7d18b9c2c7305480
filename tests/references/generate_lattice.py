"""Derives the generating vector of dynamics_cli/numerics/quadrature/lattice.py: component by component, for all 2^m points at once.

The figure of merit is the worst-case error P₂ in the weighted Korobov space, weights γ_j = 0.9/j (later axes of a
problem matter less: axes are used in any order, so they must not fade faster); each component takes the odd candidate whose
largest excess over the best one, over 2^7 … 2^14 points, is least (Cools, Kuo & Nuyens 2006 do so for embedded lattices).

    python tests/references/generate_lattice.py
"""  # noqa: E501

import numpy as np

DIMENSIONS = 40
LOW, HIGH = 7, 14


def generate():
    size = 1 << HIGH
    levels = range(LOW, HIGH + 1)
    states = {m: np.ones(1 << m) for m in levels}
    vector = []
    for j in range(DIMENSIONS):
        gamma = 0.9 / (j + 1)
        errors = {}
        for m in levels:
            n = 1 << m
            x = np.arange(n) / n
            kernel = 1.0 + gamma * 2.0 * np.pi**2 * (x * x - x + 1.0 / 6.0)
            # candidates are odd residues modulo n: products over the group need no more than that
            residues = np.arange(1, n, 2)
            index = np.arange(n)
            made = np.empty(len(residues))
            for start in range(0, len(residues), 256):
                part = residues[start : start + 256]
                made[start : start + 256] = kernel[(part[:, None] * index) & (n - 1)] @ states[m]
            errors[m] = made / n - 1.0
        candidates = np.arange(1, size, 2)
        worst = np.zeros(len(candidates))
        for m in levels:
            own = errors[m][((candidates & ((1 << m) - 1)) - 1) // 2]
            worst = np.maximum(worst, own / errors[m].min())
        chosen = int(candidates[np.argmin(worst)])
        if j == 0:
            chosen = 1
        vector.append(chosen)
        for m in levels:
            n = 1 << m
            x = (chosen * np.arange(n) % n) / n
            states[m] *= 1.0 + gamma * 2.0 * np.pi**2 * (x * x - x + 1.0 / 6.0)
        print(j, chosen, float(worst.min()), flush=True)
    return vector


if __name__ == "__main__":
    print(generate())
