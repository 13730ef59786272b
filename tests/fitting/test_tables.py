"""Tables of text in the conventions of six fields, their options, and what is refused."""

import shlex

import numpy as np
import pytest
import six_files
from document_texts import commands
from mpmath import mp
from scipy.spatial.transform import Rotation
from simulated import refused, told
from six_files import FILES

import rigidsym.fitting
from rigidsym.errors import InputError
from rigidsym.fitting import Attitudes, load
from rigidsym.fitting._agreement import _RATES
from rigidsym.fitting._files import parse_table, parse_toml
from rigidsym.fitting._layout import Layout, options_for
from rigidsym.fitting._names import SEQUENCES
from rigidsym.fitting._units import factor, measured
from rigidsym.io import _epochs as epochs
from rigidsym.quaternions import conjugate, matrices, of_matrix, product

LINES = "0,1,0,0,0\n1,0.9,0.1,0,0\n2,0.8,0.2,0,0\n"
ATTITUDES = f"t,q0,q1,q2,q3\n{LINES}"
SIGMA = Layout(sigma="attitudes=1deg")


def turned(truth):
    """Yield a motion as it is with the axes of the body named in each of 24 ways."""
    moments, omega, q = (np.array(x, float) for x in truth.exact.values())
    for turn in Rotation.create_group("O").as_quat(scalar_first=True):
        matrix = np.rint(matrices(turn))
        yield truth.replace(
            inertia=tuple(np.abs(matrix.T @ moments)),
            omega0=tuple(matrix.T @ omega),
            attitude0=tuple(product(q, turn)),
        )


