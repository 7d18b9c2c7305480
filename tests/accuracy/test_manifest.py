"""The manifest and the files of references: they agree, every case is one, and every file is made again to the byte."""

import hashlib
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run
from references import made_from

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.accuracy.listing import MANIFEST
from dynamics_cli.registry import FAMILIES

ROOT = Path(__file__).resolve().parents[2]
GENERATORS = ROOT / "tests" / "references"
FILES: list[dict[str, Any]] = json.loads(MANIFEST.read_text(encoding="utf-8"))["files"]
NAMES = [file["file"] for file in FILES]


def made_again(generator: Path, target: Path) -> bytes:
    subprocess.run([sys.executable, str(generator), str(target)], check=True, stdout=subprocess.DEVNULL)
    return target.read_bytes()


@cache
def cases(name: str) -> list[dict[str, Any]]:
    return json.loads((DATA / name).read_text(encoding="utf-8"))["cases"]


def numbers(tree: Any) -> Iterator[float]:
    """Every number of an input tree."""
    if isinstance(tree, dict):
        for part in tree.values():
            yield from numbers(part)
    elif isinstance(tree, list):
        for part in tree:
            yield from numbers(part)
    else:
        try:
            yield float(tree)
        except ValueError:
            return


class TestManifest:
    def test_generating_it_again_gives_the_same_bytes(self, tmp_path: Path) -> None:
        """Run tests/references/generate_manifest.py where this fails."""
        assert made_again(GENERATORS / "generate_manifest.py", tmp_path / "manifest.json") == MANIFEST.read_bytes()

    def test_every_file_is_in_it(self) -> None:
        assert sorted(NAMES) == sorted(path.name for path in DATA.glob("*.json"))
        for file in FILES:
            assert file["family"] in {*FAMILIES, *catalogue.CORE}
            assert file["digits"] >= 40
            assert file["method"]

    @pytest.mark.parametrize("file", FILES, ids=NAMES)
    def test_it_tells_what_is_there(self, file: dict[str, Any]) -> None:
        data = (DATA / file["file"]).read_bytes()
        assert file["sha256"] == hashlib.sha256(data).hexdigest()
        there = cases(file["file"])
        assert file["count"] == len(there) == len(file["cases"])
        assert file["hard"] == sum(case["kind"] == "hard" for case in there)
        for told, case in zip(file["cases"], there, strict=True):
            assert [told[key] for key in ("task", "name", "kind")] == [case[key] for key in ("task", "name", "kind")]
            assert told.get("why", "") == case.get("why", "")
            found = case.get("why", "").startswith("found by search") or re.search(r"\bfound\b", case["name"])
            assert told["source"].startswith("search") == bool(found)

    def test_every_source_is_explained(self) -> None:
        sources = json.loads(MANIFEST.read_text(encoding="utf-8"))["sources"]
        assert {case["source"] for file in FILES for case in file["cases"]} == set(sources)

    def test_every_command_is_one_of_the_family(self) -> None:
        """Each family's tasks that have questions have cases, and no case is of a task that there is not."""
        asked = {(one.family, one.task) for one in catalogue.questions("", "") if one.task}
        told = {(file["family"], case["command"]) for file in FILES for case in file["cases"] if case["command"]}
        # the export's proof, and ratios, draw their cases themselves
        assert asked - told <= {("cam", "export"), ("gear", "ratio")}
        assert told - asked <= {("gear", "involute"), ("cam", "check")}


@pytest.mark.parametrize("file", FILES, ids=NAMES)
class TestFiles:
    def test_its_sources_are_those_it_was_made_from(self, file: dict[str, Any]) -> None:
        """Run tests/references/regenerate.py NAME where this fails: it makes the file again."""
        name = file["file"].removesuffix(".json")
        assert made_from.known().get(name) == made_from.digest(name), f"python tests/references/regenerate.py {name}"

    @pytest.mark.slow
    def test_generating_it_again_gives_the_same_bytes(self, file: dict[str, Any], tmp_path: Path) -> None:
        made = made_again(ROOT / file["generator"], tmp_path / file["file"])
        assert made == (DATA / file["file"]).read_bytes()

    def test_its_generator_names_itself(self, file: dict[str, Any]) -> None:
        data = json.loads((DATA / file["file"]).read_text(encoding="utf-8"))
        assert Path(file["generator"]).name in data["about"]

    def test_no_two_cases_of_a_task_have_one_name(self, file: dict[str, Any]) -> None:
        counts = Counter((case["task"], case["name"]) for case in cases(file["file"]))
        assert [name for name, count in counts.items() if count > 1] == []

    def test_no_two_cases_have_the_same_inputs(self, file: dict[str, Any]) -> None:
        inputs: dict[str, str] = {}
        for case in cases(file["file"]):
            key = json.dumps([case["task"], case["inputs"], case.get("choices", {})], sort_keys=True)
            assert key not in inputs, (case["name"], inputs[key])
            inputs[key] = case["name"]

    def test_results_have_forty_digits_at_most_and_no_noise(self, file: dict[str, Any]) -> None:
        """What a working precision leaves of a zero is no reference: of inputs of ordinary size nothing is 1e-75."""
        for case in cases(file["file"]):
            given = [abs(x) for x in numbers(case["inputs"]) if x]
            for name, text in case["results"].items():
                digits = text.lower().partition("e")[0].strip("-").replace(".", "").lstrip("0")
                assert len(digits) <= 40, (case["name"], name)
                value = abs(float(text))
                assert value == 0.0 or value > 1e-75 or min(given) < 1e-30, (case["name"], name, text)


class TestListing:
    def test_cases_are_listed_with_reasons_and_sources(self) -> None:
        found = answer("accuracy", "gear", "pair", "--cases")["results"]["cases"]
        told = [
            case for file in FILES if file["family"] == "gear" for case in file["cases"] if case["command"] == "pair"
        ]
        assert [(one["name"], one["difficulty"], one["source"]) for one in found] == [
            (case["name"], case["kind"], case["source"]) for case in told
        ]
        assert all(("why" in one) == (one["difficulty"] == "hard") for one in found)
        assert {one["command"] for one in found} == {"gear pair"}

    def test_hard_ones_alone(self) -> None:
        found = answer("accuracy", "skid", "--hard", "--cases")["results"]["cases"]
        assert {one["difficulty"] for one in found} == {"hard"}
        assert {one["command"].partition(" ")[0] for one in found} == {"skid"}

    def test_of_everything(self) -> None:
        found = answer("accuracy", "--cases")["results"]["cases"]
        assert len(found) == sum(file["count"] for file in FILES)

    def test_people_read_a_block_for_each_command(self) -> None:
        lines = run("accuracy", "cam", "size", "--hard", "--cases").out.splitlines()
        head = next(line for line in lines if "reference cases" in line)
        sizes = [
            case for file in FILES if file["family"] == "cam" for case in file["cases"] if case["command"] == "size"
        ]
        count = sum(case["kind"] == "hard" for case in sizes)
        assert head.strip().startswith(f"cam size: {count} reference cases")
        assert sum(line.startswith("  ▸ ") for line in lines) == count
        assert max(map(len, lines)) <= 118

    def test_an_unknown_task_is_refused_as_ever(self) -> None:
        assert run("accuracy", "gear", "pear", "--cases").status == 2
