"""Stiffness of a vehicle's face: A and B as given, from Campbell's line, or from one barrier test."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, CrushStiffness, Distance, LineForce, Mass, RoadSpeed, Size, SpeedSlope
from dynamics_cli.records import record


@record
class Coefficients:
    """Stiffness by its coefficients."""

    stiffness_a: Annotated[LineForce, "A: force per width at which crush begins [N/m]."]
    stiffness_b: Annotated[CrushStiffness, "B: force per width and depth of crush [N/m^2]."]


@record
class Campbell:
    """Stiffness from Campbell's line of barrier tests, v = b₀ + b₁ C."""

    no_damage_speed: Annotated[RoadSpeed, "b₀: highest barrier speed without residual crush, e.g. 5 mph [m/s]."]
    speed_slope: Annotated[SpeedSlope, "b₁: barrier speed per depth of crush [1/s]."]
    test_mass: Annotated[Mass, "Mass of the tested vehicle [kg]."]
    test_width: Annotated[Distance, "Width of its crushed face, e.g. 66 in [m]."]


@record
class BarrierTest:
    """Stiffness from one full-width barrier test and an assumed speed without damage."""

    test_speed: Annotated[RoadSpeed, "Speed of the test, e.g. 35 mph [m/s]."]
    test_crush: Annotated[Size, "Mean residual crush of the test, e.g. 20 in [m]."]
    no_damage_speed: Annotated[RoadSpeed, "b₀: highest barrier speed without residual crush, e.g. 5 mph [m/s]."]
    test_mass: Annotated[Mass, "Mass of the tested vehicle [kg]."]
    test_width: Annotated[Distance, "Width of its crushed face, e.g. 66 in [m]."]


def coefficients(stiffness: Coefficients | Campbell | BarrierTest, name: str) -> tuple[float, float]:
    """A = m b₀ b₁/w and B = m b₁²/w of the tested vehicle, or as given (Campbell, SAE 740565)."""
    if isinstance(stiffness, Coefficients):
        return stiffness.stiffness_a, stiffness.stiffness_b
    require(
        (stiffness.test_mass > 0.0) & (stiffness.test_width > 0.0),
        "the {name} vehicle: mass and width of its test must be above zero",
        name=name,
        code="no-test",
    )
    if isinstance(stiffness, Campbell):
        slope = stiffness.speed_slope
    else:
        require(
            (stiffness.test_crush > 0.0) & (stiffness.test_speed > stiffness.no_damage_speed),
            "the {name} vehicle: a test at {speed} with a crush of {crush} does not show a stiffness above the speed "
            "without damage, {least}",
            name=name,
            speed=(stiffness.test_speed, RoadSpeed),
            crush=(stiffness.test_crush, Size),
            least=(stiffness.no_damage_speed, RoadSpeed),
            code="no-test",
        )
        slope = (stiffness.test_speed - stiffness.no_damage_speed) / stiffness.test_crush
    factor = stiffness.test_mass * slope / stiffness.test_width
    return factor * stiffness.no_damage_speed, factor * slope
