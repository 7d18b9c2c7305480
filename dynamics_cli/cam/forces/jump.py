"""The speed of the cam at which its follower first leaves it."""

from math import sqrt

from dynamics_cli.cam.forces.loads import load_of
from dynamics_cli.cam.forces.records import ArmOnTorsionSpring, Slide
from dynamics_cli.cam.forces.survey import Found, Sum, Survey
from dynamics_cli.cam.program.summary import extreme
from dynamics_cli.errors import require
from dynamics_cli.quantities import Force, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.forces.loads import Load
    from dynamics_cli.cam.program.motion import Motion

    Optional = tuple[float | None, float | None, float | None]

DROP = 1e-9
EXACT = 2.0**-51


def jump(motion: "Motion", load: "Load", survey: "Survey | None" = None) -> "Found | None":
    """Give the speed above which a follower leaves its cam, and where it leaves first.

    ω² = min (k s + P)/(−J s″) over s″ < 0; P is preload and load together, J the mass, or an arm's moment of inertia.

    `load`: inertia, spring and load; `survey`: a survey of the same motion, if there is one. Returns the speed [rad/s],
    the cam angle, and the error's bound; zero where the spring is slack, or the velocity drops at a joint; None if
    nothing decelerates the follower.
    """
    survey = survey or Survey(motion)
    exact = load.enclosed()
    inertia_term, spring_term = Sum((0.0, 0.0, -load.inertia)), Sum((exact.rate,), exact.steady)
    if load.rate * motion.stroke[0] + load.steady < 0.0:
        return Found(0.0, extreme(motion, 0).least_at, 0.0)
    drop = dropping(motion)
    if drop is not None:
        return Found(0.0, drop, 0.0)
    quotient = survey.greatest_quotient(inertia_term, spring_term)
    if quotient.value <= 0.0:
        return None
    speed = 1.0 / sqrt(quotient.value)
    return Found(speed, quotient.at, (0.5 * quotient.error / quotient.value + EXACT) * speed if speed else 0.0)


def asked_jump(
    motion: "Motion", slide: "Optional", arm: "Optional", *, asked: bool
) -> "tuple[float | None, float | None, float] | None":
    """Give the jump speed of a follower with known mass (or inertia), spring rate and preload, for a verdict.

    `slide`: mass, spring rate and preload of a slide; `arm`: moment of inertia, torsion rate and preload torque of an
    arm; `asked`: whether a verdict is requested, which needs all three. Returns speed, place and error bound of the
    speed; speed and place are None if it cannot jump, and the result is None if no verdict is requested. Raises
    InadmissibleError when one of the three is missing, those of the other kind of follower are given, or the spring is
    slack.
    """
    moving, other = (arm, slide) if motion.swing else (slide, arm)
    stated = [value is not None for value in (*moving, *other)]
    if not any(stated) and not asked:
        return None
    require(
        all(stated[:3]) and not any(stated[3:]),
        "the jump of an arm needs its moment of inertia, its torsion spring's rate and its preload torque"
        if motion.swing
        else "a jump needs the moved mass, the spring's stiffness and its preload",
        code="spring",
        hint='--inertia "0.002 kg*m^2" --torsion-rate "10 N*m/rad" --preload-torque "2 N*m"'
        if motion.swing
        else '--mass "0.2 kg" --spring-rate "20 N/mm" --preload "100 N"',
    )
    train = ArmOnTorsionSpring if motion.swing else Slide
    load = load_of(train(*moving), motion)  # type: ignore[arg-type]
    floor = load.steady + load.rate * motion.stroke[0]
    require(
        floor > 0.0,
        "the spring is slack at the minimum {lift}: its {what} there is {floor}",
        lift="swing" if motion.swing else "lift",
        what="torque" if motion.swing else "force",
        floor=(floor, Torque if motion.swing else Force),
        code="slack",
        hint="raise the preload",
    )
    jumping = jump(motion, load)
    return (None, None, 0.0) if jumping is None else (jumping.value, jumping.at, jumping.error)


def dropping(motion: "Motion") -> float | None:
    """The first joint at which the velocity drops, beyond rounding: no finite force holds the follower there."""
    count = len(motion.zones)
    ends = [(motion.in_zone(i, 0.0, 1)[1], motion.in_zone(i, 1.0, 1)[1]) for i in range(count)]
    middles = [motion.in_zone(i, 0.37, 1)[1] for i in range(count)]
    peak = max(map(abs, (*(value for pair in ends for value in pair), *middles)))
    for index, zone in enumerate(motion.zones):
        if ends[index][0] < ends[index - 1][1] - DROP * peak:
            return zone.start
    return None
