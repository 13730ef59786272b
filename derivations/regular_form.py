"""The rates in Jacobi's functions, for every order of the axes, both circulations and all signs.

    Omega_a = sigma A_a dn,    Omega_b = chi A_b sn,    Omega_d = chi tau A_d cn

of (u | m) with u' = lambda and always 0 <= m <= 1.  The motion is described by the amplitudes B of
the momentum, with B_b^2 = B_d^2 + m B_a^2, and by 1/c_a and 1/c_d = 1/c_a + rho Delta; the middle
inertia follows.  rho is the sign of c_a - c_d and tells the two circulations apart; tau = -rho
epsilon sigma makes lambda positive, and chi = +-1 lets a motion start with |u| <= K(m).  m = 1 is
the separatrix, m = 0 a symmetric body: neither is excluded, and neither needs a formula of its
own.
"""

from sympy import Add, Expr, Symbol, expand, factor, symbols

from derivations.attitude import HANDEDNESS, INERTIA, RATES, SENSE
from rigidsym.proof.algebra import LedgerBuilder, Part, jacobi, join, sign
from rigidsym.proof.algebra._printing import printed

CIRCULATION = sign("rho", "the sign of c_a - c_d")
HALF = sign("chi", "+1 when cn > 0 describes the start, -1 when the other half period does")
POLHODE = Part(
    witness={"i_a": "1/6", "Delta": "5/6", "B_a": "7", "B_d": "24"},
    units=("i_a", "i_a + rho*Delta", "Delta", "B_a", "B_d", "rho"),
    definitions={"c_a": "1/i_a", "i_d": "i_a + rho*Delta", "c_d": "1/i_d"},
    reading={
        "i_a": "1/c_a",
        "Delta": "|1/c_d - 1/c_a|",
        "B_a": "amplitude of c_a |Omega_a|",
        "B_d": "amplitude of c_d |Omega_d|",
    },
)
PARAMETER = Part(
    witness={"m": "1", "B_b": "25"},
    units=("B_b", "B_d**2 + m*B_a**2", "i_a*(B_d**2 + m*B_a**2) + rho*Delta*B_d**2"),
    relations=("B_b**2 - B_d**2 - m*B_a**2",),
    nonnegative=("B_b",),
    reading={"m": "parameter (k^2) of the Jacobi functions", "B_b": "amplitude of c_b |Omega_b|"},
)
# The moments enter by these, too: where two of them agree to many digits, a difference known before
# they were rounded has digits that they have lost.
PAIRS = ("ab", "ad", "bd")
DIFFERENCES = {f"c_{x}{y}": f"c_{x} - c_{y}" for x, y in PAIRS}
AMPLITUDES = Part(
    definitions={
        "i_b": "i_a + rho*Delta*B_d**2/B_b**2",
        "c_b": "1/i_b",
        **DIFFERENCES,
        "A_a": "B_a/c_a",
        "A_b": "B_b/c_b",
        "A_d": "B_d/c_d",
        "lambda_": "Delta*B_a*B_d/B_b",
        "tau": "-rho*epsilon*sigma",
        "m_1": "1 - m",
    },
    nonnegative=("A_a", "A_b", "A_d", "lambda_"),
    reading={
        "lambda_": "rate of the argument u, rad/s",
        **{f"A_{x}": f"amplitude of |Omega_{x}|, rad/s" for x in "abd"},
    },
)
ROTATING = Part(
    definitions={"Omega_a": "sigma*A_a*dn", "Omega_b": "chi*A_b*sn", "Omega_d": "chi*tau*A_d*cn"},
)
# The invariants by the amplitudes; the claims show that they are those of the rates.
INVARIANTS = Part(
    definitions={
        "H": "(i_a*B_a**2 + i_d*B_d**2)/2",
        "E_a": "c_d*c_ad*A_d**2",
        "E_b": "c_a*c_ab*A_a**2*m_1",
        "E_d": "c_a*c_ad*A_a**2",
        "M_a": "sigma*B_a*dn",
        "M_b": "chi*B_b*sn",
        "M_d": "chi*tau*B_d*cn",
    },
)
BODY = (HANDEDNESS, SENSE, CIRCULATION, HALF, POLHODE)
FUNCTIONS = jacobi("sn", "cn", "dn", "u", "m", "lambda_")
# Numbers have 1 - m without a difference.
BY_COMPLEMENT = Part(reading={f"{x}n": f"jacobi_{x}n(u, 1 - m_1)" for x in "scd"})
REGULAR = (*BODY, PARAMETER, AMPLITUDES, FUNCTIONS, BY_COMPLEMENT, ROTATING, INVARIANTS)
EULER = {f"D({name})": rate for name, rate in RATES.rates.items()}


