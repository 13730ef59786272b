"""Six files of observations in the styles of their fields, with the command that fits each.

The motions are the project's own; errors are normal, from a fixed seed.  `python
tests/six_files.py DIRECTORY` writes the files.
"""

import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import rigidsym
from rigidsym.io import _epochs as epochs
from rigidsym.quaternions import conjugate, matrices, of_rotation_vectors, product, rotated

TURN = (0.5, 0.1, -0.3, 0.8)
DEGREE = np.pi / 180


@dataclass(frozen=True)
class Sample:
    """A file, the true motion from its first time on, and the options of its command."""

    name: str
    truth: rigidsym.TorqueFreeMotion
    options: str
    write: Callable[[rigidsym.TorqueFreeMotion, np.random.Generator], str]

    def text(self) -> str:
        """Return the text of the file."""
        return self.write(self.truth, np.random.default_rng(list(self.name.encode())))


def _turned(q, sigma, random):
    """Return attitudes with random errors, rad, of random sign."""
    seen = product(q, of_rotation_vectors(sigma * random.normal(size=(len(q), 3))))
    return seen * random.choice([-1.0, 1.0], size=(len(q), 1))


def _lines(head, rows):
    return "\n".join([*head, *rows]) + "\n"


def star_tracker(truth, random):
    """ISO epochs in UTC, J2000 to body, scalar last, with the error about the boresight apart."""
    t = np.cumsum(random.uniform(0.5, 1.5, 120).round(3)) - 0.5
    t -= t[0]
    sigma = np.array([10, 10, 80]) * DEGREE / 3600
    q = conjugate(_turned(truth(t)[0], sigma, random))
    zero = epochs.parse("epoch", "2016-12-31T23:59:00", "UTC")
    clock = [epochs.printed(epochs.later(zero, float(at)), "UTC", 3) for at in t.round(3)]
    rows = [
        f"{at}Z,{x:.8f},{y:.8f},{z:.8f},{s:.8f},10,10,80,{random.integers(4, 12)}"
        for at, (s, x, y, z) in zip(clock, q, strict=True)
    ]
    head = [
        "# Star tracker A, J2000 to body, errors in arcsec",
        "UTC,Q1,Q2,Q3,Q4,err_x,err_y,err_z,stars",
    ]
    return _lines(head, rows)


def motion_capture(truth, random):
    """Tabs, lines before the header, yaw, pitch and roll in degrees, frames without the body."""
    t = np.arange(180) / 60
    q = _turned(truth(t)[0], 0.4 * DEGREE, random)
    angles = Rotation.from_quat(q, scalar_first=True).as_euler("ZYX", degrees=True)
    place = 500 + 40 * t[:, None] * [1, 2, 3]
    gone = random.uniform(size=t.size) < 0.08
    rows = [
        "\t".join(
            [str(k + 1), f"{at:.5f}"]
            + ([""] * 7 if lost else [f"{v:.3f}" for v in (*xyz, *turn[::-1], 0.4)])
        )
        for k, (at, xyz, turn, lost) in enumerate(zip(t, place, angles, gone, strict=True))
    ]
    head = [
        "NO_OF_FRAMES\t180",
        "NO_OF_CAMERAS\t12",
        "FREQUENCY\t60",
        "DATA_INCLUDED\t6D",
        "BODY_NAMES\tHandle",
        "Frame\tTime\tX\tY\tZ\tRoll\tPitch\tYaw\tResidual",
        "\ts\tmm\tmm\tmm\tdeg\tdeg\tdeg\tmm",
    ]
    return _lines(head, rows)


def gyro_log(truth, random):
    """Milliseconds since boot, deg/s, semicolons and decimal commas, a byte-order mark, CRLF."""
    t = np.arange(200) * 0.05
    omega = (truth(t)[1] + 0.3 * DEGREE * random.normal(size=(t.size, 3))) / DEGREE
    rows = [
        f"{73512 + round(1000 * at)};" + ";".join(f"{v:.2f}" for v in (*w, 23.5 + at / 50))
        for at, w in zip(t, omega, strict=True)
    ]
    text = _lines(["Zeit_ms;gx;gy;gz;Temp"], (row.replace(".", ",") for row in rows))
    return "\ufeff" + text.replace("\n", "\r\n")


def radar(truth, random):
    """Blanks, MJD, right ascension and declination of the axis of rotation in degrees."""
    days = np.sort(random.uniform(0, 30, 90)).round(4)
    days -= days[0]
    q, omega = truth(days * 86400)
    lon, lat = _angles(rotated(q, omega), 1.5 * DEGREE, random)
    rows = [
        f"  {57000 + 0.4321 + at:11.4f}  {a:8.3f}  {d:8.3f}  S"
        for at, a, d in zip(days, lon % 360, lat, strict=True)
    ]
    return _lines(["% spin axis of 2026 XY, J2000", "%     MJD       RA       Dec   site"], rows)


