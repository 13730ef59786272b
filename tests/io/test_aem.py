"""Attitude ephemeris messages agree with the text and examples of CCSDS 504.0-B-2."""

import math
import re
from datetime import UTC, datetime

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.io import Track, aem, sampled

EPOCH = "2026-03-01T12:00:00"
NAMES = {
    "object_name": "MY SAT",
    "object_id": "2026-001A",
    "originator": "RIGIDSYM",
    "creation_date": EPOCH,
}
MOTION = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), (0.05, 0.03, -0.02), (1, 2, -3, 4))
THREE = Track(
    [-0.5, 0, 43200],
    [(1, 0, 0, 0), (-0.6, 0.0, -0.8, -0.0), (0, 2, 0, 0)],
    [(0, 0, math.pi), (-math.pi / 2, -0.0, 1e-20), (0, 2 * math.pi, 0)],
)
# Table 4-3, but for what no message here has: COMMENT, CENTER_NAME, USEABLE_..., EULER_ROT_SEQ.
METADATA = (
    "OBJECT_NAME", "OBJECT_ID", "REF_FRAME_A", "REF_FRAME_B", "TIME_SYSTEM", "START_TIME",
    "STOP_TIME", "ATTITUDE_TYPE", "ANGVEL_FRAME", "INTERPOLATION_METHOD", "INTERPOLATION_DEGREE",
)  # fmt: skip

WITH_RATES = """\
CCSDS_AEM_VERS = 2.0
CREATION_DATE = 2026-03-01T12:00:00
ORIGINATOR = RIGIDSYM

META_START
OBJECT_NAME = MY SAT
OBJECT_ID = 2026-001A
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
TIME_SYSTEM = UTC
START_TIME = 2026-03-01T11:59:59.500
STOP_TIME = 2026-03-02T00:00:00.000
ATTITUDE_TYPE = QUATERNION/ANGVEL
ANGVEL_FRAME = SC_BODY_1
INTERPOLATION_METHOD = LAGRANGE
INTERPOLATION_DEGREE = 2
META_STOP

DATA_START
2026-03-01T11:59:59.500 {0} {0} {0} {1} {0} {0}  1.800000000000000e+02
2026-03-01T12:00:00.000 {0} -8.000000000000000e-01 {0} -6.000000000000000e-01 \
-9.000000000000000e+01 {0}  5.729577951308232e-19
2026-03-02T00:00:00.000 {1} {0} {0} {0} {0}  3.600000000000000e+02 {0}
DATA_STOP
""".format(" 0.000000000000000e+00", " 1.000000000000000e+00")

WITHOUT_RATES = """\
CCSDS_AEM_VERS = 2.0
CREATION_DATE = 2025-12-24T18:00:00.5Z
ORIGINATOR = cnes

META_START
OBJECT_NAME = UNKNOWN
OBJECT_ID = UNKNOWN
REF_FRAME_A = ICRF
REF_FRAME_B = INSTRUMENT_A
TIME_SYSTEM = GPS
START_TIME = 2026-03-01T12:00:00.0625
STOP_TIME = 2026-03-01T12:00:00.0625
ATTITUDE_TYPE = QUATERNION
META_STOP

DATA_START
2026-03-01T12:00:00.0625  0.000000000000000e+00  6.000000000000000e-01 -0.000000000000000e+00 \
 8.000000000000000e-01
DATA_STOP
""".replace("-0.000", " 0.000")


def fields(text):
    return re.findall(r"^(\w+) = (.*)$", text, re.MULTILINE)


def rows(text):
    """Return the numbers of the data lines."""
    lines = [line for line in text.splitlines() if re.match(r"\d{4}-", line)]
    return np.array([[float(x) for x in line.split()[1:]] for line in lines])


def test_a_whole_message_with_rates():
    assert aem(THREE, EPOCH, **NAMES) == WITH_RATES


def test_a_whole_message_of_one_state_without_rates():
    found = aem(
        Track([0.0], [(0.8, 0, 0.6, -0.0)], [(1, 2, 3)]),
        "2026-060T12:00:00.0625",
        object_name="UNKNOWN",
        object_id="UNKNOWN",
        originator="cnes",
        ref_frame_a="ICRF",
        ref_frame_b="INSTRUMENT_A",
        rates=False,
        time_system="GPS",
        creation_date="2025-12-24T18:00:00.5Z",
    )
    assert found == WITHOUT_RATES


