"""A search for stated bounds below the true error of impacts whose answers no other numbers go through.

    python tests/accuracy/impact_search.py [EVALUATIONS [TASK [SEED]]]

`impact chain`, `spatial`, `solve` and `envelope`: each answer of the program, with all results that a bound is stated
for, is one evaluation. The searches start from the shipped hard cases, disturb them, draw inputs of their own, and
climb from where errors came nearest to bounds. What the exact sides are is said in `impact_search_chain`, `_space`,
`_scene` and `_envelope`; that they are right is shown on the shipped references, which are made by other formulas.
"""

import sys
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parent))

import impact_search_chain
import impact_search_envelope
import impact_search_scene
import impact_search_space
from climbing import Question, main_of

QUESTIONS: dict[str, Callable[[], Question]] = {
    "impact chain": impact_search_chain.question,
    "impact spatial": impact_search_space.question,
    "impact solve": impact_search_scene.question,
    "impact envelope": impact_search_envelope.question,
}

if __name__ == "__main__":
    main_of(QUESTIONS)
