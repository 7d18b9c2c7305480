"""Which module may import which, for every family there is and for those to come."""

import ast
import sys
from functools import cache
from pathlib import Path

import dynamics_cli

PACKAGE = Path(dynamics_cli.__file__).parent
ROOT = "dynamics_cli"
LEAVES = {
    "quantities",
    "records",
    "errors",
    "outlines",
    "pictures",
    "markup",
    "sampling",
    "progress",
    "animation",
    "version",
}
# The packages of core in their line: each may import those before it.
CORE = ("units", "inputs", "answering", "output", "uncertainty", "batch", "command")
# What only one module may import, and which.
ALONE = {
    "pint": "core.units.fallback",
    "typer": "core.command.tree",
    "ezdxf": "core.output.drawing.dxf",
    "matplotlib": "core.output.plot.library",
    "trimesh": "inertia.mesh.opening",
}


def name_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(path): path for path in sorted(PACKAGE.rglob("*.py"))}


@cache
def imports(name: str) -> frozenset[str]:
    """Everything a module imports, at run time or for types: our modules without the root, others by their top name."""
    found = set()
    for node in ast.walk(ast.parse(MODULES[name].read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            for alias in node.names:
                whole = f"{node.module}.{alias.name}".removeprefix(f"{ROOT}.")
                ours = whole if whole in MODULES else node.module.removeprefix(f"{ROOT}.").removeprefix(ROOT)
                found.add(ours if node.module.split(".")[0] == ROOT else node.module.split(".")[0])
        elif isinstance(node, ast.Import):
            found.update(alias.name.removeprefix(f"{ROOT}.").split(".")[0] for alias in node.names)
    return frozenset(found - {name})


def families() -> set[str]:
    """Every folder with tasks of its own is a family, named here or not."""
    tops = {name.split(".")[0] for name in MODULES if name.split(".")[1:2] == ["commands"]}
    return tops - {"accuracy"}


def room(name: str) -> str:
    return name.split(".")[0]


def test_there_are_families() -> None:
    assert {"convert", "skid", "impact", "inertia", "cam", "gear"} <= families()


def test_no_circles() -> None:
    """Tarjan's strongly connected components of all imports, those for types among them."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    circles = []

    def visit(name: str) -> None:
        index[name] = low[name] = len(index)
        stack.append(name)
        for other in imports(name) & MODULES.keys():
            if other not in index:
                visit(other)
                low[name] = min(low[name], low[other])
            elif other in stack:
                low[name] = min(low[name], index[other])
        if low[name] == index[name]:
            circle = stack[stack.index(name) :]
            del stack[stack.index(name) :]
            if len(circle) > 1:
                circles.append(sorted(circle))

    for name in MODULES:
        # `from dynamics_cli import run` opens the whole program, only when it is called.
        if name and name not in index:
            visit(name)
    assert circles == []


def test_physics_imports_neither_core_nor_another_family() -> None:
    wrong = [
        (name, other)
        for name in MODULES
        if room(name) in families() and ".commands" not in name
        for other in imports(name)
        if (room(other) in families() | {"core", "accuracy", "report", "cli", "registry"} and room(other) != room(name))
        or other in ("pint", "typer", "rich", "msgspec")
    ]
    # Units are the subject of `convert` itself.
    assert [(name, other) for name, other in wrong if room(name) != "convert" or room(other) != "core"] == []


def test_commands_import_only_core_and_their_family() -> None:
    for name in MODULES:
        if room(name) in families() and ".commands" in name:
            ours = {room(other) for other in imports(name) & MODULES.keys()}
            assert ours <= {"core", room(name)} | LEAVES, name


def test_leaves_and_numerics_point_downward() -> None:
    for name in MODULES:
        ours = {room(other) for other in imports(name) & MODULES.keys()}
        if name in LEAVES:
            assert ours <= LEAVES, name
        elif room(name) == "numerics":
            assert ours <= LEAVES | {"numerics"}, name
        elif room(name) == "core":
            assert ours <= LEAVES | {"numerics", "core"}, name
        elif room(name) in ("accuracy", "report"):
            assert "cli" not in ours, name


def test_the_packages_of_core_form_a_line() -> None:
    for name in MODULES:
        if room(name) == "core" and name.split(".")[1:2] and name.split(".")[1] in CORE:
            above = CORE[CORE.index(name.split(".")[1]) + 1 :]
            wrong = {other for other in imports(name) if room(other) == "core" and other.split(".")[1:2][0] in above}
            assert not wrong, (name, wrong)


def test_heavy_libraries_have_one_door() -> None:
    for library, door in ALONE.items():
        users = {name for name in MODULES if library in imports(name) and room(name) != "accuracy"}
        assert users <= {door}, library


def test_families_are_listed_once() -> None:
    """The registry alone names the modules of families."""
    for name, path in MODULES.items():
        if name != "registry" and room(name) not in families():
            text = path.read_text(encoding="utf-8")
            assert not [family for family in families() if f'"{ROOT}.{family}.commands' in text], name


def test_no_private_names_of_others() -> None:
    private = []
    for name, path in MODULES.items():
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.ImportFrom) or not node.module:
                continue
            if node.module.split(".")[0] not in {ROOT, *sys.stdlib_module_names}:
                names = [part for alias in node.names for part in (*node.module.split("."), alias.name)]
                private += [(name, part) for part in names if part.startswith("_") and not part.startswith("__")]
    assert private == []
