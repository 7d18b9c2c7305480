"""Wrong calls: each with its exit status and the words that tell the user what to mend; none with a traceback."""

import json
from pathlib import Path

import pytest
from harness import run
from hypothesis import given, settings
from hypothesis import strategies as st

SKID = "skid|speed"
OK = "skid|speed|--distance|60 ft|--friction|0.7"

# A call, its words divided by |; the exit status; words of the message or hint.
WRONG = [
    ("convert", 2, "value is missing"),
    ("convert|60", 2, "60 has no unit"),
    ("convert|98.6 F", 2, "may be electrical or a temperature"),
    ("convert|60 mph|", 2, "the unit to convert to is empty"),
    ("skid|speed|--distance|60 ft|--friction|0.7|--limit|speed<50 km/h", 2, '--limit "speed=50 km/h"'),
    ("skid|speed|--distance|60|ft|--friction|0.7", 2, 'quote a value that has spaces: --distance "60 ft"'),
    ("skid|speed|distance=60ft|friction=0.7", 2, "did you mean --distance 60ft --friction 0.7?"),
    ("skid|speed|help", 2, "did you mean dynamics help skid speed?"),
    ("skid|speed|-distance|60ft", 2, "there is no option -distance"),
    ("skid|speed|--Distance|60ft", 2, "did you mean --distance?"),
    ("skid|speed|--distance|60ft|--us", 2, "did you mean --units us?"),
    ("convert|60|mph|kg", 2, "mph is a speed, kg is a mass"),
    ("convert|60|mhp|ft/s", 2, "did you mean mph"),
    ("convert|60|furlng|ft", 2, "unknown unit 'furlng'"),
    ("convert|sixty|mph|ft/s", 2, "is not a decimal number"),
    ("convert|1,5|m|ft", 2, "write 1.5 with a point"),
    ("convert|1_000|m|ft", 2, "is not a decimal number"),
    ("convert|nan|m|ft", 2, "is not a decimal number"),
    ("convert|inf m|ft", 2, "is not a decimal number"),
    ("convert|1e400|m|ft", 2, "beyond the range of a double"),
    ("convert|1e999999999|m|ft", 2, "beyond the range of a double"),
    ("convert|1e-400|m|ft", 2, "too close to zero"),
    ("convert|0x10|m|ft", 2, "unknown unit 'x'"),
    ("convert|٣|m|ft", 2, "is not a decimal number"),
    ("convert|5 ft 6|in", 2, "unit"),
    ("convert|6 ft 2 kg|in", 2, "kg"),
    ("convert|3 kg/3 m|kg", 2, "a number inside the unit"),
    ("convert|1 Nm|J", 2, "Nm is a torque, J is an energy"),
    ("convert|1 J|N*m", 2, "J is an energy, N*m is a torque"),
    ("convert|1 Hz|rad/s", 2, "a cycle is not an angle"),
    ("convert|1 Hz|rpm", 2, "Hz is a frequency, rpm is an angular speed"),
    ("convert|150|lbf|kg", 2, "--weight"),
    ("convert|150|lbf|m|--weight", 2, "a mass to a weight"),
    ("convert|-500|degC|degF", 3, "below absolute zero by 226.85 K"),
    ("convert|60 mph|ft/s;in", 2, "in is a length, ft/s is a speed"),
    ("convert|1 m|in;ft", 2, "put the larger unit first: ft;in"),
    ("convert|60 mph|ft/s|--bogus", 2, "there is no option --bogus"),
    ("convert|60 mph|ft/s|--frmat|json", 2, "did you mean --format?"),
    ("convert|60 mph|ft/s|-x", 2, "there is no option -x"),
    ("convert|1 m/s/|ft", 2, "a unit is missing"),
    ("convert|1 kg/m s|ft", 2, "use parentheses"),
    ("convert|1 (m|ft", 2, "has no ')'"),
    ("convert|1 m^999|ft", 2, "a power must be a whole number"),
    ("convert|1 m^0.5|ft", 2, "cannot read 'm^0.5' as a unit"),
    ("convert|1 \x1b[31mm|ft", 2, r"\x1b"),
    ("convert|1 " + "m" * 5000 + "|ft", 2, "is too long"),
    ("convert|" + "9" * 500 + " m|ft", 2, "more than 400 characters"),
    ("convert|1..5|m|ft", 2, "an uncertain value"),
    ("convert||m", 2, "the quantity is empty"),
    ("convert|0 Ba|", 2, "the unit to convert to is empty"),
    ("convert|0.7 ± 0.1 m|ft", 2, "uncertain"),
    ("convert|5 m|ft|--gravity|9 m", 2, "m is a length, m/s^2 is an acceleration"),
    (f"{SKID}|--distance|60|--friction|0.7", 2, "has no unit"),
    (f"{SKID}|--distance|60 ft", 2, "friction is missing"),
    (SKID, 2, "distance is missing"),
    (f"{SKID}|--distance|-60 ft|--friction|0.7", 2, "it must be at least 0 m"),
    (f"{SKID}|--distance|60 ft|--friction|-0.7", 2, "it must be at least 0"),
    (f"{SKID}|--distance|60 ft|--friction|0.7 m", 2, "a pure number is wanted"),
    (f"{SKID}|--distance|60 ft|--friction|0,7", 2, "write 0.7 with a point"),
    (f"{SKID}|--distance|60 kg|--friction|0.7", 2, "kg is a mass, m is a length"),
    (f"{OK}|--braking|120 %", 2, "it must be at most 1"),
    (f"{SKID}|--distance|60 ft|--friction|0.02|--grade|-3 %", 3, "the drag factor of -0.009996 is not above zero"),
    (f"{OK}|--grade|90 deg", 2, "90 deg or more"),
    (f"{SKID}|--distance|60 ft|--friction|0.75..0.65", 2, "above the upper one"),
    (f"{SKID}|--distance|60 ft|--friction|lognormal(0.7)", 2, "does not have the form mean, std"),
    (f"{SKID}|--distance|60 ft|--friction|0.7 ± 5 %", 2, "a share of the value or a difference"),
    (f"{SKID}|--distance|60 ± 2 ft|--friction|0.7 ± 0.1|--correlate|distance,grade=0.3", 2, "not an uncertain input"),
    (f"{SKID}|--distance|60 ± 2 ft|--friction|0.7|--method|guess", 2, "wanted one of auto"),
    (f"{SKID}|--distance|60 ± 2 ft|--friction|0.7|--coverage|95", 2, "less than 1"),
    (f"{OK}|--friction|0.8", 2, "--friction is given 2 times"),
    (f"{SKID}|--distance", 2, '--distance needs a value\n  for example --distance "60 ft"'),
    (f"{OK}|extra", 2, "extra"),
    (f"{OK}|--mass|0.5 lbf", 2, "weight is a force"),
    (f"{OK}|--format|xml", 2, "wanted one of table, json"),
    (f"{OK}|--json|--format|csv", 2, "cannot be given together"),
    (f"{OK}|--units|cgs", 2, "wanted one of si, us, base"),
    (f"{OK}|--digits|0", 2, "wanted 1 to 17 significant digits"),
    (f"{OK}|--to|speed=kg", 2, "cannot be shown in kg"),
    (f"{OK}|--to|sped=ft/s", 2, "there is no result 'sped'"),
    (f"{OK}|--to|speed", 2, "wanted NAME=UNIT"),
    (f"{OK}|--to|speed=frob", 2, "unknown unit 'frob'"),
    (f"{OK}|--limit|50", 2, "has no unit"),
    (f"{OK}|--limit|sped=50 mph", 2, "there is no result 'sped'"),
    (f"{OK}|--limit|50 kg", 2, "kg is a mass"),
    (f"{OK}|--model|big", 2, "there is no model 'big'"),
    (f"{OK}|--gravity|-1 m/s^2", 2, "greater than 0"),
    (f"{OK}|--gravity|", 2, "the quantity is empty"),
    (f"{OK}|--output|", 2, "--output is empty"),
    (f"{OK}|--output|x.pdf", 2, "`dynamics report` makes one of a document in .json"),
    (f"{OK}|--output|/nowhere/x.json", 5, "cannot write '/nowhere/x.json'"),
    (f"{OK}|--sweep|friction=1:2", 2, "sweep"),
    (f"{OK}|--sweep|colour=1:2:3", 2, "colour"),
    (f"{OK}|--rows|/nowhere.csv", 2, "/nowhere.csv"),
    (f"{SKID}|--segment|distance=60 ft", 2, "--segment: friction is missing"),
    (f"{SKID}|--segment|distance 60 ft", 2, "wanted name=value"),
    ("cam|profile|--drawing|c.dxf", 2, "dynamics cam export"),
    ("gear|pair|--drawing|c.dxf", 2, "dynamics gear profile"),
    ("inertia|section|i-beam", 2, "dynamics inertia section --template > i-beam.toml"),
    ("inertia|shape|flywheel|--mass|1 kg", 2, "--help lists all 49"),
    ("particle|circle|--diameter|60 m", 2, "--radius, half of it, as in 60/2 mm?"),
    ("inertia|shape|tube|--outer-diameter|60 mm", 2, "did you mean --diameter?"),
    ("balance|planes|--unbalance|300 g*mm", 2, "example: amount=12 g*mm, angle=30 deg, position=0.1 m"),
    ("force|equilibrium|--support|pin", 2, "at is missing: where it holds"),
    ("force|moment|--force|1, 0 N|--at|1, 2, 3, 4 m", 2, "read 4 components, wanted 2 or 3"),
    (f"{SKID}|--segment|distance=1 ft, distance=5 ft", 2, "is given twice"),
    (f"{SKID}|--segment|distance=60 ft, friction=0.7, color=red", 2, "there is no parameter 'color'"),
    (f"{OK}|--segment|distance=60 ft, friction=0.7", 2, "cannot be given together"),
    (f"{SKID}|--input|/nowhere.json", 2, "No such file"),
    (f"{SKID}|--input|/", 2, "Is a directory"),
    (f"{SKID}|--distance|@/nowhere.json:speed|--friction|0.7", 2, "No such file"),
    (f"{SKID}|--distance|@x|--friction|0.7", 2, "wanted a file and an address"),
    (f"{SKID}|--distance|1e308 km|--friction|0.7", 2, "beyond the range of a double"),
    (f"{SKID}|--distance|1e307 m|--friction|1e300", 3, "leaves the range of a double"),
    ("linkage|slider-crank|--crank|50 mm|--rod|1e300 mm|--crank-angle|60 deg", 3, "leaves the range of a double"),
    ("skid|sped", 2, "did you mean dynamics skid speed?"),
    ("skdi", 2, "did you mean dynamics skid?"),
    ("units|show|frobnitz", 2, "unknown unit 'frobnitz'"),
    ("units|search|qqqq", 2, "in its name or kind"),
    ("units|list|--kind|lenght", 2, "did you mean length?"),
    ("units|table|other", 2, "wanted one of josephs-huston"),
    ("schema", 2, "a family and its task are missing"),
    ("schema|skid|sped", 2, "did you mean dynamics skid speed?"),
    ("schema|frob", 2, "there is no command 'frob'"),
    ("--frob", 2, "there is no option --frob"),
]


