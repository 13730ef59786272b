"""Sensitivities column by column: formulas for numbers, without cancellation.

A column is the change of the rates by one rate at t = 0 or by one moment of inertia.  Each is what
it is where S_t, C_t and D_t stay, and what they change it by, along two directions alone: `_k`,
where p, r and k = alpha_a alpha_d Omega_b0^2 grow alike, and `_r`, where r does.  With

    F_t = the integral of S_t^2/D_t^2

these divide by D_t and `below` alone, in every regime: no case is told apart.  b being the middle
axis, kappa_a = p - k, kappa_d = r - k and p - r are single products, `below` is a sum of squares,
and what is left of Omega_b_k is small where the spin is about b.  Omega_a_k and Omega_a_r leave out
Omega_a S_t^2/2, taken off and put on: what is left is small where the spin is about a, and S_t
grows like t if the body is symmetric.  E_t and F_t follow from each other: the one where p - r is
not small, the other where p is not.
"""

from collections.abc import Iterator

from derivations.addition_form import (
    COEFFICIENTS,
    EULER,
    FUNCTIONS,
    OTHERS,
    OVER_SQUARE,
    SQUARED,
    START,
    TIME,
)
from derivations.attitude import HANDEDNESS, INERTIA
from derivations.rate_sensitivities import MODULI
from rigidsym.proof.algebra import LedgerBuilder, Part, join

AXES = ("a", "b", "d")
RATES_AT_START = Part(
    witness={"Omega_a0": "1", "Omega_b0": "1", "Omega_d0": "1"},
    reading={f"Omega_{x}0": f"body rate about axis {x} at t = 0, rad/s" for x in AXES},
)
# Euler's equations are Omega_a' = alpha_a Omega_b Omega_d and so on; `tilt` is E_b in these units.
MOMENTS = {
    "c_ab": "c_a - c_b",
    "c_ad": "c_a - c_d",
    "c_bd": "c_b - c_d",
    "alpha_a": "epsilon*c_bd/c_a",
    "alpha_b": "-epsilon*c_ad/c_b",
    "alpha_d": "epsilon*c_ab/c_d",
    "E_b": "c_a*c_ab*Omega_a0**2 - c_d*c_bd*Omega_d0**2",
    "tilt": "epsilon*E_b/(c_a*c_d)",
    **{
        name: text
        for x, (y, z) in OTHERS.items()
        for name, text in (
            (f"alpha_{x}_by_c_{x}", f"-alpha_{x}/c_{x}"),
            (f"alpha_{x}_by_c_{y}", f"epsilon/c_{x}"),
            (f"alpha_{x}_by_c_{z}", f"-epsilon/c_{x}"),
        )
    },
}
# What E_b and `tilt` change by, each with no difference but those of moments.
_TILTED = {
    "a": "epsilon*((c_a + c_ab)*Omega_a0**2)/c_a/c_d - tilt/c_a",
    "b": "-epsilon*(c_a*Omega_a0**2 + c_d*Omega_d0**2)/c_a/c_d",
    "d": "epsilon*((c_d - c_bd)*Omega_d0**2)/c_a/c_d - tilt/c_d",
}
MOMENTS |= {f"tilt_by_c_{y}": text for y, text in _TILTED.items()}
TILT_BY = {
    f"tilt_by_c_{y}": f"alpha_d_by_c_{y}*Omega_a0**2 - alpha_a_by_c_{y}*Omega_d0**2" for y in AXES
}
TILT = {"tilt": "alpha_d*Omega_a0**2 - alpha_a*Omega_d0**2"}
BODY = {
    "g_a": "alpha_a*Omega_b0**2 - alpha_b*Omega_a0**2",
    "g_d": "alpha_d*Omega_b0**2 - alpha_b*Omega_d0**2",
    "k": "alpha_a*alpha_d*Omega_b0**2",
    "kappa_a": "-alpha_b*alpha_d*Omega_a0**2",
    "kappa_d": "-alpha_a*alpha_b*Omega_d0**2",
    "p": "k + kappa_a",
    "r": "k + kappa_d",
    "apart": "-alpha_b*tilt",
}
# What p and r change by with each rate; where it is not here it is zero.
BY_RATES = {
    "p_by_Omega_a": "-2*alpha_b*alpha_d*Omega_a0",
    "p_by_Omega_b": "2*alpha_a*alpha_d*Omega_b0",
    "r_by_Omega_d": "-2*alpha_a*alpha_b*Omega_d0",
}


