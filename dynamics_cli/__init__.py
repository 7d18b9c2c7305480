"""dynamics: an engineering calculator suite for the terminal. `run("skid speed", distance="50 ft", friction=0.7)`."""

from dynamics_cli.version import __version__ as __version__


def run(command: str, /, **parameters: object) -> dict[str, object]:
    """Answer one command and return its result document as a dictionary.

    `command` is the family and task as typed (`"skid speed"`); every parameter takes what the command line or a JSON
    input would: `"50 ft"`, `0.7`, `{"value": 60, "unit": "ft"}`, a list of segments. `units="us"`, `to="speed=ft/s"`,
    `limit="50 mph"`, `input="scene.toml"`, `sweep="friction=0.3:0.9:7"`, `model` and `explain=True` mean what the
    options of that name do, and those that say how a document is written are refused; `from_` stands for `from`.
    numpy's numbers and arrays are taken as Python's.
    Raises `dynamics_cli.errors.DynamicsError` when the call is wrong or has no answer.
    """
    from dynamics_cli.cli import answer

    return answer(command, parameters)


def run_rows(command: str, rows: bytes, /, *words: str) -> bytes:
    """Answer a stream of cases, CSV or NDJSON as bytes, as `--rows` does: one row out for each row in.

    `command` is the family and task as typed, `words` what may stand after it (`"--units", "us"`). A row that is wrong
    carries its own error; raises `dynamics_cli.errors.DynamicsError` when the call itself is wrong.
    """
    from dynamics_cli.cli import answer_rows

    return answer_rows(command, rows, words)
