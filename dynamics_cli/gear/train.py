"""Gear trains of any kind, solved exactly: speeds, torques, powers and what keeps a train from moving."""

from math import isfinite, pi

from dynamics_cli.errors import require
from dynamics_cli.gear.planets import Assembly, assembly_advice, basic_ratio, planetary_assembly
from dynamics_cli.gear.train_scene import GROUND, Mesh, Network, Planetary, Shaft, Stages, settled
from dynamics_cli.numerics.rational import Solved, exact, lowest, nearest, product, total, written
from dynamics_cli.quantities import Frequency, Power, Ratio, ShaftSpeed, Text, Torque
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dynamics_cli.numerics.rational import Pair

ONE_ROUNDING = 2.0**-53


@record
class ShaftMotion:
    """What one shaft does.

    Parameters
    ----------
    name : Text
        The shaft.
    per_driver : Text
        Its turns for each turn of the driver, exact.
    turns : Ratio
        The same as a number.
    speed : ShaftSpeed
        Its speed [rad/s].
    torque : Torque
        The torque put on it from outside; on a fixed shaft, what holds it [N*m].
    power : Power
        The power put in at it from outside; negative where it is taken out [W].
    """

    name: Text
    per_driver: Text | None = None
    turns: Ratio | None = None
    speed: ShaftSpeed | None = None
    torque: Torque | None = None
    power: Power | None = None


@record
class MeshMotion:
    """What goes on in one mesh.

    Parameters
    ----------
    gears : Text
        The shafts and tooth numbers that meet.
    rolling : Text
        Turns of the first gear against the carrier for each turn of the driver, exact.
    frequency : Frequency
        Teeth that meet in a second [Hz].
    rolling_power : Power
        Power through the teeth as seen from the carrier: what the losses of the mesh are a share of [W].
    """

    gears: Text
    rolling: Text | None = None
    frequency: Frequency | None = None
    rolling_power: Power | None = None


