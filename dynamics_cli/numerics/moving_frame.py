"""The terms of velocity and acceleration of a point that moves in a moving and turning frame."""

from dynamics_cli.numerics.vectors import Vector, add, compensated_cross, scale


class Terms:
    """What ω, α and the motion in the frame contribute, and the sums; all vectors in one set of axes.

    v = v_O + ω×r + v_rel; a = a_O + α×r + ω×(ω×r) + 2ω×v_rel + a_rel.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 3.4, 4.6 and 4.10.
    """

    def __init__(
        self,
        position: Vector,
        turning: "tuple[Vector, Vector]",
        relative: "tuple[Vector, Vector]",
        origin: "tuple[Vector, Vector]",
    ) -> None:
        omega, alpha = turning
        self.spun = compensated_cross(omega, position)
        self.carried = add(origin[0], self.spun)
        self.velocity = add(self.carried, relative[0])
        self.angular = compensated_cross(alpha, position)
        self.centripetal = compensated_cross(omega, self.spun)
        self.coriolis = scale(2.0, compensated_cross(omega, relative[0]))
        acceleration = add(add(add(origin[1], self.angular), self.centripetal), self.coriolis)
        self.acceleration = add(acceleration, relative[1])