def differences() -> dict[str, str]:
    """Return 2 H c_a - K^2, K^2 - 2 H c_b and K^2 - 2 H c_d without cancellation.

    No cancellation but the one in E_b, whose sign tells the circulations apart.
    """
    moments, rates = symbols("c_a c_b c_d"), symbols("Omega_a Omega_b Omega_d")
    c_a, c_b, c_d = moments
    terms = list(zip(moments, rates, strict=True))
    twice_energy, square = sum(c * w**2 for c, w in terms), sum((c * w) ** 2 for c, w in terms)
    short = {Symbol(f"c_{x}") - Symbol(f"c_{y}"): Symbol(f"c_{x}{y}") for x, y in PAIRS}
    short |= {-form: -name for form, name in short.items()}

    def collected(form: Expr) -> str:
        found = (factor(form.coeff(w**2)).xreplace(short) * w**2 for w in rates)
        return printed(Add(*found), " ".join(map(str, (*moments, *short.values(), *rates))))

    forms = {
        "E_a": twice_energy * c_a - square,
        "E_b": square - twice_energy * c_b,
        "E_d": square - twice_energy * c_d,
    }
    return {name: collected(expand(form)) for name, form in forms.items()}


BY_RATES = {"H": RATES.definitions["H"], **differences()}
# What the number half evaluates: each amplitude, rate and parameter from inertia and invariants.
FORMULAS = {
    "A_a": "E_d/(c_a*c_ad)",
    "A_b": "E_a/(c_b*c_ab)",
    "A_d": "E_a/(c_d*c_ad)",
    "lambda_": "c_ab*E_d/(c_a*c_b*c_d)",
}
PARAMETERS = {"m": "E_a*c_bd/(E_d*c_ab)", "m_1": "c_ad*E_b/(c_ab*E_d)"}

# At t = 0 these say where on the polhode the motion starts.
START = {"sn": "chi*Omega_b/A_b", "cn": "chi*tau*Omega_d/A_d", "dn": "sigma*Omega_a/A_a"}


def derive(builder: LedgerBuilder) -> None:
    """Prove Euler's equations, and the amplitudes, lambda and m by inertia and invariants."""
    builder.open(join("regular", *REGULAR))
    builder.claim("regular.euler", EULER, ["5", "10"])
    for name, form in BY_RATES.items():
        builder.claim(f"regular.{name}", {name: form}, ["6", "15"])
    square = "(M_a**2 + M_b**2 + M_d**2)"
    builder.claim(
        "regular.differences",
        {
            "E_a": f"2*H*c_a - {square}",
            "E_b": f"{square} - 2*H*c_b",
            "E_d": f"{square} - 2*H*c_d",
        },
        ["6", "15"],
    )
    for name, radicand in FORMULAS.items():
        builder.root(f"regular.{name}", name, radicand, ["10", "13", "14"])
    for name, form in PARAMETERS.items():
        builder.claim(f"regular.{name}", {name: form}, ["10", "13", "14"])
    for name, form in START.items():
        builder.claim(f"regular.{name}", {name: form}, ["12"])
    _every_motion(builder)
    _start(builder)
    _signs(builder)


