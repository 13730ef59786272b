"""What is followed in time."""

from dataclasses import dataclass

import numpy as np


@dataclass(slots=True)
class State:
    """Attitudes (..., 4) and rates (..., 3) of bodies at one time."""

    q: np.ndarray
    omega: np.ndarray
