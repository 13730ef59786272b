"""The reference of the command line, read from the parser itself."""

import argparse
from collections.abc import Iterator

from generate.text import code, fenced, plain, prose, table
from rigidsym._cli import parser

WIDTH = 80
_HEAD = """# The command

`rigidsym COMMAND …`, or `python -m rigidsym COMMAND …`. Exit status: 0 where all went well, 1 where
a claim, certificate, comparison or bound fails, 2 for bad input or usage, said in one line that
names the field, the value and the rule; 130 where it was interrupted. `--json` is alone on standard
output; progress and remarks go to standard error.
"""


def page() -> str:
    """One section for each command: what it does, how it is called, what it takes."""
    commands = _commands(parser())
    overview = table(
        ("command", "does"),
        ((f"[`{name}`](#rigidsym-{name})", plain(parser.description or ""))
         for name, parser in commands.items()),
    )  # fmt: skip
    return "\n".join([_HEAD, overview, *(_section(*item) for item in commands.items())])


def _commands(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            return dict(action.choices)
    return {}


def _section(name: str, parser: argparse.ArgumentParser) -> str:
    rows = [_row(action) for action in parser._actions if action.dest != "help"]
    usage = _wrapped(f"rigidsym {name}", list(_usage(parser)))
    return "\n".join(
        [
            f"(rigidsym-{name})=\n## `rigidsym {name}`\n",
            plain(_sentence(parser.description or "")) + "\n",
            fenced("text", usage),
            _arguments(rows),
            f"For example: {code(_example(parser))}.\n",
        ]
    )


def _example(parser: argparse.ArgumentParser) -> str:
    """What the help ends with."""
    return (parser.epilog or "").splitlines()[-1].strip()


def _arguments(rows: list[tuple[str, str, str]]) -> str:
    """A table, with what holds by default where something does."""
    width = 3 if any(default for *_, default in rows) else 2
    return table(("argument", "", "by default")[:width], (row[:width] for row in rows))


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}."


def _wrapped(begin: str, arguments: list[str]) -> str:
    """Lines of at most WIDTH, none of them broken within an argument."""
    lines = [begin]
    for argument in arguments:
        if len(lines[-1]) + 1 + len(argument) <= WIDTH:
            lines[-1] += f" {argument}"
        else:
            lines.append(" " * len(begin) + f" {argument}")
    return "\n".join(lines)


def _usage(parser: argparse.ArgumentParser) -> Iterator[str]:
    """Each argument as it may stand on the line; one of several where they exclude each other."""
    grouped = {
        action: group._group_actions
        for group in parser._mutually_exclusive_groups
        for action in group._group_actions
    }
    for action in parser._actions:
        group = grouped.get(action, [action])
        if action.dest == "help" or action is not group[0]:
            continue
        inside = " | ".join(_called(member) for member in group)
        needed = action.required and action.nargs not in ("*", "?")
        yield inside if needed else f"[{inside}]"


def _called(action: argparse.Action) -> str:
    value = _value(action)
    if not action.option_strings:
        return f"{value} …" if action.nargs in ("*", "+") else value
    repeated = " …" if action.nargs in ("*", "+") else ""
    return " ".join([action.option_strings[0], *([f"{value}{repeated}"] if value else [])])


def _value(action: argparse.Action) -> str:
    if action.nargs == 0:
        return ""
    if action.choices is not None:
        return "{" + ",".join(map(str, action.choices)) + "}"
    return str(action.metavar or action.dest.upper())


def _row(action: argparse.Action) -> tuple[str, str, str]:
    forms = [f"{form} {_value(action)}".strip() for form in action.option_strings]
    default = action.default if action.default not in (None, False) else ""
    named = ", ".join(map(code, forms or [_value(action)]))
    return named, _help(action), code(str(default)) if default else ""


def _help(action: argparse.Action) -> str:
    """What the parser says; paths and switches that need no words get some."""
    known = {"-o": "where to write", "--json": "JSON on standard output"}
    said = action.help or next((known[x] for x in action.option_strings if x in known), "")
    repeated = isinstance(action, argparse._AppendAction) and "repeatable" not in said
    return prose("; ".join([*([said] if said else []), *(["repeatable"] if repeated else [])]))
