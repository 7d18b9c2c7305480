"""Result documents gathered into one report."""

from dynamics_cli.core.about import Command, Option

FORMS = ("markdown", "html")
REPORT = Command(
    "report",
    "FILE...",
    "Gather result documents into one Markdown or HTML report.",
    "Each FILE is a result document (or several, as NDJSON; - is standard input). Each is calculated again from the "
    "inputs it holds, and the report says whether every result came out the same.",
    "dynamics report skid.json crash.json --output report.html",
    (
        Option("format", "FORMAT", "markdown (the default) or html; else by the ending of --output.", FORMS),
        Option("output", "FILE", "Write the report to a file, whole or not at all."),
        Option("title", "TEXT", "The report's title."),
        Option("case", "TEXT", "Number or name of the case, put under the title."),
        Option("author", "TEXT", "Who prepared it, put under the title."),
        Option("digits", "N", "Significant digits of results (6)."),
    ),
    "dynamics_cli.report.command:carry_out",
)
