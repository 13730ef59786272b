"""Small validation report, with variations of it for tests."""

import copy
import json
from dataclasses import replace
from functools import cache

from rigidsym.validate._campaign import Campaign, Progress, complete
from rigidsym.validate._executors import local
from rigidsym.validate._report import Failure
from rigidsym.validate._validation import reported

STRATA = ("uniform", "separatrix", "near separatrix", "nearest separatrix", "rest")


@cache
def whole():
    """Run a small campaign once, and return its validation report."""
    progress = Progress(Campaign.of(["numpy"], cases=3, strata=STRATA))
    with local(1) as place:
        complete(progress, place)
    return reported(progress.campaign, progress.tally, {"python": "3.11", "workers": 1})


def passed():
    """Return the data of a validation report that passed, as read from JSON."""
    return json.loads(whole().to_json())


def direct():
    """Return the data of a validation report, as `to_data` returns them."""
    return whole().to_data()


def failed():
    """Return the data of a validation report with a broken bound."""
    report = whole()
    key, cells = ("numpy", "angle", "share", "uniform"), report.tally.cells
    broken = {**cells, key: replace(cells[key], count=1, worst=37.2)}
    failure = Failure("numpy", "angle", 37.2, "uniform", 1, report.worst[0])
    tally = replace(report.tally, cells=broken)
    return json.loads(replace(report, tally=tally, failures=(failure,)).to_json())


def with_peer(data, name="peer rk"):
    """Add a much less accurate peer to the data of a report.

    It is worse by many decades, and has no number in places.
    """
    peer = copy.deepcopy(data["implementations"][0])
    peer |= {"name": name, "peer": True, "passed": False, "digest": None}
    for view in ("distance", "turned", "condition"):
        for cells in peer[view].values():
            for k, cell in enumerate(cells.values()):
                cell["units"] = "inf" if k % 3 == 0 else cell["units"] * 1e12
    for sizes in peer["sizes"].values():
        sizes["angle"] = {"2^+40.5": 3, "inf": 2, "0": 1}
    for view in ("strata", "shares", "regimes"):
        peer[view].pop("rest")
    data["implementations"].append(peer)
    return data
