"""Changes of the integrals of the addition form: derivatives for bounds over a box.

E_t = int S_t^2 and F_t = int S_t^2/D_t^2 change along two directions, as S_t, C_t and D_t do: `_k`,
where p and r grow alike, and `_r`, where r does.  What that takes is the integrals of fourth powers

    U_t = int S_t^4,    V_t = int S_t^4/D_t^2,    W_t = int S_t^4/D_t^4,

which lie between 0 and the largest S_t^2, or S_t^2/D_t^2, times E_t or F_t, and are elementary in
them where p, r and p - r are not small.
"""

from derivations.addition_form import FUNCTIONS, OVER_SQUARE, SQUARED, START, TIME
from derivations.rate_sensitivities import MODULI
from rigidsym.proof.algebra import LedgerBuilder, Part, join

FOURTHS = Part(
    witness=dict.fromkeys(("U_t", "V_t", "W_t"), "0"),
    rates={"U_t": "S_t**4", "V_t": "S_t**4/D_t**2", "W_t": "S_t**4/D_t**4"},
    reading={
        "U_t": "the integral of S_t^4 from 0 to t",
        "V_t": "the integral of S_t^4/D_t^2 from 0 to t",
        "W_t": "the integral of S_t^4/D_t^4 from 0 to t",
    },
)
DIRECTIONS = Part(
    definitions={
        "S_k": "(C_t*D_t*E_t - S_t**3)/2",
        "C_k": "-S_t*(S_t*C_t + p*D_t*E_t)/2",
        "D_k": "-S_t*(S_t*D_t + r*C_t*E_t)/2",
        "E_k": "(S_t**2*E_t - 3*U_t)/2",
        "F_k": "(S_t**2*E_t/D_t**2 - V_t)/2",
        "S_r": "-C_t*D_t*F_t/2",
        "C_r": "p*S_t*D_t*F_t/2",
        "D_r": "r*S_t*C_t*F_t/2 - S_t**2/(2*D_t)",
        "E_r": "(V_t - S_t**2*F_t)/2",
        "F_r": "(3*W_t - S_t**2*F_t/D_t**2)/2",
    },
)
ELEMENTARY = Part(
    units=("p", "r", "p - r"),
    definitions={
        "U_t": "(S_t*C_t*D_t - t + 2*(p + r)*E_t)/(3*p*r)",
        "V_t": "(F_t - E_t)/r",
        "W_t": "(t - S_t*C_t/D_t**3 + 2*(2*r - p)*F_t)/(3*r*(p - r))",
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the changes along both directions, and the integrals of fourth powers."""
    parts = (MODULI, FUNCTIONS, TIME, SQUARED, OVER_SQUARE)
    builder.open(join("varied_integrals", *parts, FOURTHS, DIRECTIONS))
    for way, grows in (("k", "-S_t*D_t - p"), ("r", "-p")):
        varied = {
            f"D(S_{way})": f"C_{way}*D_t + C_t*D_{way}",
            f"D(C_{way})": f"{grows}*(S_{way}*D_t + S_t*D_{way})",
            f"D(D_{way})": f"-S_t*C_t - r*(S_{way}*C_t + S_t*C_{way})",
            f"D(E_{way})": f"2*S_t*S_{way}",
            f"D(F_{way})": f"2*S_t*(S_{way} - S_t*D_{way}/D_t)/D_t**2",
        }
        builder.claim(f"varied_integrals.along_{way}", varied, ["10"])
    builder.open(join("fourth_powers", *parts, ELEMENTARY))
    rates = {f"D({name})": rate for name, rate in FOURTHS.rates.items()}
    builder.claim("fourth_powers.rates", rates, ["10"])
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that all changes are zero at t = 0."""
    parts = (FUNCTIONS, TIME, SQUARED, OVER_SQUARE, FOURTHS)
    still = [Part(part.witness, part.units, reading=part.reading) for part in parts]
    zero = Part(relations=(*START.relations, "F_t", *FOURTHS.witness))
    builder.open(join("varied_integrals_start", MODULI, *still, DIRECTIONS, zero, static=True))
    changes = dict.fromkeys(DIRECTIONS.definitions, "0")
    builder.claim("varied_integrals_start.functions", changes, ["12"])
    still = still[:-1]
    zero = Part(relations=(*START.relations, "F_t"))
    builder.open(join("fourth_powers_start", MODULI, *still, ELEMENTARY, zero, static=True))
    integrals = dict.fromkeys(ELEMENTARY.definitions, "0")
    builder.claim("fourth_powers_start.integrals", integrals, ["12"])
