"""Motions of all regimes, for derivatives in JAX and PyTorch."""

import numpy as np

BODY = np.array([1.0, 2.0, 2.5])
T = np.array([-3.0, 0.0, 0.4, 7.0])
# A body, its rates and an attitude of some length.
MOTIONS = {
    "largest axis": (BODY, (0.1, 0.2, 1.3), (1.0, -2.0, 3.0, 0.5)),
    "smallest axis": (BODY[[1, 0, 2]], (-0.2, 1.1, 0.3), (1.0, 0.0, 0.0, 0.0)),
    "symmetric": ((1.5, 1.5, 2.0), (0.3, -0.2, 0.7), (0.0, 1e-3, 0.0, 0.0)),
    "sphere": ((2.0, 2.0, 2.0), (0.3, -0.2, 0.7), (1e6, 2e6, 0.0, 0.0)),
    "spin": (BODY, (0.0, 0.0, -0.8), (1.0, 1.0, 1.0, 1.0)),
    "spin about the middle axis": (BODY, (0.0, 0.9, 0.0), (1.0, 0.0, 0.0, 0.0)),
    "rest": (BODY, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 2.0)),
    "separatrix": ((1.0, 2.5, 3.0), (0.5, 0.4, -0.5), (1.0, 0.0, 2.0, 0.0)),
}


def arrays(name):
    """Return inertia, omega0 and attitude0 of a motion."""
    return [np.array(x, float) for x in MOTIONS[name]]
