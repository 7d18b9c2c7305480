"""Distributions whose tails have no bound that their moments survive, as of times and distances beside zero drag."""

import math

from dynamics_cli.numerics.distributions import normal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.uncertainty.propagation import Spread

# An error of the moments, in deviations, above which they are not settled; and deviations beside that of a normal
# distribution of the same interval which the tails alone make, and which the mean does not survive either.
UNSETTLED, LONG_TAILED, TAILS_ALONE = 0.02, 1.5, 10.0


def drop_moments(spread: "Spread", coverage: float) -> None:
    """Leave out a deviation, and a mean, that the tails make as large as one likes: their integrals do not settle."""
    score = -normal.quantile(0.5 * (1.0 - coverage))
    usual = (spread.interval[1] - spread.interval[0]) / (2.0 * score)
    if spread.tails or (spread.estimate > UNSETTLED and spread.std > LONG_TAILED * usual):
        spread.mean = spread.mean if spread.std < TAILS_ALONE * usual else math.nan
        spread.std = math.nan
        spread.tails = True
