"""The packages of peers, imported only when a peer is asked for."""

from importlib import import_module, metadata
from typing import Any

from rigidsym.errors import InputError


def needed(peer: str, module: str, package: str) -> tuple[Any, str]:
    """A module and the version of its package; raises InputError where it cannot be imported."""
    try:
        return import_module(module), metadata.version(package)
    except ImportError:
        raise InputError("peer", peer, f"needs the package {package} (extra bench)") from None
