"""Orekit reads messages with the right states, times, frames and direction."""

from datetime import date
from types import SimpleNamespace

import numpy as np
import pytest
from leap_seconds import TAI_MINUS_UTC

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.io import aem, sampled
from rigidsym.io.cases import paper_case
from rigidsym.validate import peers
from rigidsym.validate.peers import _orekit_peer as orekit_peer

NAMES = {"object_name": "UNKNOWN", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
PAPER = paper_case().motion
TURNED = TorqueFreeMotion(PAPER.inertia, PAPER.omega0, (1, 2, -3, 4))


@pytest.fixture(scope="module")
def orekit():
    """Return Orekit's parser with its leap seconds; skip without Orekit or Java."""
    try:
        peers.peer("orekit")
    except InputError as error:
        pytest.skip(str(error))
    orekit_peer.started()
    import jpype

    context = jpype.JClass("org.orekit.data.LazyLoadedDataContext")()
    context.getTimeScales().addUTCTAIOffsetsLoader(offsets(jpype))
    builder = jpype.JClass("org.orekit.files.ccsds.ndm.ParserBuilder")(context)
    source = jpype.JClass("org.orekit.data.DataSource")
    opener = jpype.JClass("org.orekit.data.DataSource$StreamOpener")
    stream = jpype.JClass("java.io.ByteArrayInputStream")

    def read(text):
        data = jpype.JArray(jpype.JByte)(text.encode("ascii"))
        return builder.buildAemParser().parseMessage(source("aem", opener @ (lambda: stream(data))))

    vector = jpype.JClass("org.hipparchus.geometry.euclidean.threed.Vector3D")
    utc = context.getTimeScales().getUTC()
    new_year = jpype.JClass("org.orekit.time.AbsoluteDate")("2026-01-01T00:00:00", utc)
    return SimpleNamespace(read=read, context=context, vector=vector, new_year=new_year)


def offsets(jpype):
    """Return the leap seconds, which the parser needs to read CREATION_DATE."""
    model = jpype.JClass("org.orekit.time.OffsetModel")
    day = jpype.JClass("org.orekit.time.DateComponents")
    models = jpype.JClass("java.util.ArrayList")()
    for start, offset in TAI_MINUS_UTC.items():
        since = date.fromisoformat(start)
        models.add(model(day(since.year, since.month, since.day), offset))
    loader = jpype.JClass("org.orekit.time.UTCTAIOffsetsLoader")
    return jpype.JProxy(loader, dict={"loadOffsets": lambda: models})


def states(segment, start):
    """Return the times after an instant, quaternions, and body rates of a segment."""
    found = list(segment.getData().getAngularCoordinates())
    turns = [(c.getRotation(), c.getRotationRate()) for c in found]
    return (
        np.array([float(c.getDate().durationFrom(start)) for c in found]),
        np.array([[r.getQ0(), r.getQ1(), r.getQ2(), r.getQ3()] for r, _ in turns], float),
        np.array([[w.getX(), w.getY(), w.getZ()] for _, w in turns], float),
    )


@pytest.mark.parametrize("rates", [True, False])
@pytest.mark.parametrize("motion", [PAPER, TURNED], ids=["paper", "turned"])
@pytest.mark.parametrize(
    ("system", "epoch"),
    [
        ("TAI", "2026-01-01T00:00:00"),
        ("TT", "1969-07-20T20:17:40.125"),
        ("GPS", "2026-01-01T00:00:00"),
        ("UTC", "2026-01-01T00:00:00"),
        ("UTC", "2016-12-31T23:58:30.5"),  # the leap second lies within
    ],
)
def test_orekit_reads_the_states_back(orekit, system, epoch, motion, rates):
    track = sampled(motion, np.linspace(0, 180, 721))
    text = aem(track, epoch, time_system=system, rates=rates, creation_date="2026-01-01T00:00:00",
               **NAMES)  # fmt: skip
    (segment,) = orekit.read(text).getSegments()
    metadata = segment.getMetadata()
    kind = "QUATERNION/ANGVEL" if rates else "QUATERNION"
    assert str(metadata.getAttitudeType()) == kind
    assert str(metadata.getTimeSystem()) == system
    assert metadata.getEndpoints().isA2b()
    times, q, omega = states(segment, metadata.getStartTime())
    assert np.max(np.abs(times - track.times)) == 0
    assert np.max(np.abs(q - track.q)) < 1e-15
    if rates:
        speed = np.linalg.norm(track.omega, axis=1, keepdims=True)
        assert np.max(np.abs(omega - track.omega) / speed) < 1e-15


def test_orekit_turns_the_frames_as_the_motion_does(orekit):
    """Apply Orekit's attitude, from the inertial frame to the body, to a vector."""
    track = sampled(TURNED, np.linspace(0, 30, 61))
    (segment,) = orekit.read(aem(track, "2026-01-01T00:00:00", **NAMES)).getSegments()
    frame = orekit.context.getFrames().getEME2000()
    start = segment.getMetadata().getStartTime()
    provider = segment.getAttitudeProvider()
    rotations = TURNED.rotation(track.times)
    for t, rotation in zip(track.times.tolist(), rotations, strict=True):
        turned = provider.getAttitude(None, start.shiftedBy(t), frame).getRotation()
        found = turned.applyTo(orekit.vector(1.0, 2.0, 3.0))
        expected = rotation.inv().apply([1, 2, 3])
        assert np.max(np.abs([found.getX(), found.getY(), found.getZ()] - expected)) < 1e-12


def test_orekit_reads_decimals_of_seconds_and_segments(orekit):
    grids = np.arange(0, 50) / 7, np.arange(100, 150) * 0.1, 1e6 + np.arange(50) * 0.1
    tracks = [sampled(TURNED, times) for times in grids]
    message = orekit.read(aem(tracks, "2026-01-01T00:00:00", **NAMES))
    for track, segment in zip(tracks, message.getSegments(), strict=True):
        times, q, _ = states(segment, orekit.new_year)
        assert np.max(np.abs(times - track.times)) <= 5e-15
        assert np.max(np.abs(q - track.q)) < 1e-15