def _by_moments() -> Iterator[tuple[str, str]]:
    """Yield the changes of p, p - r, kappa_a and rates with each moment, functions fixed."""
    for y in AXES:
        a, b, d = (f"alpha_{x}_by_c_{y}" for x in AXES)
        yield f"kappa_by_c_{y}", f"-({b}*alpha_d + alpha_b*{d})*Omega_a0**2"
        yield f"p_by_c_{y}", f"kappa_by_c_{y} + ({a}*alpha_d + alpha_a*{d})*Omega_b0**2"
        yield (
            f"apart_by_c_{y}",
            f"-alpha_b*tilt_by_c_{y} - {b}*tilt",
        )
        # Of k - kappa_d: p and p - r together are twice kappa_a, and this.
        yield (
            f"leant_by_c_{y}",
            f"({a}*alpha_d + alpha_a*{d})*Omega_b0**2 + ({a}*alpha_b + alpha_a*{b})*Omega_d0**2",
        )
        yield f"a_by_c_{y}", f"{a}*Omega_b0*Omega_d0"
        yield f"b_by_c_{y}", f"{b}*Omega_d0*Omega_a0"
        yield f"d_by_c_{y}", f"{d}*Omega_a0*Omega_b0"


CONSTANTS = {**BODY, **BY_RATES, **dict(_by_moments())}
RATES = {
    "below": "D_t**2 + kappa_d*S_t**2",
    "over": "1/below",
    "Omega_a": "over*(Omega_a0*D_t + alpha_a*Omega_b0*Omega_d0*S_t*C_t)",
    "Omega_b": "over*(Omega_b0*C_t*D_t + alpha_b*Omega_d0*Omega_a0*S_t)",
    "Omega_d": "over*(Omega_d0*C_t + alpha_d*Omega_a0*Omega_b0*S_t*D_t)",
}
# Along `_k` and `_r`; those of S_t, C_t and D_t, of `below`, and of the rates.
DIRECTIONS = {
    "S_k": "(C_t*D_t*E_t - S_t**3)/2",
    "C_k": "-S_t*(S_t*C_t + p*D_t*E_t)/2",
    "D_k": "-S_t*(S_t*D_t + r*C_t*E_t)/2",
    "below_k": "-S_t*(S_t*below + k*C_t*D_t*E_t)",
    "leant": "alpha_a*Omega_b0*Omega_d0",
    # Half of Omega_a'.
    "turning": "over*(S_t*C_t*(k*Omega_a*D_t - r*Omega_a0/2) + leant*D_t*(C_t**2 - p*S_t**2)/2)",
    "Omega_a_k": "turning*E_t - over*leant*S_t**3*C_t/2",
    # Each small square is multiplied by 1/below: two of them may be below the least double.
    "Omega_b_k": "over*(alpha_b*Omega_d0*Omega_a0)*(S_k - S_t*(over*below_k))"
    " - Omega_b0*S_t*E_t*((over*kappa_a + over*kappa_d)*(over*C_t**2)*D_t**2"
    " + S_t**2*(p*(over*kappa_a)*(over*D_t**2) + r*(over*kappa_d)*(over*C_t**2)))/2",
    "Omega_d_k": "over*(Omega_d0*C_k + alpha_d*Omega_a0*Omega_b0*(S_k*D_t + S_t*D_k)"
    " - Omega_d*below_k)",
    "f": "D_t*F_t",
    "S_r": "-C_t*f/2",
    "C_r": "p*S_t*f/2",
    "D_r": "(r*S_t*C_t*f - S_t**2)/(2*D_t)",
    "below_r": "k*S_t*C_t*f",
    "Omega_a_r": "over*S_t**3*(leant*C_t - r*Omega_a0*S_t/D_t)/2 - f*(turning/D_t)",
    "Omega_b_r": "over*(Omega_b0*(C_r*D_t + C_t*D_r) + alpha_b*Omega_d0*Omega_a0*S_r"
    " - Omega_b*below_r)",
    "Omega_d_r": "over*(Omega_d0*C_r + alpha_d*Omega_a0*Omega_b0*(S_r*D_t + S_t*D_r)"
    " - Omega_d*below_r)",
}
# What each rate changes by where the functions stay, by the rate at t = 0.
STAYING = {
    "a": {"a": "D_t", "b": "alpha_b*Omega_d0*S_t", "d": "alpha_d*Omega_b0*S_t*D_t"},
    "b": {"a": "alpha_a*Omega_d0*S_t*C_t", "b": "C_t*D_t", "d": "alpha_d*Omega_a0*S_t*D_t"},
    "d": {"a": "alpha_a*Omega_b0*S_t*C_t", "b": "alpha_b*Omega_a0*S_t", "d": "C_t"},
}
# What Omega_a_k and Omega_a_r leave out, taken off and put on.
HALF = "Omega_a*S_t**2/2"
# The functions that the coefficient of each rate stands with.
WITH = {"a": "S_t*C_t", "b": "S_t", "d": "S_t*D_t"}


