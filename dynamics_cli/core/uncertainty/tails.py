"""Distributions whose tails have no bound that their moments survive, as of times and distances beside zero drag.

What helps there is not effort but the input that decides: of a ratio near its pole no sample is large enough.
"""

import math

from dynamics_cli.numerics.distributions import normal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.uncertainty.propagation import Propagation, Spread

# An error of the moments, in deviations, above which they are not settled; and deviations beside that of a normal
# distribution of the same interval which the tails alone make (values at both ends of the interval make 1.96), and
# which the mean does not survive either.
UNSETTLED, LONG_TAILED, TAILS_ALONE = 0.02, 2.0, 10.0
# An error, in deviations, that ten times as many samples do not reduce.
BEYOND_SAMPLES = 0.06


def drop_moments(spread: "Spread", coverage: float) -> None:
    """Leave out a deviation, and a mean, that the tails make as large as one likes: their integrals do not settle."""
    score = -normal.quantile(0.5 * (1.0 - coverage))
    usual = (spread.interval[1] - spread.interval[0]) / (2.0 * score)
    if spread.tails or (spread.estimate > UNSETTLED and spread.std > LONG_TAILED * usual):
        spread.mean = spread.mean if spread.std < TAILS_ALONE * usual else math.nan
        spread.std = math.nan
        spread.tails = True


def narrowing(propagation: "Propagation", spread: "Spread") -> str:
    """What to narrow for a result: the input that alone moves it farthest; nothing where that is not known."""
    alone = [abs(high - low) for low, high in spread.tornado]
    widest = max((width for width in alone if math.isfinite(width)), default=0.0)
    return f"narrow {propagation.inputs[alone.index(widest)]}, which decides most" if widest > 0.0 else ""


def remedy(propagation: "Propagation", rough: "list[Spread]") -> str:
    """What helps where intervals are known poorly: more samples, or a narrower input."""
    worst = max(rough, key=lambda spread: spread.estimate)
    narrow = "" if worst.estimate <= BEYOND_SAMPLES else narrowing(propagation, worst)
    return narrow if narrow and propagation.space.affordable is None else propagation.remedy
