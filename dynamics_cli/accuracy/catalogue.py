"""Every question there is: each task with references, and the comparisons of methods."""

from functools import cache

from dynamics_cli.accuracy.cases import DATA, load
from dynamics_cli.accuracy.questions import Comparison, Question, groups_of, own_questions
from dynamics_cli.core.task import load as imported

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.task import Family

IMPACT = ("impact_particles.json", "impact_rigid.json", "impact_spatial.json")
# Each family's module, its files of references, and its rivals: methods beside the chosen one, by the cases' task.
FAMILIES: "dict[str, tuple[str, tuple[str, ...], str]]" = {
    "convert": ("dynamics_cli.convert.commands", (), "dynamics_cli.accuracy.rivals.convert"),
    "coords": ("dynamics_cli.convert.commands", (), "dynamics_cli.accuracy.rivals.coords"),
    "skid": ("dynamics_cli.skid.commands", ("skid.json",), "dynamics_cli.accuracy.rivals.skid"),
    "inertia": ("dynamics_cli.inertia.commands", (), "dynamics_cli.accuracy.rivals.inertia"),
    "cam": ("dynamics_cli.cam.commands", (), "dynamics_cli.accuracy.rivals.cam"),
    "gear": ("dynamics_cli.gear.commands", (), "dynamics_cli.accuracy.rivals.gear"),
    "impact": ("dynamics_cli.impact.commands", IMPACT, "dynamics_cli.accuracy.rivals.impact"),
    "uncertainty": ("", (), "dynamics_cli.accuracy.rivals.uncertainty"),
}


@cache
def _family(name: str) -> "Family":
    return imported(f"{FAMILIES[name][0]}:FAMILIES")[name]  # type: ignore[no-any-return]


@cache
def groups(name: str) -> "dict[str, type]":
    """The record classes of a family's inputs."""
    made: dict[str, type] = {}
    if FAMILIES[name][0]:
        for task in _family(name).tasks.values():
            made |= groups_of(task)
    return made


def questions(family: str, task: str) -> "list[Question | Comparison]":
    """The questions of a family and task, or all; rivals stand in the question of the chosen method."""
    found: list[Question | Comparison] = []
    for name in FAMILIES:
        if family in ("", name):
            found += [question for question in _questions(name) if task in ("", question.task)]
    return found


@cache
def _questions(name: str) -> "list[Question | Comparison]":
    _, files, module = FAMILIES[name]
    own = {
        (question.file, question.cases): question
        for file in files
        if (DATA / file).exists()
        for question in own_questions(_family(name), file, {case.task for case in load(file)})
    }
    made: list[Question | Comparison] = list(own.values())
    for rival in imported(f"{module}:QUESTIONS"):
        chosen = own.get((rival.file, rival.cases)) if isinstance(rival, Question) else None
        if chosen is None:
            made.append(rival)
        else:
            chosen.methods = (*chosen.methods, *rival.methods)
    return made