def _columns() -> Iterator[tuple[str, str]]:
    """Yield the columns by each rate at t = 0 and each moment."""
    for x in AXES:
        stays = f"{STAYING['a'][x]} - Omega_{x}*p_by_Omega_a*{'k*S_t**4' if x == 'a' else 'S_t**2'}"
        yield (
            f"Omega_{x}_by_Omega_a",
            f"over*({stays}) + p_by_Omega_a*(Omega_{x}_k - Omega_{x}_r)",
        )
    for y, grows, way, sign in (("b", "p", "k", "+"), ("d", "r", "r", "-")):
        for x in AXES:
            along = f"(Omega_a_{way} {sign} {HALF})" if x == "a" else f"Omega_{x}_{way}"
            stays = STAYING[y][x]
            yield f"Omega_{x}_by_Omega_{y}", f"over*({stays}) + {grows}_by_Omega_{y}*{along}"
    for y in AXES:
        for x in AXES:
            stays = f"over*({x}_by_c_{y}*({WITH[x]}) - Omega_{x}*kappa_by_c_{y}*S_t**2)"
            if x == "a":
                left = f"leant_by_c_{y} - 2*(over*kappa_by_c_{y})*k*S_t**2"
                stays = f"over*(a_by_c_{y}*({WITH[x]})) + {HALF}*({left})"
            yield (
                f"Omega_{x}_by_c_{y}",
                f"{stays} + p_by_c_{y}*Omega_{x}_k - apart_by_c_{y}*Omega_{x}_r",
            )


