"""Lines sorted into groups that one array call can answer; rows that fit no group are left to the single call.

Most blocks are one group: that is tried first, by whole-block operations. Only when it fails is each line looked at.
"""

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.inputs import CsvInput, Input, JsonInput, TextInput
from dynamics_cli.core.batch.text.words import WordGroups
from dynamics_cli.core.inputs.specification import Leaf

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.batch.rows.group import Groups


def groups_of(source: Input, case: Case, first: bytes) -> "Groups | None":
    """How the rows of this input are sorted; None when they are answered one by one."""
    if isinstance(source, TextInput) and case.measure[0]:
        return WordGroups(case)
    from dynamics_cli.core.batch.text.cells import CellGroups

    if isinstance(source, JsonInput):
        from dynamics_cli.core.batch.text.objects import JsonGroups

        return JsonGroups(source, case)
    if isinstance(source, CsvInput):
        columns = source.columns
        addresses = [column.address if column.path else "" for column in columns]
        # Two columns for one parameter, or an earlier error: the single call knows which counts.
        if len(set(filter(None, addresses))) < len(list(filter(None, addresses))):
            return None
        addresses = [address or ("error" if i in source.errors else "") for i, address in enumerate(addresses)]
        return CellGroups(source, case, b",", addresses, [column.unit for column in columns])
    free = [field for field in case.task.specification.words if field.key not in case.fixed]
    words = first.split()
    if not isinstance(source, TextInput) or len(words) != len(free):
        return None
    if not all(isinstance(field.node, Leaf) and field.place == "word" for field in free):
        return None
    return CellGroups(source, case, b" ", [field.key for field in free], [""] * len(free))