@record
class TrainMotion:
    """Speeds, torques and powers of a train.

    Parameters
    ----------
    ratio : Text
        Speed of the driver over speed of the driven shaft, exact; negative when they turn against each other.
    ratio_value : Ratio
        The same as a number.
    freedom : int
        How many speeds may be chosen freely.
    basic_ratio : Text
        Planetary: speed of the sun over speed of the ring with the carrier held, exact (Willis).
    input_power : Power
        All power put in [W].
    circulating_power : Power
        Power that runs in a loop between the parts of the train, beyond all that is put in [W].
    shafts : tuple of ShaftMotion
        Every shaft.
    meshes : tuple of MeshMotion
        Every mesh.
    assembly : Assembly
        Planetary: whether the planets can be put in, and where.
    """

    ratio: Text | None
    ratio_value: Ratio | None
    freedom: int
    basic_ratio: Text | None
    input_power: Power | None
    circulating_power: Power | None
    shafts: tuple[ShaftMotion, ...]
    meshes: tuple[MeshMotion, ...]
    assembly: Assembly | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def train(
    *,
    arrangement: Stages | Planetary | Network,
    driver: Text = "",
    driven: Text = "",
    fixed: Text = "",
    speed: ShaftSpeed | None = None,
    torque: Torque | None = None,
    power: Power | None = None,
    shafts: tuple[Shaft, ...] = (),
) -> TrainMotion:
    """Speeds, torques and powers of any gear train, from Willis' equation of every mesh solved in whole numbers.

    Equation
    --------
    z₁ (ω₁ − ω_c) + z₂ (ω₂ − ω_c) = 0 for every mesh, z₂ < 0 for an internal gear, ω_c = 0 when the frame holds the
    axes; the forces of the meshes do no work, so the torques solve the transposed equations.

    Parameters
    ----------
    arrangement : Stages | Planetary | Network
        Stages held by the frame, a planetary set, or any meshes.
    driver : Text
        The shaft that drives. First of the stages, or the sun, unless given.
    driven : Text
        The shaft that is driven. Last of the stages, or the carrier, unless given.
    fixed : Text
        Shafts held still, commas between them. The ring of a planetary set unless given; `none` holds nothing.
    speed : ShaftSpeed
        Speed of the driver [rad/s].
    torque : Torque
        Torque put in at the driver [N*m].
    power : Power
        Power put in at the driver, instead of its torque [W].
    shafts : tuple of Shaft
        Speeds and torques known of other shafts: a differential needs a second speed.

    Returns
    -------
    TrainMotion
        The exact ratio, every shaft and mesh, circulating power, and the assembly of a planetary set.

    Raises
    ------
    InadmissibleError
        When the train is locked, its motion is not settled by what is given, planets touch or cannot be put in, or a
        shaft is not of the train.

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
    known = _Known(arrangement, driver, driven, fixed, shafts)
    speeds = known.speeds(speed)
    motion = _Motion(known, speeds)
    forces = _Forces(known, motion, torque, power)
    assembly = planetary_assembly(arrangement) if isinstance(arrangement, Planetary) else None
    ratio = motion.ratio()
    shown = tuple(_shaft(name, motion, forces) for name in known.names)
    given_power = forces.input_power()
    circulating = forces.circulating()
    result = TrainMotion(
        ratio=None if ratio is None else written(ratio),
        ratio_value=None if ratio is None else _finite(nearest(ratio)),
        freedom=motion.freedom,
        basic_ratio=basic_ratio(arrangement) if isinstance(arrangement, Planetary) else None,
        input_power=_number(given_power),
        circulating_power=_number(circulating),
        shafts=shown,
        meshes=tuple(_mesh(mesh, index, motion, forces) for index, mesh in enumerate(known.meshes)),
        assembly=assembly,
        checks=_checks(known, shown),
        advice=motion.advice() + forces.advice() + (assembly_advice(arrangement) if assembly else ()),
        numerics=_numerics(ratio is not None),
    )
    return result  # noqa: RET504


class _Known:
    """The train as indices and whole numbers, with what is given of it."""

    def __init__(
        self, arrangement: Stages | Planetary | Network, driver: str, driven: str, fixed: str, shafts: tuple[Shaft, ...]
    ) -> None:
        meshes = arrangement.meshes if isinstance(arrangement, Network) else arrangement.meshes()
        self.meshes = tuple(
            Mesh(settled(m.first), m.first_teeth, settled(m.second), m.second_teeth, m.internal, settled(m.carrier))
            for m in meshes
        )
        names = [name for mesh in self.meshes for name in (mesh.first, mesh.second, mesh.carrier) if name != GROUND]
        self.names = tuple(dict.fromkeys(names))
        for mesh in self.meshes:
            _require_mesh(mesh)
        first, last, held = _usual(arrangement, self.names)
        self.driver = self._named(driver, "driver") if driver else first
        words = [] if fixed.strip().lower() == "none" else [word for word in fixed.split(",") if word.strip()]
        self.fixed = tuple(dict.fromkeys(self._named(word, "fixed") for word in words if settled(word) != GROUND))
        self.driven = self._named(driven, "driven") if driven else last
        self.shafts = tuple(Shaft(self._named(one.name, "shaft"), one.speed, one.torque) for one in shafts)
        if not fixed and held and held not in (driver, driven) and not any(one.name == held for one in self.shafts):
            self.fixed = (held,)
        if not driven and last in (self.driver, *self.fixed):
            self.driven = next(
                (
                    name
                    for name in ("carrier", "ring", "sun")
                    if name in names and name not in (self.driver, *self.fixed)
                ),
                "",
            )
        self._require_roles()
        self.rows = [self._row(mesh) for mesh in self.meshes]

    def _named(self, word: str, role: str) -> str:
        name = settled(word)
        require(
            name in self.names,
            f"there is no shaft {word.strip()!r} ({role}): the shafts are {', '.join(self.names)}",
            code="unknown-shaft",
        )
        return name

    def _require_roles(self) -> None:
        require(self.driver != "", "name the shaft that drives", code="driver", hint=f"--driver {self.names[0]}")
        require(
            self.driver not in self.fixed,
            f"the driver {self.driver} is also held fixed: it cannot turn",
            code="fixed-driver",
        )
        require(self.driver != self.driven, f"{self.driver} cannot both drive and be driven", code="same-shaft")

    def _row(self, mesh: Mesh) -> list[int]:
        row = [0] * len(self.names)
        first, second = mesh.teeth
        for name, teeth in ((mesh.first, first), (mesh.second, second), (mesh.carrier, -first - second)):
            if name != GROUND:
                row[self.names.index(name)] += teeth
        return row

    def speeds(self, speed: float | None) -> "dict[str, Pair | None]":
        """Shafts whose speed is given; None for a driver that turns by one."""
        found: dict[str, Pair | None] = {}
        for one in self.shafts:
            if one.speed is not None:
                require(one.name not in self.fixed, f"{one.name} is fixed and has a speed", code="fixed-speed")
                require(one.name not in found, f"{one.name} has two speeds", code="two-speeds")
                found[one.name] = exact(one.speed)
        if speed is not None:
            require(self.driver not in found, f"the driver {self.driver} has two speeds", code="two-speeds")
            found[self.driver] = exact(speed)
        return found or {self.driver: None}


def _require_mesh(mesh: Mesh) -> None:
    require(
        mesh.first_teeth > 0 and mesh.second_teeth > 0,
        "a gear of the mesh {0}–{1} has no teeth",
        mesh.first,
        mesh.second,
        code="teeth",
    )
    distinct = len({mesh.first, mesh.second, mesh.carrier}) == 3
    require(distinct, f"the mesh {mesh.first}–{mesh.second} needs two shafts and a carrier, all different", code="mesh")
    require(
        not mesh.internal or mesh.second_teeth > mesh.first_teeth,
        "an internal gear of {0} teeth has no room for a gear of {1}",
        mesh.second_teeth,
        mesh.first_teeth,
        code="no-room",
    )


def _usual(arrangement: Stages | Planetary | Network, names: "Sequence[str]") -> tuple[str, str, str]:
    """Driver, driven and fixed shaft where none is named."""
    if isinstance(arrangement, Stages):
        return "1", str(len(names)), ""
    return ("sun", "carrier", "ring") if isinstance(arrangement, Planetary) else ("", "", "")


class _Motion:
    """Every speed as an exact multiple of those given."""

    def __init__(self, known: _Known, given: "Mapping[str, Pair | None]") -> None:
        self.known = known
        names = [name for name in known.names if name not in known.fixed]
        columns = [known.names.index(name) for name in names]
        rows = [[row[column] for column in columns] for row in known.rows]
        self._solved = Solved(rows, len(names), [names.index(name) for name in given])
        self._names = names
        self._given = dict(given)
        self.freedom = self._solved.freedom
        self._require_motion()

    def terms(self, name: str) -> "tuple[Pair, ...] | None":
        """The shaft's speed as multiples of the given ones."""
        if name in self.known.fixed or name == GROUND:
            return ((0, 1),) * len(self._given)
        return self._solved.terms(self._names.index(name))

    def relative(self, name: str) -> "Pair | None":
        """Turns for each turn of the driver, where one speed settles all."""
        terms, driver = self.terms(name), self.terms(self.known.driver)
        if terms is None or driver is None or len(terms) != 1 or driver[0][0] == 0:
            return None
        return product(terms[0], (driver[0][1], driver[0][0]))

    def speed(self, name: str) -> "Pair | None":
        """The speed in radians per second, where speeds were given."""
        terms = self.terms(name)
        if terms is None or None in self._given.values():
            return None
        return total(product(term, own) for term, own in zip(terms, self._given.values(), strict=True) if own)

    def ratio(self) -> "Pair | None":
        """Driver over driven."""
        driven = self.relative(self.known.driven) if self.known.driven else None
        return None if driven is None or driven[0] == 0 else lowest(driven[1], driven[0])

    def _require_motion(self) -> None:
        known = self.known
        held = f" with {', '.join(known.fixed)} fixed" if known.fixed else ""
        require(
            self.freedom > 0,
            f"the train is locked{held}: its meshes leave {len(self._names)} shafts no motion",
            code="locked",
            hint=f"release {known.fixed[-1]}" if known.fixed else "leave out a mesh",
        )
        conflict = [self._names[column] for column in self._solved.conflict]
        if conflict and len(self._given) == 1:
            require(
                False,
                f"{known.driver} cannot turn{held}: the train locks it",
                code="locked",
                hint="drive another shaft",
            )
        require(
            not conflict,
            f"{len(self._given)} speeds are given ({', '.join(self._given)}), but only "
            f"{len(self._given) - len(conflict)} can be chosen freely{held}",
            code="too-many-speeds",
            hint=f"leave out the speed of {conflict[-1]}" if conflict else None,
        )
        open_shafts = [name for name in self._names if self.terms(name) is None]
        wanted = known.driven or known.driver
        require(
            self.terms(wanted) is not None and self.terms(known.driver) is not None,
            f"the motion of {wanted} is not settled{held}: {self.freedom} speeds may be chosen, {len(self._given)} given",
            code="indeterminate",
            hint=f'fix one of {", ".join(open_shafts)}, or give its speed: --shaft "name={open_shafts[-1]}, speed=100 rpm"'
            if open_shafts
            else None,
        )

    def advice(self) -> tuple[Advice, ...]:
        """What the motion does not settle, and a driven shaft that stands still."""
        found = []
        driven = self.relative(self.known.driven) if self.known.driven else None
        if driven is not None and driven[0] == 0:
            found.append(
                Advice(
                    "driven-stands",
                    f"{self.known.driven} stands still whatever the driver does",
                    "serious",
                    result="ratio",
                )
            )
        loose = [name for name in self._names if self.terms(name) is None]
        if loose:
            found.append(Advice("loose-shafts", f"nothing settles the motion of {', '.join(loose)}"))
        return tuple(found)