def light_curves(truth, random):
    """Julian dates, ecliptic longitude and latitude of a pole with errors, quoted names."""
    days = np.sort(random.uniform(0, 12, 100)).round(5)
    days -= days[0]
    sigma = random.uniform(1, 3, days.size).round(1) * DEGREE
    lon, lat = _angles(
        rotated(truth(days * 86400)[0], np.array([0.0, 0, 1])), sigma[:, None], random
    )
    rows = [
        f"{2460123.51234 + at:.5f},{a % 360:.2f},{d:+.2f},"
        f"{s / DEGREE / np.cos(d * DEGREE):.4f},{s / DEGREE:.4f}"
        for at, a, d, s in zip(days, lon, lat, sigma, strict=True)
    ]
    return _lines(['"JD","lambda","beta","e_lambda","e_beta"'], rows)


def _angles(directions, sigma, random):
    """Return longitudes and latitudes, deg, of directions with errors across them."""
    unit = directions / np.linalg.norm(directions, axis=-1, keepdims=True)
    noise = random.normal(size=unit.shape) * sigma
    across = noise - np.sum(noise * unit, axis=-1, keepdims=True) * unit
    x, y, z = (unit + across).T
    return np.arctan2(y, x) / DEGREE, np.arctan2(z, np.hypot(x, y)) / DEGREE


def simulation(truth, random):
    """Units in brackets, scientific notation of Fortran, nine entries of a matrix, rates."""
    t = np.arange(60) * 5.0
    q, omega = truth(t)
    turn = matrices(_turned(q, 2e-3, random)).reshape(-1, 9)
    omega = omega + 1e-4 * random.normal(size=omega.shape)
    rows = [
        ", ".join(f"{v:.9E}".replace("E", "D") for v in (at, *r, *w))
        for at, r, w in zip(t, turn, omega, strict=True)
    ]
    names = [f"DCM_{i}{j} [-]" for i in "123" for j in "123"]
    rates = [f"omega_{axis}(rad/s)" for axis in "xyz"]
    return _lines([", ".join(["Time [s]", *names, *rates])], rows)


def _motion(moments, rates):
    return rigidsym.TorqueFreeMotion(moments, rates, TURN)


FILES = (
    Sample(
        "star_tracker.csv",
        _motion((1.0, 0.8, 0.5), (0.03, 0.05, -0.04)),
        "--columns time=UTC,q1=Q1,q2=Q2,q3=Q3,q4=Q4,sigma_q1=err_x,sigma_q2=err_y,sigma_q3=err_z "
        "--time-format iso --attitude quaternion-scalar-last --direction inertial-to-body "
        "--units angle=arcsec",
        star_tracker,
    ),
    Sample(
        "motion_capture.tsv",
        _motion((1.0, 0.7, 0.4), (2.0, 5.0, -3.0)),
        "--delimiter tab --header-line 6 --data-line 8 --attitude euler321 --units angle=deg "
        "--columns time=Time,angle1=Yaw,angle2=Pitch,angle3=Roll --sigma attitudes=0.4deg "
        "--allow missing",
        motion_capture,
    ),
    Sample(
        "gyro_log.csv",
        _motion((1.0, 0.8, 0.5), (0.8, 1.5, -1.0)),
        "--delimiter ';' --decimal , --columns time=Zeit_ms,omega1=gx,omega2=gy,omega3=gz "
        "--units time=ms,rate=deg/s --epoch first --sigma rates=0.3deg/s",
        gyro_log,
    ),
    Sample(
        "radar.dat",
        _motion((1.0, 0.9, 0.4), (8e-6, 1.1e-5, 1.6e-5)),
        "--delimiter space --header-line 2 --columns time=MJD,lon=RA,lat=Dec --time-format mjd "
        "--units angle=deg --axis spin --sigma vectors=1.5deg",
        radar,
    ),
    Sample(
        "light_curves.csv",
        _motion((1.0, 0.85, 0.4), (2e-5, -3e-5, 6e-5)),
        "--columns time=JD,lon=lambda,lat=beta,sigma_lon=e_lambda,sigma_lat=e_beta "
        "--time-format jd --units angle=deg --axis 0,0,1 --fastest 1e-4",
        light_curves,
    ),
    Sample(
        "simulation.csv",
        _motion((0.0506, 0.04, 0.0109), (0.05, 0.03, -0.02)),
        "--columns time=Time,"
        + ",".join(f"r{i}{j}=DCM_{i}{j}" for i in "123" for j in "123")
        + ",omega1=omega_x,omega2=omega_y,omega3=omega_z --attitude matrix "
        "--sigma attitudes=2e-3rad,rates=1e-4rad/s",
        simulation,
    ),
)


def write(directory):
    """Write the six files to a directory, and return it."""
    directory.mkdir(parents=True, exist_ok=True)
    for sample in FILES:
        (directory / sample.name).write_bytes(sample.text().encode())
    return directory


if __name__ == "__main__":
    write(Path(sys.argv[1]))
    for sample in FILES:
        print(f"rigidsym fit {sample.name} {sample.options}")
