"""Gear trains of any kind, solved exactly: speeds, torques, powers and causes of locking."""

from math import isfinite, pi

from dynamics_cli.errors import require
from dynamics_cli.gear.trains.equations import Known, Motion, rolling_speed
from dynamics_cli.gear.trains.planets import Assembly, assembly_advice, basic_ratio, planetary_assembly
from dynamics_cli.gear.trains.scene import GROUND, Mesh, Network, Planetary, Shaft, Stages
from dynamics_cli.gear.trains.torques import Forces
from dynamics_cli.numerics.exact.rational import nearest, product, total, written
from dynamics_cli.quantities import Annotated, Frequency, Power, Ratio, ShaftSpeed, Text, Torque
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.exact.rational import Pair

ONE_ROUNDING = 2.0**-53


@record
class ShaftMotion:
    """The motion of one shaft."""

    name: Annotated[Text, "The shaft."]
    per_driver: Annotated[Text | None, "Its turns for each turn of the driver, exact."] = None
    turns: Annotated[Ratio | None, "The same as a number."] = None
    speed: Annotated[ShaftSpeed | None, "Its speed [rad/s]."] = None
    torque: Annotated[Torque | None, "External torque; on a fixed shaft, the holding torque [N*m]."] = None
    power: Annotated[Power | None, "External power; negative where it is taken out [W]."] = None


@record
class MeshMotion:
    """The motion in one mesh."""

    gears: Annotated[Text, "The shafts and the tooth numbers in mesh."]
    rolling: Annotated[
        Text | None, "Turns of the first gear against the carrier for each turn of the driver, exact."
    ] = None
    frequency: Annotated[Frequency | None, "Teeth that meet in a second [Hz]."] = None
    rolling_power: Annotated[
        Power | None,
        "Power through the teeth seen from the carrier, on which the losses of the mesh are based [W].",
    ] = None