class _Forces:
    """The torques that balance every shaft, as exact multiples of those given, and the powers they carry."""

    def __init__(self, known: _Known, motion: _Motion, torque: float | None, power: float | None) -> None:
        self.known = known
        self.motion = motion
        self.given = self._given(torque, power)
        self.open: tuple[str, ...] = ()
        self._values: dict[str, Pair] | None = None
        self._mesh_forces: list[Pair] = []
        if self.given:
            self._solve()

    def _given(self, torque: float | None, power: float | None) -> "dict[str, Pair]":
        known = self.known
        require(torque is None or power is None, "give the torque or the power of the driver, not both", code="torque")
        found = {one.name: exact(one.torque) for one in known.shafts if one.torque is not None}
        if torque is None and power is None:
            return found
        require(known.driver not in found, f"the driver {known.driver} has two torques", code="two-torques")
        if torque is not None:
            found[known.driver] = exact(torque)
            return found
        speed = self.motion.speed(known.driver)
        require(speed is not None, "power needs the speed of the driver", code="speed", hint="give --speed")
        assert speed is not None and power is not None
        require(speed[0] != 0, "a driver at rest takes no power", code="speed", hint="give --torque")
        found[known.driver] = product(exact(power), (speed[1], speed[0]))
        return found

    def _solve(self) -> None:
        known = self.known
        loaded = dict.fromkeys((known.driver, known.driven, *known.fixed, *(one.name for one in known.shafts)))
        ends = [name for name in loaded if name]
        width = len(known.meshes) + len(ends)
        rows = []
        for place, name in enumerate(known.names):
            row = [mesh[place] for mesh in known.rows] + [1 if name == end else 0 for end in ends]
            rows.append(row)
        columns = {name: len(known.meshes) + place for place, name in enumerate(ends)}
        solved = Solved(rows, width, [columns[name] for name in self.given])
        require(
            not solved.conflict,
            f"nothing takes up the torque on {', '.join(self.given)}",
            code="torque",
            hint="name the driven shaft, or give fewer torques",
        )
        found = {name: self._value(solved.terms(column)) for name, column in columns.items()}
        forces = [self._value(solved.terms(column)) for column in range(len(known.meshes))]
        self.open = tuple(name for name, value in found.items() if value is None)
        if self.open or None in forces:
            self.open = self.open or ("the meshes",)
            return
        self._values = {name: value for name, value in found.items() if value is not None}
        self._mesh_forces = [value for value in forces if value is not None]

    def _value(self, terms: "tuple[Pair, ...] | None") -> "Pair | None":
        if terms is None:
            return None
        return total(product(term, own) for term, own in zip(terms, self.given.values(), strict=True))

    def torque(self, name: str) -> "Pair | None":
        """Torque from outside; none on a shaft that is neither driven nor held."""
        return None if self._values is None else self._values.get(name, (0, 1))

    def power(self, name: str) -> "Pair | None":
        """Power from outside."""
        torque, speed = self.torque(name), self.motion.speed(name)
        return None if torque is None or speed is None else product(torque, speed)

    def rolling_power(self, index: int) -> "Pair | None":
        """Power through the teeth of a mesh seen from its carrier."""
        mesh = self.known.meshes[index]
        rolling = _rolling(mesh, self.motion)
        if self._values is None or rolling is None:
            return None
        power = product(self._mesh_forces[index], (mesh.teeth[0], 1), rolling)
        return abs(power[0]), power[1]

    def input_power(self) -> "Pair | None":
        """All power put in."""
        powers = [self.power(name) for name in self.known.names]
        if any(power is None for power in powers):
            return None
        return total(power for power in powers if power is not None and power[0] > 0)

    def circulating(self) -> "Pair | None":
        """The largest flow between shafts and gear sets, beyond the power put in; meshes on one carrier are one set."""
        put_in = self.input_power()
        if put_in is None:
            return None
        sets: dict[object, list[int]] = {}
        for index, mesh in enumerate(self.known.meshes):
            sets.setdefault(index if mesh.carrier == GROUND else mesh.carrier, []).append(index)
        largest = put_in
        for members in sets.values():
            for place, name in enumerate(self.known.names):
                speed = self.motion.speed(name)
                if speed is None:
                    continue
                rows = self.known.rows
                torque = total(product(self._mesh_forces[index], (rows[index][place], 1)) for index in members)
                flow = product(torque, speed)
                if abs(flow[0]) * largest[1] > largest[0] * flow[1]:
                    largest = (abs(flow[0]), flow[1])
        return total((largest, (-put_in[0], put_in[1])))

    def advice(self) -> tuple[Advice, ...]:
        """Torques that statics alone does not settle."""
        if not self.open:
            return ()
        where = ", ".join(self.open)
        message = f"statics does not settle the torque on {where}: the load is shared by parallel ways, or another torque is free"
        return (Advice("torques-open", message, result="input_power"),)


