"""Files of observations: their contents, and mistakes that are refused."""

import numpy as np
import pytest
from simulated import TUMBLING, refused

from rigidsym.fitting._files import load, parse_message, parse_table, parse_toml
from rigidsym.fitting._layout import Layout
from rigidsym.io import _attitude_ephemeris as attitude_ephemeris
from rigidsym.io import aem, sampled

T = np.array([0.0, 1.5, 4.0])
ATTITUDE = Layout(sigma={"attitudes": 1})
Q, OMEGA = TUMBLING(T)

TOML = """
days = true
degrees = true
epoch = "2020-01-01T00:00:00"
moments = [3, 2, 1.5]
moments_sigma = [0.1, 0.1, 0.1]
[[attitudes]]
sigma = 2
times = ["2020-01-01T00:00:00", "2020-01-02T12:00:00"]
euler_313 = [[90, 0, 90], [0, 90, 0]]
[[rates]]
times = [0, 1]
sigma = [[1, 0, 0], [0, 1, 0], [0, 0, 4]]
omega = [[1, 2, 3], [4, 5, 6]]
[[vectors]]
times = [0.5]
sigma = 1
seen = [[0, 0, 2]]
known = [1, 0, 0]
seen_in = "space"
"""


def test_toml_has_all_kinds_and_their_units():
    found = parse_toml(TOML)
    (attitudes,), (rates,), (vectors,) = found.observations.values()
    assert attitudes.t.tolist() == [0, 1.5 * 86400]
    assert attitudes.seen == pytest.approx(
        np.array([[0, 0, 0, 1], [np.sqrt(0.5), np.sqrt(0.5), 0, 0]]), abs=1e-12
    )
    assert attitudes.weights[0, 0, 0] == pytest.approx(1 / np.deg2rad(2))
    assert rates.seen[0] == pytest.approx(np.deg2rad([1, 2, 3]) / 86400)
    assert rates.weights[0, 2, 2] == pytest.approx(1 / (2 * np.deg2rad(1) / 86400))
    assert vectors.seen_in == "space"
    assert vectors.t.tolist() == [43200]
    assert found.options == {"moments": [3, 2, 1.5], "sigma": {"moments": [0.1, 0.1, 0.1]}}


def test_csv_has_attitudes_and_rates_where_there_are_any():
    text = (
        "# said\nt,q0,q1,q2,q3,omega1,omega2,omega3,sigma_omega\n0,1,0,0,0,,,,\n2,,,,,1,2,3,0.5\n"
    )
    found = parse_table(text, Layout(sigma={"attitudes": 0.1}))
    (attitudes,), (rates,) = found.observations.values()
    assert (attitudes.t.tolist(), rates.t.tolist()) == ([0], [2])
    assert rates.seen.tolist() == [[1, 2, 3]]
    assert (attitudes.weights.item(), rates.weights.item()) == (10, 2)


