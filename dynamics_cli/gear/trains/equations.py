"""A gear train as equations in integers: givens, motion, and balancing torques."""

from dynamics_cli.errors import require, worded
from dynamics_cli.gear.trains.scene import GROUND, Mesh, Network, Planetary, Shaft, Stages, settled
from dynamics_cli.numerics.exact.rational import Solved, exact, lowest, product, total
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from dynamics_cli.numerics.exact.rational import Pair


class Known:
    """The train as indices and integers, with its givens."""

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
        self.shafts = tuple(Shaft(self._named(s.name, "shaft"), s.speed, s.torque) for s in shafts)
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
            "there is no shaft {word} ({role}): the shafts are {names}",
            word=repr(word.strip()),
            role=role,
            names=", ".join(self.names),
            code="unknown-shaft",
        )
        return name

    def _settle_planetary(self, *, hold: bool) -> None:
        """Default roles: the sun drives, the carrier is driven, and the remaining shaft is held."""
        taken = [self.driver, self.driven, *self.fixed, *(s.name for s in self.shafts if s.speed is not None)]

        def left_over(*names: str) -> str:
            remaining = next((name for name in names if name not in taken), "")
            taken.append(remaining)
            return remaining

        # a shaft with a given speed may still be the driver or the driven one
        self.driver = self.driver or left_over("sun", "carrier", "ring")
        self.driven = self.driven or left_over("carrier", "ring", "sun")
        held_shaft = left_over("ring", "sun", "carrier") if hold else ""
        if held_shaft:
            self.fixed = (held_shaft,)

    def _require_roles(self) -> None:
        require(
            self.driver in self.names,
            "name the shaft that drives",
            shaft=self.names[0],
            code="driver",
            hint="--driver {shaft}",
        )
        require(
            self.driver not in self.fixed,
            "the driver {driver} is also held fixed: it cannot turn",
            driver=self.driver,
            code="fixed-driver",
        )
        require(
            self.driver != self.driven,
            "{driver} cannot both drive and be driven",
            driver=self.driver,
            code="same-shaft",
        )

    def _row(self, mesh: Mesh) -> list[int]:
        row = [0] * len(self.names)
        first, second = mesh.teeth
        for name, teeth in ((mesh.first, first), (mesh.second, second), (mesh.carrier, -first - second)):
            if name != GROUND:
                row[self.names.index(name)] += teeth
        return row

    def speeds(self, speed: float | None) -> "dict[str, Pair | None]":
        """Shafts whose speed is given; None for a driver that turns by one."""
        speeds_known: dict[str, Pair | None] = {}
        for s in self.shafts:
            if s.speed is not None:
                require(s.name not in self.fixed, "{name} is fixed and has a speed", name=s.name, code="fixed-speed")
                require(s.name not in speeds_known, "{name} has two speeds", name=s.name, code="two-speeds")
                speeds_known[s.name] = exact(s.speed)
        if speed is not None:
            require(
                self.driver not in speeds_known,
                "the driver {driver} has two speeds",
                driver=self.driver,
                code="two-speeds",
            )
            speeds_known[self.driver] = exact(speed)
        return speeds_known or {self.driver: None}


def _require_mesh(mesh: Mesh) -> None:
    require(
        mesh.first_teeth > 0 and mesh.second_teeth > 0,
        "a gear of the mesh {first}–{second} has no teeth",
        first=mesh.first,
        second=mesh.second,
        code="teeth",
    )
    distinct = len({mesh.first, mesh.second, mesh.carrier}) == 3
    require(
        distinct,
        "the mesh {first}–{second} needs two shafts and a carrier, all different",
        first=mesh.first,
        second=mesh.second,
        code="mesh",
    )
    require(
        not mesh.internal or mesh.second_teeth > mesh.first_teeth,
        "an internal gear of {second_teeth} teeth cannot hold a gear of {first_teeth}",
        second_teeth=mesh.second_teeth,
        first_teeth=mesh.first_teeth,
        code="no-room",
    )


class Motion:
    """Every speed as an exact multiple of the given ones."""

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
        """Turns for each turn of the driver, if one speed determines all."""
        terms, driver = self.terms(name), self.terms(self.known.driver)
        if terms is None or driver is None or len(terms) != 1 or driver[0][0] == 0:
            return None
        return product(terms[0], (driver[0][1], driver[0][0]))

    def speed(self, name: str) -> "Pair | None":
        """The speed in radians per second, where speeds were given."""
        terms = self.terms(name)
        if terms is None or None in self._given.values():
            return None
        return total(product(term, omega) for term, omega in zip(terms, self._given.values(), strict=True) if omega)

    def ratio(self) -> "Pair | None":
        """Driver over driven."""
        driven = self.relative(self.known.driven) if self.known.driven else None
        return None if driven is None or driven[0] == 0 else lowest(driven[1], driven[0])

    def _require_motion(self) -> None:
        known = self.known
        fixed = f" with {', '.join(known.fixed)} fixed" if known.fixed else ""
        require(
            self.freedom > 0,
            "the train is locked{held}: its meshes allow no motion of its {count} shafts",
            held=fixed,
            count=len(self._names),
            code="locked",
            hint="release {last}" if known.fixed else "leave out a mesh",
            last=known.fixed[-1] if known.fixed else "",
        )
        conflict = [self._names[column] for column in self._solved.conflict]
        if conflict and len(self._given) == 1:
            require(
                False,
                "{driver} cannot turn{held}: the train locks it",
                driver=known.driver,
                held=fixed,
                code="locked",
                hint="drive another shaft",
            )
        require(
            not conflict,
            "{count} speeds are given ({names}), but only {free} can be chosen freely{held}",
            count=len(self._given),
            names=", ".join(self._given),
            free=len(self._given) - len(conflict),
            held=fixed,
            code="too-many-speeds",
            hint="leave out the speed of {last}",
            last=conflict[-1] if conflict else "",
        )
        open_shafts = [name for name in self._names if self.terms(name) is None]
        s = known.driven or known.driver
        require(
            self.terms(s) is not None and self.terms(known.driver) is not None,
            "the motion of {wanted} is not determined{held}: {freedom} speeds can be chosen and {count} are given",
            wanted=s,
            held=fixed,
            freedom=self.freedom,
            count=len(self._given),
            code="indeterminate",
            hint='fix one of {shafts}, or give its speed: --shaft "name={last}, speed=100 rpm"'
            if open_shafts
            else None,
            shafts=", ".join(open_shafts),
            last=open_shafts[-1] if open_shafts else "",
        )

    def advice(self) -> tuple[Advice, ...]:
        """Advice on undetermined motion, and on a driven shaft that stands still."""
        advices = []
        driven = self.relative(self.known.driven) if self.known.driven else None
        if driven is not None and driven[0] == 0:
            message = worded("{driven} stands still at every speed of the driver", driven=self.known.driven)
            advices.append(Advice("driven-stands", message, "serious", result="ratio"))
        loose = [name for name in self._names if self.terms(name) is None]
        if loose:
            advices.append(
                Advice("loose-shafts", worded("the motion of {names} is not determined", names=", ".join(loose)))
            )
        return tuple(advices)


def rolling_speed(mesh: Mesh, motion: Motion) -> "Pair | None":
    """Speed of the first gear against its carrier."""
    first, carrier = motion.speed(mesh.first), motion.speed(mesh.carrier)
    if first is None or carrier is None:
        return None
    return total((first, (-carrier[0], carrier[1])))
