"""Who is measured: the generated modules by target, and peers."""

import json
import threading
from collections.abc import Sequence
from functools import cache
from importlib import resources

from rigidsym import engines
from rigidsym.engines import Engine
from rigidsym.errors import InputError
from rigidsym.validate.peers import Peer, peer
from rigidsym.validate.steps import Steps

PEER = "peer "
TARGETS = (*engines.EVERY, *engines.STEPPERS)
Implementation = Engine | Peer | Steps


def check_target(target: str) -> None:
    """Raise InputError for a target there is no module of, or that does not compile here."""
    if target not in TARGETS:
        raise InputError("target", target, f"must be one of: {', '.join(TARGETS)}")
    try:
        implementation(target)
    except InputError as error:
        raise InputError("target", target, error.rule) from None


def check_kinds(targets: Sequence[str]) -> None:
    """Raise InputError where some targets are steps and others are not."""
    if len({target in engines.STEPPERS for target in targets}) > 1:
        rule = "steps go a turn at most, and motions all the way: validate them apart"
        raise InputError("target", ", ".join(targets), rule)


def missing(targets: Sequence[str] = engines.ENGINES) -> dict[str, str]:
    """Targets, each with the reason why it cannot be measured on this machine; "" where it can."""
    found = {}
    for target in targets:
        try:
            check_target(target)
            found[target] = ""
        except InputError as error:
            found[target] = error.rule
    return found


def implementation(name: str) -> Implementation:
    """The engine of a target, or "peer NAME"; InputError where it cannot be had."""
    if name.startswith(PEER):
        return own_peer(name.removeprefix(PEER))
    if name in engines.STEPPERS:
        return Steps(engines.exact_stepper(name))
    return engines.exactly(name)


def own_peer(name: str) -> Peer:
    """The peer of a name that this thread has; InputError where it cannot be had."""
    # Peers serve one thread at a time, and workers of a cluster have several.
    return _peer(name, threading.get_ident())


@cache
def _peer(name: str, thread: int) -> Peer:
    return peer(name)


def forget() -> None:
    """Look for every peer again when it is next asked for."""
    _peer.cache_clear()


def digest(target: str) -> str:
    """What an installed module was generated from."""
    package = resources.files("rigidsym.generated")
    text = package.joinpath(f"{target}.map.json").read_text(encoding="utf-8")
    return json.loads(text)["manifest"]["digest"]
