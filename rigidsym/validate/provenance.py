"""Where and how a campaign was run: all of a report that differs from run to run."""

import os
import platform
import sys
from importlib.metadata import PackageNotFoundError, version

from rigidsym.validate.campaign import Campaign
from rigidsym.view.report_data import Figure

PACKAGES = ("numpy", "python-flint", "mpmath", "sympy")


def environment(
    campaign: Campaign, place: str, seconds: float, states: int
) -> dict[str, Figure | None]:
    """Versions, machine, time and memory."""
    return {
        "place": place,
        "seconds": round(seconds, 2),
        "enclosed states": states,
        "enclosed states a second": round(states / seconds),
        "peak memory of a process, MB": _peak(),
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.machine()}",
        "cores": os.cpu_count(),
        **{name: _version(name) for name in PACKAGES},
        **({"compiler": _compiler()} if any(x.startswith("c") for x in campaign.targets) else {}),
        **dict(zip(campaign.peers, campaign.peer_versions, strict=True)),
    }


def _peak() -> int | None:
    """Of this process and of its children, the largest; None where the system does not say."""
    try:
        import resource
    except ImportError:  # Windows
        return None
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    # Kilobytes, except on macOS.
    unit = 2**20 if sys.platform == "darwin" else 2**10
    return round(max(resource.getrusage(x).ru_maxrss for x in who) / unit)


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "unknown"


def _compiler() -> str:
    from rigidsym.engines.compiler import find

    return find().version.partition("\n")[0]