@pytest.mark.parametrize("sample", FILES, ids=lambda sample: sample.name)
def test_a_file_of_each_field_is_fitted_by_one_command(sample, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    six_files.write(tmp_path)
    assert len(sample.text().splitlines()) < 210
    fits = []
    fit = rigidsym.fitting.fit
    monkeypatch.setattr(
        rigidsym.fitting, "fit", lambda **how: fits.append(fit(**how)) or fits[-1], raising=False
    )
    run(f"fit {sample.name} {sample.options}")
    (found,) = fits
    assert found.converged
    assert found.probability > 1e-3
    # Squared deviations of up to eight quantities; the names of axes are not in directions.
    own = "vectors" not in sample.options
    truths = [sample.truth] if own else turned(sample.truth)
    assert min(np.sum(told(found, x) ** 2) for x in truths) < 26


def test_the_page_has_these_commands():
    shown = [sorted(shlex.split(one)) for one in commands() if one.startswith("rigidsym fit six/")]
    for sample in FILES:
        command = f"rigidsym fit six/{sample.name} {sample.options}"
        assert sorted(shlex.split(command)) in shown


def test_options_are_the_same_in_python_and_in_toml(tmp_path):
    gyro = FILES[2]
    six_files.write(tmp_path)
    words = shlex.split(gyro.options)
    options = dict(zip((x[2:] for x in words[::2]), words[1::2], strict=True))
    text = "\n".join(f'{name.replace("-", "_")} = "{value}"' for name, value in options.items())
    (tmp_path / "both.toml").write_text(
        f'[[files]]\nfile = "gyro_log.csv"\n{text}\n[[files]]\nfile = "simulation.csv"\n'
        'attitude = "matrix"\nsigma = {attitude = 0.01, rate = "1e-4rad/s"}\n[files.columns]\n'
        + "\n".join(f'r{i}{j} = "DCM_{i}{j}"' for i in "123" for j in "123")
        + '\nt = "Time"\nomega1 = "omega_x"\nomega2 = "omega_y"\nomega3 = "omega_z"\n'
    )
    both = load(tmp_path / "both.toml")
    one = load(
        tmp_path / gyro.name,
        columns={"time": "Zeit_ms", "omega1": "gx", "omega2": "gy", "omega3": "gz"},
        units={"time": "ms", "rate": "deg/s"}, sigma={"rates": "0.3deg/s"},
        delimiter=";", decimal=",", epoch="first",
    )  # fmt: skip
    (attitudes,), (rates, others) = both.observations["attitudes"], both.observations["rates"]
    assert (attitudes.count, others.count) == (60, 60)
    assert one.observations["rates"][0].seen.tolist() == rates.seen.tolist()
    assert one.notes == ("columns not read: Temp",)
    assert both.notes == ("gyro_log.csv: columns not read: Temp",)
    assert rates.t.tolist() == [k / 20 for k in range(200)]


def test_units_are_exact():
    with mp.workdps(50):
        nearest = [float(k * mp.pi / 180) for k in range(181)]
    assert [measured("x", "angle", f"{k}deg") for k in range(181)] == nearest
    assert measured("x", "angle", "3600arcsec") == np.deg2rad(1)
    assert measured("x", "angle", "1turn") == 2 * np.pi
    assert measured("x", "rate", 0.5) == 0.5
    rates = (
        "deg/s",
        "°/s",
        "DEG/SEC",
        "deg s^-1",
        "deg.s-1",
        "deg s⁻¹",
        "degrees per second",
        "dps",
    )
    assert {factor("rate", x) for x in rates} == {factor("angle", "deg")}
    assert factor("rate", "rpm") * 30 == factor("angle", "deg") * 180
    assert factor("rate", "deg") is factor("angle", "deg/s") is factor("time", "year") is None


@pytest.mark.parametrize(
    ("layout", "cells", "seconds"),
    [
        ("jd", ["2460000.5,0.12345678901", "2460000.5,0.12345678902"], [0, 86400e-11]),
        ("mjd", ["60000,0", "60000.00000000001,0"], [0, 86400e-11]),
        ("unix", ["1700000000.000000001,0", "1700000000.000000002,0"], [0, 1e-9]),
        ("iso", ["2016-12-31,23:59:59.5", "2017-01-01,00:00:00.25"], [0, 1.75]),
        ("iso", ["2024-01-01T01:00:00.1+02:00,", "2023-12-31 23:00:00.2Z,"], [0, 0.1]),
        ("seconds", ["1e9,0.000000001", "1e9,0.000000002"], [1e9, 1e9]),
    ],
)
def test_times_lose_no_digits(layout, cells, seconds):
    text = "t,t2,omega1,omega2,omega3\n" + "\n".join(f"{x},1,2,3" for x in cells)
    how = Layout(sigma="rates=1", time_format=layout, allow="repeated")
    (rates,) = parse_table(text, how).observations["rates"]
    assert rates.t.tolist() == seconds[: rates.count]
    assert rates.count == 1 + (layout != "seconds")


def test_an_epoch_says_when_times_are_zero():
    text = "t,omega1,omega2,omega3\n60000,1,2,3\n60001,1,2,3\n"
    how = {"sigma": "rates=1", "time_format": "mjd"}
    first = parse_table(text, Layout(**how))
    assert first.epoch == "2023-02-25T00:00:00.000"
    later = parse_table(text, Layout(**how, epoch="2023-02-26T00:00:00Z"))
    assert later.observations["rates"][0].t.tolist() == [-86400, 0]
    with pytest.raises(InputError, match="years 1 to 9999, as jd: check --time-format"):
        epochs.instant("t", "", "jd", 60000)


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_euler_angles_are_rotations_about_axes_in_turn(sequence):
    angles = (20.0, 40.0, -70.0)
    turns = [
        Rotation.from_rotvec(np.eye(3)[int(axis) - 1] * np.deg2rad(angle)).as_matrix()
        for axis, angle in zip(sequence, angles, strict=True)
    ]
    expected = of_matrix(turns[0] @ turns[1] @ turns[2])
    text = "t,angle1,angle2,angle3\n0," + ",".join(map(str, angles))
    how = {"sigma": "attitudes=1", "attitude": f"euler{sequence}", "units": "angle=deg"}
    for direction, q in (("body-to-inertial", expected), ("inertial-to-body", conjugate(expected))):
        (found,) = parse_table(text, Layout(**how, direction=direction)).observations["attitudes"]
        assert found.seen[0] * np.sign(found.seen[0, 0]) == pytest.approx(q, abs=1e-15)


def test_errors_of_longitude_count_by_the_cosine_of_latitude():
    text = "t,lon,lat,sigma_lon,sigma_lat\n0,30,60,2,1\n1,30,60,2,1\n"
    how = {"axis": "spin", "units": "angle=deg"}
    (found,) = parse_table(text, Layout(**how)).observations["vectors"]
    assert found.seen[0] == pytest.approx([np.sqrt(3) / 4, 1 / 4, np.sqrt(3) / 2])
    assert found.weights[0] @ found.weights[0].T == pytest.approx(np.eye(2) / np.deg2rad(1) ** 2)
    (found,) = parse_table(
        "t,v1,v2,v3,sigma_v\n0,0,0,2,0.1\n", Layout(axis=[1, 0, 0])
    ).observations["vectors"]
    assert (found.seen.tolist(), found.known.tolist()) == ([[0, 0, 1]], [1, 0, 0])


def test_lines_are_left_out_and_moved_where_that_is_allowed():
    text = "t,q0,q1,q2,q3\n3,1,0,0,0\n1,1,NaN,0,0\n2,1,0,0,0\n2,0,1,0,0\n,,,,\n"
    how = {"sigma": "attitudes=1"}
    found = parse_table(text, Layout(**how, allow="missing,unsorted,repeated"))
    (seen,) = found.observations["attitudes"]
    assert seen.t.tolist() == [2, 3]
    assert seen.seen.tolist() == [[1, 0, 0, 0]] * 2
    assert found.notes == ("lines left out or moved: 2 missing, 1 unsorted, 1 repeated",)


def test_every_other_convention_has_an_option():
    for name in [*_RATES, *(f"attitudes {x}" for x in Attitudes.conventions if x)]:
        assert options_for(name).startswith("--"), name
    both = "attitudes inertial to body, times in ms, or rates in mrad/s"
    assert options_for(both) == "--direction inertial-to-body --units time=ms"
    assert options_for("attitudes scalar last, rates along inertial axes") == ""


def test_another_encoding_is_asked_for_and_read(tmp_path):
    path = tmp_path / "gyro.csv"
    text = "t,omega1 [°/s],omega2 [°/s],omega3 [°/s]\n0,180,0,0\n1,0,180,0\n"
    path.write_bytes(text.encode("cp1252"))
    refused(lambda: load(path, sigma="rates=1"), "is not UTF-8 text (add --encoding cp1252, utf-16")
    refused(lambda: load(path, encoding="x"), "encoding = 'x': is no encoding of text, such as")
    (rates,) = load(path, sigma="rates=1", encoding="cp1252").observations["rates"]
    assert rates.seen[0, 0] == np.pi


# What is in the file, the options given, and the end of the one line that is printed.
WRONG = {
    "other names": (
        "UTC,qx,qy,qz,qw\n2024-01-01T00:00:00Z,0,0,0,1\n", "",
        "header = UTC: looks like t: add --columns t=UTC,q0=qw,q1=qx,q2=qy,q3=qz "
        "--time-format iso",
    ),
    "an angle in the name": (
        "time_ms,wx_dps,wy_dps,wz_dps\n0,1,2,3\n", "",
        "header = time_ms: looks like t: add --columns t=time_ms,omega1=wx_dps,omega2=wy_dps,"
        "omega3=wz_dps --units time=ms,rate=dps",
    ),
    "another delimiter": ("t;q0;q1;q2;q3\n0;1;0;0;0\n", "", "is one column: add --delimiter ';'"),
    "a decimal comma": (
        "t;q0;q1;q2;q3\n0,5;1;0;0;0\n", "--sigma attitudes=1deg --delimiter ;",
        "line 2, t = '0,5': must be a number where the line has t, q0, q1, q2, q3; "
        "add --decimal , if that is the decimal mark",
    ),
    "capitals": (
        "UTC,Q1,Q2,Q3,Q4,err_x,err_y,err_z\n2024-01-01T00:00:00Z,0,0,0,1,9,9,9\n", "",
        "header = UTC: looks like t: add --columns t=UTC,q1=Q1,q2=Q2,q3=Q3,q4=Q4,sigma_q1=err_x,"
        "sigma_q2=err_y,sigma_q3=err_z --attitude quaternion-scalar-last --time-format iso",
    ),
    "rates without a unit": (
        "t,gx,gy,gz\n0,1,2,3\n", "--columns omega1=gx,omega2=gy,omega3=gz --sigma rates=1deg/s",
        "units.rate = missing: gx has none: add --units rate=deg/s or rate=rad/s",
    ),
    "a decimal comma and another delimiter": (
        "t_ms;gx;gy;gz\n1,5;2,5;3,5;4,5\n", "",
        "header = 't_ms;gx;gy;gz': is one column: add --delimiter ';'",
    ),
    "no errors": (
        ATTITUDES, "",
        "sigma.attitudes = missing: a standard deviation is needed: add --sigma "
        "attitudes=0.1deg, or, if a column has it, --columns sigma_q=NAME",
    ),
    "four numbers from 1": (
        "t,q1,q2,q3,q4\n0,0,0,0,1\n", "",
        "header = no q0: is needed with q1, q2, q3; if q4 is the scalar, add --attitude "
        "quaternion-scalar-last; if q1 is, add --columns q0=q1,q1=q2,q2=q3,q3=q4",
    ),
    "names in a comment": (
        f"# t, q0, q1, q2, q3\n{LINES}", "",
        "header = #1: is a column of a file without names: if the comment in line 1 has them, "
        "add --header-line 1",
    ),
    "a missing number": (
        "t,q0,q1,q2,q3\n0,1,NaN,0,0\n", "--sigma attitudes=1deg",
        "line 2, q1 = 'NaN': must be a number where the line has t, q0, q1, q2, q3; add --allow "
        "missing to leave out such lines",
    ),
    "an epoch": (
        "time,q0,q1,q2,q3\n2024-01-01T00:00:00Z,1,0,0,0\n", "--sigma attitudes=1deg",
        "line 2, t (time) = '2024-01-01T00:00:00Z': looks like a time of another format: add "
        "--time-format iso",
    ),
    "Euler angles": (
        "t,yaw,pitch,roll\n0,90,2,3\n", "",
        "header = yaw: looks like angle1: add --columns t,angle1=yaw,angle2=pitch,angle3=roll "
        "--attitude euler321 --units angle=deg",
    ),
    "angles without a unit": (
        "t,yaw,pitch,roll\n0,90,2,3\n",
        "--columns angle1=yaw,angle2=pitch,angle3=roll --attitude euler321 --sigma attitudes=1deg",
        "units.angle = missing: yaw has none: add --units angle=deg or angle=rad",
    ),
    "directions of what": (
        "JD,ra,dec\n2460000.5,1,2\n",
        "--columns time=JD,lon=ra,lat=dec --units angle=deg --time-format jd --sigma vectors=1deg",
        "axis = missing: add --axis spin if the directions are those of the axis of rotation, or, "
        "for an axis of the body, its components, as --axis 0,0,1",
    ),
    "lines before the header": (
        "FRAMES\t3\nDATE\t2024\nt\tq0\tq1\tq2\tq3\n0\t1\t0\t0\t0\n", "--delimiter tab",
        "header = 2 columns: a line has more cells: line 3 has 5; name or remove them, or add "
        "--header-line 3 if it has the names",
    ),
    "no matrix": (
        "t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,1,0,0,0,1,0,0,0,-1\n",
        "--attitude matrix --sigma attitudes=1deg",
        "line 2, r11 … r33 = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0]: is no rotation: "
        "R R^T differs from 1 by 0, det R is -1; check --columns r11=NAME,r12=NAME,…,r33=NAME",
    ),
    "no such column": (
        ATTITUDES, "--columns q0=qs",
        "columns.q0 = qs: is no column of the file, which has t, q0, q1, q2, q3",
    ),
    "times out of order": (
        "t,q0,q1,q2,q3\n2,1,0,0,0\n0,1,0,0,0\n", "--sigma attitudes=1deg",
        "line 3, t = '0': is before the time of line 2: sort the lines, or add --allow unsorted",
    ),
    "an option of tables": (
        "", "--delimiter ; --sigma rates=1", "delimiter = ;: describes tables (.csv, .tsv, .txt, "
        ".dat); none.toml is none: leave it",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_input_is_one_line_with_the_option_to_add(name, tmp_path, monkeypatch, refused):
    content, options, message = WRONG[name]
    monkeypatch.chdir(tmp_path)
    (tmp_path / "seen.csv").write_text(content)
    file = "seen.csv" if content else "none.toml"
    assert refused("fit", file, *options.split()).endswith(message)


@pytest.mark.parametrize(
    ("read", "message"),
    [
        (lambda: Layout(units="rate=foot"), "units.rate = 'foot': must be a unit of rate: r"),
        (lambda: Layout(units={"q0": "deg"}), "units = 'q0': must be one of: time, angle, rate"),
        (lambda: Layout(units="ms"), "units = 'ms': must be QUANTITY=UNIT,QUANTITY=UNIT, as time"),
        (lambda: Layout(sigma="0.1"), "sigma = 0.1: must be KIND=ERROR, as attitudes=0.1deg"),
        (lambda: Layout(sigma="rates=fast"), "sigma.rates = 'fast': must be a positive number wit"),
        (lambda: Layout(sigma="rates=-1deg/s"), "'-1deg/s': must be a positive number with a unit"),
        (lambda: Layout(columns=["t"]), "columns = ['t']: must be NAME=VALUE,NAME=VALUE, or a ta"),
        (lambda: Layout(attitude="euler322"), "must be one of: quaternion, quaternion-scalar-last"),
        (lambda: Layout(header_line=0), "header_line = 0: must be a whole number, at least 1"),
        (lambda: Layout(decimal=","), "decimal = ',': is the delimiter, too: add --delimiter ';'"),
        (lambda: Layout(allow="all"), "allow = 'all': must be one of: missing, unsorted, repeat"),
        (lambda: Layout(allow=3), "allow = 3: must be some of: missing, unsorted, repeated"),
        (lambda: Layout(delimiter=3), "delimiter = 3: must be a text"),
        (lambda: parse_table(ATTITUDES, Layout(delimiter="ab")), "delimiter = 'ab': must be one"),
        (lambda: parse_table(ATTITUDES, Layout(header_line=9)), "must be a line of the file, whic"),
        (lambda: parse_table(ATTITUDES, Layout(columns="tme=t")), "columns = tme: is not one of"),
        (lambda: parse_table(ATTITUDES, Layout(columns="q0=q0,q1=q0")),
         "columns.q1 = q0: is the column of q0, too: give each its own"),
        (lambda: parse_table(ATTITUDES, Layout(axis="spin", sigma="attitudes=1")),
         "axis = spin: the file has no directions: leave it"),
        (lambda: parse_table(ATTITUDES, Layout(sigma="attitudes=1", epoch="2024-01-01T00:00:00")),
         "epoch = 2024-01-01T00:00:00: is for times that are dates: add --time-format iso, jd"),
        (lambda: parse_table("t,q0,q1,q2,q3\n0,1e999999999,0,0,0\n", SIGMA), "must be at most 1e"),
        (lambda: parse_table("t,q0,q1,q2,q3\nx,y,z,y,z\n", SIGMA),
         "line 2 = x, y, z, y, z: has no numbers: add --data-line 3"),
        (lambda: parse_table("t,X,X,Y\n0,1,2,3\n", Layout(columns="omega1=X")),
         "columns.omega1 = X: is the name of 2 columns: take #2 or #3"),
        (lambda: parse_table("t,omega1 [mm/s],omega2,omega3\n0,1,2,3\n", Layout(sigma="rates=1")),
         "header = omega1 [mm/s]: has no unit of rate: add --units omega1=UNIT; rpm, or an angle"),
        (lambda: parse_table("t,omega1 [deg/s],omega2,omega3\n0,1,2,3\n", Layout(sigma="rates=1")),
         "units.omega2 = missing: omega2 has none: add --units omega2=deg/s or omega2=rad/s"),
        (lambda: parse_table("t,lon,lat\n0,9,91\n",
                             Layout(sigma="vectors=1", units="angle=deg", axis="spin")),
         "line 2, lat = '91': is beyond the pole: check --columns and --units"),
        (lambda: parse_table("t,v1,v2,v3\n0,9,9,9\n", Layout(sigma="vectors=1", axis="up")),
         "axis = 'up': must be spin, or three numbers, as 0,0,1"),
        (lambda: parse_table("t,v1,v2,v3\n0,9,9,9\n", Layout(sigma="vectors=1", axis="0,0,0")),
         "axis = 0,0,0: must not be zero"),
        (lambda: parse_table("t,q0,q1,q2,q3,sigma_q\n0,1,0,0,0,0\n"),
         "line 2, sigma_q = '0': a standard deviation must be positive"),
        (lambda: parse_table(""), "observations = the file: has no lines of data"),
        (lambda: parse_toml('[[files]]\nfile = "a.toml"\n'), "files[0].file = a.toml: must not be"),
        (lambda: parse_toml("[[files]]\nfiel = 3\n"), "files[0] = fiel: is not one of"),
    ],
)  # fmt: skip
def test_options_that_cannot_be_are_refused(read, message):
    refused(read, message)
