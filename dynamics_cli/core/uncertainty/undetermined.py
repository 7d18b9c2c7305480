"""A judgement that refused the nominal inputs, extended by the intervals that their uncertainty leaves."""

from dynamics_cli.core.answering.models import answer, result_numbers
from dynamics_cli.core.documents import number
from dynamics_cli.core.uncertainty.document import spread_of
from dynamics_cli.errors import DynamicsError
from dynamics_cli.sampling import Drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.reader import Reader
    from dynamics_cli.core.inputs.settings import Settings
    from dynamics_cli.core.inputs.values import Fields
    from dynamics_cli.core.units.display import Display
    from dynamics_cli.errors import InadmissibleError

DIGITS = 3
_PERCENT = 100.0


def add_intervals(
    error: "InadmissibleError",
    task: "Task",
    bound: "Fields",
    reader: "Reader",
    settings: "Settings",
    display: "Display",
) -> None:
    """Put the interval of every result that was judged before the hint; leave the hint where physics refuses too."""
    try:
        with Drawing():
            answered = answer(task, bound, settings.model)
        propagation = spread_of(task, answered.model, bound, answered.record, reader, settings, only=error.judged)
    except DynamicsError:
        return
    kinds = {name: kind for name, kind, _ in result_numbers(answered.record, task.specification.result)}
    parts = []
    for name in error.judged:
        shown = display.of(name, kinds[name])
        low, high = (number(shown.value(end), DIGITS) for end in propagation.spreads[name].interval)
        parts.append(f"{name} is from {low} to {high} {shown.text}".rstrip())
    if parts:
        error.left = f"the inputs' uncertainty leaves ({_PERCENT * propagation.coverage:g} %): {', '.join(parts)}"
        error.hint = f"{error.left}; {error.hint}" if error.hint else error.left
