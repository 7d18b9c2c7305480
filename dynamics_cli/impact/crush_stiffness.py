"""Stiffness of a vehicle's face: A and B as given, from Campbell's line, or from one barrier test."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import CrushStiffness, Distance, LineForce, Mass, RoadSpeed, Size, SpeedSlope
from dynamics_cli.records import record


@record
class Coefficients:
    """Stiffness by its coefficients.

    Parameters
    ----------
    stiffness_a : LineForce
        A: force per width at which crush begins [N/m].
    stiffness_b : CrushStiffness
        B: force per width and depth of crush [N/m^2].
    """

    stiffness_a: LineForce
    stiffness_b: CrushStiffness


@record
class Campbell:
    """Stiffness from Campbell's line of barrier tests, v = b₀ + b₁ C.

    Parameters
    ----------
    no_damage_speed : RoadSpeed
        b₀: greatest barrier speed without residual crush [m/s].
    speed_slope : SpeedSlope
        b₁: barrier speed per depth of crush [1/s].
    test_mass : Mass
        Mass of the tested vehicle [kg].
    test_width : Distance
        Width of its crushed face [m].
    """

    no_damage_speed: RoadSpeed
    speed_slope: SpeedSlope
    test_mass: Mass
    test_width: Distance


@record
class BarrierTest:
    """Stiffness from one full-width barrier test and an assumed speed without damage.

    Parameters
    ----------
    test_speed : RoadSpeed
        Speed of the test [m/s].
    test_crush : Size
        Mean residual crush of the test [m].
    no_damage_speed : RoadSpeed
        b₀: greatest barrier speed without residual crush [m/s].
    test_mass : Mass
        Mass of the tested vehicle [kg].
    test_width : Distance
        Width of its crushed face [m].
    """

    test_speed: RoadSpeed
    test_crush: Size
    no_damage_speed: RoadSpeed
    test_mass: Mass
    test_width: Distance


def coefficients(stiffness: Coefficients | Campbell | BarrierTest, name: str) -> tuple[float, float]:
    """A = m b₀ b₁/w and B = m b₁²/w of the tested vehicle, or as given."""
    if isinstance(stiffness, Coefficients):
        return stiffness.stiffness_a, stiffness.stiffness_b
    require(
        (stiffness.test_mass > 0.0) & (stiffness.test_width > 0.0),
        f"the {name} vehicle: a test of no mass or width shows no stiffness",
        code="no-test",
    )
    if isinstance(stiffness, Campbell):
        slope = stiffness.speed_slope
    else:
        require(
            (stiffness.test_crush > 0.0) & (stiffness.test_speed > stiffness.no_damage_speed),
            f"the {name} vehicle: " + "a test at {0:.4g} m/s with a crush of {1:.4g} m shows no stiffness above the "
            "speed without damage {2:.4g} m/s",
            stiffness.test_speed,
            stiffness.test_crush,
            stiffness.no_damage_speed,
            code="no-test",
        )
        slope = (stiffness.test_speed - stiffness.no_damage_speed) / stiffness.test_crush
    share = stiffness.test_mass * slope / stiffness.test_width
    return share * stiffness.no_damage_speed, share * slope
