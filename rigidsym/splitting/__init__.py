"""Motion under torques: splitting methods on the exact free motion (`integrate`)."""

from rigidsym.splitting.integration import integrate
from rigidsym.splitting.methods import METHODS, Method
from rigidsym.splitting.orbits import KeplerOrbit
from rigidsym.splitting.torques import (
    ConstantInBody,
    ConstantInSpace,
    FieldPotential,
    GravityGradient,
    Potential,
    Tide,
    Torque,
    TorqueInC,
)
from rigidsym.splitting.trajectory import Trajectory

__all__ = [
    "METHODS",
    "ConstantInBody",
    "ConstantInSpace",
    "FieldPotential",
    "GravityGradient",
    "KeplerOrbit",
    "Method",
    "Potential",
    "Tide",
    "Torque",
    "TorqueInC",
    "Trajectory",
    "integrate",
]
