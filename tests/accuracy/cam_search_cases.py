"""Inputs for the search for broken bounds of cams: drawn, taken from the shipped cases, and disturbed.

A case is plain data as the references ship it: the program's words, and trees of doubles as text.
"""

import json
import random
from collections.abc import Iterator
from fractions import Fraction
from math import nextafter, pi
from typing import Any

from cam_search_laws import JERKY, MOVING, RESTING
from cam_search_motion import Clause, read, written

from dynamics_cli.accuracy.cases import DATA

Case = dict[str, Any]
FILES = ("cam_motion.json", "cam_geometry.json", "cam_forces.json", "cam_design.json")
ROLLING = ("KnifeEdge", "Roller", "OscillatingRoller", "ConjugateRoller", "ConjugateOscillatingRoller")
SLIDING = ("KnifeEdge", "Roller", "FlatFace", "ConjugateRoller")
SPRINGS = ("mass", "spring_rate", "preload", "inertia", "torsion_rate", "preload_torque")
ARMS = ("OscillatingRoller", "OscillatingFlat", "ConjugateOscillatingRoller")


def shipped(*tasks: str) -> list[Case]:
    """The shipped cases of some tasks with a program; sizes whose offset is to be found take too long."""
    found = []
    for file in FILES:
        for case in json.loads((DATA / file).read_text(encoding="utf-8"))["cases"]:
            given = case["inputs"]
            slow = case["task"] == "size" and "least_radius" in given and given["follower"]["record"] != "FlatFace"
            if case["task"] in tasks and "program" in given and not slow:
                found.append(given)
    return found


def law(rng: random.Random, *, jerky: bool = True) -> tuple[str, tuple[float, ...]]:
    """A law and its numbers."""
    kind = rng.random()
    if kind < 0.08:
        b, c = rng.randrange(1, 30), rng.randrange(0, 30)
        return "scca", (b / 64, c / 64, (64 - b - c) / 64)
    if kind < 0.14:
        return "modified-constant-velocity", (rng.randrange(1, 60) / 64,)
    return rng.choice(JERKY if jerky and kind < 0.3 else RESTING), ()


def _span(rng: random.Random, most: float) -> Fraction:
    wide = rng.random()
    if wide < 0.05:
        return Fraction(round(10.0 ** rng.uniform(-4.0, 0.0), 6)).limit_denominator(10**6)
    digits = rng.choice((0, 0, 1, 3))
    return Fraction(round(rng.uniform(15.0, most) * 10**digits), 10**digits)


def _clause(move: str, amount: Fraction | None, span: Fraction | None, swing: bool, named: Any = ("", ())) -> Clause:
    return {"move": move, "amount": amount, "swing": swing, "span": span, "law": named[0], "numbers": named[1]}


def program(rng: random.Random, *, swing: bool, jerky: bool = True, jumps: bool = False) -> str:
    """A program of one turn: one or two rises, dwells or none, below the base circle now and then."""
    size = Fraction(rng.randrange(100, 2500), 100) if rng.random() < 0.9 else Fraction(rng.randrange(1, 1000), 10**6)
    size = size if swing else size / 1000
    down = rng.random() < 0.12
    up, back = ("return", "rise") if down else ("rise", "return")
    named = [("linear", ()), (rng.choice(MOVING), ())] if jumps and rng.random() < 0.3 else []
    laws = named or [law(rng, jerky=jerky) for _ in range(3)]
    if down:
        size = size / 4
    shape = rng.randrange(4)
    first, last = laws[0], laws[1]
    if shape == 0:
        clauses = [_clause(up, size, _span(rng, 170.0), swing, first), _clause(back, size, None, swing, last)]
    elif shape == 1:
        clauses = [
            _clause(up, size, _span(rng, 110.0), swing, first), _clause("dwell", None, _span(rng, 40.0), swing),
            _clause(back, size, _span(rng, 110.0), swing, last), _clause("dwell", None, None, swing),
        ]  # fmt: skip
    elif shape == 2:
        clauses = [
            _clause("dwell", None, _span(rng, 50.0), swing), _clause(up, size, _span(rng, 120.0), swing, first),
            _clause(back, size, _span(rng, 120.0), swing, last), _clause("dwell", None, None, swing),
        ]  # fmt: skip
    else:
        part = size * rng.randrange(1, 8) / 8
        clauses = [
            _clause(up, part, _span(rng, 70.0), swing, first), _clause("dwell", None, _span(rng, 30.0), swing),
            _clause(up, size - part, _span(rng, 70.0), swing, laws[-1]),
            _clause(back, size, _span(rng, 110.0), swing, last), _clause("dwell", None, None, swing),
        ]  # fmt: skip
    return written(clauses)