@record
class TrainMotion:
    """Speeds, torques and powers of a train."""

    ratio: Annotated[
        Text | None,
        "Speed of the driver over speed of the driven shaft, exact; negative when they turn against each other.",
    ]
    ratio_value: Annotated[Ratio | None, "The same as a number."]
    freedom: Annotated[int, "Number of speeds that may be chosen freely."]
    basic_ratio: Annotated[
        Text | None, "Planetary: speed of the sun over speed of the ring with the carrier held, exact (Willis)."
    ]
    input_power: Annotated[Power | None, "All power put in [W]."]
    circulating_power: Annotated[
        Power | None, "Power that runs in a loop between the parts of the train, beyond all that is put in [W]."
    ]
    shafts: Annotated[tuple[ShaftMotion, ...], "Every shaft."]
    meshes: Annotated[tuple[MeshMotion, ...], "Every mesh."]
    assembly: Annotated[Assembly | None, "Planetary: whether the planets can be assembled, and where."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def train(
    *,
    arrangement: Annotated[Stages | Planetary | Network, "Stages held by the frame, a planetary set, or any meshes."],
    driver: Annotated[Text, "The shaft that drives. First of the stages, or the sun, unless given."] = "",
    driven: Annotated[Text, "The shaft that is driven. Last of the stages, or the carrier, unless given."] = "",
    fixed: Annotated[
        Text, "Shafts held still, separated by commas; unless given, the ring of a planetary set; `none` for no shaft."
    ] = "",
    speed: Annotated[ShaftSpeed | None, "Speed of the driver [rad/s]."] = None,
    torque: Annotated[Torque | None, "Torque put in at the driver, e.g. 12 N*m [N*m]."] = None,
    power: Annotated[Power | None, "Power put in at the driver, instead of its torque, e.g. 5 kW [W]."] = None,
    shafts: Annotated[
        tuple[Shaft, ...], "Speeds and torques known of other shafts: a differential needs a second speed."
    ] = (),
) -> TrainMotion:
    """Speeds, torques and powers of any gear train, from Willis' equation of every mesh solved in whole numbers.

    Equation
    --------
    z₁ (ω₁ − ω_c) + z₂ (ω₂ − ω_c) = 0 for every mesh, z₂ < 0 for an internal gear, ω_c = 0 when the frame holds the
    axes; the forces of the meshes do no work, so the torques solve the transposed equations.

    Returns
    -------
    TrainMotion
        The exact ratio, every shaft and mesh, circulating power, and the assembly of a planetary set.

    Raises
    ------
    InadmissibleError
        When the train is locked, its motion is not determined, planets touch or cannot be assembled, or a shaft is
        unknown.

    Notes
    -----
    Exact for any tooth numbers; each printed number is rounded once. Without losses. A worm counts by its threads;
    for crossed or bevel axes the sign of a ratio is that of a spur mesh.

    References
    ----------
    Willis, Principles of Mechanism, 1841; Josephs & Huston, Dynamics of Mechanical Systems, section 17.10.

    Examples
    --------
    >>> train(arrangement=Planetary(sun=24, ring=72)).ratio
    '4'
    """
    known = Known(arrangement, driver, driven, fixed, shafts)
    speeds = known.speeds(speed)
    motion = Motion(known, speeds)
    forces = Forces(known, motion, torque, power)
    assembly = planetary_assembly(arrangement) if isinstance(arrangement, Planetary) else None
    ratio = motion.ratio()
    shaft_results = tuple(_shaft(name, motion, forces) for name in known.names)
    return TrainMotion(
        ratio=None if ratio is None else written(ratio),
        ratio_value=None if ratio is None else _finite(nearest(ratio)),
        freedom=motion.freedom,
        basic_ratio=basic_ratio(arrangement) if isinstance(arrangement, Planetary) else None,
        input_power=_number(forces.input_power()),
        circulating_power=_number(forces.circulating()),
        shafts=shaft_results,
        meshes=tuple(_mesh(mesh, index, motion, forces) for index, mesh in enumerate(known.meshes)),
        assembly=assembly,
        checks=_checks(known, shaft_results),
        advice=motion.advice()
        + forces.advice()
        + (assembly_advice(arrangement) if isinstance(arrangement, Planetary) else ()),
        numerics=_numerics(ratio is not None),
    )


def _shaft(name: str, motion: Motion, forces: Forces) -> ShaftMotion:
    relative = motion.relative(name)
    return ShaftMotion(
        name=name,
        per_driver=None if relative is None else written(relative),
        turns=_number(relative),
        speed=_number(motion.speed(name)),
        torque=_number(forces.torque(name)),
        power=_number(forces.power(name)),
    )


def _mesh(mesh: Mesh, index: int, motion: Motion, forces: Forces) -> MeshMotion:
    first, second = mesh.teeth
    relative_speed, carrier = motion.relative(mesh.first), motion.relative(mesh.carrier)
    relative = None if relative_speed is None or carrier is None else total((relative_speed, (-carrier[0], carrier[1])))
    rolling = rolling_speed(mesh, motion)
    suffix = "" if mesh.carrier == GROUND else f" on {mesh.carrier}"
    return MeshMotion(
        gears=f"{mesh.first} {first} : {mesh.second} {second}{suffix}",
        rolling=None if relative is None else written(relative),
        frequency=None if rolling is None else _finite(abs(nearest(product(rolling, (first, 1)))) / (2.0 * pi)),
        rolling_power=_number(forces.rolling_power(index)),
    )


def _number(value: "Pair | None") -> float | None:
    return None if value is None else _finite(nearest(value))


def _finite(value: float) -> float:
    require(isfinite(value), "a result is beyond the largest double", code="overflow")
    return value


def _checks(known: Known, shafts: tuple[ShaftMotion, ...]) -> tuple[Check, ...]:
    """Check Willis' equation of every mesh and the power balance with the returned numbers."""
    speeds = {shaft.name: shaft.speed if shaft.speed is not None else shaft.turns for shaft in shafts}
    speeds[GROUND] = 0.0
    worst = 0.0
    for mesh in known.meshes:
        turns = [speeds[name] for name in (mesh.first, mesh.second, mesh.carrier)]
        if None in turns:
            continue
        first, second = mesh.teeth
        parts = [first * turns[0], second * turns[1], -first * turns[2], -second * turns[2]]  # type: ignore[operator]
        scale = max(map(abs, parts))
        worst = max(worst, abs(sum(parts)) / scale if scale else 0.0)
    checks = [Check("Willis' equation of every mesh", worst <= 8.0 * ONE_ROUNDING, worst, 8.0 * ONE_ROUNDING)]
    powers = [shaft.power for shaft in shafts if shaft.power is not None]
    scale = sum(map(abs, powers))
    if scale:
        imbalance = abs(sum(powers)) / scale
        checks.append(Check("power in and power out", imbalance <= 8.0 * ONE_ROUNDING, imbalance, 8.0 * ONE_ROUNDING))
    return tuple(checks)


def _numerics(has_ratio: bool) -> Numerics:
    bounds = (ErrorBound("ratio_value", ONE_ROUNDING),) if has_ratio else ()
    return Numerics("Willis' equations solved in whole numbers; each number rounded once", bounds)
