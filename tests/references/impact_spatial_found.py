"""Impacts in space where a search of the program's bounds found them broken, or nearest to it: name, why, inputs."""

from typing import Any


def _body(mass: float, inertia: list[list[float]], lever: list[float], velocity: list[float], spin: list[float]) -> Any:
    return {
        "record": "BodyInSpace", "bulk": {"record": "ByMass", "mass": mass}, "inertia": inertia,
        "arm": {"record": "LeverInSpace", "lever": lever}, "velocity": velocity, "spin": spin,
    }  # fmt: skip


def _met(first: Any, velocity: list[float], normal: list[float], mu: float, e: float, law: str) -> dict[str, Any]:
    bulk = {"record": "Fixed", "fixed": True}
    wall = {"record": "TargetInSpace", "bulk": bulk, "velocity": velocity, "spin": [0.0, 0.0, 0.0]}
    return {
        "first": first, "second": wall, "normal": normal, "friction": mu,
        "contact": {"record": "Restituted", "restitution": e}, "law": {"word": law},
    }  # fmt: skip


_SPHERE = _body(
    622.8005495546884,
    [[368.96840562837167, 0.0, 0.0], [0.0, 368.96840562837167, 0.0], [0.0, 0.0, 368.96840562837167]],
    [0.0, 0.0, -1.0835728470214634],
    [0.04118910949529575, 0.19652350593264015, -0.10186609575933347],
    [2.246371882453367, -26.003299025754497, 6.8670612357044405],
)
_FAR = _body(
    0.7008331224933038,
    [[0.22743253963333165, -0.018753310855137918, 0.047987485783019854],
     [-0.018753310855137918, 0.26167908145318225, 0.03182969298468498],
     [0.047987485783019854, 0.03182969298468498, 0.061388433839414516]],
    [2.2887933973083556, -46.95410162064171, 1.222917891964079],
    [1.439987834756547, 0.0, -0.6409258448753504],
    [31.150832571054114, -85.39668944121539, -46.95410162063829],
)  # fmt: skip
_NEARLY_CENTRAL = _body(
    1553.5060233291051,
    [[230.04318444634526, -33.56207276020867, -16.64720177154667],
     [-33.56207276020867, 119.61038717423656, 2.4014619575343796],
     [-16.64720177154667, 2.4014619575343796, 137.93945109241406]],
    [1.6860184861083827e-17, 1.462907143859706e-13, -0.9526991002838746],
    [3.6296468187386104, -3.60474362211345, -0.4567411209874441],
    [-2.309228806620227, 0.163290860544409, 2.3487488468553632],
)  # fmt: skip
_REST = [0.0, 0.0, 0.0]
_SLANT = [-0.9092658864149299, 0.27863227417935554, -0.4858814251293516]
_WALL = [-1.0074451054079376, -0.1229691794260428, -1.1683478649217798]

FOUND: tuple[tuple[str, str, dict[str, Any]], ...] = (
    ("hardly any restitution", "found by search: what the rebound gives back, e² of the work, is lost beside the work",
     _met(_SPHERE, _WALL, [0.0, 0.0, 1.0], 3.523987342406449e-05, 0.0004524136371614196, "stronge")),
    ("lever of eighty gyration radii", "found by search: K is nearly singular, the contact's speed a small difference",
     _met(_FAR, _REST, _SLANT, 36.39001588677206, 0.0, "newton")),
    ("lever of eighty gyration radii", "found by search: the same with a rebound by impulses",
     _met(_FAR, _REST, _SLANT, 36.39001588677206, 0.62, "poisson")),
    ("1.5e-13 m off the centre", "found by search: the coupling is a thousand roundings of K, and none to leave out",
     _met(_NEARLY_CENTRAL, _REST, [0.0, 0.0, -1.0], 0.6, 0.36, "stronge")),
)  # fmt: skip