def follower(rng: random.Random, kind: str, *, sized: bool = False) -> dict[str, str]:
    """A follower of sizes a designer would try, and sometimes of others; `sized` leaves what `cam size` finds."""
    scale = 1.0 if rng.random() < 0.85 else 10.0 ** rng.uniform(-3.0, 3.0)
    base = rng.uniform(0.015, 0.07) if rng.random() < 0.9 else 10.0 ** rng.uniform(-6.0, 0.0)
    radius = rng.uniform(0.002, 0.015) * scale
    pivot = rng.uniform(0.09, 0.14)
    offset = rng.choice((0.0, rng.uniform(-0.5, 0.5) * base, rng.uniform(-0.97, 0.97) * base))
    arm = rng.uniform(0.75, 1.0) * pivot
    values: dict[str, float]
    if kind == "KnifeEdge":
        values = {"base_radius": base, "offset": offset}
    elif kind == "Roller":
        values = {"base_radius": base, "roller_radius": radius, "offset": offset}
    elif kind == "FlatFace":
        values = {"base_radius": base * rng.choice((1.0, 2.0))}
    elif kind == "OscillatingFlat":
        values = {
            "base_radius": 0.6 * min(base, 0.1), "pivot_distance": pivot, "face_offset": rng.uniform(-0.004, 0.012)
        }  # fmt: skip
    elif kind == "OscillatingRoller":
        values = {"base_radius": base, "roller_radius": min(radius, 0.02), "arm": arm, "pivot_distance": pivot}
    elif kind == "ConjugateRoller":
        far = base + radius + rng.uniform(0.03, 0.1)
        values = {"base_radius": base, "roller_radius": radius, "roller_distance": far, "offset": 0.3 * offset}
    else:
        values = {
            "base_radius": base, "roller_radius": min(radius, 0.02), "arm": arm, "pivot_distance": pivot,
            "arm_angle": rng.uniform(0.7, 1.6),
        }  # fmt: skip
    if sized:
        values = {name: value for name, value in values.items() if name not in ("base_radius", "offset")}
    return {"record": kind, **{name: repr(value) for name, value in values.items()}}


def train(rng: random.Random, swing: bool) -> dict[str, str]:
    """What moves, and what presses it."""
    preload = rng.choice((rng.uniform(0.5, 300.0), 10.0 ** rng.uniform(-6.0, 4.0)))
    rate = rng.choice((0.0, rng.uniform(0.0, 4e4), 10.0 ** rng.uniform(0.0, 7.0)))
    load = rng.choice((0.0, 0.0, rng.uniform(-0.9, 1.0) * preload))
    if not swing:
        values = {"mass": 10.0 ** rng.uniform(-2.0, 1.0), "spring_rate": rate, "preload": preload, "load": load}
        return {"record": "Slide", **{name: repr(value) for name, value in values.items()}}
    inertia = 10.0 ** rng.uniform(-4.5, -1.5)
    if rng.random() < 0.6:
        given = {"inertia": inertia, "torsion_rate": rate / 500.0, "preload_torque": preload / 50.0}
        return {"record": "ArmOnTorsionSpring", **{name: repr(value) for name, value in given.items()}}
    given = {"inertia": inertia, "spring_radius": rng.uniform(0.02, 0.1), "spring_rate": rate, "preload": preload}
    return {"record": "ArmOnSpring", **{name: repr(value) for name, value in given.items()}}


def _moved(rng: random.Random, value: float) -> float:
    """A number moved by its last bits, by percents, or by orders of magnitude."""
    way = rng.random()
    if way < 0.4:
        for _ in range(rng.randrange(1, 4)):
            value = nextafter(value, rng.choice((-1e300, 1e300)))
        return value
    if way < 0.6:
        return value * (1.0 + rng.choice((-1.0, 1.0)) * 10.0 ** rng.uniform(-14.0, -3.0))
    if way < 0.95:
        return value * (1.0 + rng.uniform(-0.1, 0.1))
    return value * 10.0 ** rng.uniform(-1.0, 1.0)