@pytest.mark.parametrize("rates", [True, False])
def test_the_keywords_have_the_order_of_the_tables(rates):
    track = sampled(MOTION, range(20))
    found = [keyword for keyword, _ in fields(aem(track, EPOCH, rates=rates, **NAMES))]
    assert found[:3] == ["CCSDS_AEM_VERS", "CREATION_DATE", "ORIGINATOR"]
    assert found[3:] == [k for k in METADATA if rates or k != "ANGVEL_FRAME"]


def test_every_line_is_short_printable_ascii():
    text = aem(sampled(MOTION, np.arange(50) / 7), EPOCH, **{**NAMES, "object_name": "X" * 200})
    lines = text.split("\n")
    assert lines.pop() == ""
    assert all(re.fullmatch(r"[ -~]{0,254}", line) for line in lines)


@pytest.mark.parametrize(("count", "degree"), [(2, "1"), (7, "6"), (8, "7"), (500, "7")])
def test_there_are_states_enough_for_the_interpolation(count, degree):
    found = dict(fields(aem(sampled(MOTION, range(count)), EPOCH, **NAMES)))
    assert (found["INTERPOLATION_METHOD"], found["INTERPOLATION_DEGREE"]) == ("LAGRANGE", degree)


def test_numbers_come_back_to_the_last_of_16_digits():
    track = sampled(MOTION, np.arange(0, 180, 0.5))
    found = rows(aem(track, EPOCH, **NAMES))
    assert np.max(np.abs(found[:, [3, 0, 1, 2]] - track.q)) < 2e-16
    assert np.max(np.abs(np.radians(found[:, 4:]) / track.omega - 1)) < 1e-15
    digits = re.findall(r"\d\.(\d+)e", aem(track, EPOCH, **NAMES))
    assert {len(each) for each in digits} == {15}


def test_signs_are_kept_from_state_to_state():
    found = rows(aem(sampled(MOTION, np.arange(0, 400, 1.0)), EPOCH, **NAMES))[:, :4]
    assert np.all(np.sum(found[1:] * found[:-1], axis=1) > 0.9)
    assert np.any(found[:, 3] < 0)
    assert np.any(found[:, 3] > 0)


def test_the_same_input_makes_the_same_message():
    first, again = (aem(sampled(MOTION, range(30)), EPOCH, **NAMES) for _ in range(2))
    assert first == again
    assert ("CREATION_DATE", EPOCH) in fields(first)


def test_a_message_is_of_the_time_of_writing_unless_it_says_another():
    names = {name: text for name, text in NAMES.items() if name != "creation_date"}
    before = datetime.now(UTC).replace(microsecond=0)
    found = dict(fields(aem(THREE, EPOCH, **names)))["CREATION_DATE"]
    assert before <= datetime.fromisoformat(f"{found}+00:00") <= datetime.now(UTC)


def matrix_of_annex_f(q1, q2, q3, qc):
    """Return M_BA of annex F2.1, which converts components in frame A to frame B."""
    return np.array([
        [q1*q1 - q2*q2 - q3*q3 + qc*qc, 2*(q1*q2 + q3*qc), 2*(q1*q3 - q2*qc)],
        [2*(q1*q2 - q3*qc), -q1*q1 + q2*q2 - q3*q3 + qc*qc, 2*(q2*q3 + q1*qc)],
        [2*(q1*q3 + q2*qc), 2*(q2*q3 - q1*qc), -q1*q1 - q2*q2 + q3*q3 + qc*qc],
    ])  # fmt: skip


def test_the_direction_is_that_of_annex_f():
    # F2.2: B is A turned by +90 deg about Z; a body that turns so from the identity.
    quarter = TorqueFreeMotion((1, 1, 1), (0, 0, math.pi / 2))
    (written,) = rows(aem(sampled(quarter, 1.0), EPOCH, **NAMES))
    assert written[:4] == pytest.approx([0, 0, 0.7071, 0.7071], abs=5e-5)
    assert matrix_of_annex_f(*written[:4]) @ [1, 0, 0] == pytest.approx([0, -1, 0])
    # F5.4: "the quaternion from frame A to frame B" and where it puts the Z axis of B in A.
    (written,) = rows(aem(Track([0], [(0.3812, 0.0805, 0.0334, 0.9204)], [(0, 0, 1)]), EPOCH,
                          **NAMES))  # fmt: skip
    assert matrix_of_annex_f(*written[:4])[2] == pytest.approx([0.1736, 0, 0.9848], abs=2e-4)


