"""Check of the printed C in single precision, by the reader of C for doubles."""

import re
from collections.abc import Mapping

from rigidsym._codegen import header
from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.targets.c.read_back import check_names, compared
from rigidsym._codegen.targets.c_single.module import TARGET, Files, doubled, single
from rigidsym.errors import InputError


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """Check the printed files against their routines, and return the number of derived lines.

    Raises InputError for a statement that differs, and for other text that does.
    """
    made = Files(functions, constants, form)
    wanted, _ = made.printed()
    check_names(files, wanted)
    texts = {}
    for file, text in files.items():
        own = header.unsealed(text, key(TARGET, form), header.digest_in(file, text))
        found = doubled(own)
        both = zip(bare(own), bare(single(found)), strict=True)
        for number, (line, same) in enumerate(both, 1):
            if line != same:
                raise InputError(f"{file}:{number}", line.strip(), "has a word of doubles")
        texts[file] = found, doubled(wanted[file])
    return compared(texts, made.printer, functions, constants)


def bare(text: str) -> list[str]:
    """Return the lines of a C text without its comments."""
    without = re.sub(r"/\*.*?\*/", lambda x: "\n" * x[0].count("\n"), text, flags=re.DOTALL)
    return without.split("\n")
