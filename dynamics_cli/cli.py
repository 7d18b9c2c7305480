"""The program: chooses the direct route or the tree of commands, and turns every error into an exit status."""

import sys

from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import DynamicsError, ExitStatus, FaultError, UsageError
from dynamics_cli.registry import FAMILIES
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.task import Family, Task

# Whole words alone, so that `convert -40degC degF` keeps its number.
SHORT = {"-h": "--help", "-o": "--output", "-q": "--quiet", "-j": "--json"}
# Forces every call through typer, so that tests can compare the two routes.
ROUTE_VARIABLE = "DYNAMICS_ROUTE"
# Shows the traceback of an internal error.
DEBUG_VARIABLE = "DYNAMICS_DEBUG"


def family(name: str) -> "Family":
    """The family of that name, imported now."""
    module = __import__(FAMILIES[name].module, fromlist=["FAMILIES"])
    return module.FAMILIES[name]  # type: ignore[no-any-return]


def find_task(words: "list[str]") -> "tuple[Task, int] | None":
    """The task the first words name, and how many words that took."""
    if not words or words[0] not in FAMILIES:
        return None
    members = family(words[0])
    if members.alone is not None:
        return members.alone, 1
    task = members.tasks.get(words[1]) if len(words) > 1 else None
    return (task, 2) if task is not None else None


def _named(words: "list[str]") -> bool:
    """Whether words after `help` name a command, or nothing; other words are searched for."""
    from dynamics_cli.core.command.plain_commands import COMMANDS

    names = {*FAMILIES, *(command.name for command in COMMANDS), "report", "examples"}
    return not words or (len(words) == 1 and words[0] in names) or find_task(words) is not None


def program(argv: "list[str]", terminal: Terminal) -> int:
    """Carry out one call; errors are raised."""
    from dynamics_cli.core.inputs.sources.preferences import with_preferences

    terminal.environ = with_preferences(terminal.environ)
    if argv[:1] == ["help"] and _named(argv[1:]):
        argv = [*argv[1:], "--help"]
    if argv == ["--version"]:
        terminal.write(f"dynamics {__version__}\n")
        return ExitStatus.DONE
    if terminal.environ.get(ROUTE_VARIABLE) != "tree":
        found = find_task(argv)
        if found is not None:
            from dynamics_cli.core.command.direct import read_plainly

            task, taken = found
            call = read_plainly(task, argv[taken:])
            if call is not None:
                from dynamics_cli.core.command.execute import execute

                return execute(task, call, terminal)
    from dynamics_cli.core.command.tree import run_tree
    from dynamics_cli.examples_command import EXAMPLES
    from dynamics_cli.report import REPORT

    lines = {name: (entry.group, entry.summary) for name, entry in FAMILIES.items()}
    return run_tree(argv, lines, family, (REPORT, EXAMPLES), terminal)


def run_argv(argv: "list[str]", terminal: Terminal) -> int:
    """Carry out one call and report any failure; the exit status."""
    argv = [SHORT.get(word, word) for word in argv]
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
            message = f"internal error (please report it): {type(error).__name__}: {error}"
            raise FaultError(message, hint=f"{DEBUG_VARIABLE}=1 shows where") from error
    except DynamicsError as error:
        from dynamics_cli.core.output.failure import error_text, wants_json

        if error.code == "unreadable" and not error.hint:
            from dynamics_cli.examples_command.command import how_to_copy

            error.hint = how_to_copy(argv)
        json, columns = wants_json(argv, terminal.environ), terminal.error_columns
        colours = terminal.has_colours(columns)
        terminal.tell(error_text(error, json=json, typed=argv, columns=columns, colours=colours))
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

    # No product of matrices here is worth a second thread, and waiting threads take processor time.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    status = main()
    if os.environ.get(DEBUG_VARIABLE):
        sys.exit(status)
    os._exit(status)


def answer(command: str, parameters: "dict[str, object]") -> "dict[str, Any]":
    """The result document of one command, for Python callers."""
    from dynamics_cli.core.answering.gather import Gathered, over_file
    from dynamics_cli.core.command.arguments import options_of, plain_parameters
    from dynamics_cli.core.command.execute import document_of
    from dynamics_cli.core.command.plain_commands import task_of
    from dynamics_cli.core.inputs.reader import Reader
    from dynamics_cli.core.inputs.settings import Settings

    task = task_of(command.split(), FAMILIES, family)
    terminal = Terminal()
    raw = plain_parameters(parameters)
    settings = Settings(options_of(raw), terminal.environ)
    gathered = (
        over_file(task, raw, settings.input, terminal) if settings.input else Gathered(raw, Reader(terminal.environ))
    )
    return document_of(task, gathered, settings)


def answer_rows(command: str, rows: bytes, words: "tuple[str, ...]") -> bytes:
    """The rows that a stream of cases becomes, for Python callers."""
    from io import BytesIO

    sink = BytesIO()
    program([*command.split(), *words, "--rows", "-"], Terminal(BytesIO(rows), sink))
    return sink.getvalue()
