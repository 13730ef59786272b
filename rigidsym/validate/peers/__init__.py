"""Independent programs that compute torque-free motions, for comparison with this package.

Each is run at the best settings that we found for it, on float64 numbers as a user would give them.
"""

from collections.abc import Callable, Mapping
from functools import partial

from rigidsym.errors import unknown
from rigidsym.validate.peers._integrators import HeyokaPeer, ScipyPeer
from rigidsym.validate.peers._orekit_peer import OrekitPeer
from rigidsym.validate.peers._protocol import Peer

__all__ = ["PEERS", "Peer", "peer"]

_MAKERS: Mapping[str, Callable[[], Peer]] = {
    "heyoka": HeyokaPeer,
    "dop853": partial(ScipyPeer, "DOP853"),
    "lsoda": partial(ScipyPeer, "LSODA"),
    "orekit": OrekitPeer,
}
PEERS = tuple(_MAKERS)


def peer(name: str) -> Peer:
    """Return the peer program with a given name, such as "heyoka".

    Packages are imported only here, and Java starts with the first motion of a process, so that
    workers forked before each have their own.

    Raises
    ------
    InputError
        If there is no such peer, or its package is not installed.
    """
    if name not in _MAKERS:
        raise unknown("peer", name, PEERS, plain=True)
    return _MAKERS[name]()
