"""Write cam_forces.json: forces, torques, jump speeds and stresses of cams to 40 digits, by another construction.

The laws are written out anew (cam_programs.py), their derivatives come from Taylor arithmetic in 90 digits. The force
along the normal comes from statics: an envelope found from its definition (cam_envelope.py) gives the point of contact
and the normal, and the moment balance of the arm about its pivot, or the balance along the slide, gives the force; no
lever formula is used. Curvatures come from differentiating the curve. Extremes are roots of derivatives, beside the
ends of every branch of every law.

Run: python tests/references/generate_cam_forces_references.py [FILE]. The same bytes every time.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from cam_envelope import Carried, extreme
from cam_forces_cases import CASES, STEEP, S
from cam_geometry_cases import flat, roller
from cam_programs import branches, program_text
from case_files import DATA, put_tree
from digits import DOUBLES, MANY, written
from taylor import diff, expanded

WIDTH, YOUNG, POISSON = (MANY.number(text) for text in (0.012, 206e9, 0.3))
PI = MANY.pi


class Pressed:
    """A follower's load: force of a slide or torque of an arm."""

    def __init__(self, train, speed, field):
        values = {key: field.double(value) for key, value in train.items() if key != "record"}
        zero = field.number(0)
        self.kind = train["record"]
        if self.kind == "Slide":
            self.inertia, self.rate = values["mass"], values.get("spring_rate", zero)
            self.steady = values.get("preload", zero) + values.get("load", zero)
        elif self.kind == "ArmOnTorsionSpring":
            self.inertia, self.rate = values["inertia"], values.get("torsion_rate", zero)
            self.steady = values.get("preload_torque", zero) + values.get("load_torque", zero)
        else:
            r = values["spring_radius"]
            self.inertia, self.rate = values["inertia"], values.get("spring_rate", zero) * r * r
            self.steady = values.get("preload", zero) * r + values.get("load_torque", zero)
        self.square = field.double(speed) ** 2

    def force(self, lift, t):
        s, _, s2 = expanded(lift, t, 2)
        return self.rate * s + self.steady + self.inertia * self.square * s2

    def torque(self, lift, t):
        return self.force(lift, t) * diff(lift, t)

    def lifting(self, lift, t):
        """1/ω² at which the load vanishes."""
        s, _, s2 = expanded(lift, t, 2)
        return -self.inertia * s2 / (self.rate * s + self.steady)

    def slowing(self, lift, t):
        """Where the motion can leave the cam at all."""
        return diff(lift, t, 2) < -(10**-20)


class Touched:
    """The force along the normal, and how close cam and follower lie."""

    def __init__(self, pressed, follower, turn, field):
        self.pressed = pressed
        self.carried = Carried(follower, turn, 1, field)

    def normal(self, lift, t):
        point, n = self.carried.point(lift, t)
        forth = self.carried.back(t).conjugate()
        point, n = point * forth, n * forth
        if self.pressed.kind == "Slide":
            return self.pressed.force(lift, t) / (n * self.carried.way(lift(t)).conjugate()).real
        # moment of the normal force about the pivot, in the sense that lifts the arm (clockwise)
        x = point.real - self.carried.f["pivot_distance"]
        return self.pressed.force(lift, t) / (point.imag * n.real - x * n.imag)

    def crowding(self, lift, t):
        """Normal force times the sum of both curvatures."""
        curved = 1 / self.carried.radius(lift, t)
        if self.carried.roller:
            curved = curved + 1 / self.carried.roller
        return self.normal(lift, t) * curved


def turned(segments, *, swing):
    """The branches of one turn in many digits and in doubles."""
    unit = PI / 180 if swing else MANY.number(1)
    levels = [float(MANY.number(to) * unit) for _, _, to in segments]
    exact = branches(MANY, segments, [MANY.number(level) for level in levels])
    return [(one[:3], two[:3]) for one, two in zip(exact, branches(DOUBLES, segments, levels), strict=True)]


def answers(segments, swing, speed, train, follower, turn, stressed):
    both = turned(segments, swing=swing)
    pressed, coarse = (Pressed(train, speed, field) for field in (MANY, DOUBLES))
    name = "arm_torque" if swing else "force"
    out = {}
    for end, sign in (("least", -1), ("greatest", 1)):
        out[f"{end}_{name}"] = extreme(pressed.force, both, sign, coarse.force)
        out[f"{end}_torque"] = extreme(pressed.torque, both, sign, coarse.torque)
    lifted = extreme(pressed.lifting, both, 1, coarse.lifting, only=pressed.slowing)
    out["jump_speed"] = 1 / MANY.sqrt(lifted)
    if follower is not None:
        touched, rough = Touched(pressed, follower, turn, MANY), Touched(coarse, follower, turn, DOUBLES)
        for end, sign in (("least", -1), ("greatest", 1)):
            out[f"{end}_contact_force"] = extreme(touched.normal, both, sign, rough.normal)
        if stressed:
            give = 2 * (1 - POISSON**2) / YOUNG
            crowded = extreme(touched.crowding, both, 1, rough.crowding)
            out["stress"] = MANY.sqrt(crowded / (PI * WIDTH * give))
    return out


def cusps():
    """Rollers and faces that come to a hair of a cusp: chosen by the least radius of the pitch curve."""
    both = turned(STEEP, swing=False)
    point = {"record": "Roller", "base_radius": "0.03", "roller_radius": "0"}
    pitch, coarse = Carried(point, 1, 1), Carried(point, 1, 1, DOUBLES)
    sharpest = 1 / extreme(pitch.bend, both, 1, coarse.bend)
    for share, words, left in (("1e-3", "a thousandth", "three"), ("1e-7", "a ten-millionth", "seven")):
        radius = float(sharpest * (1 - MANY.number(share)))
        base = float(MANY.number("0.03") - radius)
        yield (
            f"roller within {words} of the radius of curvature",
            f"1 − R κ is left over from terms that agree in {left} digits", STEEP, "60", S,
            roller(repr(base), repr(radius)), 1, True,
        )  # fmt: skip
    low = extreme(lambda lift, t: lift(t) + diff(lift, t, 2), both, -1)
    base = float(-low + MANY.number("1e-9"))
    yield ("flat face a nanometre off a cusp",
        "R + s + s″ is a nanometre left over from centimetres: seven digits of the curvature cancel", STEEP, "150", S,
           flat(repr(base)), 1, True)  # fmt: skip


def main():
    cases = []
    for name, why, segments, speed, train, follower, turn, stressed in [*CASES, *cusps()]:
        swing = train["record"] != "Slide"
        results = answers(segments, swing, speed, train, follower, turn, stressed)
        inputs = {
            "program": program_text(segments, *(("deg", 1) if swing else ("mm", 1000))),
            "shaft_speed": speed,
            "train": train,
            **({} if follower is None else {"follower": follower}),
            "rotation": "counter-clockwise" if turn > 0 else "clockwise",
            **({"contact": {"width": "0.012"}} if stressed else {}),
        }
        cases.append(
            {
                "task": "force",
                "kind": "hard" if why else "ordinary",
                "name": name,
                **({"why": why} if why else {}),
                "inputs": inputs,
                "results": {key: written(value) for key, value in results.items()},
            }
        )
    about = "Written by generate_cam_forces_references.py: SI inputs as doubles, results to 40 digits of 90."
    put_tree(DATA / "cam_forces.json", {"about": about, "cases": cases})


if __name__ == "__main__":
    main()
