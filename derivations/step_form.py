"""One step from any state by its elapsed time alone: no phase, no regime, and no modulus.

Two functions of the elapsed time carry everything,

    X' = Y,    Y' = -e_1 X + 2 e_2 X^3,    starting at 0, 1,    e_1 = p - r/2,  e_2 = h^2,  h = r/4

with p and r of the addition form: X is sn(mu t | k_1^2)/mu after Landen's descent, but its modulus
is not asked for.  They double by rational functions (`doubling`), and S, C and D of the addition
form are rational in them.

The momentum over its size is a point n of a sphere; z = (n_d + i n_b)/(1 + n_a), its stereographic
projection, moves as an elliptic function of order two does, so that with G = 1 + h z^2 X^2

    z at t = (z Y + z' X)/G,    psi/2 = (psi_0/2) t - Im(arg G/2 + h z z' J),    J' = X^2/G

where z, z' and psi_0 are those at the start (`turn`).  The first two terms are of a Pi whose
parameter is complex, and J is small with t^3.  By G alone the second half of a time follows from
the first (`second_half`), whatever J is: psi needs J for the shortest of times.
"""

from derivations.attitude import HANDEDNESS, INERTIA, PULL_BACK, RATES, SENSE, SHORTEST, TURN
from derivations.theta_edges import given
from derivations.theta_form import times
from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, join
from rigidsym.proof.algebra._parts import part_of

# n_a, n_b, n_d are sigma M_a/K, sigma epsilon M_b/K and M_d/K: Euler's equations without signs.
POINT = Part(
    witness={"h_a": "1", "h_d": "1", "n_d0": "0", "n_b0": "0", "n_a0": "1"},
    units=("1 + n_a0",),
    relations=("n_a0**2 + n_b0**2 + n_d0**2 - 1",),
    definitions={
        "h_b": "-h_a - h_d",
        "h": "h_a*(h_d*n_b0**2 - h_b*n_d0**2)/4",
        "e_1": "2*h - h_b*(h_d*n_a0**2 - h_a*n_d0**2)",
        "e_2": "h**2",
        "z_re": "n_d0/(1 + n_a0)",
        "z_im": "n_b0/(1 + n_a0)",
        "zr_re": "n_b0*(h_d*n_a0 - z_re*h_a*n_d0)/(1 + n_a0)",
        "zr_im": "n_d0*(h_b*n_a0 - z_im*h_a*n_b0)/(1 + n_a0)",
        "turn_0": "(h_d*n_b0**2 - h_b*n_d0**2)/(2*(1 + n_a0))",
    },
    reading={
        "h_a": "(1/c_d - 1/c_b) K, 1/s",
        "h_d": "(1/c_b - 1/c_a) K, 1/s",
        **{f"n_{x}0": f"component {x} of M/K at t = 0, but for signs" for x in "abd"},
    },
)
ELAPSED = Part(
    witness={"X": "0", "Y": "1"},
    relations=("Y**2 - 1 + e_1*X**2 - e_2*X**4",),
    rates={"X": "Y", "Y": "-e_1*X + 2*e_2*X**3"},
    reading={
        "X": "sn(mu t | k_1^2)/mu with mu^2 and k_1^2 mu^2 the roots of x^2 - e_1 x + e_2",
        "Y": "X', cn dn of the same",
    },
)
# What the start alone decides of psi: nu X^2 is 1 - G, and rate is half of nu'.
START = Part(
    definitions={
        "nu_re": "h*(z_im**2 - z_re**2)",
        "nu_im": "-2*h*z_re*z_im",
        "rate_re": "h*(z_im*zr_im - z_re*zr_re)",
        "rate_im": "-h*(z_re*zr_im + z_im*zr_re)",
    },
)
FACTOR = Part(
    units=("square",),
    definitions={
        "G_re": "1 - nu_re*X**2",
        "G_im": "-nu_im*X**2",
        "square": "G_re**2 + G_im**2",
        "G_re_rate": "-2*nu_re*X*Y",
        "G_im_rate": "-2*nu_im*X*Y",
        "J_rate": "X**2*(rate_im*G_re - rate_re*G_im)/square",
        "G_rate": "-2*nu_im*X*Y/square",
    },
)
PLACES = Part(
    units=("room",),
    definitions={
        "f": "1 + h*X**2",
        "g": "1 - h*X**2",
        "room": "f**2 - h_a*h_d*n_b0**2*X**2",
        "even": "room + n_a0*f*g",
        "odd": "h_a*n_b0*n_d0*X*Y",
        "one_0": "1 + n_a0",
    },
)


