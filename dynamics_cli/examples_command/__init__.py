"""The worked examples that ship with the program."""

from dynamics_cli.core.command.plain_commands import Command, Option

EXAMPLES = Command(
    "examples",
    "[NAME | FAMILY]",
    "List the worked examples, or copy one into the current folder.",
    "Without a NAME it lists them; with a FAMILY those that use it. With a NAME (or the name of one of its files) it "
    "shows what the example consists of and how to run it.",
    "dynamics examples crash --copy",
    (Option("copy", "", "Write the files into the current folder; a file that exists is never overwritten."),),
    "dynamics_cli.examples_command.command:carry_out",
    "dynamics_cli.examples_command.command:names",
)
