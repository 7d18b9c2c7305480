"""Plainly written calls, read without typer: `--name VALUE` pairs, flags and words; anything else goes to the tree."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS, Call


def read_plainly(task: Task, argv: "list[str]") -> "Call | None":
    """The call, or None when it is not plain: `--x=v`, unknown or repeated names, a missing value, a short option."""
    call = Call()
    options = task.options
    takes_words = bool(task.specification.words)
    words = iter(argv)
    for word in words:
        if word.startswith("--"):
            name = word[2:]
            if name in UNIVERSAL_OPTIONS:
                how, target = UNIVERSAL_OPTIONS[name][0], call.settings
            elif name in options:
                option = options[name]
                how, target = "flag" if option.flag else "many" if option.repeats else "value", call.options
            else:
                return None
            value: str | bool | None = True if how == "flag" else next(words, None)
            if value is None or (value is not True and str(value).startswith("--")):
                return None
            if how == "many":
                many = target.setdefault(name, [])
                many.append(str(value))  # type: ignore[union-attr]
            elif name in target:
                return None
            else:
                target[name] = value
        elif takes_words and not _is_short_option(word):
            call.words.append(word)
        else:
            return None
    return call


def _is_short_option(word: str) -> bool:
    """`-h`, but neither `-40` nor `-.5` nor `-` (standard input)."""
    return word.startswith("-") and word[1:2] not in "0123456789." and word != "-"