def _rolling(mesh: Mesh, motion: _Motion) -> "Pair | None":
    """Speed of the first gear against its carrier."""
    first, carrier = motion.speed(mesh.first), motion.speed(mesh.carrier)
    if first is None or carrier is None:
        return None
    return total((first, (-carrier[0], carrier[1])))


def _shaft(name: str, motion: _Motion, forces: _Forces) -> ShaftMotion:
    relative = motion.relative(name)
    return ShaftMotion(
        name=name,
        per_driver=None if relative is None else written(relative),
        turns=_number(relative),
        speed=_number(motion.speed(name)),
        torque=_number(forces.torque(name)),
        power=_number(forces.power(name)),
    )


def _mesh(mesh: Mesh, index: int, motion: _Motion, forces: _Forces) -> MeshMotion:
    first, second = mesh.teeth
    own, carrier = motion.relative(mesh.first), motion.relative(mesh.carrier)
    relative = None if own is None or carrier is None else total((own, (-carrier[0], carrier[1])))
    rolling = _rolling(mesh, motion)
    held = "" if mesh.carrier == GROUND else f" on {mesh.carrier}"
    return MeshMotion(
        gears=f"{mesh.first} {first} : {mesh.second} {second}{held}",
        rolling=None if relative is None else written(relative),
        frequency=None if rolling is None else _finite(abs(nearest(product(rolling, (first, 1)))) / (2.0 * pi)),
        rolling_power=_number(forces.rolling_power(index)),
    )


