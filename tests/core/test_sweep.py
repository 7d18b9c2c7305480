"""Sweeps: every point is the single call with the number shown, whichever route answered it."""

import io
import json
import shlex

import pytest
import row_helpers
from harness import answer, run
from row_helpers import PROBE

from dynamics_cli.cli import family, find_task
from dynamics_cli.core.answering.gather import gather
from dynamics_cli.core.batch import sweep as sweeping
from dynamics_cli.core.command.direct import read_plainly
from dynamics_cli.core.inputs.settings import Call, Settings
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import UsageError


def sweep(task, sweep, *, arrays=True, environ=None, **options):
    """The document and whether some point failed."""
    call = Call()
    for name, value in options.items():
        (call.options if name in task.options else call.settings)[name] = value
    call.settings["sweep"] = sweep
    terminal = Terminal(io.BytesIO(), io.BytesIO(), io.BytesIO(), environ or {})
    settings = Settings(call.settings, terminal.environ)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sweeping, "ARRAY_POINTS", 1 if arrays else 10**9)
        return sweeping.sweep(task, gather(task, call, settings, terminal), settings)


def table(document):
    return document["results"]["sweep"]


@pytest.mark.parametrize(
    "axes",
    [
        ["friction=0.3:0.9:301"],
        ["distance=20:60 ft:40", "friction=0:5.5:12"],
        ["friction=-0.2:6:63"],
        ["temperature=-470 degF:80 degF:111"],
        ["angle=0 deg:90 deg:91"],
        ["grade=-10 %:10 %:21"],
        ["at[0]=0 m:1 m:7"],
        ["count=0:6:7"],
        ["count=1:3:4"],
        ["invert=-1:1:21"],
        ["friction=0.9:0.3:4"],
        ["friction=0.5:0.5:2"],
    ],
)
def test_routes_agree(axes) -> None:
    options = {"distance": "60 ft", "at": "1, 2, 3 m"}
    if axes[0].startswith("distance"):
        del options["distance"]
    assert sweep(PROBE, axes, **options) == sweep(PROBE, axes, arrays=False, **options)


@pytest.mark.parametrize("arrays", [True, False])
def test_points_are_single_calls(arrays: bool) -> None:
    document, failed = sweep(PROBE, ["distance=10 ft:11 ft:31"], arrays=arrays, friction="0.7")
    assert not failed
    columns = table(document)
    for place in (0, 1, 7, 30):
        single = row_helpers.run(PROBE, b"distance[ft],friction\n%r,0.7\n" % columns["distance"]["value"][place])[1]
        assert single.split(b"\n")[1].split(b",")[2] == repr(columns["speed"]["value"][place]).encode()


def test_points_are_rounded_once_and_ends_exact() -> None:
    columns = table(sweep(PROBE, ["friction=0.1:0.7:7"], distance="60 ft")[0])
    assert columns["friction"]["value"] == [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]
    columns = table(sweep(PROBE, ["distance=0.1 in:0.2 ft:4"])[0])
    assert columns["distance"] == {"value": [0.1, 0.8666666666666667, 1.6333333333333333, 2.4], "unit": "in"}


def test_document() -> None:
    document, failed = sweep(PROBE, ["friction=0.3:0.9:3"], distance="60 ft")
    assert not failed
    assert list(document) == [
        "schema", "command", "version", "inputs", "results", "model", "numerics", "checks", "warnings",
    ]  # fmt: skip
    assert document["inputs"]["distance"] == {"value": 60, "unit": "ft"}
    assert "friction" not in document["inputs"]
    assert document["inputs"]["sweep"] == [
        {"parameter": "friction", "from": {"value": 0.3}, "to": {"value": 0.9}, "count": 3}
    ]
    assert set(table(document)) == {
        "friction",
        "speed",
        "warm",
        "turn",
        "slope",
        "inner.mean",
        "fast",
        "surface",
        "total",
    }
    assert table(document)["speed"]["unit"] == "km/h"


def test_first_parameter_varies_slowest() -> None:
    columns = table(sweep(PROBE, ["distance=1 m:2 m:2", "friction=0.1:0.3:3"])[0])
    assert columns["distance"]["value"] == [1.0, 1.0, 1.0, 2.0, 2.0, 2.0]
    assert columns["friction"]["value"] == [0.1, 0.2, 0.3] * 2