COLUMNS = dict(_columns())
# Of the integral of Omega_b^2: what it has beyond that of the rate at t = 0.
EXCESS = {
    "excess_b": "g_a*g_d*E_t + Omega_b0*(Omega_b*(S_t - t) + (Omega_b - Omega_b0)*t)",
}
# The same near a spin about b, where E_t and t are large beside it: kappa_a, kappa_d, p - r and the
# product of the other two rates are small, and each term has one of them.
SPUN = {
    "swung": "over*S_t*(alpha_b*Omega_d0*Omega_a0"
    " - Omega_b0*S_t*(kappa_a*D_t + kappa_d*C_t)/(D_t + C_t))",
    "lag": "kappa_a/p*(S_t*C_t/D_t - t) + apart*(S_t**3/(D_t + C_t) - k/p*f)/D_t",
    "excess_spun": "Omega_b0**2*(lag + (kappa_a + kappa_d)*E_t)"
    " + (alpha_b*Omega_d0*Omega_a0)**2*E_t + Omega_b0*swung*S_t",
}
# The middle rate's columns where the spin is about it: with no difference.
MIDDLE = {
    "middle_by_Omega_a": "alpha_b/alpha_d*(Omega_d/Omega_b)*Omega_d_by_Omega_a",
    "middle_by_Omega_d": "alpha_b/alpha_a*(Omega_a/Omega_b)*Omega_a_by_Omega_d",
}
# Where p grows alone: `_k` less `_r`, by r times the integral of S_t^2/D_t^2 over the phase, from
# where it was at t = 0, instead of over the elapsed time from 0.
PASSING = {
    "passed": "r*F_t - alpha_a/alpha_b*(Omega_b*Omega_b0/(Omega_a*Omega_a0))*S_t/D_t",
    "half_over_p": "1/(2*p)",
    "since": "(t + passed)*half_over_p",
    "share": "1/(2*alpha_b*alpha_d*Omega_a0)",
    "Omega_a_p": "alpha_a*Omega_b*Omega_d*since"
    " + (over*(k*S_t**4*Omega_a + share*D_t) - share*(Omega_a0/Omega_a))",
    "Omega_b_p": "alpha_b*Omega_d*Omega_a*since + over*S_t*(Omega_b*S_t + share*alpha_b*Omega_d0)",
    "Omega_d_p": "alpha_d*Omega_a*Omega_b*since"
    " + over*S_t*(Omega_d*S_t + share*alpha_d*Omega_b0*D_t)",
}
CHANGES = ("Omega_a", "Omega_b", "Omega_d", "c_a", "c_b", "c_d")
AT_TIME = {**RATES, **DIRECTIONS, **COLUMNS, **EXCESS}
MOVED = {"a": "h1", "b": "h2", "d": "h3"}
# By what each integral follows from the other, and the square that it is of.
ELAPSED = {
    "F_t": ("E_t", "(t - p*E_t - S_t*C_t/D_t)/(p - r)", "p - r", "S_t**2/D_t**2"),
    "E_t": ("F_t", "(t - S_t*C_t/D_t - (p - r)*F_t)/p", "p", "S_t**2"),
}
GIVEN = Part(
    witness={
        **COEFFICIENTS.witness,
        **dict.fromkeys((f"alpha_{x}_by_c_{y}" for x in AXES for y in AXES), "1"),
    },
    reading={
        **COEFFICIENTS.reading,
        **{
            f"alpha_{x}_by_c_{y}": f"what alpha_{x} changes by with c_{y}"
            for x in AXES
            for y in AXES
        },
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the variation of Euler's equations, the start, and E_t by F_t."""
    _moments(builder)
    _columns_vary(builder)
    _elapsed(builder)


def _moments(builder: LedgerBuilder) -> None:
    """Prove the coefficients and their changes by the moments of inertia."""
    changes = Part(
        {f"h{n}": "1" for n in (1, 2, 3)},
        definitions={
            **MOMENTS,
            **{
                f"dalpha_{x}": " + ".join(f"alpha_{x}_by_c_{y}*{h}" for y, h in MOVED.items())
                for x in AXES
            },
        },
        reading={h: f"a change of c_{y}" for y, h in MOVED.items()},
    )
    builder.open(join("coefficients", HANDEDNESS, INERTIA, RATES_AT_START, changes, static=True))
    same = {f"c_{x}*alpha_{x}": f"epsilon*(c_{y} - c_{z})" for x, (y, z) in OTHERS.items()}
    builder.claim("coefficients.euler", same, ["5"])
    varied = {
        f"c_{x}*dalpha_{x} + {MOVED[x]}*alpha_{x}": f"epsilon*({MOVED[y]} - {MOVED[z]})"
        for x, (y, z) in OTHERS.items()
    }
    builder.claim("coefficients.variation", varied, ["5"])
    builder.claim("coefficients.tilt", TILT, ["6", "15"])
    builder.claim("coefficients.tilt_by", TILT_BY, ["6", "15"])


def _columns_vary(builder: LedgerBuilder) -> None:
    """Prove the columns at all times and at the start."""
    defined = Part(
        definitions={**TILT, **TILT_BY, **CONSTANTS, **AT_TIME},
        units=("below",),
    )
    given = (GIVEN, RATES_AT_START)
    functions = (FUNCTIONS, TIME, SQUARED, OVER_SQUARE)
    builder.open(join("varied_rates", *given, *functions, defined))
    builder.claim("varied_rates.below", {"below": "1 - k*S_t**2", "p - r": "apart"}, ["10"])
    builder.claim("varied_rates.euler", EULER, ["5"])
    for y in CHANGES:
        builder.claim(f"varied_rates.by_{y}", _variation(y), ["5"])
    builder.claim("varied_rates.excess", {"D(excess_b)": "Omega_b**2 - Omega_b0**2"}, ["10"])
    _excesses(builder, *given, *functions, defined)
    _middle(builder, *given, *functions, defined)
    _passing(builder, *given, *functions, defined)
    _spun(builder, *given, *functions, defined)
    still = [Part(x.witness, x.units, reading=x.reading) for x in functions]
    start = Part(relations=(*START.relations, "F_t"))
    builder.open(join("varied_rates_start", *given, *still, defined, start, static=True))
    begun = {f"Omega_{x}": f"Omega_{x}0" for x in AXES}
    begun |= {f"Omega_{x}_by_{y}": str(int(y == f"Omega_{x}")) for y in CHANGES for x in AXES}
    builder.claim("varied_rates_start.rates", begun | {"excess_b": "0"}, ["12"])


def _variation(y: str) -> dict[str, str]:
    """Return the variation of Euler's equations for one change."""

    def change(x: str, others: tuple[str, str]) -> str:
        v, w = others
        product = f"Omega_{v}_by_{y}*Omega_{w} + Omega_{v}*Omega_{w}_by_{y}"
        moved = f"alpha_{x}_by_{y}*Omega_{v}*Omega_{w} + " if y.startswith("c") else ""
        return f"{moved}alpha_{x}*({product})"

    return {f"D(Omega_{x}_by_{y})": change(x, others) for x, others in OTHERS.items()}


def _excesses(builder: LedgerBuilder, *parts: Part) -> None:
    """Prove the integrals of the other squares where b is no axis of symmetry."""
    defined = {f"excess_{x}": f"alpha_{x}/alpha_b*excess_b" for x in "ad"}
    builder.open(join("excesses", *parts, Part(definitions=defined, units=("alpha_b",))))
    squares = {f"D({name})": f"Omega_{name[-1]}**2 - Omega_{name[-1]}0**2" for name in defined}
    builder.claim("excesses.squares", squares, ["10"])


def _middle(builder: LedgerBuilder, *parts: Part) -> None:
    """Prove the columns of the middle rate, by alpha_x Omega_b^2 - alpha_b Omega_x^2 constant."""
    defined = Part(definitions=MIDDLE, units=("alpha_a", "alpha_d", "Omega_b"))
    builder.open(join("middle_columns", *parts, defined))
    same = {name: name.replace("middle", "Omega_b") for name in MIDDLE}
    builder.claim("middle_columns.products", same, ["10"])


def _passing(builder: LedgerBuilder, *parts: Part) -> None:
    """Prove the columns for growing p without differences of growing terms."""
    _, text, _, _ = ELAPSED["E_t"]
    # p is alpha_d g_a.
    units = ("alpha_b", "alpha_d", "Omega_a", "Omega_a0", "g_a")
    defined = Part(definitions={"E_t": text, **PASSING}, units=units)
    builder.open(join("passing", *(x for x in parts if x is not SQUARED), defined))
    builder.claim(
        "passing.integral", {"D(passed)": "-alpha_a/alpha_b*(Omega_b/Omega_a)**2"}, ["10"]
    )
    same = {f"Omega_{x}_p": f"Omega_{x}_k - Omega_{x}_r" for x in AXES}
    builder.claim("passing.changes", same, ["10"])


def _spun(builder: LedgerBuilder, *parts: Part) -> None:
    """Prove the change and the integral of the middle rate near a spin about b."""
    _, text, _, _ = ELAPSED["E_t"]
    defined = Part(definitions={"E_t": text, **SPUN}, units=("p", "C_t + D_t"))
    builder.open(join("spun", *(x for x in parts if x is not SQUARED), defined))
    builder.claim("spun.excess", {"swung": "Omega_b - Omega_b0", "excess_spun": "excess_b"}, ["10"])


def _elapsed(builder: LedgerBuilder) -> None:
    """Prove E_t by F_t, and F_t by E_t."""
    for name, (other, text, divisor, changing) in ELAPSED.items():
        integral = {"E_t": SQUARED, "F_t": OVER_SQUARE}[other]
        defined = Part(definitions={name: text}, units=("D_t", divisor))
        context = f"elapsed_{name[0]}"
        builder.open(join(context, MODULI, FUNCTIONS, TIME, integral, defined))
        builder.claim(f"{context}.integral", {f"D({name})": changing}, ["DLMF 22.16"])
        still = [Part(x.witness, reading=x.reading) for x in (FUNCTIONS, TIME, integral)]
        start = Part(relations=("t", "S_t", "C_t - 1", "D_t - 1", other))
        builder.open(join(f"{context}_start", MODULI, *still, start, defined, static=True))
        builder.claim(f"{context}_start.integral", {name: "0"}, ["12"])
