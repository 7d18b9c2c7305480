"""Whole impacts in the plane and in space by Dormand and Prince's steps along the impulse, on K of numpy."""

from dynamics_cli.accuracy.alternatives.impact.rigid import Meeting, _results
from peers.impact import paths, space
from peers.impact.march import own

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def planar(**given: "Any") -> "dict[str, float]":
    """The path in normal impulse; Newton, Poisson, Stronge."""
    import numpy as np

    m = Meeting(given)
    if m.law not in ("newton", "poisson", "stronge"):
        raise ArithmeticError
    (kt, _, kx), _, (_, _, kn) = m.k.tolist()
    contact = paths.Contact((kt, kx, kn), (float(m.u[0]), float(m.u[2])), m.mu, m.e, m.law)
    pn, pt = paths.integral(contact, own(1e-12))
    return _results(m, np.array([pt, 0.0, pn]))


def spatial(**given: "Any") -> "dict[str, float]":
    """Keller's equations, to 1e-10."""
    import numpy as np

    m = Meeting(given)
    contact = space.Contact(tuple(map(tuple, m.k.tolist())), tuple(m.u.tolist()), m.mu, m.e, m.law)
    return _results(m, np.array(space.integral(contact, own(1e-10))))
