"""Peer that uses the closed-form solution `TorqueFree` of Orekit, in Java."""

import math
import os
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import EngineError, States
from rigidsym.errors import InputError
from rigidsym.validate.peers._protocol import Start, checked, needed

_CLASSES = {
    "rotation": "org.hipparchus.geometry.euclidean.threed.Rotation",
    "vector": "org.hipparchus.geometry.euclidean.threed.Vector3D",
    "attitude": "org.orekit.attitudes.Attitude",
    "inertia": "org.orekit.attitudes.Inertia",
    "inertia_axis": "org.orekit.attitudes.InertiaAxis",
    "torque_free": "org.orekit.attitudes.TorqueFree",
    "frames": "org.orekit.frames.FramesFactory",
    "date": "org.orekit.time.AbsoluteDate",
}


# JPype makes its classes as it runs.
JavaObject: TypeAlias = Any


class OrekitPeer:
    """Peer that evaluates Orekit's `TorqueFree` at each time.

    Java starts with the first motion.  The peer returns rotations, which have no double-cover sign.
    """

    # Nothing is integrated over time.
    name, reach, double_cover_sign = "orekit", math.inf, False

    def __init__(self) -> None:
        (_, self.version), (jpype, _) = _packages()
        try:
            jpype.getDefaultJVMPath()
        except jpype.JVMNotFoundException:
            raise InputError("peer", self.name, "needs Java (JAVA_HOME may name it)") from None

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> JavaObject:
        """Return the `TorqueFree` object of a motion.

        Java is started for it.
        """
        return started().motion(Start.of(inertia, omega0, attitude0))

    def states(self, prepared: JavaObject, t: ArrayLike) -> States:
        """Compute the states at times, with NaN where Orekit fails."""
        java = started()
        rows = [java.state(prepared, time) for time in checked(t).tolist()]
        found = np.array(rows, float).reshape(-1, 7)
        return found[:, :4], found[:, 4:]


@dataclass(frozen=True, slots=True)
class _Java:
    """Java virtual machine of one process, with the Orekit classes that a motion needs.

    The epoch and the frame need none of Orekit's data files.
    """

    process: int
    failure: type[Exception]
    classes: dict[str, JavaObject]
    epoch: JavaObject
    frame: JavaObject

    def motion(self, start: Start) -> JavaObject:
        """Create the `TorqueFree` object of a motion.

        Raises EngineError with Orekit's message.
        """
        new, vector = self.classes, self.classes["vector"]
        axes = zip(start.inertia, (vector.PLUS_I, vector.PLUS_J, vector.PLUS_K), strict=True)
        # Hipparchus turns v to conj(q) v q: of our q that is inertial to body, as Orekit means it.
        rotation = new["rotation"](*start.attitude0, False)
        try:
            spin = vector(*start.omega0)
            attitude = new["attitude"](self.epoch, self.frame, rotation, spin, vector.ZERO)
            inertia = new["inertia"](*(new["inertia_axis"](*axis) for axis in axes))
            return new["torque_free"](attitude, inertia)
        except self.failure as error:
            raise EngineError("orekit", _line(error)) from None

    def state(self, motion: JavaObject, time: float) -> list[float]:
        """Compute the state at a time as a list of q and omega, or of NaN if Orekit fails."""
        try:
            found = motion.getAttitude(None, self.epoch.shiftedBy(time), self.frame)
        except self.failure:
            return [math.nan] * 7
        r, spin = found.getRotation(), found.getSpin()
        return [r.getQ0(), r.getQ1(), r.getQ2(), r.getQ3(), spin.getX(), spin.getY(), spin.getZ()]


def started() -> _Java:
    """Return the Java virtual machine of this process, and start it if necessary.

    Raises EngineError if it does not start.
    """
    java = _java()
    if java.process != os.getpid():
        raise EngineError("orekit", "Java does not outlive a fork: nothing may use it before")
    return java


@cache
def _java() -> _Java:
    """Start the Java virtual machine, and load the Orekit classes that a motion needs."""
    (package, _), (jpype, _) = _packages()
    try:
        package.initVM()
        classes = {name: jpype.JClass(path) for name, path in _CLASSES.items()}
        epoch, frame = classes["date"].ARBITRARY_EPOCH, classes["frames"].getGCRF()
    except (OSError, RuntimeError, TypeError, jpype.JException) as error:
        raise EngineError("orekit", f"Java does not start ({_line(error)})") from None
    return _Java(os.getpid(), jpype.JException, classes, epoch, frame)


def _packages() -> tuple[tuple[ModuleType, str], tuple[ModuleType, str]]:
    """Import Orekit's and JPype's Python modules, and return them with their versions.

    This does not start Java.
    """
    orekit = needed("orekit", "orekit_jpype", "orekit-jpype")
    return orekit, needed("orekit", "jpype", "jpype1")


def _line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__
