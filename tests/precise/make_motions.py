"""Write motions.json: states of motions of every kind, by Taylor series and nothing else.

python tests/precise/make_motions.py
"""

import json
from fractions import Fraction
from pathlib import Path

from mpmath import mp

from rigidsym.precise._taylor import integrate

DIGITS = 40
FILE = Path(__file__).with_name("motions.json")
TURNED = ["0.5", "-0.5", "0.1", "0.7"]
MOTIONS = {
    "paper": (["0.0109", "0.04", "0.0506"], ["0.05", "0.03", "-0.02"], "180"),
    "about the largest axis": (["2", "3", "4"], ["0.1", "-0.2", "1"], "40"),
    "about the smallest axis, axes 2 3 1": (["3", "1", "2"], ["0.1", "-1", "0.3"], "-40"),
    "about the largest axis, axes 3 2 1": (["5", "4", "2"], ["-2", "0.3", "-0.7"], "25"),
    "on the separatrix": (["1", "2", "2.25"], ["0.75", "0.5", "1"], "30"),
    "1e-30 from the separatrix": (["1", "2", "2.25"], ["0.75", "0.5", "1." + "0" * 29 + "1"], "30"),
    "tilted by 1e-12 from the middle axis": (["1", "2", "3"], ["1e-12", "1", "0"], "50"),
    "moments that differ by 1e-12": (["1", "1.000000000001", "1.5"], ["1", "-2", "3"], "10"),
    "oblate": (["1", "1", "1.5"], ["0.4", "0.3", "-2"], "20"),
    "prolate": (["1", "3", "3"], ["1", "0.3", "-0.2"], "20"),
    "sphere": (["2", "2", "2"], ["0.3", "-0.4", "1.2"], "20"),
    "spin about the middle axis": (["1", "2", "2.5"], ["0", "-1.5", "0"], "20"),
    "large and fast": (["1e9", "2e9", "2.5e9"], ["30", "-20", "10"], "1"),
    "small and slow": (["1e-9", "2e-9", "2.5e-9"], ["1e-9", "-2e-9", "1e-9"], "2e10"),
}


def main() -> None:
    """Write the state of each motion at its time, to `DIGITS` digits."""
    motions = []
    for name, (inertia, omega0, t) in MOTIONS.items():
        exact = [tuple(map(Fraction, x)) for x in (inertia, omega0, TURNED)]
        q, omega = integrate(*exact, Fraction(t), DIGITS)
        given = {"name": name, "inertia": inertia, "omega0": omega0, "attitude0": TURNED, "t": t}
        motions.append(given | {"q": _printed(q), "omega": _printed(omega)})
    FILE.write_text(json.dumps({"digits": DIGITS, "motions": motions}, indent=1) + "\n")


def _printed(values) -> list[str]:
    return [mp.nstr(value, DIGITS) for value in values]


if __name__ == "__main__":
    main()
