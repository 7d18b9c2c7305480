"""Derives the embedded Genz–Keister rules 1 ⊂ 3 ⊂ 9 ⊂ 19 ⊂ 35 of dynamics_cli/numerics/quadrature/hermite.py with 80 digits.

Genz & Keister, J. Comput. Appl. Math. 71 (1996): given the nodes so far, the roots of P, the m new ones are the roots of
the monic E for which P·E is orthogonal to every power below m under the normal density. By symmetry E is even and P odd,
so a linear system of m/2 equations gives it. Weights are those of interpolation.

    python tests/references/generate_hermite_tables.py
"""  # noqa: E501

import mpmath as mp

mp.mp.dps = 120
ADDED = (2, 6, 10, 16)


def moment(power):
    """E[z^power] of a standard normal variable."""
    return mp.mpf(0) if power % 2 else mp.fac2(power - 1)


def multiply(a, b):
    made = [mp.mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            made[i + j] += x * y
    return made


def extension(known, count):
    """The new positive nodes."""
    p = [mp.mpf(1)]
    for node in known:
        p = multiply(p, [-node, mp.mpf(1)])
    half = count // 2
    matrix, right = mp.matrix(half, half), mp.matrix(half, 1)
    for row in range(half):
        k = 2 * row + 1
        for column in range(half):
            matrix[row, column] = sum(c * moment(i + 2 * column + k) for i, c in enumerate(p))
        right[row] = -sum(c * moment(i + count + k) for i, c in enumerate(p))
    solved = mp.lu_solve(matrix, right)
    squares = mp.polyroots([mp.mpf(1), *[solved[half - 1 - i] for i in range(half)]], maxsteps=2000, extraprec=800)
    return sorted(mp.sqrt(mp.re(s)) for s in squares)


def weights(nodes):
    made = []
    for i, x in enumerate(nodes):
        basis = [mp.mpf(1)]
        for j, y in enumerate(nodes):
            if i != j:
                basis = multiply(basis, [-y / (x - y), 1 / (x - y)])
        made.append(sum(c * moment(k) for k, c in enumerate(basis)))
    return made


def rules():
    """Every rule's nodes (in the order they were added, positive before negative) and weights."""
    nodes = [mp.mpf(0)]
    made = [(list(nodes), [mp.mpf(1)])]
    for count in ADDED:
        new = extension(nodes, count) if len(nodes) > 1 else [mp.sqrt(3)]
        for node in new:
            nodes += [node, -node]
        made.append((list(nodes), weights(nodes)))
    return made


if __name__ == "__main__":
    made = rules()
    print("positive nodes in the order added")
    print([float(x) for x in made[-1][0][1::2]])
    for nodes, w in made:
        print(len(nodes), [float(w[0]), *[float(x) for x in w[1::2]]])
