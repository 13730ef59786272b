"""Peer by Orekit's `TorqueFree`: closed forms of rates and angles, in Java."""

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
    """`TorqueFree` evaluated at each time alone; Java starts with the first motion.

    It returns rotations, which have no double-cover sign.
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
        """Return a `TorqueFree`, for which Java is started."""
        return started().motion(Start.of(inertia, omega0, attitude0))

    def states(self, prepared: JavaObject, t: ArrayLike) -> States:
        """Return states as `Peer` does, NaN where Orekit fails."""
        java = started()
        rows = [java.state(prepared, time) for time in checked(t).tolist()]
        found = np.array(rows, float).reshape(-1, 7)
        return found[:, :4], found[:, 4:]


@dataclass(frozen=True, slots=True)
class _Java:
    """Java of one process, with the classes of Orekit that a motion needs.

    The epoch and the frame need none of Orekit's data files.
    """

    process: int
    failure: type[Exception]
    classes: dict[str, JavaObject]
    epoch: JavaObject
    frame: JavaObject

    def motion(self, start: Start) -> JavaObject:
        """Return a `TorqueFree`; raise EngineError with Orekit's message."""
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
        """Return q and omega, or NaN."""
        try:
            found = motion.getAttitude(None, self.epoch.shiftedBy(time), self.frame)
        except self.failure:
            return [math.nan] * 7
        r, spin = found.getRotation(), found.getSpin()
        return [r.getQ0(), r.getQ1(), r.getQ2(), r.getQ3(), spin.getX(), spin.getY(), spin.getZ()]


def started() -> _Java:
    """Return Java of this process; raise EngineError if it does not start."""
    java = _java()
    if java.process != os.getpid():
        raise EngineError("orekit", "Java does not outlive a fork: nothing may use it before")
    return java


@cache
def _java() -> _Java:
    """Start Java and load the classes that a motion needs."""
    (package, _), (jpype, _) = _packages()
    try:
        package.initVM()
        classes = {name: jpype.JClass(path) for name, path in _CLASSES.items()}
        epoch, frame = classes["date"].ARBITRARY_EPOCH, classes["frames"].getGCRF()
    except (OSError, RuntimeError, TypeError, jpype.JException) as error:
        raise EngineError("orekit", f"Java does not start ({_line(error)})") from None
    return _Java(os.getpid(), jpype.JException, classes, epoch, frame)


def _packages() -> tuple[tuple[ModuleType, str], tuple[ModuleType, str]]:
    """Return Orekit's and JPype's modules and versions; importing them does not start Java."""
    orekit = needed("orekit", "orekit_jpype", "orekit-jpype")
    return orekit, needed("orekit", "jpype", "jpype1")


def _line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__
