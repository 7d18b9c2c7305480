"""Inputs of the skid tasks found by tests/accuracy/bound_search.py, each with what it is the worst of and why."""

from typing import Any

FOUND: dict[str, list[tuple[str, str, dict[str, Any]]]] = {}