def words(call: str) -> list[str]:
    return call.split("|")


@pytest.mark.parametrize(("call", "status", "fragment"), WRONG, ids=[call[:50] for call, _, _ in WRONG])
def test_a_wrong_call_is_told(call: str, status: int, fragment: str) -> None:
    outcome = run(*words(call))
    assert outcome.status == status, outcome.err
    assert outcome.out == ""
    assert fragment.lower() in outcome.err.lower()
    assert "Traceback" not in outcome.err


@pytest.mark.parametrize(
    ("call", "status"),
    [(call, status) for call, status, _ in WRONG if "--format" not in call],
    ids=[call[:50] for call, _, _ in WRONG if "--format" not in call],
)
def test_with_json_an_error_is_one_object(call: str, status: int) -> None:
    outcome = run(*words(call), env={"DYNAMICS_FORMAT": "json"})
    assert outcome.status == status
    assert {"code", "parameter", "message", "hint"} <= set(outcome.error)
    assert outcome.err.count("\n") == 1


FILES = {
    "twice.json": (b'{"distance": "60 ft", "distance": "50 ft"}', "is given twice"),
    "nan.json": (b'{"distance": NaN}', "must be finite"),
    "infinity.json": (b'{"distance": -Infinity}', "must be finite"),
    "latin.json": ('{"note": "é"}'.encode("latin-1"), "is not UTF-8 text: byte 10 is 0xe9"),
    "deep.json": (b"[" * 100_000, "nested too deeply"),
    "empty.json": (b"", "it is empty"),
    "list.json": (b"[1, 2]", "a list of cases goes to --rows"),
    "bad.toml": (b"distance = \n", "is not TOML"),
    "words.toml": (b"a = 1\nname = Ford\n", "that line is: name = Ford; text stands in quotes"),
    "date.toml": (b"distance = 2026-01-01\n", "a date or time"),
    "inf.toml": (b"friction = inf\n", "must be finite"),
    "other.json": (b'{"schema": "other/1", "results": {}}', "wanted 'dynamics/2'"),
    "none.json": (b'{"schema": "dynamics/1"}', "has no results"),
    "nul.json": (b"\x00\x01\x02", "is not JSON"),
    "unknown.json": (b'{"distance": "60 ft", "fricton": 0.7}', "did you mean friction?"),
    "types.json": (b'{"distance": true, "friction": [1]}', "read true"),
    "null.json": (b'{"distance": {"value": null, "unit": "ft"}, "friction": 1}', "has no such result"),
    "pair.json": (b'{"distance": {"size": 60}, "friction": 1}', "wanted value and unit"),
    "units.json": (b'{"units": 3, "distance": 60, "friction": 1}', "default units"),
    "huge.json": (b'{"distance": "60 ft", "friction": 1e999}', "range of a double"),
}


