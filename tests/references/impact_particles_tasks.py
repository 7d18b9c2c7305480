"""The particle tasks of impact by name."""

from dynamics_cli.impact.held import seize, step
from dynamics_cli.impact.particles import central, chain, drop, oblique, pendulum
from dynamics_cli.impact.reconstruction import crush, momentum, yaw_inertia

TASKS = {
    "central": central.central,
    "oblique": oblique.oblique,
    "drop": drop.drop,
    "pendulum": pendulum.pendulum,
    "seize": seize.seize,
    "step": step.step,
    "chain": chain.chain,
    "momentum": momentum.momentum,
    "momentum_and_energy": momentum.momentum_and_energy,
    "crush": crush.crush,
    "yaw_inertia": yaw_inertia.yaw_inertia,
}
# Answers that carry a bound of their own, and answers that take no arrays.
UNTRACKED = ("chain",)
CASE_BY_CASE = ("chain", "drop")
