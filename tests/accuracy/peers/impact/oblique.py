"""Further ways beside those of `alternatives/impact/oblique`."""

from dynamics_cli.accuracy.alternatives.impact.oblique import Meeting, _results

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def by_matrix(**given: "Any") -> "dict[str, float]":
    """Four equations for four components: momentum along x and y, the first's tangential part, and restitution."""
    import numpy as np

    m = Meeting(given)
    (a, s), (b, _) = (m.along(v) for v in m.before)
    one, two = m.masses
    rows: list[list[float]] = [[*m.t, 0.0, 0.0], [-m.n[0], -m.n[1], *m.n]]
    right = [s, m.e * (a - b)]
    if two is None:
        rows += [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
        right += m.before[1]
    else:
        assert one is not None
        rows += [[one, 0.0, two, 0.0], [0.0, one, 0.0, two]]
        right += [one * v + two * w for v, w in zip(*m.before, strict=True)]
    x = np.linalg.solve(np.array(rows), np.array(right)).tolist()
    return _results(m, [(x[0], x[1]), (x[2], x[3])])
