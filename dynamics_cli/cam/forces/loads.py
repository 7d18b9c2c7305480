"""The load on the cam from a follower's inertia, spring and external load: a force for a slide, a torque for an arm."""

from math import sqrt

from dynamics_cli.cam.forces.records import ArmOnSpring, ArmOnTorsionSpring, Slide, Train
from dynamics_cli.errors import UsageError, require
from dynamics_cli.quantities import Force, Inertia, Mass, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.program.motion import Motion

SLIDES = 'write "rise 20 mm in 90 deg …" for a slide'
SWINGS = 'write "rise 15 deg in 90 deg …" for an arm'


class Load:
    """Q = k s + P + J ω² s″, the load on the cam: a force, or for an arm a torque about its pivot.

    `train`: what moves, and what presses it.
    """

    __slots__ = ("arm", "inertia", "inertial", "preload", "rate", "spring_radius", "steady", "surging")

    def __init__(self, train: Train, omega: float = 0.0) -> None:
        self.arm = not isinstance(train, Slide)
        self.spring_radius = 1.0
        if isinstance(train, Slide):
            self.inertia, self.rate, self.preload = train.mass, train.spring_rate, train.preload
            self.steady = train.preload + train.load
            self.surging = train.spring_mass, train.spring_rate
        elif isinstance(train, ArmOnSpring):
            r = self.spring_radius = train.spring_radius
            self.inertia, self.rate, self.preload = train.inertia, train.spring_rate * r * r, train.preload * r
            self.steady = self.preload + train.load_torque
            self.surging = train.spring_mass, train.spring_rate
        else:
            self.inertia, self.rate, self.preload = train.inertia, train.torsion_rate, train.preload_torque
            self.steady = train.preload_torque + train.load_torque
            self.surging = train.spring_inertia, train.torsion_rate
        self.inertial = self.inertia * omega * omega

    def force(self, s: "Any", s2: "Any") -> "Any":
        """The force or torque, from the lift or swing and its second derivative by cam angle."""
        return self.rate * s + self.steady + self.inertial * s2

    def enclosed(self) -> "Load":
        """The same load for discs, including the rounding of its constants."""
        from dynamics_cli.numerics.discs import Disc

        enclosed = Load.__new__(Load)
        for name in self.__slots__:
            setattr(enclosed, name, getattr(self, name))
        # k r r, m ω ω and P + L
        for name in ("rate", "inertial", "steady"):
            value = getattr(self, name)
            setattr(enclosed, name, Disc(value, 2.0**-51 * abs(value)))
        return enclosed


def load_of(train: Train, motion: "Motion", omega: float = 0.0) -> Load:
    """Give the load of a train on a motion of the same kind.

    `train`: what moves, and what presses it. Raises UsageError when the program slides and the train is an arm's, or
    vice versa. Raises InadmissibleError when the mass or inertia is zero, a preload pulls, or a spring acts at the
    pivot itself.
    """
    if motion.swing and isinstance(train, Slide):
        raise UsageError(
            "mass: the program swings an arm; mass, force and spring rate describe a slide",
            parameter="mass", code="lift-kind",
            hint='give --inertia "0.002 kg*m^2" with --torsion-rate and --preload-torque, or with --spring-radius, '
            f"--spring-rate and --preload; or {SLIDES}",
        )  # fmt: skip
    if not motion.swing and not isinstance(train, Slide):
        raise UsageError(
            "inertia: the program's lift is a length; moment of inertia and torques describe an arm",
            parameter="inertia", code="lift-kind",
            hint=f'give --mass "0.5 kg" with --spring-rate and --preload; or {SWINGS}',
        )  # fmt: skip
    load = Load(train, omega)
    quantity = "moment of inertia" if load.arm else "mass"
    require(
        load.inertia > 0.0,
        "the {what} is {inertia}; wanted a positive one",
        what=quantity, inertia=(load.inertia, Inertia if load.arm else Mass), code="mass",
    )  # fmt: skip
    if isinstance(train, ArmOnSpring):
        require(
            train.spring_radius > 0.0,
            "a spring whose line passes through the pivot gives no torque",
            code="spring-radius",
            hint="leave the spring out, or give its distance from the pivot",
        )
    preload = train.preload_torque if isinstance(train, ArmOnTorsionSpring) else train.preload
    require(
        preload >= 0.0,
        "a preload of {preload} would pull; a spring presses",
        preload=(preload, Torque if isinstance(train, ArmOnTorsionSpring) else Force),
        code="preload",
        hint=f"use the load{' torque' if load.arm else ''}",
    )
    return load


def surge(load: Load) -> float | None:
    """Lowest natural frequency of the spring between its ends, both held: f = ½√(k/m) [Hz]; None without its mass.

    `load`: the load, with the mass of the spring's coils or their moment of inertia. Returns the frequency [Hz]. Raises
    InadmissibleError when a spring's mass is zero, or its rate.
    """
    mass, rate = load.surging
    if mass is None:
        return None
    require(
        mass > 0.0,
        "the spring's mass is zero: its surge needs a positive mass",
        code="spring-mass",
        hint="leave the spring's mass out",
    )
    require(rate > 0.0, "the spring's rate is zero: its surge needs a positive rate", code="spring-rate")
    return 0.5 * sqrt(rate / mass)