def _moved(point: str, x: str, one: str, turn: str) -> Part:
    """Return the point after a time, or before it, and half of psi's rate there."""
    n_a, n_b, n_d = (f"{point}_{axis}" for axis in "abd")
    return Part(
        units=(one,),
        definitions={
            n_a: f"(n_a0*f*g + h_a*n_b0*n_d0*{x}*Y)/room",
            n_b: f"(n_b0*g*Y + h_b*n_d0*n_a0*f*{x})/room",
            n_d: f"(n_d0*f*Y + h_d*n_a0*n_b0*g*{x})/room",
            one: f"1 + {n_a}",
            turn: f"(h_d*{n_b}**2 - h_b*{n_d}**2)/(2*{one})",
        },
    )


STEP = (POINT, ELAPSED, START, FACTOR, PLACES, _moved("n", "X", "one", "after"))
BEFORE = _moved("o", "(-X)", "other", "before")
# The projection at t.
QUOTIENT = Part(
    definitions={
        "F_re": "z_re*Y + zr_re*X",
        "F_im": "z_im*Y + zr_im*X",
        "w_re": "(F_re*G_re + F_im*G_im)/square",
        "w_im": "(F_im*G_re - F_re*G_im)/square",
    },
)
# The rate of psi/2 as a share of that at the start; then its even and its odd part.
SHARE = Part(
    witness={"one_0": "2", "one": "2", "square": "1", "even": "2", "odd": "0", "turn_0": "1"},
    units=("one_0", "one", "square"),
    relations=("one*(even - odd) - one_0**2*square",),
    definitions={"after": "turn_0*one_0/one"},
)
EARLIER = Part(
    witness={"other": "2"},
    units=("other",),
    relations=("other*(even + odd) - one_0**2*square",),
    definitions={"before": "turn_0*one_0/other"},
)
PARTS = Part(
    witness={"one_0": "2", "square": "1", "even": "2", "odd": "0", "turn_0": "1"},
    units=("one_0", "square"),
    definitions={
        "after": "turn_0*(even - odd)/(one_0*square)",
        "G_rate": "2*turn_0*odd/(one_0*square)",
    },
)
EVEN = Part(definitions={"J_rate": "turn_0*even/(one_0*square) - turn_0"})
BACK = Part(definitions={"before": "turn_0*(even + odd)/(one_0*square)"})
# R is the modulus of G; V is what the turn W of the first half becomes in the second.
HALVES = Part(
    witness={"W_re": "1", "W_im": "0", "R": "1"},
    units=("R",),
    relations=("W_im**2 + W_re**2 - 1", "R**2 - square"),
    rates={
        "W_re": "-before*W_im",
        "W_im": "before*W_re",
        "R": "(G_re*G_re_rate + G_im*G_im_rate)/R",
    },
    nonnegative=("R",),
    definitions={
        "V_re": "(W_re*G_re + W_im*G_im)/R",
        "V_im": "(W_im*G_re - W_re*G_im)/R",
    },
    reading={"W_re": "cos of psi/2 from -t to 0", "W_im": "sin of psi/2 from -t to 0"},
)
TURNED = Part(
    witness={"before": "1", "G_re": "1", "G_im": "0", "G_re_rate": "0", "G_im_rate": "0"},
    units=("square",),
    rates={
        **dict.fromkeys(("before", "G_re_rate", "G_im_rate"), "?"),
        "G_re": "G_re_rate",
        "G_im": "G_im_rate",
    },
    definitions={
        "square": "G_re**2 + G_im**2",
        "G_rate": "(G_im_rate*G_re - G_re_rate*G_im)/square",
        "after": "before - G_rate",
    },
)