@pytest.mark.parametrize("arrays", [True, False])
def test_points_without_an_answer(arrays: bool) -> None:
    document, failed = sweep(PROBE, ["friction=-1:7:9"], arrays=arrays, distance="60 ft")
    assert failed
    columns = table(document)
    assert [value is None for value in columns["speed"]["value"]] == [True] + [False] * 5 + [True] * 3
    warnings = {warning["code"]: warning for warning in document["warnings"]}
    assert warnings["glue"]["count"] == 3
    assert warnings["glue"]["first"] == 6
    assert "friction = 5.0" in warnings["glue"]["message"]
    assert warnings["bounds"]["count"] == 1
    json.dumps(document, allow_nan=False)


def test_every_point_without_an_answer() -> None:
    document, failed = sweep(PROBE, ["friction=6:7:3"], distance="60 ft")
    assert failed
    assert list(table(document)) == ["friction"]
    document, failed = sweep(PROBE, ["friction=-6:-5:3"], distance="60 ft")
    assert failed
    assert document["warnings"][0]["count"] == 3


def test_addresses() -> None:
    marks = ["distance=10 m, friction=0.5", "distance=10 m, friction=0.4"]
    by_address, _ = sweep(PROBE, ["marks[1].friction=0.1:0.3:3"], mark=marks)
    assert next(iter(table(by_address))) == "marks[1].friction"
    assert "friction" not in by_address["inputs"]["marks"][1]
    assert by_address["inputs"]["marks"][0]["friction"] == {"value": 0.5}


@pytest.mark.parametrize(
    ("axis", "code"),
    [
        ("friction=0.3:0.9", "syntax"),
        ("friction=0.3:0.9:1", "count"),
        ("friction=0.3:0.9:x", "count"),
        ("friction=0.3:0.9:9999999", "count"),
        ("friction=a:0.9:3", "number"),
        ("friction=0.3 kg:0.9:3", "kind"),
        ("distance=1 ft:3 kg:3", "kind"),
        ("distance=1:3:3", "missing-unit"),
        ("frction=0.3:0.9:3", "unknown-parameter"),
        ("surface=1:3:3", "unknown-choice"),
        ("friction=1e400:2:3", None),
    ],
)
def test_wrong_sweeps(axis: str, code: str | None) -> None:
    options = {} if axis.startswith("distance") else {"distance": "60 ft"}
    with pytest.raises(UsageError) as caught:
        sweep(PROBE, [axis], **options)
    assert code is None or caught.value.code == code


@pytest.mark.parametrize(
    ("axis", "remedy"),
    [
        ("distance=20 m:21 m:1", 'in steps of 1: --sweep "distance=20 m:21 m:2"'),
        ("friction=0.3:0.9:0.7", "from 0.3 to 0.9 is not a whole number of steps of 0.7; for example"),
        (
            "friction=0.2:0.9:0.3",
            'from 0.2 to 0.9 is not a whole number of steps of 0.3: --sweep "friction=0.2:0.8:0.3"',
        ),
        ("friction=0.3:0.9:-0.1", "from 0.3 to 0.9"),
        ("friction=0.3:0.9:0", "for example"),
        ("distance=20 ft:60:5 kg", "from 20 ft to 60"),
    ],
)
def test_a_step_that_does_not_reach_the_end_is_refused(axis: str, remedy: str) -> None:
    with pytest.raises(UsageError) as caught:
        sweep(PROBE, [axis])
    assert str(caught.value.hint).startswith(remedy)


@pytest.mark.parametrize("step", ["10", "-10"])
def test_steps_go_downwards_from_a_larger_number(step: str) -> None:
    column = answer("skid", "speed", "--friction", "0.7", "--sweep", f"distance=60:20:{step} m")["results"]["sweep"]
    assert column["distance"]["value"] == [60.0, 50.0, 40.0, 30.0, 20.0]


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ("friction=0,5, 0,7", "'0,5, 0,7' may be numbers with decimal commas"),
        ("distance=1,000, 2,000 m", "'1,000, 2,000 m' may be numbers with decimal commas"),
        ("friction=0.3, 0.5 ± 0.1", "the points '0.3, 0.5 ± 0.1' are uncertain"),
        ("distance=20, 40 m,", "'20, 40 m,' has an empty item"),
    ],
)
def test_lists_that_may_be_read_in_two_ways_are_refused(points: str, message: str) -> None:
    outcome = run("skid", "speed", "--distance", "20 m", "--friction", "0.7", "--sweep", points, "--json")
    assert (outcome.status, outcome.error["parameter"], outcome.error["message"]) == (2, "sweep", message)


