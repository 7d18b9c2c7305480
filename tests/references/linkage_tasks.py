"""The closed-form linkage tasks by name, and the records that their inputs are made of."""

from dynamics_cli.linkage.bodies import body, chain
from dynamics_cli.linkage.fourbar import four_bar, grashof
from dynamics_cli.linkage.sliders import double_slider, quick_return, slider_crank

TASKS = {
    "four_bar": four_bar.four_bar,
    "classify": grashof.classify,
    "slider_crank": slider_crank.slider_crank,
    "quick_return": quick_return.quick_return,
    "scotch_yoke": double_slider.scotch_yoke,
    "oldham": double_slider.oldham,
    "trammel": double_slider.trammel,
    "body": body.body,
    "chain": chain.chain,
}
GROUPS: dict[str, type] = {"ChainLink": chain.ChainLink, "Turning": body.Turning}
