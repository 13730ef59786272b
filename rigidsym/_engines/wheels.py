"""Wheels that bring the compiled engine, for seven platforms, by Zig's C compiler.

    python -m rigidsym._engines.wheels -o dist

writes them all and the source distribution; names of platforms choose some.  It needs the packages
hatchling and ziglang (extra `dev`), and no network.  The same sources and versions make the same
bytes on every machine.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path

from rigidsym._engines import build, shipped

ROOT = Path(__file__).parents[2]
# The environment variable by which the hook of a build learns of the platform.
VARIABLE = "RIGIDSYM_WHEEL"
# The package that has the compiler, in the version that makes the bytes of a release.
COMPILER = "ziglang"
# Clang's `flatten` inlines calls of calls only where this allows it, and vectorises no loop else.
_INLINED = ("-mllvm", "-inline-threshold=20000")
_X86 = {
    "x86-64": ("-mcpu=x86_64",),
    "x86-64-v3": ("-mcpu=x86_64_v3", *_INLINED),
    "x86-64-v4": ("-mcpu=x86_64_v4", "-mprefer-vector-width=512", *_INLINED),
}
_ARM = {"arm64": _INLINED}


@dataclass(frozen=True, slots=True)
class Platform:
    """A platform of wheels.

    tag: of the wheel's name; target: as Zig names it; end: of the names of libraries; paths: flags
    of the compiler by code path.
    """

    tag: str
    target: str
    end: str
    paths: Mapping[str, tuple[str, ...]]


PLATFORMS = {
    "manylinux-x86-64": Platform("manylinux_2_17_x86_64", "x86_64-linux-gnu.2.17", ".so", _X86),
    "manylinux-arm64": Platform("manylinux_2_17_aarch64", "aarch64-linux-gnu.2.17", ".so", _ARM),
    "musllinux-x86-64": Platform("musllinux_1_2_x86_64", "x86_64-linux-musl", ".so", _X86),
    "musllinux-arm64": Platform("musllinux_1_2_aarch64", "aarch64-linux-musl", ".so", _ARM),
    "macos-x86-64": Platform("macosx_11_0_x86_64", "x86_64-macos.11.0", ".dylib", _X86),
    "macos-arm64": Platform("macosx_11_0_arm64", "aarch64-macos.11.0", ".dylib", _ARM),
    "windows-x86-64": Platform("win_amd64", "x86_64-windows-gnu", ".dll", _X86),
}


def compiled(platform: Platform, folder: Path) -> list[Path]:
    """Compile the libraries of a platform into a folder, and return their paths.

    Raises CompilerError if the compiler fails.
    """
    command = (sys.executable, "-m", COMPILER, "cc", "-target", platform.target)
    text = resources.files("rigidsym._engines").joinpath("processor.c").read_text("utf-8")
    sources = {"processor.c": text}
    for module in shipped.MODULES:
        sources |= build.package_sources(module)
    plain = tuple(flag for flag in build.FLAGS if flag not in build.NATIVE)
    builds = {name: (*plain, *flags) for name, flags in platform.paths.items()}
    found = []
    for name, flags in (builds | {shipped.PORTABLE: build.PORTABLE_FLAGS}).items():
        with tempfile.TemporaryDirectory(prefix="rigidsym-") as work:
            made = build.compile_library(
                build.Compiler(command, ""), sources, Path(work), (*flags, "-s")
            )
            found.append(made.replace(folder / f"{name}{platform.end}"))
    return found


def main() -> None:
    """Build the wheels that the command line names, or all of them and the source distribution."""
    parser = argparse.ArgumentParser(description="Build wheels with the compiled engine.")
    parser.add_argument("platforms", nargs="*", metavar="PLATFORM", help=", ".join(PLATFORMS))
    parser.add_argument("-o", "--output", default="dist", metavar="DIR", help="folder of the files")
    options = parser.parse_args()
    if unknown := sorted({*options.platforms} - {*PLATFORMS}):
        parser.error(f"PLATFORM = {unknown[0]}: must be one of: {', '.join(PLATFORMS)}")
    line = [sys.executable, "-m", "hatchling", "build", "-d", str(Path(options.output).absolute())]
    builds = [(*line, "-t", "wheel")] * len(options.platforms or PLATFORMS)
    for name, one in zip(options.platforms or PLATFORMS, builds, strict=True):
        subprocess.run(one, cwd=ROOT, env=os.environ | {VARIABLE: name}, check=True)
    if not options.platforms:
        subprocess.run([*line, "-t", "sdist"], cwd=ROOT, check=True)


if __name__ == "__main__":
    main()