def test_a_vector_is_swept_by_its_components() -> None:
    words = ["impact", "oblique", "--first-mass", "1 kg", "--first-velocity", "3, 1 m/s", "--second-mass", "1 kg"]
    words += ["--second-velocity", "0, 0 m/s", "--normal", "0 deg", "--restitution", "0.9", "--sweep"]
    refused = run(*words, "first-velocity=1, 2 m/s", "--json")
    assert refused.error["hint"] == 'sweep one component of it: --sweep "first.velocity[0]=1, 2 m/s"'
    column = answer(*words, "first-velocity[0]=1, 2 m/s")["results"]["sweep"]["second.speed"]["value"]
    words[5] = "2, 1 m/s"
    assert column[1] == answer(*words[:-1])["results"]["second"]["speed"]["value"]


def test_too_many_points() -> None:
    with pytest.raises(UsageError, match="too many"):
        sweep(PROBE, ["friction=0:1:2000", "distance=1 m:2 m:2000"])


def test_what_is_missing_is_told_as_in_a_single_call() -> None:
    with pytest.raises(UsageError, match="distance is missing"):
        sweep(PROBE, ["friction=0:1:3"])


def test_options_for_one_case() -> None:
    with pytest.raises(UsageError):
        sweep(PROBE, ["friction=0:1:3"], distance="1 m", explain=True)


def test_files_and_timing(tmp_path) -> None:
    (tmp_path / "case.json").write_text('{"distance": "60 ft", "friction": 0.2}')
    document, _ = sweep(PROBE, ["friction=0:1:3"], input=str(tmp_path / "case.json"), timing=True)
    assert len(document["files"]) == 1
    assert document["timing"]["unit"] == "s"


def test_models_chosen_by_value() -> None:
    document, _ = sweep(row_helpers.MODELS, ["a=0:1:11"], arrays=True)
    assert document == sweep(row_helpers.MODELS, ["a=0:1:11"], arrays=False)[0]
    assert document["warnings"][-1]["code"] == "several-models"


def example_axes():
    """Every number of every documented example of the families, half to one and a half times itself."""
    for name in ("skid", "coords"):
        for task in family(name).tasks.values():
            for example in task.examples:
                argv = shlex.split(example)[1:]
                call = read_plainly(task, argv[find_task(argv)[1] :])
                if call is None or call.settings:
                    continue
                terminal = Terminal(io.BytesIO(), io.BytesIO(), io.BytesIO(), {})
                gathered = gather(task, call, Settings(call.settings, {}), terminal)
                bound = gathered.reader.read(task.specification.fields, gathered.raw)
                for address, kind, si in bound.leaves():
                    unit = f" {kind.unit}".rstrip()
                    axis = f"{address}={0.5 * si!r}{unit}:{1.5 * si!r}{unit}:40"
                    yield pytest.param(task, call, axis, id=f"{task.path} {address} {len(argv)}")


@pytest.mark.parametrize(("task", "call", "axis"), list(example_axes()))
def test_every_task_answers_arrays_to_the_bit(task, call, axis: str) -> None:
    made = []
    for arrays in (True, False):
        terminal = Terminal(io.BytesIO(), io.BytesIO(), io.BytesIO(), {})
        call.settings["sweep"] = [axis]
        settings = Settings(call.settings, {})
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(sweeping, "ARRAY_POINTS", 1 if arrays else 10**9)
            made.append(sweeping.sweep(task, gather(task, call, settings, terminal), settings))
    assert made[0] == made[1]


def test_whole_program() -> None:
    document = answer("skid", "speed", "--distance", "60 ft", "--sweep", "friction=0.3:0.9:1500")
    single = answer(
        "skid",
        "speed",
        "--distance",
        "60 ft",
        "--friction",
        repr(document["results"]["sweep"]["friction"]["value"][777]),
    )
    assert document["results"]["sweep"]["speed"]["value"][777] == single["results"]["speed"]["value"]
    for form in ("table", "csv", "markdown", "ndjson"):
        outcome = run("skid", "speed", "--distance", "60 ft", "--sweep", "friction=-0.3:0.9:5", "--format", form)
        assert outcome.status == 4
        assert outcome.out


