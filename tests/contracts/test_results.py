"""What tasks declare of their results exists, and rows carry every result that fits a column."""

import re
from collections.abc import Iterator

import pytest

from dynamics_cli import cli
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.specification import Leaf, Many, Record
from dynamics_cli.core.output.row_layout import Layout
from dynamics_cli.core.units.display import Display
from dynamics_cli.records import Advice, Check, Numerics

TASKS = {task.path: task for name in cli.FAMILIES for task in cli.family(name).tasks.values()}
# The bodies' names in findings: `{first} was travelling at {}`.
BODIES = {"first", "second"}
NO_COLUMN = {"file", "drawing", "matrix", "remark"}


def addresses(spec: Record, above: str = "", around: tuple[type, ...] = ()) -> Iterator[tuple[str, object]]:
    """Each result's address without indices, and its node."""
    for field in spec.fields:
        address = f"{above}.{field.key}".lstrip(".")
        yield address, field.node
        inner = field.node.item if isinstance(field.node, Many) else field.node
        if isinstance(inner, Record) and inner.cls not in (*around, Check, Advice, Numerics):
            yield from addresses(inner, address, (*around, inner.cls))


@pytest.mark.parametrize("path", TASKS)
def test_declared_results_exist(path: str) -> None:
    task = TASKS[path]
    known = {address for address, _ in addresses(task.specification.result)}
    named = {
        re.sub(r"\[\d+\]", "", name)
        for address, text in (*task.headline, *task.findings)
        for name in (address.strip("{}"), *re.findall(r"{([a-z_.\[\]0-9]+)}", text))
    }
    named |= {*task.errors, *task.unspread, *task.chances, *task.chances.values(), *task.table.split()}
    named |= {name for groups in task.limited.values() for group in groups for name in group.split()}
    assert sorted(named - known - BODIES) == []


def single_results(spec: Record, above: str = "") -> Iterator[str]:
    """The addresses of the numbers and words outside tables and lists."""
    for field in spec.fields:
        address = f"{above}.{field.key}".lstrip(".")
        if isinstance(field.node, Record) and field.node.cls is not Numerics:
            yield from single_results(field.node, address)
        elif isinstance(field.node, Leaf) and not {field.node.kind.form, field.node.kind.name} & NO_COLUMN:
            yield address


def columns(task: Task) -> list[str]:
    layout = Layout(task.specification.result, Display("si", {}))
    return list(dict.fromkeys(".".join(part.keys) for part in layout.parts))


@pytest.mark.parametrize("path", TASKS)
def test_rows_carry_every_single_result_in_order(path: str) -> None:
    task = TASKS[path]
    wanted = list(single_results(task.specification.result))
    assert [name for name in columns(task) if name in wanted] == wanted
