"""Result documents gathered into one report."""

from dynamics_cli.core.command.plain_commands import Command, Option

FORMS = ("markdown", "html", "pdf")
PAPERS = ("a4", "letter")
REPORT = Command(
    "report",
    "FILE...",
    "Gather result documents into one report: HTML, PDF or Markdown.",
    "Each FILE is a result document (or several, as NDJSON; - is standard input). Each is calculated again from its "
    "inputs: the report shows the new results, and everything in which the document differs. "
    "A gear pair or a cam alone is a data sheet of one page.",
    "dynamics report skid.json crash.json --output report.html",
    (
        Option("format", "FORMAT", "markdown (the default), html or pdf; else by the ending of --output.", FORMS),
        Option("output", "FILE", "Write the report to a file, whole or not at all: .html, .pdf or .md."),
        Option("title", "TEXT", "The report's title."),
        Option("case", "TEXT", "Number or name of the case, for the title block."),
        Option("author", "TEXT", "Who prepared it, for the title block."),
        Option("date", "TEXT", "Date of the report, for the title block (today)."),
        Option("paper", "SIZE", "Paper of the PDF: a4 (the default) or letter.", PAPERS),
        Option("digits", "N", "Significant digits of certain results (6)."),
        Option("full", "", "Sections and appendices also where there is a data sheet (gear pairs, cams)."),
    ),
    "dynamics_cli.report.command:carry_out",
)