def test_some_columns_of_a_sweep_with_their_spread() -> None:
    call = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7 ± 0.1", "--sweep", "distance=20:60ft:2")
    outcome = run(*call, "--only", "speed", "--format", "csv")
    header = outcome.out.splitlines()[0].split(",")
    assert header[:2] == ["distance[ft]", "speed[km/h]"]
    assert [name for name in header[2:] if not name.startswith("speed.")] == []
    assert len(outcome.out.splitlines()) == 3
    refused = run(*call, "--only", "sped")
    assert (refused.status, "results of rows are speed," in refused.err) == (2, True)


@pytest.mark.parametrize("words", ["--only speed,time", "--all", "--table sweep", "--digits 17 --only speed"])
def test_a_sweep_is_no_wider_than_the_terminal(words: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Terminal, "columns", 80)
    call = ("skid", "speed", "--distance", "60 ± 2 ft", "--friction", "0.7", "--sweep", "friction=0.5:0.8:4")
    lines = run(*call, "--to", "speed=mph", *words.split()).out.splitlines()
    assert max(map(len, lines)) <= 80
    monkeypatch.setattr(Terminal, "columns", 0)
    whole = run(*call, "--to", "speed=mph", *words.split()).out.splitlines()
    assert {*" ".join(whole).split()} <= {*" ".join(lines).split()}


def test_a_result_of_an_input_s_name_is_said_to_be_one() -> None:
    call = ("vibration", "free", "--natural-frequency", "3 Hz", "--sweep", "damping_ratio=0.1:0.2:2")
    assert "damping ratio (result)" in run(*call).out


def test_a_quiet_sweep_is_its_table() -> None:
    out = run("skid", "speed", "--distance", "18 m", "--sweep", "friction=0.5:0.9:3", "-q").out
    assert out.startswith("sweep\n")
    assert "0.7" in out
    assert "for " not in out


def test_an_uncertain_sweep_shows_the_interval_of_the_headline_first() -> None:
    call = ("skid", "speed", "--distance", "38 ± 1 m", "--sweep", "friction=0.5:0.9:3")
    head, units, first = run(*call).out.splitlines()[1:4]
    assert head.split()[:7] == ["friction", "speed", "95", "%", "from", "to", "time"]
    table = json.loads(run(*call, "--json").out)["results"]["sweep"]
    assert "mean" not in head
    assert first.split()[:4] == [
        "0.5", *(f"{table[name]['value'][0]:.6g}" for name in ("speed", "speed.low", "speed.high"))
    ]  # fmt: skip
    assert units.split()[:3] == ["km/h"] * 3


@pytest.mark.parametrize(
    ("text", "unit", "values"),
    [
        ("distance=20, 40,60 ft", "ft", [20.0, 40.0, 60.0]),
        ("distance=20 m, 100 ft", "m", [20.0, 30.48]),
        ("distance=20:60:20 ft", "ft", [20.0, 40.0, 60.0]),
        ("distance=1 m:3 m:50 cm", "m", [1.0, 1.5, 2.0, 2.5, 3.0]),
        ("distance=3:1:-1 m", "m", [3.0, 2.0, 1.0]),
        ("distance=20 ft:21:3 in", "ft", [20.0, 20.25, 20.5, 20.75, 21.0]),
        ("friction=0.2:0.4:0.1", "", [0.2, 0.3, 0.4]),
    ],
)
def test_points_by_list_or_step(text: str, unit: str, values: list[float]) -> None:
    more = {} if text.startswith("distance") else {"distance": "1 m"}
    document, failed = sweep(PROBE, [text], **more)
    column = document["results"]["sweep"][text.partition("=")[0]]
    assert (column.get("unit", ""), column["value"], failed) == (unit, values, False)


def test_points_that_are_words() -> None:
    document, _ = sweep(PROBE, ["surface=dry, wet", "distance=1,2 m"])
    table = document["results"]["sweep"]
    assert table["surface"]["value"] == ["dry", "dry", "wet", "wet"]
    assert table["results.surface"]["value"] == table["surface"]["value"]
    assert document["inputs"]["sweep"][0] == {"parameter": "surface", "values": ["dry", "wet"], "count": 2}
    with pytest.raises(UsageError, match="'damp'"):
        sweep(PROBE, ["surface=dry,damp"], distance="1 m")
