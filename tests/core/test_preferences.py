"""`dynamics.toml` and the environment's variables."""

from pathlib import Path

import pytest
from harness import run

CALL = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--only", "speed")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_file_in_the_folder_sets_units_and_digits(folder: Path) -> None:
    (folder / "dynamics.toml").write_text('units = "us"\ndigits = 4\n')
    assert run(*CALL).out == "35.45 mph\n"


def test_the_environment_stands_over_the_file_and_an_option_over_both(folder: Path) -> None:
    (folder / "dynamics.toml").write_text('units = "us"\n')
    assert run(*CALL, env={"DYNAMICS_UNITS": "base"}).out == "15.8456 m/s\n"
    assert run(*CALL, "--units", "si", env={"DYNAMICS_UNITS": "base"}).out == "57.044 km/h\n"


def test_the_users_own_file_serves_every_folder(folder: Path) -> None:
    (folder / "home" / "dynamics").mkdir(parents=True)
    (folder / "home" / "dynamics" / "dynamics.toml").write_text('units = "us"\n')
    assert run(*CALL, env={"XDG_CONFIG_HOME": str(folder / "home")}).out == "35.4455 mph\n"


def test_an_unknown_setting_is_named(folder: Path) -> None:
    (folder / "dynamics.toml").write_text('unit = "us"\n')
    outcome = run(*CALL)
    assert outcome.status == 2
    assert "'unit'" in outcome.err
    assert "units, digits, format, gravity" in outcome.err


@pytest.mark.parametrize(
    ("variable", "value"),
    [("UNITS", "imperial"), ("FORMAT", "yaml"), ("DIGITS", "x"), ("GRAVITY", "32.2")],
)
def test_a_bad_variable_is_named(folder: Path, variable: str, value: str) -> None:
    outcome = run(*CALL, env={f"DYNAMICS_{variable}": value})
    assert outcome.status == 2
    assert outcome.err.startswith(f"dynamics: DYNAMICS_{variable}: ")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("units = us", "that line is: units = us; text stands in quotes"),
        ('units = "usa"', "wanted one of si, us, base"),
    ],
)
def test_a_bad_value_in_the_file_is_named_with_the_file(folder: Path, text: str, said: str) -> None:
    (folder / "dynamics.toml").write_text(text)
    outcome = run(*CALL)
    assert outcome.status == 2
    assert "dynamics.toml" in outcome.err
    assert said in outcome.err
