"""Check of the printed module in single precision, which is read back as C for doubles is."""

from collections.abc import Mapping

from rigidsym._codegen import header
from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.targets.c.read_back import check_names, compared
from rigidsym._codegen.targets.c_single.module import TARGET, Files, doubled


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
    texts = {
        file: (
            doubled(header.unsealed(text, key(TARGET, form), header.digest_in(file, text))),
            doubled(wanted[file]),
        )
        for file, text in files.items()
    }
    return compared(texts, made.printer, functions, constants)