# psi/2 by three turns: T at the start's rate, E at that of J, and U, by half the angle of G.
PRODUCT = times("P", "U")
THIRDS = Part(
    witness={
        **{"T_re": "1", "T_im": "0", "E_re": "1", "E_im": "0", "R": "1", "N": "2"},
    },
    units=("R", "N", "R + G_re"),
    relations=(
        *("T_im**2 + T_re**2 - 1", "E_im**2 + E_re**2 - 1"),
        *("R**2 - square", "N**2 - 2*R*(R + G_re)"),
    ),
    rates={
        **{"T_re": "-(psi_0/2)*T_im", "T_im": "(psi_0/2)*T_re"},
        **{"E_re": "-J_rate*E_im", "E_im": "J_rate*E_re"},
        "R": "(G_re*G_re_rate + G_im*G_im_rate)/R",
        "N": "((G_re*G_re_rate + G_im*G_im_rate)*(2*R + G_re)/R + R*G_re_rate)/N",
    },
    nonnegative=("R", "N"),
    definitions={
        "U_re": "(R + G_re)/N",
        "U_im": "-G_im/N",
        **{f"P_{part}": form for part, form in times("T", "E").items()},
        "cos_half_psi": PRODUCT["re"],
        "sin_half_psi": PRODUCT["im"],
    },
    reading={
        **{"T_re": "cos(psi_0*t/2)", "T_im": "sin(psi_0*t/2)"},
        **{"E_re": "cos of the integral of J_rate", "E_im": "sin of the integral of J_rate"},
        **{"R": "the modulus of G", "N": "sqrt(2*R*(R + G_re))"},
    },
)
THIRD = Part(
    witness={
        **{"psi_0": "1", "J_rate": "0", "G_re": "1", "G_im": "0"},
        **{"G_re_rate": "0", "G_im_rate": "0"},
    },
    units=("square",),
    rates={
        **dict.fromkeys(("J_rate", "G_re_rate", "G_im_rate"), "?"),
        **{"G_re": "G_re_rate", "G_im": "G_im_rate"},
    },
    definitions={
        "square": "G_re**2 + G_im**2",
        "G_rate": "(G_im_rate*G_re - G_re_rate*G_im)/square",
        "psi_rate": "psi_0 + 2*J_rate - G_rate",
    },
)
# A body and its start, by the inverse moments and the momentum.
STARTED = Part(
    witness={
        **{"i_a": "1/3", "i_b": "1/2", "i_d": "1"},
        **{"M_d0": "0", "M_b0": "0", "M_a0": "3", "K": "3"},
    },
    units=("i_a", "i_b", "i_d", "K", "K + sigma*M_a0"),
    relations=("K**2 - M_a0**2 - M_b0**2 - M_d0**2",),
    nonnegative=("K",),
    definitions={
        **{f"c_{x}": f"1/i_{x}" for x in "abd"},
        **{f"Omega_{x}0": f"i_{x}*M_{x}0" for x in "abd"},
        "c_ab": "c_a - c_b",
        "c_ad": "c_a - c_d",
        "c_bd": "c_b - c_d",
        "alpha_a": "epsilon*c_bd/c_a",
        "alpha_b": "-epsilon*c_ad/c_b",
        "alpha_d": "epsilon*c_ab/c_d",
        "l_a": "c_ab*c_ad/(c_b*c_d)",
        "l_b": "c_ab*c_bd/(c_a*c_d)",
        "l_d": "c_ad*c_bd/(c_a*c_b)",
        "H_0": "(c_a*Omega_a0**2 + c_b*Omega_b0**2 + c_d*Omega_d0**2)/2",
        "psi_0": "(2*H_0 + K*sigma*Omega_a0)/(K + sigma*M_a0)",
        "h": "(i_d - i_b)*((i_b - i_a)*M_b0**2 - (i_a - i_d)*M_d0**2)/4",
        "e_1": "2*h - (i_a - i_d)*((i_b - i_a)*M_a0**2 - (i_d - i_b)*M_d0**2)",
        "e_2": "h**2",
        "z_re": "M_d0/(K + sigma*M_a0)",
        "z_im": "sigma*epsilon*M_b0/(K + sigma*M_a0)",
        "zr_re": "epsilon*M_b0*((i_b - i_a)*M_a0 - sigma*(i_d - i_b)*M_d0*z_re)/(K + sigma*M_a0)",
        "zr_im": "sigma*M_d0*((i_a - i_d)*M_a0 - epsilon*(i_d - i_b)*M_b0*z_im)/(K + sigma*M_a0)",
    },
    reading={
        "K": "|M|, kg m^2 rad/s",
        **{f"i_{x}": f"1/c_{x}" for x in "abd"},
        **{f"M_{x}0": f"the momentum about axis {x} at t = 0, kg m^2 rad/s" for x in "abd"},
    },
)
MOVED = Part(
    units=("room",),
    definitions={
        "f": "1 + h*X**2",
        "g": "1 - h*X**2",
        "room": "f**2 - (i_d - i_b)*(i_b - i_a)*M_b0**2*X**2",
        "M_a": "(M_a0*f*g + epsilon*(i_d - i_b)*M_b0*M_d0*X*Y)/room",
        "M_b": "(M_b0*g*Y + epsilon*(i_a - i_d)*M_d0*M_a0*f*X)/room",
        "M_d": "(M_d0*f*Y + epsilon*(i_b - i_a)*M_a0*M_b0*g*X)/room",
        **{f"Omega_{x}": f"i_{x}*M_{x}" for x in "abd"},
    },
)
# The names of `turn` in a body's, and what `attitude` says of psi.
POINTED = Part(
    definitions={
        "h_a": "K*(i_d - i_b)",
        "h_d": "K*(i_b - i_a)",
        "h_b": "-h_a - h_d",
        **{f"n_a{x}": f"sigma*M_a{x}/K" for x in ("", "0")},
        **{f"n_b{x}": f"sigma*epsilon*M_b{x}/K" for x in ("", "0")},
        **{f"n_d{x}": f"M_d{x}/K" for x in ("", "0")},
        "one_0": "1 + n_a0",
        "one": "1 + n_a",
        "turn_0": "(h_d*n_b0**2 - h_b*n_d0**2)/(2*one_0)",
        "even": "room + n_a0*f*g",
        "odd": "h_a*n_b0*n_d0*X*Y",
    },
)
TURNING = Part(
    units=("K + sigma*M_a",),
    definitions={
        "after": "(h_d*n_b**2 - h_b*n_d**2)/(2*one)",
        "H": "(i_a*M_a**2 + i_b*M_b**2 + i_d*M_d**2)/2",
        "psi_rate": "(2*H + K*sigma*Omega_a)/(K + sigma*M_a)",
    },
)
DIRECTION = Part(
    witness={
        **{"i_a": "1/3", "i_b": "1/2", "i_d": "1"},
        **{"M_d": "0", "M_b": "0", "M_a": "3", "K": "3"},
    },
    units=("K",),
    relations=("K**2 - M_a**2 - M_b**2 - M_d**2",),
    definitions={
        "Omega_a": "i_a*M_a",
        **{name: POINTED.definitions[name] for name in ("h_a", "h_d", "h_b")},
        **{f"n_{x}": POINTED.definitions[f"n_{x}"] for x in "abd"},
        "one": "1 + n_a",
    },
)


