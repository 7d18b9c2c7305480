"""Answers of `cam force` beside exact ones, and jump speeds, for the search."""

from collections.abc import Iterator
from typing import Any

from cam_search_compared import Compared, Stated, nearest, placed
from cam_search_contact import Carried, extreme
from cam_search_motion import Jet, Turn
from cam_search_tables import MISSED, NOTHING, doubles, follower_of
from precise import FUNCTIONS, Exact, exact_pi

from dynamics_cli.cam.forces.forces import force
from dynamics_cli.cam.forces.records import ArmOnSpring, ArmOnTorsionSpring, Contact, Slide
from dynamics_cli.cam.geometry.followers import Rotation

TRAINS = {one.__name__: one for one in (Slide, ArmOnTorsionSpring, ArmOnSpring)}


class Pressed:
    """A follower's load, and the force along the common normal by statics."""

    def __init__(self, train: dict[str, str], speed: float, carried: Carried | None) -> None:
        given = {key: Exact(value) for key, value in doubles(train).items()}
        none = Exact(0)
        self.carried = carried
        arm = given.get("spring_radius", Exact(1))
        self.inertia = given.get("mass", none) + given.get("inertia", none)
        self.rate = given.get("spring_rate", none) * arm * arm + given.get("torsion_rate", none)
        self.preload = given.get("preload", none) * arm + given.get("preload_torque", none)
        self.steady = self.preload + given.get("load", none) + given.get("load_torque", none)
        self.arm, self.square = arm, Exact(speed) ** 2

    def _kind(self, s: Any) -> tuple[Any, ...]:
        given = (self.rate, self.steady, self.inertia, self.square)
        return tuple(map(float, given)) if hasattr(s, "shape") else given

    def force(self, s: Any, _: Any, s2: Any) -> Any:
        """Spring, load and inertia."""
        rate, steady, inertia, square = self._kind(s)
        return rate * s + steady + inertia * square * s2

    def lifting(self, s: Any, _: Any, s2: Any) -> Any:
        """1/ω² at which the load vanishes."""
        rate, steady, inertia, _ = self._kind(s)
        return -inertia * s2 / (rate * s + steady)

    def normal(self, s: Any, s1: Any, s2: Any) -> Any:
        """The balance along the slide, or of the arm's moments about its pivot."""
        assert self.carried is not None
        touch = self.carried.touch(s, s1, s2)
        (x, y), (nx, ny) = touch["point"], touch["normal"]
        given = self.force(s, s1, s2)
        if not self.carried.swing:
            return given / ny
        pivot = self.carried.f["pivot_distance"]
        x = x - (float(pivot) if hasattr(s, "shape") else pivot)
        # clockwise lifts the arm
        return given / (y * nx - x * ny)

    def crowding(self, s: Any, s1: Any, s2: Any) -> Any:
        """Normal force times the sum of both curvatures."""
        assert self.carried is not None
        touch, roller = self.carried.touch(s, s1, s2), self.carried.roller
        if self.carried.flat:
            return self.normal(s, s1, s2) / touch["radius"]
        radius = float(roller) if hasattr(s, "shape") else roller
        return self.normal(s, s1, s2) / (radius * (1 - radius * touch["curvature"]))


