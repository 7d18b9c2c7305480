"""Random cams: no extreme of motion, force, torque or speed of jump lies beyond the one that is told."""

import random

import numpy as np

from dynamics_cli.cam.forces.forces import force
from dynamics_cli.cam.forces.records import Slide
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.cam.program.summary import extreme

FREE = ("scca", "polynomial", "spline")
LAWS = [name for name in LawName.names if name not in FREE and not name.startswith("half")]


def programs(seed: int, count: int):
    generator = random.Random(seed)
    for _ in range(count):
        a, b, c = (round(generator.uniform(20, 110), 2) for _ in range(3))
        lift = round(generator.uniform(2, 30), 2)
        first, second = generator.choice(LAWS), generator.choice(LAWS)
        line = f"rise {lift} mm in {a} deg {first}; dwell {b} deg; return in {c} deg {second}; dwell"
        yield (
            line,
            {
                "shaft_speed": generator.uniform(5, 300),
                "mass": generator.uniform(0.05, 2),
                "spring_rate": generator.uniform(500, 40000),
                "preload": generator.uniform(0.5, 300),
            },
        )


def test_no_extreme_is_missed() -> None:
    for line, given in programs(1, 60):
        motion = motion_of(Program(), line)
        speed = given.pop("shaft_speed")
        found = force(Program(), program=line, shaft_speed=speed, train=Slide(**given), count=2, at_lifts=())
        for order in range(4):
            ends = extreme(motion, order)
            size = max(abs(ends.least), abs(ends.greatest))
            for index in range(len(motion.zones)):
                values = motion.in_zone(index, np.linspace(0.0, 1.0, 1001))[order]
                assert values.max() <= ends.greatest + 1e-14 * size, line
                assert values.min() >= ends.least - 1e-14 * size, line
        for index in range(len(motion.zones)):
            s, s1, s2 = motion.in_zone(index, np.linspace(0.0, 1.0, 2001), 2)
            held = given["spring_rate"] * s + given["preload"]
            axial = held + given["mass"] * speed**2 * s2
            size = max(abs(found.greatest_force), abs(found.least_force))
            assert axial.min() >= found.least_force - 1e-11 * size, line
            assert axial.max() <= found.greatest_force + 1e-11 * size, line
            torque = axial * s1
            scale = max(found.greatest_torque, -found.least_torque)
            assert torque.max() <= found.greatest_torque + 1e-11 * scale, line
            assert torque.min() >= found.least_torque - 1e-11 * scale, line
            down = s2 < 0.0
            if down.any():
                jump = np.sqrt((held[down] / (-given["mass"] * s2[down])).min())
                assert found.jump_speed is not None
                assert jump >= found.jump_speed * (1.0 - 1e-11), line
