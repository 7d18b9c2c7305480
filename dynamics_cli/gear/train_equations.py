"""A gear train as equations in whole numbers: what is given, how it moves, and the torques that balance it."""

from dynamics_cli.errors import require
from dynamics_cli.gear.train_scene import GROUND, Mesh, Network, Planetary, Shaft, Stages, settled
from dynamics_cli.numerics.rational import Solved, exact, lowest, product, total
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from dynamics_cli.numerics.rational import Pair


class Known:
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
        words = [] if fixed.strip().lower() == "none" else [word for word in fixed.split(",") if word.strip()]
        self.fixed = tuple(dict.fromkeys(self._named(word, "fixed") for word in words if settled(word) != GROUND))
        self.shafts = tuple(Shaft(self._named(one.name, "shaft"), one.speed, one.torque) for one in shafts)
        self.driver = self._named(driver, "driver") if driver else ""
        self.driven = self._named(driven, "driven") if driven else ""
        if isinstance(arrangement, Stages):
            self.driver, self.driven = self.driver or "1", self.driven or self.names[-1]
        elif isinstance(arrangement, Planetary):
            self._settle_planetary(hold=not fixed)
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

    def _settle_planetary(self, *, hold: bool) -> None:
        """Roles that were not named: sun drives, carrier is driven, and the shaft left over is held."""
        taken = [self.driver, self.driven, *self.fixed, *(one.name for one in self.shafts if one.speed is not None)]

        def left_over(*names: str) -> str:
            found = next((name for name in names if name not in taken), "")
            taken.append(found)
            return found

        # a named shaft with a speed may still be the driver or the driven one
        self.driver = self.driver or left_over("sun", "carrier", "ring")
        self.driven = self.driven or left_over("carrier", "ring", "sun")
        held = left_over("ring", "sun", "carrier") if hold else ""
        if held:
            self.fixed = (held,)

    def _require_roles(self) -> None:
        require(
            self.driver in self.names, "name the shaft that drives", code="driver", hint=f"--driver {self.names[0]}"
        )
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


class Motion:
    """Every speed as an exact multiple of those given."""

    def __init__(self, known: Known, given: "Mapping[str, Pair | None]") -> None:
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
            f"the motion of {wanted} is not settled{held}: "
            f"{self.freedom} speeds may be chosen, {len(self._given)} given",
            code="indeterminate",
            hint=f"fix one of {', '.join(open_shafts)}, or give its speed: "
            f'--shaft "name={open_shafts[-1]}, speed=100 rpm"'
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


class Forces:
    """The torques that balance every shaft, as exact multiples of those given, and the powers they carry."""

    def __init__(self, known: Known, motion: Motion, torque: float | None, power: float | None) -> None:
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
        assert speed is not None
        assert power is not None
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
        rolling = rolling_speed(mesh, self.motion)
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
        message = (
            f"statics does not settle the torque on {where}: "
            "the load is shared by parallel ways, or another torque is free"
        )
        return (Advice("torques-open", message, result="input_power"),)


def rolling_speed(mesh: Mesh, motion: Motion) -> "Pair | None":
    """Speed of the first gear against its carrier."""
    first, carrier = motion.speed(mesh.first), motion.speed(mesh.carrier)
    if first is None or carrier is None:
        return None
    return total((first, (-carrier[0], carrier[1])))