def pressing(case: dict[str, Any]) -> Iterator[Compared]:
    """`cam force`: extremes, jump speed, stress and tables."""
    tree, speed, count = case.get("follower"), float(case["shaft_speed"]), int(case.get("count", 9))
    contact = case.get("contact")
    turn = Turn(case["program"])
    answer = force(
        NOTHING, program=case["program"], shaft_speed=speed, follower=tree and follower_of(tree), count=count,
        train=TRAINS[case["train"]["record"]](**doubles(case["train"])),
        contact=contact and Contact(**doubles(contact)), rotation=Rotation(case.get("rotation", "ccw")),
    )  # fmt: skip
    stated = Stated(answer)
    carried = Carried(tree, case.get("rotation", "")) if tree else None
    pressed = Pressed(case["train"], speed, carried)
    arm = turn.swing
    own = "arm_torque" if arm else "force"
    quantities = [(own, pressed.force), ("torque", lambda *state: pressed.force(*state) * state[1])]
    if carried is not None:
        quantities.append(("contact_force", pressed.normal))
    sizes = {}
    least = None
    for name, quantity in quantities:
        low, high = (extreme(turn, quantity, sign) for sign in (-1, 1))
        least = low if least is None else least
        sizes[name] = size = max(float(abs(low)), float(abs(high)))
        for end, exact in (("least", low), ("greatest", high)):
            address = f"{end}_{name}"
            yield from stated.compare(address, getattr(answer, address), exact, size=size)
            yield from placed(address, getattr(answer, f"{address}_at"), turn, quantity, exact, MISSED * size)
        if name == "torque":
            power = max(abs(low), abs(high)) * abs(Exact(speed))
            yield from stated.compare("greatest_power", answer.greatest_power, power)
    needed = max(pressed.preload - least, Exact(0)) / (pressed.arm if case["train"]["record"] == "ArmOnSpring" else 1)
    for name in ("preload_needed", "preload_torque_needed"):
        room = MISSED * (sizes[own] + float(pressed.preload)) / float(pressed.arm)
        yield from stated.compare(name, getattr(answer, name), needed, room, size=room / MISSED)
    yield from _limits(answer, turn, stated, pressed, case)
    yield from _pressed_rows(answer, turn, stated, pressed, sizes)


def _limits(answer: Any, turn: Turn, stated: Stated, pressed: Pressed, case: dict[str, Any]) -> Iterator[Compared]:
    """The speed at which the follower jumps, and the greatest stress."""
    yield from jumping(answer, turn, stated, pressed)
    if answer.stress is not None:
        worst = extreme(turn, pressed.crowding, 1)
        # steel on steel: 206 GPa and 0.3 are the doubles that the program takes
        give = 2 * (1 - Exact(0.3) ** 2) / Exact(206e9)
        width = Exact(float(case["contact"]["width"]))
        exact = FUNCTIONS["sqrt"](max(worst, Exact(0)) / (exact_pi() * width * give))
        yield from stated.compare("stress", answer.stress, exact)


def jumping(answer: Any, turn: Turn, stated: Stated, pressed: Pressed) -> Iterator[Compared]:
    """The jump speed; where nothing but rounding holds a follower that rests, the quotient is 0/0 and left out."""
    if not answer.jump_speed or pressed.steady <= 0:
        return

    def down(s: Any, s1: Any, s2: Any) -> Any:
        return s2.value < 0 if isinstance(s2, Jet) else s2 < 0

    lifted = extreme(turn, pressed.lifting, 1, only=down, rests=False)
    if lifted is not None and lifted > 0:
        yield from stated.compare("jump_speed", answer.jump_speed, FUNCTIONS["sqrt"](1 / lifted))


def _pressed_rows(
    answer: Any, turn: Turn, stated: Stated, pressed: Pressed, sizes: dict[str, float]
) -> Iterator[Compared]:
    words, own, force_name = ("arm_table", "swing", "arm_torque") if turn.swing else ("table", "lift", "axial_force")
    arrays = getattr(answer, words).arrays
    contacts = answer.contact_table.arrays if answer.contact_table is not None else None
    travel = max(abs(level) for level in turn.levels)
    for index, theta in enumerate(arrays["angle"].tolist()):
        states = [zone.at(at, 2) for zone, at in turn.zones_at(theta)]
        force_size = sizes["arm_torque" if turn.swing else "force"]
        rows = [
            (f"{words}[{index}].{own}", arrays[own][index], lambda *state: state[0], travel),
            (f"{words}[{index}].{force_name}", arrays[force_name][index], pressed.force, force_size),
            (f"{words}[{index}].torque", arrays["torque"][index], lambda *state: pressed.force(*state) * state[1],
             sizes["torque"]),
        ]  # fmt: skip
        if contacts is not None and pressed.carried is not None:
            rows += [
                (f"contact_table[{index}].pressure_angle", contacts["pressure_angle"][index],
                 pressed.carried.leaning, 1.0),
                (f"contact_table[{index}].contact_force", contacts["contact_force"][index], pressed.normal,
                 sizes["contact_force"]),
            ]  # fmt: skip
        for address, value, quantity, size in rows:
            exact = nearest([quantity(*state) for state in states], float(value))
            yield from stated.compare(address, value, exact, MISSED * size, size=size, row=f"rows[{index}]")
