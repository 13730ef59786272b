"""Who is measured: the generated modules by target, and peers."""

import json
import threading
from functools import cache
from importlib import resources
from typing import Any

from rigidsym import engines
from rigidsym.errors import InputError
from rigidsym.validate.peers import peer

PEER = "peer "


def check_target(target: str) -> None:
    """Raise InputError for a target there is no module of, or that does not compile here."""
    if target not in engines.ENGINES:
        raise InputError("target", target, f"must be one of: {', '.join(engines.ENGINES)}")
    try:
        engines.exactly(target)
    except InputError as error:
        raise InputError("target", target, error.rule) from None


def implementation(name: str) -> Any:
    """The engine of a target, or "peer NAME"; InputError where it cannot be had."""
    # Peers serve one thread at a time, and workers of a cluster have several.
    return _implementation(name, threading.get_ident())


@cache
def _implementation(name: str, thread: int) -> Any:
    if name.startswith(PEER):
        return peer(name.removeprefix(PEER))
    return engines.exactly(name)


def forget() -> None:
    """Look for every implementation again when it is next asked for."""
    _implementation.cache_clear()


def digest(target: str) -> str:
    """What an installed module was generated from."""
    package = resources.files("rigidsym.generated")
    text = package.joinpath(f"{target}.map.json").read_text(encoding="utf-8")
    return json.loads(text)["manifest"]["digest"]
