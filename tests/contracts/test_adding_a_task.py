"""The page for developers, followed to the letter: its family is built in a copy of the package, and works."""

import json
import sys

import jsonschema
import pytest
from documents import Workshop
from shell import ROOT, shell

PAGE = ROOT / "docs" / "developers" / "adding-a-task.md"
CALL = 'dynamics swing period --length "1 m" --amplitude "90 deg"'


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Workshop:
    return Workshop(tmp_path_factory.mktemp("swing"), PAGE.read_text())


def test_the_family_is_in_the_copy_only(workshop: Workshop) -> None:
    assert "swing" in workshop.run("dynamics --help")
    assert not (ROOT / "dynamics_cli" / "swing").exists()


def test_units_and_headline(workshop: Workshop) -> None:
    answer = workshop.run(CALL)
    assert answer.startswith("period T")
    assert "2.36825 s" in answer
    assert workshop.run("dynamics swing period --length 1 --only period").startswith("dynamics: --length: ")
    assert workshop.run('dynamics swing period --length "100 cm" --amplitude "0.25 rev" --only period') == (
        workshop.run(f"{CALL} --only period")
    )


def test_json_fits_its_schema_and_bounds_hold(workshop: Workshop) -> None:
    document = json.loads(workshop.run(f"{CALL} --json"))
    jsonschema.validate(document, json.loads(workshop.run("dynamics schema swing period")))
    mpmath = pytest.importorskip("mpmath")
    with mpmath.workdps(40):
        angle = mpmath.mpf(1.5707963267948966)
        exact = 4 * mpmath.sqrt(1 / mpmath.mpf(9.80665)) * mpmath.ellipk(mpmath.sin(angle / 2) ** 2)
        error = abs(document["results"]["period"]["value"] / exact - 1)
    assert error <= document["numerics"]["error_bound"]["period"]["relative"] < 1e-13
    assert document["numerics"]["condition"]["period"]["length"] == pytest.approx(0.5)


def test_rows_are_the_single_answers(workshop: Workshop) -> None:
    text = workshop.run(r"printf 'length[m],amplitude[deg]\n1,90\n-1,0\n' | dynamics swing period --rows -")
    header, answered, refused = text.splitlines()[:3]
    single = json.loads(workshop.run(f"{CALL} --json"))["results"]["period"]["value"]
    assert header.startswith("length[m],amplitude[deg],period[s]")
    assert answered.split(",")[2] == repr(single)
    assert "above zero" in refused


def test_uncertainty(workshop: Workshop) -> None:
    call = 'dynamics swing period --length "1.00 ± 0.01 m" --limit "2.05 s" --json'
    document = json.loads(workshop.run(call))
    assert document["results"]["period"]["std"] == pytest.approx(0.01, rel=0.01)
    assert 0.0 < document["limits"][0]["probability"] < 0.01


def test_explanation_help_and_reference(workshop: Workshop) -> None:
    assert "with numbers" in workshop.run(f"{CALL} --explain")
    help_ = workshop.run("dynamics swing period --help")
    assert "--amplitude ANGLE" in help_
    assert "e.g. 20 deg" in help_ or "default 0 deg" in help_
    assert "### dynamics swing period" in workshop.run("dynamics reference swing")


def test_completion(workshop: Workshop) -> None:
    line = "env _DYNAMICS_COMPLETE=complete_bash COMP_WORDS='dynamics swing period --a' COMP_CWORD=3 dynamics"
    assert "--amplitude" in shell(line, workshop.folder, workshop.bin, workshop.root).stdout


def test_refusals_are_in_the_units_of_the_inputs(workshop: Workshop) -> None:
    said = workshop.run('dynamics swing period --length "-3 ft"')
    assert "-3 ft" in said
    assert "180 deg" in workshop.run('dynamics swing period --length "1 m" --amplitude "180 deg"')


def test_the_copy_keeps_the_rules(workshop: Workshop) -> None:
    """Docstring examples hold, and the contracts of imports cover the family without naming it."""
    code = "import doctest, dynamics_cli.swing.period as m; raise SystemExit(doctest.testmod(m).failed)"
    assert shell(f"'{sys.executable}' -c '{code}'", workshop.root, workshop.bin, workshop.root).returncode == 0
    contracts = ROOT / "tests" / "contracts" / "test_imports.py"
    call = f"'{sys.executable}' -m pytest -q -p no:cacheprovider -c /dev/null '{contracts}'"
    done = shell(call, workshop.root, workshop.bin, workshop.root)
    assert done.returncode == 0, done.stdout
