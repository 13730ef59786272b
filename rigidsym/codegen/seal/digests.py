"""The digests that a module names are those of its files."""

import hashlib

from rigidsym.codegen import header
from rigidsym.codegen.generate import Generated
from rigidsym.errors import InputError


def check(generated: Generated) -> None:
    """Raises InputError, naming it, for a digest that is another one."""
    manifest, files = generated.manifest, dict(generated.files)
    found = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()}
    for name in sorted({*found, *manifest["sha256"]}):
        if found.get(name) != manifest["sha256"].get(name):
            raise InputError("sha256", name, "is not what the manifest says")
    target, digest = manifest["target"], manifest["digest"]
    unsealed = {name: header.unsealed(text, target, digest) for name, text in files.items()}
    if header.sealed(unsealed, target) != (files, digest):
        raise InputError("digest", digest, "is not that of the files")
