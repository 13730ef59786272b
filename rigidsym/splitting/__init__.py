"""Numerical integration of motion under torques by splitting methods."""

from rigidsym.splitting._integration import integrate
from rigidsym.splitting._methods import METHODS, Method
from rigidsym.splitting._orbits import KeplerOrbit
from rigidsym.splitting._torques import (
    ConstantInBody,
    ConstantInSpace,
    FieldPotential,
    GravityGradient,
    Potential,
    Tide,
    Torque,
    TorqueInC,
)
from rigidsym.splitting._trajectory import Trajectory

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