# A body by i_a, K and h_a, h_d; its start by the direction of the momentum.
AIMED = Part(
    witness={"i_a": "1/3", "K": "3", "h_a": "3/2", "h_d": "1/2"},
    units=("K", "i_a", "i_b", "i_d"),
    definitions={
        "i_b": "i_a + h_d/K",
        "i_d": "i_b + h_a/K",
        "M_a0": "sigma*K*n_a0",
        "M_b0": "sigma*epsilon*K*n_b0",
        "M_d0": "K*n_d0",
    },
    nonnegative=("K",),
    reading={"K": STARTED.reading["K"]},
)
# The shortest rotation that takes the momentum to its axis.
SHORTEST_TURN = Part(
    {"nu": "6"},
    ("nu",),
    SHORTEST.definitions,
    SHORTEST.relations[1:],
    SHORTEST.rates,
    ("nu",),
    reading={"nu": SHORTEST.reading["nu"]},
)
# What the turn by thirds has for J's rate: psi's, less that at the start.
RATE_OF_J = Part(
    definitions={
        **{f"i_{x}": f"1/c_{x}" for x in "abd"},
        **{name: form for name, form in DIRECTION.definitions.items() if name != "Omega_a"},
        "after": TURNING.definitions["after"],
        "turn_0": "psi_0/2 - K*i_a/2",
        "J_rate": "after - turn_0 + G_rate/2",
    },
)
# At the start no time has passed, and nothing has turned.
ELAPSED_START = ("X", "Y - 1")
TURN_START = ("W_re - 1", "W_im", "R - 1")
THIRDS_START = ("T_re - 1", "T_im", "E_re - 1", "E_im", "R - 1", "N - 2")


