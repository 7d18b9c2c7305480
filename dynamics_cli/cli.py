"""The program: chooses the direct route or the tree of commands, and turns every error into an exit status."""

import sys

from dynamics_cli import __version__
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import DynamicsError, ExitStatus, FaultError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.task import Family, Task

# Each family's module, and its line in the list of commands, so that help need import none of them.
FAMILIES: "dict[str, tuple[str, str]]" = {
    "convert": ("dynamics_cli.convert.commands", "Convert a quantity to other units, exactly."),
    "units": ("dynamics_cli.convert.commands", "List, show and search units; the book's conversion table."),
    "coords": ("dynamics_cli.convert.commands", "Cartesian, cylindrical and spherical coordinates."),
    "skid": ("dynamics_cli.skid.commands", "Speeds and distances from skids, yaw marks, vaults and braking."),
    "impact": ("dynamics_cli.impact.commands", "Impacts, from two balls to a two-car crash with friction."),
    "inertia": ("dynamics_cli.inertia.commands", "Mass properties of shapes, assemblies, sections and meshes."),
    "cam": ("dynamics_cli.cam.commands", "Cam motions, profiles, sizes, forces and files for machines."),
    "gear": ("dynamics_cli.gear.commands", "Gear geometry, measurement, pairs, trains and ratios."),
    "accuracy": ("dynamics_cli.accuracy.commands", "Speed against error of every method, measured here and now."),
}
# Forces every call through typer, so that tests can compare the two routes.
ROUTE_VARIABLE = "DYNAMICS_ROUTE"
# Shows the traceback of a fault of ours.
DEBUG_VARIABLE = "DYNAMICS_DEBUG"


def family(name: str) -> "Family":
    """The family of that name, imported now."""
    module = __import__(FAMILIES[name][0], fromlist=["FAMILIES"])
    return module.FAMILIES[name]  # type: ignore[no-any-return]


def find_task(words: "list[str]") -> "tuple[Task, int] | None":
    """The task the first words name, and how many words that took."""
    if not words or words[0] not in FAMILIES:
        return None
    found = family(words[0])
    if found.alone is not None:
        return found.alone, 1
    task = found.tasks.get(words[1]) if len(words) > 1 else None
    return (task, 2) if task is not None else None


def program(argv: "list[str]", terminal: Terminal) -> int:
    """Carry out one call; errors are raised."""
    if argv == ["--version"]:
        terminal.write(f"dynamics {__version__}\n")
        return ExitStatus.DONE
    if terminal.environ.get(ROUTE_VARIABLE) != "tree":
        found = find_task(argv)
        if found is not None:
            from dynamics_cli.core.direct import read_plainly

            task, taken = found
            call = read_plainly(task, argv[taken:])
            if call is not None:
                from dynamics_cli.core.execute import execute

                return execute(task, call, terminal)
    from dynamics_cli.core.tree import run_tree
    from dynamics_cli.report import REPORT

    return run_tree(argv, FAMILIES, family, (REPORT,), terminal)


def run_argv(argv: "list[str]", terminal: Terminal) -> int:
    """Carry out one call and report any failure; the exit status."""
    try:
        try:
            status = program(argv, terminal)
            terminal.flush()
        except DynamicsError:
            raise
        except (KeyboardInterrupt, BrokenPipeError):
            raise
        except OSError as error:
            from dynamics_cli.errors import OutputError

            raise OutputError(f"cannot read or write: {error.strerror or error}") from error
        except RecursionError:
            raise UsageError(
                "the input is nested too deeply", code="nested", hint="some dozens of levels work"
            ) from None
        except Exception as error:
            if terminal.environ.get(DEBUG_VARIABLE):
                raise
            message = f"a fault of ours: {type(error).__name__}: {error}"
            raise FaultError(message, hint=f"please report it; {DEBUG_VARIABLE}=1 shows where") from error
    except DynamicsError as error:
        from dynamics_cli.core.failing import error_text, wants_json

        terminal.tell(error_text(error, json=wants_json(argv, terminal.environ)))
        status = error.status
    except KeyboardInterrupt:
        status = ExitStatus.INTERRUPTED
    except BrokenPipeError:
        _close_quietly()
        status = ExitStatus.DONE
    return status


def _close_quietly() -> None:
    """The reader has gone: nothing more can be written, not even at exit."""
    import os

    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


def main() -> int:
    """Carry out the process's call; the exit status, everything written and flushed."""
    return run_argv(sys.argv[1:], Terminal())


def script() -> None:
    """The `dynamics` command: ends the process at once, for taking the interpreter down costs a calculation."""
    import os

    status = main()
    if os.environ.get(DEBUG_VARIABLE):
        sys.exit(status)
    os._exit(status)


def answer(command: str, parameters: "dict[str, object]") -> "dict[str, Any]":
    """The result document of one command, for Python callers."""
    from dynamics_cli.core.call import UNIVERSAL_OPTIONS, Settings
    from dynamics_cli.core.execute import document_of
    from dynamics_cli.core.gather import Gathered
    from dynamics_cli.core.reading import Reader

    words = command.split()
    found = find_task(words)
    if found is None or found[1] != len(words):
        raise UsageError(f"there is no command {command!r}", code="unknown-command")
    terminal = Terminal()
    raw = {name.rstrip("_"): value for name, value in parameters.items()}
    asked: dict[str, Any] = {name: raw.pop(name) for name in UNIVERSAL_OPTIONS if name in raw}
    for name, value in asked.items():
        if UNIVERSAL_OPTIONS[name][0] == "many" and isinstance(value, str):
            asked[name] = [value]
    return document_of(found[0], Gathered(raw, Reader(terminal.environ)), Settings(asked, terminal.environ))


def answer_rows(command: str, rows: bytes, words: "tuple[str, ...]") -> bytes:
    """The rows that a stream of cases becomes, for Python callers."""
    from io import BytesIO

    sink = BytesIO()
    program([*command.split(), *words, "--rows", "-"], Terminal(BytesIO(rows), sink))
    return sink.getvalue()
