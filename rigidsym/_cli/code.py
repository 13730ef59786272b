"""Functions that run the commands `codegen` and `trace`."""

import signal
import sys
from argparse import Namespace
from collections.abc import Generator, Iterable
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from pathlib import Path
from typing import TYPE_CHECKING

from rigidsym._cli.output import say, say_written
from rigidsym._cli.proofs import replayed
from rigidsym.errors import InputError, unknown

if TYPE_CHECKING:
    from rigidsym._codegen import Generated


def codegen(options: Namespace) -> int:
    """Generate numeric modules, and write, print or check them.

    With --check, returns 1 if one differs from the files on disk.
    """
    if options.profile is not None:
        return _profile(options)
    chosen = _modules(options)
    if not (options.output or options.in_place or options.check or options.stdout):
        rule = "give -o DIR (. for here), --stdout, --check, or --in-place for the package itself"
        raise InputError("output", "missing", rule)
    if options.single_file and not (options.output or options.stdout):
        rule = "is for copies: give -o DIR or --stdout; the package has the arithmetic once"
        raise InputError("single-file", "the package itself", rule)
    with replayed_beside() as pool:
        if len(chosen) > 1:
            modules = list(pool.map(_sealed_module, chosen))
        else:
            modules = list(map(_sealed_module, chosen))
        if options.single_file:
            modules = [module.single_file() for module in modules]
    if options.stdout:
        for module in modules:
            print("".join(module.files.values()), end="")
        return 0
    import rigidsym.generated

    directory = options.output or Path(rigidsym.generated.__path__[0])
    if options.check:
        # Modules may share a file: each is compared.
        texts = dict.fromkeys(text for one in modules for text in one.texts().items())
        return _differences(texts, directory)
    for module in modules:
        say_written(module.write(directory))
    return 0


def _sealed_module(chosen: tuple[str, str]) -> "Generated":
    """Generate a module of a target and a form, and seal its formulas and its text."""
    from rigidsym._codegen import generate
    from rigidsym._codegen.seal import seal, seal_text
    from rigidsym.solution import sealed

    target, form = chosen
    seal(sealed(), form)
    module = generate(target, form=form)
    seal_text(module, sealed())
    return module


def _profile(options: Namespace) -> int:
    """Write the files of a profile, or compare them with a directory.

    With --check, returns 1 if they differ.  Raises InputError for an unknown profile, and for
    options that it does not have.
    """
    from rigidsym._codegen.forms import STEP, THETA
    from rigidsym._codegen.targets import PROFILES, known

    if options.profile not in PROFILES:
        raise unknown("profile", options.profile, PROFILES, plain=True)
    command = f"rigidsym codegen c --profile {options.profile} -o DIR"
    if options.target is None or known(options.target) != "c":
        raise InputError("profile", options.profile, f"is one of C alone: {command}")
    if options.form is not None:
        raise InputError("form", options.form, f"the profile has motions and steps: {command}")
    if options.single_file:
        raise InputError("single-file", "given", f"a profile has one source already: {command}")
    if options.in_place or options.stdout or not options.output:
        raise InputError("output", "no directory", f"a profile is several files: {command}")
    with replayed_beside():
        from rigidsym._codegen.flight.profile import files
        from rigidsym._codegen.seal import seal
        from rigidsym.io._files import write_all
        from rigidsym.solution import sealed

        for form in (THETA, STEP):
            seal(sealed(), form)
        texts = files(sealed())
    if options.check:
        return _differences(texts.items(), Path(options.output))
    say_written(write_all(Path(options.output), texts))
    return 0


def _modules(options: Namespace) -> list[tuple[str, str]]:
    """Return the targets and forms of the modules that the options select.

    With --check these are all where none is named.  Raises InputError for an unknown one.
    """
    from rigidsym._codegen.forms import THETA, checked
    from rigidsym._codegen.targets import TARGETS, forms_of, known

    if options.target is None and not options.check:
        rule = f"name one, {', '.join(TARGETS)}; --check alone checks all"
        raise InputError("target", "missing", rule)
    targets = TARGETS if options.target is None else [known(options.target)]
    if options.form is None and options.target is None:
        return [(target, form) for target in targets for form in forms_of(target)]
    form = checked(options.form or THETA)
    return [(target, form) for target in targets if options.target or form in forms_of(target)]


@contextmanager
def replayed_beside() -> Generator[ProcessPoolExecutor]:
    """Check the sealed ledger in another process during a `with` block.

    Yields the pool of processes, one for each processor.  The block ends when both are done.
    Raises LedgerError if the ledger is refused.
    """
    ignored = (signal.SIGINT, signal.SIG_IGN)
    with ProcessPoolExecutor(
        None, get_context("spawn"), initializer=signal.signal, initargs=ignored
    ) as pool:
        checking = pool.submit(replayed)
        yield pool
        checking.result()


def _differences(texts: Iterable[tuple[str, str]], directory: Path) -> int:
    """Print the differences between generated texts and the files of these names in a directory.

    Returns 1 if there are any.
    """
    from difflib import unified_diff

    status = 0
    for name, text in texts:
        path = directory / name
        there = path.read_text("utf-8", errors="replace") if path.is_file() else ""
        if there != text:
            status = 1
            lines = unified_diff(there.splitlines(True), text.splitlines(True), str(path), "new")
            sys.stdout.writelines(lines)
    print("differs" if status else "current", file=sys.stderr)
    return status


def trace(options: Namespace) -> int:
    """Print the proved facts behind a generated line, or the lines derived from an equation."""
    from rigidsym._codegen.trace import TraceError, lines_of_equation, told
    from rigidsym.proof.paper import EQUATIONS

    if (options.place is None) == (options.equation is None):
        given = options.place or options.equation or "nothing"
        raise InputError("trace", given, "takes either FILE:LINE, FILE, or --equation NUMBER")
    try:
        if options.place is not None:
            found = told(options.place)
        else:
            found = lines_of_equation(options.equation, [e.number for e in EQUATIONS])
    except TraceError as error:
        say(f"rigidsym trace: {error}")
        return 1
    for line in found:
        print(line)
    return 0
