"""Torques of a gear train: the equilibrium of every shaft, solved exactly, and the powers."""

from dynamics_cli.errors import require, worded
from dynamics_cli.gear.trains.equations import Known, Motion, rolling_speed
from dynamics_cli.gear.trains.scene import GROUND
from dynamics_cli.numerics.exact.rational import Solved, exact, product, total
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.exact.rational import Pair


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
        given = {shaft.name: exact(shaft.torque) for shaft in known.shafts if shaft.torque is not None}
        if torque is None and power is None:
            return given
        require(
            known.driver not in given, "the driver {driver} has two torques", driver=known.driver, code="two-torques"
        )
        if torque is not None:
            given[known.driver] = exact(torque)
            return given
        speed = self.motion.speed(known.driver)
        require(speed is not None, "power needs the speed of the driver", code="speed", hint="give --speed")
        assert speed is not None
        assert power is not None
        require(speed[0] != 0, "a driver at rest takes no power", code="speed", hint="give --torque")
        given[known.driver] = product(exact(power), (speed[1], speed[0]))
        return given

    def _solve(self) -> None:
        known = self.known
        loaded = dict.fromkeys((known.driver, known.driven, *known.fixed, *(shaft.name for shaft in known.shafts)))
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
            "nothing balances the torque on {names}",
            names=", ".join(self.given),
            code="torque",
            hint="name the driven shaft, or give fewer torques",
        )
        torques = {name: self._value(solved.terms(column)) for name, column in columns.items()}
        forces = [self._value(solved.terms(column)) for column in range(len(known.meshes))]
        self.open = tuple(name for name, value in torques.items() if value is None)
        if self.open or None in forces:
            self.open = self.open or ("the meshes",)
            return
        self._values = {name: value for name, value in torques.items() if value is not None}
        self._mesh_forces = [value for value in forces if value is not None]

    def _value(self, terms: "tuple[Pair, ...] | None") -> "Pair | None":
        if terms is None:
            return None
        return total(product(term, torque) for term, torque in zip(terms, self.given.values(), strict=True))

    def torque(self, name: str) -> "Pair | None":
        """External torque; zero on a shaft that is neither driven nor held."""
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
        """Advice on torques that statics alone does not determine."""
        if not self.open:
            return ()
        where = ", ".join(self.open)
        message = worded(
            "statics alone does not determine the torque on {where}: the load is shared by parallel paths, or "
            "another torque is free",
            where=where,
        )
        return (Advice("torques-open", message, result="input_power"),)
