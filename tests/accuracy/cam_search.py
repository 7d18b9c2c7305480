"""A search for stated bounds of cams below the true error: motion, forces, profiles, sizes, verdicts and exports.

    python tests/accuracy/cam_search.py [EVALUATIONS [TASK]]

The exact side is written anew in reals of 240 bits: laws integrated from their accelerations, followers carried round
the cam, forces by statics, sizes from conditions, distances from feet of perpendiculars (cam_search_*.py). Inputs are
the shipped cases and those drawn, disturbed by last bits, percents and orders of magnitude, and the worst found so far,
climbed from. An evaluation is a row of a table with its results, a certified extreme or another single result, or a
place of a written piece; the extremes are looked for on samples of every branch of every law and climbed in 240 bits,
so that one that the program misses is found.
"""

import json
import random
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import cam_search_cases as cases
import cam_search_contact as contact
import cam_search_designs as designs
import cam_search_export as exports
import cam_search_forces as forces
import cam_search_tables as tables
from cam_search_compared import UNIT_ROUNDOFF, Compared, column_of
from precise import many_bits
from search_length import told

from dynamics_cli.errors import DynamicsError

Case = dict[str, Any]


class Question(NamedTuple):
    """A task: how inputs are drawn, how an answer is compared, what it takes of which shipped cases, how often.

    An undercut takes the program ten times as long as any other cam: `cam check` climbs from few of them.
    """

    draw: Callable[[random.Random], Case]
    compare: Callable[[Case], Iterator[Compared]]
    tasks: tuple[str, ...]
    keys: tuple[str, ...]
    shipped: float = 0.3
    climb: float = 0.25


CAM = ("program", "follower", "rotation", "flank")
QUESTIONS = {
    "cam motion": Question(cases.motion, tables.moving, ("motion", "profile", "force"), ("program",)),
    "cam force": Question(cases.force, forces.pressing, ("force",), (*CAM, "train", "contact", "shaft_speed")),
    "cam profile": Question(cases.profile, tables.outlining, ("profile",), CAM),
    "cam size": Question(
        cases.size, designs.sizing, ("size",), (*CAM, "rise_limit", "return_limit", "least_radius"), 0.15
    ),
    "cam check": Question(cases.check, designs.checking, ("profile", "check"), CAM, 0.08, 0.08),
    "cam export": Question(cases.export, exports.exporting, ("profile",), CAM),
}
# Of the worst cases found so far, so many are climbed from.
CLIMBED = 8


Found = tuple[float, str, Case]


def _higher(first: Found, second: Found) -> Found:
    return second if second[0] > first[0] else first


class Findings:
    """How many results were compared, where a bound did not hold, and how near and how loose the bounds are."""

    def __init__(self) -> None:
        self.evaluations = self.compared = self.refused = self.answered = 0
        self.broken: list[str] = []
        self.looseness: dict[str, list[float]] = {}
        self.nearest: Found = (0.0, "", {})
        self.loosest: Found = (0.0, "", {})
        self.largest: Found = (0.0, "", {})
        self.worst: list[tuple[float, int, Case]] = []

    @property
    def median(self) -> float:
        """The median of bound over max(error, 2⁻⁵³·size) of the bounds that answers state."""
        every = [one for found in self.looseness.values() for one in found]
        return median(every) if every else 0.0

    def medians(self) -> dict[str, float]:
        """The same of every result by itself, loosest first."""
        found = {name: median(values) for name, values in self.looseness.items()}
        return dict(sorted(found.items(), key=lambda pair: -pair[1]))

    def take(self, case: Case, results: list[Compared]) -> None:
        """Count an answer's results."""
        self.answered += 1
        self.evaluations += len({one.row for one in results})
        self.compared += len(results)
        most = 0.0
        for one in results:
            error = one.error
            if not error <= one.bound:
                self.broken.append(
                    f"{one.name}: {one.value!r} is {error:.3g} off, bound {one.bound:.3g} "
                    f"({'stated' if one.stated else 'promised'}); {json.dumps(case, ensure_ascii=False)}"
                )
            if not one.stated:
                continue
            room = max(error, UNIT_ROUNDOFF * one.size, 5e-324)
            share, loose = error / (one.bound or 1.0), one.bound / room
            most = max(most, share)
            self.nearest = _higher(self.nearest, (share, one.name, case))
            self.loosest = _higher(self.loosest, (loose, one.name, case))
            if one.size > 1e-290:
                self.largest = _higher(self.largest, (0.5 * error / (UNIT_ROUNDOFF * one.size), one.name, case))
            self.looseness.setdefault(column_of(one.name), []).append(loose)
        self.worst.append((most, self.answered, case))
        self.worst = sorted(self.worst, key=lambda found: found[:2], reverse=True)[:CLIMBED]


def _drawn(rng: random.Random, question: Question, starts: list[Case], found: Findings) -> Case:
    """An input: drawn anew, a shipped one disturbed, or one of the worst so far, disturbed."""
    way = rng.random()
    if way < question.shipped:
        return cases.disturbed(rng, cases.fitted(rng, rng.choice(starts), question.draw, question.keys))
    if way < question.shipped + question.climb and found.worst:
        return cases.disturbed(rng, rng.choice(found.worst)[2])
    return question.draw(rng)


def answered(question: Question, case: Case) -> list[Compared]:
    """The results of one input; where a bound seems broken, an extreme may have been missed here: looked at finely."""
    results = list(question.compare(case))
    if all(one.error <= one.bound for one in results):
        return results
    looking = contact.Looking
    looking.shares, looking.steps = looking.fine
    try:
        return list(question.compare(case))
    finally:
        looking.shares, looking.steps = looking.coarse


def search(task: str, count: int, seed: int) -> Findings:
    """So many evaluations of one task."""
    many_bits()
    question = QUESTIONS[task]
    rng = random.Random(f"{task} {seed}")
    found = Findings()
    starts = cases.shipped(*question.tasks)
    while found.evaluations < count:
        case = _drawn(rng, question, starts, found)
        try:
            results = answered(question, case)
        except DynamicsError:
            found.refused += 1
            assert found.refused < 4 * count + 100
            continue
        except Exception as error:
            error.add_note(json.dumps(case, ensure_ascii=False))
            raise
        found.take(case, results)
    return found


def main() -> None:
    """Search as long as asked, and tell what was found."""
    for found in told(QUESTIONS, search):
        for words, (figure, name, case) in (
            ("nearest its bound", found.nearest), ("loosest", found.loosest), ("largest, in ulps", found.largest)
        ):  # fmt: skip
            print(f"    {words}: {figure:.3g}, {name}; {json.dumps(case, ensure_ascii=False)}")
        for name, value in list(found.medians().items())[:8]:
            print(f"    {name}: looseness {value:.1f} in the median")


if __name__ == "__main__":
    main()
