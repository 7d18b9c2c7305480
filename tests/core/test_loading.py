"""Files of parameters: what JSON and TOML are refused, and at what cost."""

import time

import pytest

from dynamics_cli.core.inputs.sources.files import parse_json, parse_toml
from dynamics_cli.errors import UsageError


def test_a_repeated_name_among_many_is_found_in_linear_time() -> None:
    def cost(count: int) -> float:
        text = "{" + ",".join(f'"n{i}":1' for i in range(count)) + f',"n{count - 1}":2}}'
        start = time.process_time()
        with pytest.raises(UsageError, match=f"'n{count - 1}' is given twice"):
            parse_json(text, "scene.json")
        return time.process_time() - start

    # A quadratic search would take 400 times as long, some minutes.
    cost(10_000)
    assert cost(200_000) < 10.0


@pytest.mark.parametrize("digits", ["9" * 5000, "0x" + "f" * 5000, "0b" + "1" * 20_000])
def test_a_toml_integer_of_thousands_of_digits_is_refused(digits: str) -> None:
    with pytest.raises(UsageError, match="a whole number has thousands of digits"):
        parse_toml(f"teeth = {digits}", "gear.toml")