def derive(builder: LedgerBuilder) -> None:
    """Prove the doubling, the turn, the second half of a time, and the motion by these."""
    for claims in (_doubling, _turn, _halves, _psi, _body, _motion):
        claims(builder)


def _doubling(builder: LedgerBuilder) -> None:
    """Prove that X and Y at 2 t are the functions of 2 t, by their rates and their start."""
    free = Part(
        witness={"e_1": "1", "e_2": "0", **ELAPSED.witness},
        units=("1 - e_2*X**4",),
        relations=ELAPSED.relations,
        rates=ELAPSED.rates,
        definitions={
            "inside": "1 - e_2*X**4",
            "X_next": "2*X*Y/inside",
            "Y_next": "1 - 2*X**2*(e_1*(1 + e_2*X**4) - 4*e_2*X**2)/inside**2",
        },
    )
    builder.open(join("doubling", free))
    moved = {"D(X_next)": "2*Y_next", "D(Y_next)": "2*(-e_1*X_next + 2*e_2*X_next**3)"}
    builder.claim("doubling.rates", moved, ["DLMF 22.6.5"])
    curve = {"Y_next**2": "1 - e_1*X_next**2 + e_2*X_next**4"}
    builder.claim("doubling.curve", curve, ["DLMF 22.6.5"])
    start = {"X_next": "0", "Y_next": "1"}
    builder.begin("doubling", ELAPSED_START, "", start, "DLMF 22.6.5")


def _turn(builder: LedgerBuilder) -> None:
    """Prove Euler's equations for the point, its projection, and psi's rate."""
    builder.open(join("turn", *STEP, QUOTIENT))
    others = {"a": "bd", "b": "da", "d": "ab"}
    euler = {f"D(n_{x})": f"h_{x}*n_{y}*n_{z}" for x, (y, z) in others.items()}
    builder.claim("turn.euler", euler, ["5", "10"])
    builder.claim("turn.point", {"n_a**2 + n_b**2 + n_d**2": "1"}, ["6", "15"])
    projected = {"w_re*(1 + n_a)": "n_d", "w_im*(1 + n_a)": "n_b"}
    builder.claim("turn.projection", projected, ["27"])
    _shared(builder, "share", SHARE, "turn")
    parts = join("parts", PARTS, EVEN, static=True)
    builder.open(parts)
    builder.claim("parts.psi", {"after": "turn_0 + J_rate - G_rate/2"}, ["33", "34", "36"])
    builder.claim("turn.parts", {x: parts.definitions[x] for x in ("J_rate", "G_rate")}, ["36"])
    builder.model("turn", "parts", ["turn.after", "turn.parts"])
    builder.carry("turn", ["parts.psi"])


def _shared(builder: LedgerBuilder, name: str, share: Part, context: str) -> None:
    """Prove the rates as shares of the energy, and by 1 + n_a at t and -t."""
    times = {"after": "one*(even - odd)", "before": "other*(even + odd)"}
    shares = {"after": PARTS.definitions["after"], **BACK.definitions}
    builder.open(join(name, share, static=True))
    for rate in share.definitions:
        builder.claim(f"{name}.{rate}", {rate: shares[rate]}, ["36"])
    builder.claim(f"{context}.conserved", share.definitions, ["6"])
    products = {times[rate]: "one_0**2*square" for rate in share.definitions}
    builder.claim(f"{context}.product", products, ["36"])
    builder.model(context, name, [f"{context}.conserved", f"{context}.product"])
    builder.carry(context, [f"{name}.{rate}" for rate in share.definitions])