def _number(value: "Pair | None") -> float | None:
    return None if value is None else _finite(nearest(value))


def _finite(value: float) -> float:
    require(isfinite(value), "a result is beyond the largest double", code="overflow")
    return value


def _checks(known: _Known, shafts: tuple[ShaftMotion, ...]) -> tuple[Check, ...]:
    """Willis' equation of every mesh, and the balance of power, from the numbers that were returned."""
    speeds = {one.name: one.speed if one.speed is not None else one.turns for one in shafts}
    speeds[GROUND] = 0.0
    worst = 0.0
    for mesh in known.meshes:
        own = [speeds[name] for name in (mesh.first, mesh.second, mesh.carrier)]
        if None in own:
            continue
        first, second = mesh.teeth
        parts = [first * own[0], second * own[1], -first * own[2], -second * own[2]]  # type: ignore[operator]
        scale = max(map(abs, parts))
        worst = max(worst, abs(sum(parts)) / scale if scale else 0.0)
    found = [Check("Willis' equation of every mesh", worst <= 8.0 * ONE_ROUNDING, worst, 8.0 * ONE_ROUNDING)]
    powers = [one.power for one in shafts if one.power is not None]
    scale = sum(map(abs, powers))
    if scale:
        left = abs(sum(powers)) / scale
        found.append(Check("power in and power out", left <= 8.0 * ONE_ROUNDING, left, 8.0 * ONE_ROUNDING))
    return tuple(found)


def _numerics(has_ratio: bool) -> Numerics:
    bounds = (ErrorBound("ratio_value", ONE_ROUNDING),) if has_ratio else ()
    return Numerics("Willis' equations solved in whole numbers; each number rounded once", bounds)
