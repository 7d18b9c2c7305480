"""Tasks found by words, and what a command that there is not may mean."""

import pytest
from harness import run


@pytest.mark.parametrize(
    ("words", "first"),
    [
        ("flywheel", "balance flywheel"),
        ("four-bar", "linkage four-bar"),
        ("quaternions", "orient convert"),
        ("stopping distance", "skid stop"),
        ("Campbell diagram", "vibration whirl"),
        ("center of mass", "inertia shape"),
        ("edr", "skid record"),
        ("gyroscope", "spin gyro"),
    ],
)
def test_tasks_are_found_by_words_of_their_names_and_texts(words: str, first: str) -> None:
    outcome = run("help", *words.split())
    assert outcome.status == 0
    assert any(line.startswith(f"{first} ") for line in outcome.out.splitlines())
    assert max(map(len, outcome.out.splitlines())) <= 80


def test_a_task_of_that_name_stands_before_those_that_mention_it() -> None:
    lines = run("help", "unbalance").out.splitlines()
    assert lines[0].startswith("vibration unbalance ")
    assert len(lines) > 2


def test_many_tasks_are_cut_and_counted() -> None:
    assert any(line.endswith("more: add a word") for line in run("help", "mass").out.splitlines())


@pytest.mark.parametrize(
    ("words", "option", "other"),
    [("sweep", "--sweep", "--rows"), ("uncertainty", "--correlate", "--rows"), ("monte carlo", "--samples", "--all")],
)
def test_options_of_every_task_are_found_too(words: str, option: str, other: str) -> None:
    text = run("help", *words.split()).out.partition("Options of every task:")[2]
    assert f"\n  {option} " in text
    assert other not in text.replace("\n", " ").split()
    assert ("0.7 ± 0.05" in text) == (words == "uncertainty")


def test_what_an_example_names_is_not_what_an_option_is_about() -> None:
    assert "Options of every task" not in run("help", "friction").out


def test_nothing_found_is_an_error() -> None:
    outcome = run("help", "zymurgy")
    assert (outcome.status, outcome.out) == (2, "")
    assert "no task is about 'zymurgy'" in outcome.err
    assert "try: dynamics skid --help" in run("help", "skid", "zymurgy").err
    assert "did you mean dynamics help stopping distance?" in run("help", "stoping", "distance").err


@pytest.mark.parametrize(
    ("call", "said"),
    [
        ("four-bar", "did you mean dynamics linkage four-bar?"),
        ("skid momentum", "did you mean dynamics impact momentum?"),
        ("speed", "did you mean dynamics skid speed or dynamics energy speed?"),
        ("vibraton", "did you mean dynamics vibration?"),
        ("skid sped", "did you mean dynamics skid speed?"),
        ("Campbell", "did you mean dynamics vibration whirl or dynamics vibration rotor?"),
        ("mass", "try: dynamics help mass"),
        ("banana", "try: dynamics --help"),
        ("version", "did you mean dynamics --version?"),
        ("impact banana", "try: dynamics impact --help"),
    ],
)
def test_an_unknown_command_is_answered_by_what_it_may_mean(call: str, said: str) -> None:
    outcome = run(*call.split())
    assert outcome.status == 2
    assert said in outcome.err


@pytest.mark.parametrize(
    ("words", "task"),
    [
        ("CDR", "skid record"),
        ("headway", "skid follow"),
        ("motorcycle", "skid throw"),
        ("reconstruction", "impact crash"),
        ("Searle", "skid throw"),
        ("speed from skid marks", "skid speed"),
    ],
)
def test_words_of_a_crash_find_its_tasks(words: str, task: str) -> None:
    assert run("help", *words.split()).out.startswith(f"{task} ")