@pytest.mark.parametrize("name", FILES)
def test_a_wrong_file_is_told(name: str, tmp_path: Path) -> None:
    data, fragment = FILES[name]
    path = tmp_path / name
    path.write_bytes(data)
    outcome = run(*words(SKID), "--input", str(path))
    assert outcome.status == 2
    assert fragment in outcome.err
    assert "Traceback" not in outcome.err


def test_all_bad_parameters_are_reported_at_once() -> None:
    outcome = run("skid", "speed", "--distance", "60", "--friction", "x", "--mass", "1 m", "--json")
    assert [error["parameter"] for error in outcome.error["errors"]] == ["distance", "friction", "mass"]


def test_a_file_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    target = tmp_path / "out.json"
    target.write_text("before")
    assert run(*words(f"{SKID}|--distance|1 kg|--friction|1"), "--output", str(target)).status == 2
    assert target.read_text() == "before"
    assert run(*words(OK), "--json", "--output", str(target)).status == 0
    assert json.loads(target.read_text())["command"] == "skid speed"
    assert [path.name for path in tmp_path.iterdir()] == ["out.json"]


def test_a_bug_is_status_1_and_no_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    from dynamics_cli.skid import braking

    def broken(**_: object) -> None:
        raise RuntimeError("broken")

    monkeypatch.setattr(braking, "speed", broken)
    from dynamics_cli.cli import find_task

    found = find_task(["skid", "speed"])
    assert found is not None
    monkeypatch.setattr(found[0], "_specification", found[0].specification)
    outcome = run(*words(OK), "--json")
    assert outcome.status == 1
    assert outcome.error["code"] == "fault"