def _moved_program(rng: random.Random, text: str) -> str:
    """The program with one amount or span moved; a last segment without a span keeps the turn whole."""
    clauses = read(text)
    which = rng.choice(clauses)
    if which["amount"] is not None and rng.random() < 0.5:
        up = [clause for clause in clauses if clause["move"] == which["move"]]
        ways = [clause for clause in clauses if clause["move"] not in (which["move"], "dwell")]
        moved = _moved(rng, float(which["amount"] * (1 if which["swing"] else 1000)))
        which["amount"] = Fraction(repr(abs(moved))) / (1 if which["swing"] else 1000)
        # a single way back returns to zero, whatever the way there is
        if len(ways) == 1:
            total = sum(clause["amount"] for clause in up if clause["amount"] is not None)
            ways[0]["amount"] = total
    elif which["span"] is not None:
        which["span"] = Fraction(repr(abs(_moved(rng, float(which["span"])))))
        open_ = next((one for one in reversed(clauses) if one["span"] is None), clauses[-1])
        if open_ is not which:
            open_["span"] = None
    elif which["law"] and rng.random() < 0.3:
        which["law"], which["numbers"] = law(rng)
    return written(clauses)


def disturbed(rng: random.Random, case: Case) -> Case:
    """A case with a few of its numbers moved; zeros stay, words stay."""
    made = json.loads(json.dumps(case))
    for _ in range(rng.randrange(1, 4)):
        places = list(_numbers(made))
        if places and rng.random() < 0.7:
            tree, key = rng.choice(places)
            tree[key] = repr(_moved(rng, float(tree[key])))
        else:
            made["program"] = _moved_program(rng, made["program"])
    return made


def _numbers(tree: Any) -> Iterator[tuple[Any, Any]]:
    """Where the doubles of a tree are."""
    for key, value in tree.items():
        if isinstance(value, dict):
            yield from _numbers(value)
        elif isinstance(value, str) and key not in ("program", "record", "rotation", "flank", "form", "curve"):
            yield tree, key


def motion(rng: random.Random) -> Case:
    """An input of `cam motion`."""
    made: Case = {"program": program(rng, swing=rng.random() < 0.3, jumps=True), "count": rng.randrange(30, 90)}
    if rng.random() < 0.5:
        made["shaft_speed"] = repr(10.0 ** rng.uniform(-1.0, 4.0))
    return made


def _cam(rng: random.Random, kinds: tuple[str, ...], *, jerky: bool = True) -> Case:
    kind = rng.choice(kinds)
    made: Case = {
        "program": program(rng, swing=kind in ARMS, jerky=jerky),
        "follower": follower(rng, kind),
        "rotation": rng.choice(("counter-clockwise", "clockwise")),
    }
    if kind in ("Roller", "OscillatingRoller") and rng.random() < 0.15:
        made["flank"] = "outer"
    return made


def profile(rng: random.Random) -> Case:
    """An input of `cam profile`."""
    made = _cam(rng, ("KnifeEdge", "Roller", "FlatFace", "ConjugateRoller", *ARMS))
    made["points"] = rng.randrange(30, 70)
    if rng.random() < 0.5:
        made["start_angle"] = repr(rng.choice((rng.uniform(-pi, pi), 0.5 * pi, 1.0)))
    if rng.random() < 0.3:
        made["cutter_radius"] = repr(rng.uniform(0.001, 0.03))
    if rng.random() < 0.4:
        made |= {"thickness": "0.012", "density": repr(rng.uniform(1e3, 8e3))}
    return made


def force(rng: random.Random) -> Case:
    """An input of `cam force`."""
    made = _cam(rng, ("KnifeEdge", "Roller", "FlatFace", "OscillatingRoller", "OscillatingFlat"))
    made.pop("flank", None)
    swing = made["follower"]["record"] in ARMS
    made |= {"train": train(rng, swing), "shaft_speed": repr(10.0 ** rng.uniform(-1.0, 3.0))}
    made["count"] = rng.randrange(60, 140)
    if rng.random() < 0.1:
        del made["follower"]
    elif rng.random() < 0.4:
        made["contact"] = {"width": repr(rng.uniform(0.005, 0.02))}
    return made