def test_the_momentum_stands_still_in_frame_a():
    """Compute the momentum from the written numbers alone, by the matrix of the standard."""
    found = rows(aem(sampled(MOTION, range(181)), EPOCH, **NAMES))
    inertia = np.array([0.0109, 0.04, 0.0506])
    momenta = [matrix_of_annex_f(*row[:4]).T @ (inertia * np.radians(row[4:])) for row in found]
    assert np.max(np.abs(momenta - momenta[0])) < 1e-17
    wrong = [matrix_of_annex_f(*row[:4]) @ (inertia * np.radians(row[4:])) for row in found]
    assert np.max(np.abs(np.array(wrong) - wrong[0])) > 1e-3


def test_tracks_after_each_other_are_segments():
    coasting, held = (
        sampled(MOTION, [0, 1, 2.5]),
        Track([2.5, 3], [(1, 0, 0, 0)] * 2, [(0,) * 3] * 2),
    )
    text = aem([coasting, held], EPOCH, **NAMES)
    header, first, second = text.split("\nMETA_START\n")
    assert f"{header}\nMETA_START\n{first}" == aem(coasting, EPOCH, **NAMES)
    assert "START_TIME = 2026-03-01T12:00:02.500\nSTOP_TIME = 2026-03-01T12:00:03.000" in second
    assert second.endswith("\nDATA_STOP\n")
    with pytest.raises(InputError, match=r"^track\[1\] = too early: must not begin before"):
        aem([held, coasting], EPOCH, **NAMES)


def test_a_leap_second_is_written_and_skipped_by_other_systems():
    track = sampled(MOTION, [0, 0.5, 1, 2])
    epochs = {
        system: re.findall(r"^\d\S+T(\S+) ", aem(track, "2016-12-31T23:59:59.5",
                           time_system=system, **NAMES), re.MULTILINE)
        for system in ("UTC", "TAI")
    }  # fmt: skip
    assert epochs["UTC"] == ["23:59:59.500", "23:59:60.000", "23:59:60.500", "00:00:00.500"]
    assert epochs["TAI"] == ["23:59:59.500", "00:00:00.000", "00:00:00.500", "00:00:01.500"]


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"epoch": "soon"}, "epoch = 'soon': must be YYYY-MM-DDThh:mm:ss"),
        ({"creation_date": "2026-01-01"}, "creation_date = '2026-01-01': must be YYYY-MM-DD"),
        ({"time_system": "UT1"}, "time_system = 'UT1': must be one of: UTC, TAI, TT, GPS"),
        ({"rates": "SPIN"}, "rates = 'SPIN': must be one of: True (QUATERNION/ANGVEL), False (QUA"),
        ({"rates": 1}, "rates = 1: must be one of: True"),
        ({"track": []}, "track = []: must be a Track or a list of them"),
        ({"track": [THREE, None]}, "must be a Track or a list of them"),
        ({"track": None}, "track = None: must be a Track or a list of them"),
        ({"object_name": "A\nMETA_STOP"}, r"object_name = 'A\nMETA_STOP': must be printable ASCII"),
        ({"object_name": "A\rB"}, "must be printable ASCII characters on one line"),
        ({"object_name": "A\tB"}, "must be printable ASCII characters on one line"),
        ({"object_name": ""}, "must be printable ASCII characters on one line"),
        ({"object_name": None}, "object_name = None: must be printable ASCII"),
        ({"object_name": "Cassini"}, "'Cassini': must be all uppercase or all lowercase"),
        ({"object_name": "X" * 233}, "must have at most 231 characters"),
        ({"object_id": " 2026-001A"}, "must have single blanks, between words only"),
        ({"object_id": "2026  001A"}, "must have single blanks, between words only"),
        ({"originator": "DÉPÔT"}, r"originator = 'D\xc9P\xd4T': must be printable ASCII"),
        ({"ref_frame_a": "J\u20322000"}, "ref_frame_a = 'J\\u20322000': must be printable ASCII"),
        ({"ref_frame_b": "EME2000"}, "ref_frame_b = 'EME2000': must not be frame A as well"),
        ({"track": Track([0, 1e-15], [(1, 0, 0, 0)] * 2, [(0,) * 3] * 2)}, "1e-14 s later"),
    ],
)  # fmt: skip
def test_bad_input_is_one_line(changed, message):
    given = {"track": THREE, "epoch": EPOCH, **NAMES, **changed}
    with pytest.raises(InputError) as refused:
        aem(given.pop("track"), given.pop("epoch"), **given)
    assert message in str(refused.value)
    assert len(str(refused.value).splitlines()) == 1