def _halves(builder: LedgerBuilder) -> None:
    """Prove that the second half of a time turns as the first, times the conjugate of G."""
    builder.open(join("halves", *STEP, BEFORE, HALVES))
    _shared(builder, "shares", part_of(join("shares", SHARE, EARLIER, static=True)), "halves")
    builder.open(join("difference", PARTS, BACK, static=True))
    builder.claim("difference.rates", {"after": "before - G_rate"}, ["33", "34", "36"])
    builder.claim("halves.odd", {"G_rate": PARTS.definitions["G_rate"]}, ["36"])
    builder.model("halves", "difference", [f"halves.{x}" for x in ("after", "before", "odd")])
    builder.carry("halves", ["difference.rates"])
    builder.open(join("second_half", TURNED, HALVES))
    builder.root("second_half.R", "R", "G_re**2 + G_im**2", ["36"])
    later = {"D(V_re)": "-after*V_im", "D(V_im)": "after*V_re", "V_re**2 + V_im**2": "1"}
    builder.claim("second_half.turn", later, ["33", "34", "36"])
    builder.model("halves", "second_half", ["halves.rates"])
    builder.carry("halves", ["second_half.turn", "second_half.R"])
    begun = {"V_re": "1", "V_im": "0"}
    start = ("G_re - 1", "G_im", *TURN_START)
    builder.begin("second_half", start, "R", begun, "33", "34")
    builder.begin("halves", (*ELAPSED_START, *TURN_START), "R", begun, "33", "34")


def _psi(builder: LedgerBuilder) -> None:
    """Prove that psi/2 is the angle of a product of three turns."""
    builder.open(join("thirds", THIRD, THIRDS))
    builder.root("thirds.R", "R", "G_re**2 + G_im**2", ["36"])
    builder.root("thirds.N", "N", "2*R*(R + G_re)", ["36"])
    turn = {
        "D(cos_half_psi)": "-psi_rate/2*sin_half_psi",
        "D(sin_half_psi)": "psi_rate/2*cos_half_psi",
        "cos_half_psi**2 + sin_half_psi**2": "1",
    }
    builder.claim("thirds.turn", turn, ["33", "34", "36"])
    start = ("G_re - 1", "G_im", *THIRDS_START)
    builder.begin("thirds", start, "R N", {"cos_half_psi": "1", "sin_half_psi": "0"}, "33", "34")


def _body(builder: LedgerBuilder) -> None:
    """Prove Euler's equations for the rates of a body, and psi' as in `attitude`."""
    signs = (HANDEDNESS, SENSE)
    builder.open(join("direction", *signs, DIRECTION, TURNING, static=True))
    builder.claim("direction.psi_rate_of_point", {"psi_rate": "K*i_a + 2*after"}, ["33", "34"])
    parts = (*signs, STARTED, ELAPSED, START, FACTOR, MOVED, POINTED, TURNING, QUOTIENT)
    builder.open(join("step", *parts))
    builder.claim("step.euler", {f"D({x})": rate for x, rate in RATES.rates.items()}, ["5", "10"])
    momenta = {f"M_{x}0": f"c_{x}*Omega_{x}0" for x in "abd"}
    for name, form in momenta.items():
        builder.claim(f"step.{name}", {name: form}, ["8"])
    builder.claim("step.momentum", {"M_a**2 + M_b**2 + M_d**2": "K**2"}, ["6", "15"])
    builder.claim("step.energy", {"H": "H_0"}, ["6"])
    builder.root("step.K", "K", "M_a0**2 + M_b0**2 + M_d0**2", ["6", "15"])
    builder.claim("step.turn_0", {"turn_0": "psi_0/2 - K*i_a/2"}, ["33", "34"])
    builder.model("step", "direction", ["step.momentum"])
    builder.carry("step", ["direction.psi_rate_of_point"])
    builder.model("step", "turn")
    builder.carry("step", ["turn.psi"])
    _numbers(builder)