def _every_motion(builder: LedgerBuilder) -> None:
    """Prove that m and squared amplitudes by any inertia and rates meet the relations.

    That the squares are nonnegative and 0 <= m <= 1 is the choice of the axis a, in the chapter
    on regimes; where E_a or E_d vanish the rates are constant.
    """
    squares = Part(
        units=(
            "c_a - c_b",
            "c_a - c_d",
            "c_b*(c_a - c_b)*Omega_b**2 + c_d*(c_a - c_d)*Omega_d**2",
            "c_a*(c_a - c_d)*Omega_a**2 + c_b*(c_b - c_d)*Omega_b**2",
        ),
        definitions={
            **{f"{name}_squared": form for name, form in FORMULAS.items()},
            "m": PARAMETERS["m"],
            "B_a_squared": "c_a**2*A_a_squared",
            "B_b_squared": "c_b**2*A_b_squared",
            "B_d_squared": "c_d**2*A_d_squared",
        },
    )
    moving = Part(witness={"Omega_a": "1", "Omega_b": "0", "Omega_d": "1"})
    by_rates = Part(definitions=DIFFERENCES | BY_RATES)
    builder.open(join("any_motion", INERTIA, moving, by_rates, squares, static=True))
    builder.claim("any_motion.parameter", {"B_b_squared": "B_d_squared + m*B_a_squared"}, ["14"])
    builder.claim(
        "any_motion.inertia", {"1/c_b": "1/c_a + (1/c_d - 1/c_a)*B_d_squared/B_b_squared"}, ["14"]
    )
    builder.claim(
        "any_motion.rate",
        {"lambda__squared": "(1/c_d - 1/c_a)**2*B_a_squared*B_d_squared/B_b_squared"},
        ["14"],
    )
    builder.claim(
        "any_motion.start",
        {
            "Omega_b**2/A_b_squared + Omega_d**2/A_d_squared": "1",
            "Omega_a**2/A_a_squared + m*Omega_b**2/A_b_squared": "1",
        },
        ["12"],
    )


def _start(builder: LedgerBuilder) -> None:
    """Prove that the rates at t = 0 are those given, with u_1 = phase and psi = 0.

    That sn, cn and dn are on the curve of Jacobi's functions is `any_motion.start`.
    """
    witness = {"Omega_a": "1", "Omega_b": "0", "Omega_d": "4", "K": "5"}
    amplitudes = {"A_a": "1", "A_b": "4", "A_d": "4"}
    others = ("t", "phase", "mu", "psi_0", "kappa", "J", "J_0")
    given = Part(
        witness=witness | amplitudes | dict.fromkeys(others, "0"),
        units=("c_ab", "c_ad", "E_d", *amplitudes),
        definitions={
            **DIFFERENCES,
            **RATES.definitions,
            **BY_RATES,
            **PARAMETERS,
            "tau": AMPLITUDES.definitions["tau"],
            **START,
            "u_1": "mu*t + phase",
            "psi": "psi_0*t + kappa*(J - J_0)",
        },
        relations=(
            "K**2 - M_a**2 - M_b**2 - M_d**2",
            *(f"{name}**2 - {FORMULAS[name]}" for name in amplitudes),
            "t",
            "J - J_0",
        ),
        nonnegative=("K", *amplitudes),
    )
    signs = (HANDEDNESS, SENSE, CIRCULATION, HALF)
    builder.open(join("rates_start", *signs, INERTIA, given, static=True))
    builder.root("rates_start.K", "K", "M_a**2 + M_b**2 + M_d**2", ["6", "15"])
    for name in amplitudes:
        builder.root(f"rates_start.{name}", name, FORMULAS[name], ["10", "13", "14"])
    builder.claim("rates_start.rates", ROTATING.definitions, ["10"])
    builder.claim("rates_start.time", {"u_1": "phase", "psi": "0"}, ["20", "21", "33", "34"])
    builder.claim("rates_start.parameters", {"m + m_1": "1"}, ["13", "14"])


def _signs(builder: LedgerBuilder) -> None:
    """Prove dn >= 0, cn >= 0 and Delta >= 0 at the start, by the definitions of the signs."""
    given = Part(
        witness={"i_a": "1", "Delta": "1", "A_a": "1", "A_d": "1", "dn": "1", "cn": "1"},
        units=("i_a", "i_a + rho*Delta", "A_a", "A_d"),
        definitions={
            **POLHODE.definitions,
            **{name: AMPLITUDES.definitions[name] for name in ("c_ad", "tau")},
            **{name: ROTATING.definitions[name] for name in ("Omega_a", "Omega_d")},
        },
        nonnegative=("A_a", "A_d", "c_a", "c_d", "rho*c_ad", "sigma*Omega_a", "chi*tau*Omega_d"),
    )
    builder.open(join("start_signs", HANDEDNESS, SENSE, CIRCULATION, HALF, given, static=True))
    forms = {
        "dn": "sigma*Omega_a/A_a",
        "cn": "chi*tau*Omega_d/A_d",
        "Delta": "rho*c_ad/(c_a*c_d)",
    }
    builder.sign("start_signs.signs", forms, ["12"])
