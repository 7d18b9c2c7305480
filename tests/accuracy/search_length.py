"""How many evaluations a search of bounds makes: few in every run, many on demand.

SEARCH_EVALUATIONS=10000 python -m pytest -n auto tests/accuracy -k search    the long search, an hour of processor time
"""

import os

EVALUATIONS = int(os.environ.get("SEARCH_EVALUATIONS", "400"))