def _numbers(builder: LedgerBuilder) -> None:
    """Prove the step by moments and rates, with sums of nonnegative terms where signs decide."""
    builder.claim("step.h", {"h": "(l_b*Omega_b0**2 + l_d*Omega_d0**2)/4"}, ["10"])
    first = {"e_1": "l_a*Omega_a0**2 + (l_b*Omega_b0**2 - l_d*Omega_d0**2)/2"}
    builder.claim("step.e_1", first, ["10"])
    builder.claim("step.room", {"room": "g**2 + l_d*Omega_d0**2*X**2"}, ["10"])
    rates = {
        "Omega_a": "(Omega_a0*f*g + alpha_a*Omega_b0*Omega_d0*X*Y)/room",
        "Omega_b": "(Omega_b0*g*Y + alpha_b*Omega_d0*Omega_a0*f*X)/room",
        "Omega_d": "(Omega_d0*f*Y + alpha_d*Omega_a0*Omega_b0*g*X)/room",
    }
    projected = {
        "zr_re": "epsilon*Omega_b0*(c_ab*Omega_a0 - sigma*c_bd*Omega_d0*z_re)/(K + sigma*M_a0)",
        "zr_im": "-sigma*Omega_d0*(c_ad*Omega_a0 + epsilon*c_bd*Omega_b0*z_im)/(K + sigma*M_a0)",
    }
    for name, form in rates.items():
        builder.claim(f"step.{name}", {name: form}, ["5", "10"])
    for name, form in projected.items():
        builder.claim(f"step.{name}", {name: form}, ["27"])


def _motion(builder: LedgerBuilder) -> None:
    """Prove that rates and attitude of the whole step are the motion.

    Its variables are those of the point, by which psi's rate is short enough to be compared.
    """
    signs = (HANDEDNESS, SENSE)
    turned = (*signs, INERTIA, RATES, SHORTEST, *given((THIRD,), ["J_rate"], ()), RATE_OF_J)
    angle = Part(definitions=half_angle("psi").definitions)
    builder.open(join("turned_by_thirds", *turned, THIRDS, TURN, angle, PULL_BACK))
    rate = {"psi_rate": "psi_0 + 2*J_rate - G_rate"}
    builder.claim("turned_by_thirds.rate", rate, ["33", "34"])
    builder.model("turned_by_thirds", "thirds", ["turned_by_thirds.rate"])
    builder.carry("turned_by_thirds", ["thirds.turn", "thirds.R", "thirds.N"])
    builder.model("turned_by_thirds", "attitude", ["turned_by_thirds.turn"])
    builder.carry("turned_by_thirds", ["attitude.solution", "attitude.nu"])
    body = Part(definitions={**STARTED.definitions, **MOVED.definitions, **TURNING.definitions})
    step = (*signs, AIMED, body, *STEP, QUOTIENT, THIRDS, SHORTEST_TURN)
    builder.open(join("step_motion", *step, TURN, angle, PULL_BACK))
    builder.model("step_motion", "turn")
    builder.carry("step_motion", ["turn.psi"])
    builder.model("step_motion", "step")
    builder.carry("step_motion", ["step.euler", "step.momentum"])
    premises = [f"step_motion.{name}" for name in ("psi", "euler", "momentum")]
    builder.model("step_motion", "turned_by_thirds", premises)
    builder.carry("step_motion", [f"turned_by_thirds.{name}" for name in ("R", "N", "nu")])
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that the step starts at its rates and its attitude."""
    published = "M_a0 M_b0 M_d0 K h e_1 zr_re zr_im room Omega_a Omega_b Omega_d"
    rates = {f"Omega_{x}": f"Omega_{x}0" for x in "abd"}
    builder.begin("step", ELAPSED_START, published, rates, "5", "10")
    turned = {"cos_half_psi": "1", "sin_half_psi": "0"}
    start = (*ELAPSED_START, *THIRDS_START)
    builder.begin("step_motion", start, "R N nu", rates | turned, "33", "34", "37")
    for context in ("step_start", "attitude_begun"):
        builder.model("step_motion_start", context)