ANY_TEXT = st.text(max_size=60)
LIKELY = st.text(alphabet="0123456789.,+-−eE ±%°/*^()[]{}\"'@:;mkgftinslbNdegnaif²·\x00\n\t", max_size=30)


@settings(max_examples=400, deadline=None)
@given(distance=ANY_TEXT | LIKELY, friction=ANY_TEXT | LIKELY)
def test_random_text_never_yields_a_fault(distance: str, friction: str) -> None:
    outcome = run("skid", "speed", f"--distance={distance}", f"--friction={friction}", "--json")
    assert outcome.status in (0, 2, 3), (distance, friction, outcome.err)
    if outcome.status == 0:
        assert outcome.document["results"]["speed"]["value"] >= 0.0


@settings(max_examples=300, deadline=None)
@given(value=ANY_TEXT | LIKELY, target=ANY_TEXT | LIKELY)
def test_random_conversions_never_yield_a_fault(value: str, target: str) -> None:
    assert run("convert", "--json", "--", value, target).status in (0, 2, 3)


JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | ANY_TEXT | LIKELY,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(["value", "unit", "x"]), inner),
    max_leaves=5,
)


@settings(max_examples=300, deadline=None)
@given(
    st.dictionaries(
        st.sampled_from(["distance", "friction", "grade", "braking", "segments", "mass", "units", "schema", "x"]),
        JSON_VALUES,
    )
)
def test_random_json_never_yields_a_fault(scene: dict[str, object]) -> None:
    outcome = run("skid", "speed", "--input", "-", "--json", stdin=json.dumps(scene))
    assert outcome.status in (0, 2, 3), (scene, outcome.err)


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200))
def test_random_bytes_never_yield_a_fault(data: bytes) -> None:
    assert run("skid", "speed", "--input", "-", "--json", stdin=data).status == 2