def check(rng: random.Random) -> Case:
    """An input of `cam check`; a spring for the jump, and now and then a small cam that is undercut."""
    # rockers take the program longest
    kinds = ("Roller", "Roller", "KnifeEdge", "KnifeEdge", "FlatFace", "OscillatingRoller", "OscillatingRoller")
    made = _cam(rng, (*kinds, "OscillatingFlat") if rng.random() < 0.5 else kinds)
    tree = made["follower"]
    if rng.random() < 0.06 and tree["record"] in ("Roller", "FlatFace"):
        tree["base_radius"] = repr(float(tree["base_radius"]) * rng.uniform(0.2, 0.6))
    if rng.random() < 0.7:
        rate, preload = rng.uniform(100.0, 3e4), rng.uniform(1.0, 300.0)
        made |= (
            {"inertia": repr(10.0 ** rng.uniform(-4.0, -2.0)), "torsion_rate": repr(rate / 500.0),
             "preload_torque": repr(preload / 50.0)}
            if tree["record"] in ARMS
            else {"mass": repr(rng.uniform(0.05, 3.0)), "spring_rate": repr(rate), "preload": repr(preload)}
        )  # fmt: skip
        made["shaft_speed"] = repr(rng.uniform(10.0, 300.0))
    made |= {"rise_limit": repr(rng.uniform(0.3, 0.8)), "return_limit": repr(rng.uniform(0.3, 0.8))}
    made["least_radius"] = repr(rng.uniform(0.0, 0.02))
    return made


def size(rng: random.Random) -> Case:
    """An input of `cam size` of a kind that is answered in closed form from extremes."""
    kind = rng.choice(("Roller", "Roller", "KnifeEdge", "FlatFace", "FlatFace", "ConjugateRoller", "OscillatingRoller"))
    # a curvature that binds takes the program a hundred times as long
    slow = rng.random()
    kind = "OscillatingFlat" if slow < 0.004 else "Roller" if slow < 0.03 else kind
    made: Case = {"program": program(rng, swing=kind in ARMS), "follower": follower(rng, kind, sized=True)}
    made["follower"].pop("roller_distance", None)
    if kind in ("Roller", "KnifeEdge") and (slow < 0.03 or rng.random() < 0.5):
        made["follower"]["offset"] = repr(rng.uniform(-0.02, 0.02))
    if kind == "FlatFace" or slow < 0.03:
        made["least_radius"] = repr(rng.choice((0.0, rng.uniform(0.0, 0.02))))
    else:
        made |= {"rise_limit": repr(rng.uniform(0.2, 1.0)), "return_limit": repr(rng.uniform(0.2, 1.0))}
    made["rotation"] = rng.choice(("counter-clockwise", "clockwise"))
    return made


def export(rng: random.Random) -> Case:
    """An input of `cam export`."""
    made = _cam(rng, ("KnifeEdge", "Roller", "FlatFace", "OscillatingRoller", "OscillatingFlat"), jerky=False)
    made |= {
        "form": rng.choice(("arcs", "arcs", "cubics", "cubics", "lines")),
        "points": rng.randrange(4, 40),
    }
    # how many pieces a tolerance takes: its second, third and sixth root
    finest = {"lines": -5.5, "arcs": -8.0, "cubics": -11.5 if rng.random() < 0.2 else -9.0}[made["form"]]
    made["tolerance"] = repr(10.0 ** rng.uniform(finest, -4.0))
    if rng.random() < 0.3:
        made["start_angle"] = repr(rng.uniform(-pi, pi))
    way = rng.random()
    if way < 0.15 and made["follower"]["record"] in ROLLING:
        made["curve"] = "pitch"
    elif way < 0.3:
        made |= {"curve": "cutter", "cutter_radius": repr(rng.uniform(0.001, 0.02))}
    return made


def fitted(rng: random.Random, start: Case, draw: Any, keys: tuple[str, ...]) -> Case:
    """A shipped case as an input of a task: what it leaves out, such as a table's length, is drawn."""
    other = draw(rng)
    kept = {key: value for key, value in other.items() if key not in keys}
    if "inertia" in kept or "mass" in kept:
        # a spring for what the case moves, not for what was drawn
        kept = {key: value for key, value in kept.items() if key not in (*SPRINGS, "shaft_speed")}
    return {**kept, **{key: start[key] for key in keys if key in start}}
