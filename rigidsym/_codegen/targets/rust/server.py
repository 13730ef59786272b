"""Start of a process that computes states by the crate, built once."""

import hashlib
import json
import os
import shutil
import subprocess
import tempfile
from importlib.resources.abc import Traversable
from pathlib import Path

from rigidsym._codegen.forms import STEP, split
from rigidsym._codegen.targets.rust.module import CRATES
from rigidsym.errors import InputError

# Python has checked the moments.
_CRATE = ("--crate-type=rlib", "--crate-name=torque_free", '--cfg=feature="allow-nonphysical"')
_FLAGS = ("--edition=2021", "-Copt-level=3", "-Ccodegen-units=1")


def command(name: str, home: Traversable, cache: Path) -> list[str]:
    """Return the command that starts the process, which is built if the cache has none.

    name: the key of the crate, for example "rust-pi".  home: the folder of generated files.  Raises
    InputError without rustc, and where it refuses the crate.
    """
    rustc, form = shutil.which("rustc"), split(name)[1]
    if rustc is None:
        raise InputError("engine", name, "needs Rust's compiler (rustc) on the path")
    crate = home.joinpath(CRATES[form]).joinpath("src")
    texts = {x: crate.joinpath(x).read_text("utf-8") for x in ("lib.rs", "routines.rs")}
    texts["server.rs"] = Path(__file__).with_suffix(".rs").read_text("utf-8")
    version = subprocess.run([rustc, "-vV"], capture_output=True, check=False).stdout.decode()
    determining = json.dumps([texts, _CRATE, _FLAGS, version]).encode()
    program = cache / f"rust-{hashlib.sha256(determining).hexdigest()[:32]}"
    if not program.exists():
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="rust-", dir=cache) as work:
            for file, text in texts.items():
                Path(work, file).write_text(text, "utf-8")
            steps = ["--cfg=steps"] if form == STEP else []
            _run(name, work, [rustc, *_FLAGS, *_CRATE, "lib.rs"])
            extern = "--extern=torque_free=libtorque_free.rlib"
            _run(name, work, [rustc, *_FLAGS, *steps, extern, "server.rs", "-o", "server"])
            os.replace(Path(work, "server"), program)
    return [str(program)]


def _run(name: str, work: str, given: list[str]) -> None:
    done = subprocess.run(given, cwd=work, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        said = next((x for x in done.stderr.splitlines() if x.startswith("error")), "an error")
        raise InputError("engine", name, f"is refused by {given[0]}: {said}")