def test_a_message_comes_back_as_it_was_written():
    names = {"object_name": "UNKNOWN", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
    text = aem(sampled(TUMBLING, T), "2016-12-31T23:59:59", **names)
    found = attitude_ephemeris.read(text)
    assert found.epoch == "2016-12-31T23:59:59.000"
    assert found.times == pytest.approx(T, abs=1e-14)
    assert found.q == pytest.approx(Q, abs=1e-15)
    assert found.rates == pytest.approx(OMEGA, abs=1e-15)
    both = parse_message(text, Layout(sigma={"attitudes": 0.1, "rates": 0.2}))
    assert [*both.observations] == ["attitudes", "rates"]
    assert [*parse_message(text, Layout(sigma="attitudes=0.1")).observations] == ["attitudes"]


def test_older_messages_say_where_the_scalar_is():
    text = (
        "META_START\nTIME_SYSTEM = TAI\nATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = FIRST\n"
        "ATTITUDE_DIR = B2A\nMETA_STOP\nDATA_START\n2020-001T00:00:00 1 2 3 4\nDATA_STOP\n"
    )
    assert attitude_ephemeris.read(text).q.tolist() == [[1, -2, -3, -4]]


@pytest.mark.parametrize(
    ("read", "message"),
    [
        (lambda: load("nowhere.csv"), "cannot be read"),
        (lambda: load("some.doc"), "must end in .csv, .tsv, .txt, .dat, .toml or .aem, or be one"),
        (lambda: parse_table("t,q5\n0,1\n"), "header = q5: is not one of: t (or time)"),
        (lambda: parse_table("t,q0,q1\n0,1,0\n"), "header = no q2: is needed with q0, q1"),
        (lambda: parse_table("q0,q1,q2,q3\n1,0,0,0\n"), "header = no t: is needed with q0"),
        (lambda: parse_table("t,q0\n0,1,2\n"), "header = 2 columns: a line has more cells"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,x,0,0\n"), "line 2, q1 = 'x': must be a num"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,0,0,0\n"), "sigma.attitudes = missing"),
        (lambda: parse_table("t,q0,q1,q2,q3,q1\n0,1,0,0,0,0\n"),
         "header = q1: is the name of two columns: remove or rename one of them"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,,0,0,1\n", ATTITUDE),
         "line 2, q0 = '': must be a number where the line has t, q1, q2, q3"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,0,0,\n", ATTITUDE), "line 2, q3 = ''"),
        (lambda: parse_table("t,q0,q1,q2,q3\n,1,0,0,0\n", ATTITUDE), "line 2, t = ''"),
        (lambda: parse_table("# x\nt,omega1,omega2,omega3\n\n0,1,,3\n", Layout(sigma="rates=1")),
         "line 4, omega2 = '': must be a number"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,0,0,0\n1,1,0,0,0,9\n", ATTITUDE),
         "header = 5 columns: a line has more cells: line 3 has 6; name or remove them"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,0,0,0\n1,1,0\n", ATTITUDE),
         "line 3 = 3 cells: must be 5 as in the header"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,0,0,0\n1,,,,\n", ATTITUDE),
         "line 3 = 1,,,,: has no attitude: fill it in, remove the line, or add"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,0,0,0\n0,1,0,0,0\n", ATTITUDE),
         "line 3, t = '0': is the time of line 2, too: remove one of them, or add --allow repe"),
        (lambda: parse_table("t,q0,q1,q2,q3\nnan,1,0,0,0\n", ATTITUDE), "line 2, t = 'nan'"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1_0,0,0,0\n", ATTITUDE), "line 2, q0 = '1_0'"),
        (lambda: parse_table("t,q0,q1,q2,q3,sigma_omega\n0,1,0,0,0,1\n", ATTITUDE),
         "header = no omega1: is needed with sigma_omega"),
        (lambda: parse_table("t,q0,q1,q2,q3,sigma_q\n0,1,0,0,0,1\n", ATTITUDE),
         "sigma.attitudes = 1: the file has errors of its own, sigma_q: give one of the two"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1,0,0,0\n", Layout(sigma="attitudes=1,rates=2")),
         "sigma.rates = 2.0: the file has no rates: leave it"),
        (lambda: load("toutatis", sigma={"attitudes": 1}), "toutatis has errors of its own"),
        (lambda: load("some.toml", sigma="rates=1"), "some.toml has errors of its own: leave it"),
        (lambda: parse_message("QUATERNION_TYPE = LAST\nQUATERNION_TYPE = FIRST\n"),
         "line 2, QUATERNION_TYPE = FIRST: is given twice in a segment"),
        (lambda: parse_toml("[[rates]]\ntimes = [0]\nsigma = 1\nsigma = 2\n"), "is not TOML"),
        (lambda: parse_toml("[[attitude]]\n"), "observations = attitude: is not one of"),
        (lambda: parse_toml("[[rates]]\ntimes = [0]\n"), "sigma = missing"),
        (lambda: parse_toml("[[rates]]\ntimes = [0]\nsigma = 1\n"), "rates[0].omega = missing"),
        (lambda: parse_toml('[[rates]]\ntimes = ["2020-01-01T00:00:00"]\nsigma = 1\n'),
         "epoch = missing: rates[0].times are epochs"),
        (lambda: parse_toml("attitudes = 3"), "attitudes = int: must be tables [[attitudes]]"),
        (lambda: parse_toml("[[attitudes]]\ntimes = [0]\nsigma = 1\n"), "must have q or euler_313"),
        (lambda: parse_message("META_START\n"), "message = no states"),
        (lambda: parse_message("ATTITUDE_TYPE = SPIN\nDATA_START\nx 1\n"),
         "ATTITUDE_TYPE = SPIN: must be one of: QUATERNION, QUATERNION/ANGVEL"),
    ],
)  # fmt: skip
def test_files_that_cannot_be_read_are_refused(read, message):
    refused(read, message)
