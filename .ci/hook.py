"""The hook of builds that puts the compiled engine into a wheel.

It acts where RIGIDSYM_WHEEL names a platform; all other builds are of pure Python, and compile at
the first use, if at all.
"""

import os
import sys
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

VARIABLE = "RIGIDSYM_WHEEL"


class CompiledEngine(BuildHookInterface[Any]):
    """Compile the libraries of one platform, and give the wheel its tag."""

    def dependencies(self) -> list[str]:
        """Return the packages that compile: Zig, and those that the package itself imports."""
        if not os.environ.get(VARIABLE):
            return []
        return [*self.metadata.core.dependencies, "ziglang>=0.13"]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile, and name what was compiled to the builder."""
        name = os.environ.get(VARIABLE)
        if not name or version == "editable":
            return
        sys.path.insert(0, self.root)
        from rigidsym._engines import wheels

        if name not in wheels.PLATFORMS:
            known = ", ".join(wheels.PLATFORMS)
            raise SystemExit(f"{VARIABLE} = {name}: must be one of: {known}")
        platform = wheels.PLATFORMS[name]
        self._folder = tempfile.TemporaryDirectory(prefix="rigidsym-wheel-")
        for path in wheels.compiled(platform, Path(self._folder.name)):
            build_data["force_include"][str(path)] = f"rigidsym/_engines/shipped/{path.name}"
        build_data["pure_python"], build_data["tag"] = False, f"py3-none-{platform.tag}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Remove what was compiled."""
        if hasattr(self, "_folder"):
            self._folder.cleanup()
