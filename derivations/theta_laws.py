"""Laws of theta functions and, by these, of Jacobi's: all that the attitude needs, proved.

Neville's notation (DLMF 20.1) serves two families at once: sn = s/n, cn = c/n and dn = d/n up to
constants, where s, c, d, n are theta_1, theta_2, theta_3, theta_4 of a real v in the circular
family, and theta_1, theta_4, theta_3, theta_2 of an imaginary I v in the hyperbolic one.

    null_c null_d null_n    c, d, n at 0, and null_s the derivative of s there
    v_s v_c v_d v_n         at v; dv_s dv_c dv_d dv_n are derivatives in v
    b_s b_c b_d b_n         at the shift b, and db_n, made real by a factor I where they are not
    S_re S_im N_re N_im     s and n of the shifted v, and dN_re dN_im, derivatives in v

Modulus, scale of the arguments and Jacobi's functions are *defined* by these: no word is said of
elliptic integrals.  Each law is a relation of Riemann's between products of four, at arguments
some of which agree.  At four arguments that do not it says that two series have the same terms.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from sympy import Expr, Matrix, Rational, Symbol, symbols

from rigidsym.proof.algebra import LedgerBuilder

ARGUMENTS = symbols("a b c d")
_SIGNS = Matrix([[1, 1, 1, 1], [1, 1, -1, -1], [1, -1, 1, -1], [1, -1, -1, 1]])
HALF_SUMS = list(_SIGNS * Matrix(ARGUMENTS) / 2)
COMPLEX = ("re", "im")
# Twice a product at half sums of a, b, c, d is the sum of these at a, b, c, d; with signs of the
# circular family, where s**2 has the other one than in the hyperbolic family.
RIEMANN = {
    "nnnn": {"nnnn": 1, "ssss": -1, "cccc": -1, "dddd": 1},
    "ssss": {"nnnn": -1, "ssss": 1, "cccc": -1, "dddd": 1},
    "nncc": {"nncc": 1, "ccnn": 1, "ssdd": 1, "ddss": 1},
    "nndd": {"nndd": 1, "ddnn": 1, "sscc": 1, "ccss": 1},
    "sncd": {"sncd": 1, "nsdc": 1, "cdsn": 1, "dcns": 1},
    "cncn": {"cncn": 1, "ncnc": 1, "sdsd": -1, "dsds": -1},
    "dndn": {"dndn": 1, "ndnd": 1, "scsc": -1, "cscs": -1},
}


# Names for values at v, at b and at the shifted v; where they are that of s, or of a derivative,
# other parts of complex values may be real.
PLACES = {
    "v": ("re(v)", "re(I*v)"),
    "v_s": ("re(v)", "im(I*v)"),
    "dv": ("re(v)", "im(-I*v)"),
    "dv_s": ("re(v)", "re(I*v)"),
    "b": ("re(I*b)", "re(b)"),
    "b_s": ("im(I*b)", "re(b)"),
    "db": ("im(I*b)", "re(-b)"),
    "S_re": ("re(v - I*b)", "im(b + I*v)"),
    "S_im": ("im(v - I*b)", "re(-b - I*v)"),
    "N_re": ("re(v - I*b)", "re(b + I*v)"),
    "N_im": ("im(v - I*b)", "im(b + I*v)"),
    "dN_re": ("re(v - I*b)", "im(b - I*v)"),
    "dN_im": ("im(v - I*b)", "re(b + I*v)"),
}


@dataclass(frozen=True, slots=True)
class Family:
    """The theta functions for s, c, d, n, the arguments v and b, and the nome."""

    column: int
    functions: Mapping[str, int]
    v: str
    b: str
    nome: str

    def of(self, role: str, argument: object, order: int = 0) -> str:
        """Return a function or its derivative."""
        return f"{'d' * order}theta{self.functions[role]}({argument}, {self.nome})"

    def declared(self) -> dict[str, str]:
        """Return the declarations of the names."""
        at = {name: parts[self.column] for name, parts in PLACES.items()}

        def part(name: str, role: str, order: int = 0) -> str:
            which, argument = at.get(f"{name}_{role}", at.get(name, "re(0)")).rstrip(")").split("(")
            return f"{which}({self.of(role, argument, order)})"

        return {
            **{f"null_{role}": part("null", role, int(role == "s")) for role in "cdns"},
            **{f"{name}_{role}": part(name, role) for name in "vb" for role in "scdn"},
            **{f"dv_{role}": part("dv", role, 1) for role in "scdn"},
            **{
                f"{role.upper()}_{x}": part(f"{role.upper()}_{x}", role)
                for role in "sn"
                for x in COMPLEX
            },
            **{f"dN_{x}": part(f"dN_{x}", "n", 1) for x in COMPLEX},
            "db_n": part("db", "n", 1),
        }

    def riemann(self, top: str, *along: Symbol) -> str:
        """Return Riemann's relation for a product, or its derivative along arguments."""
        terms = self._product(Rational(1), top, HALF_SUMS, along)
        for roles, sign in RIEMANN[top].items():
            turns = (roles.count("s") - top.count("s")) // 2 if self.column else 0
            weight = -Rational(sign * (-1) ** turns, 2)
            terms += self._product(weight, roles, ARGUMENTS, along)
        return " + ".join(terms)

    def _product(
        self, weight: Expr, roles: str, forms: Iterable[Expr], along: tuple[Symbol, ...]
    ) -> list[str]:
        """Return a product times a weight, or the terms of its derivative."""
        pairs = [*zip(roles, forms, strict=True)]
        speeds = [sum(form.coeff(x) for x in along) for _, form in pairs]
        terms = []
        for place, speed in enumerate(speeds) if along else [(None, 1)]:
            factors = [self.of(*pair, int(k == place)) for k, pair in enumerate(pairs)]
            if speed:
                terms.append("*".join([f"({weight * speed})", *factors]))
        return terms


CIRCULAR = Family(0, {"s": 1, "c": 2, "d": 3, "n": 4}, "v", "-I*b", "nome_m**2")
HYPERBOLIC = Family(1, {"s": 1, "c": 4, "d": 3, "n": 2}, "I*v", "b", "nome_c")
# The order is that in which normal forms are found.
VALUES = ("null_c", "null_d", "null_n", "null_s", "S_re", "S_im", "db_n", "dv_n", "v_n", "b_n")
MORE = ("N_re", "N_im", "b_s", "b_c", "b_d", "v_s", "v_c", "v_d", "dv_s", "dv_c", "dv_d")
NAMES = (*VALUES, *MORE, "dN_re", "dN_im")
LAWS = {
    "addition": {
        "(S_re*N_re + S_im*N_im)*null_c*null_d": "v_s*v_n*b_c*b_d",
        "(S_im*N_re - S_re*N_im)*null_c*null_d": "-v_c*v_d*b_s*b_n",
    },
    "modulus": {"(N_re**2 + N_im**2)*null_n**2": "v_n**2*b_n**2 + v_s**2*b_s**2"},
    "zeta_addition": {
        "null_n*(dN_re*v_n*b_n - dv_n*N_re*b_n - db_n*v_n*N_im)": "-null_s*v_s*b_s*S_im",
        "null_n*(dN_im*v_n*b_n - dv_n*N_im*b_n + db_n*v_n*N_re)": "null_s*v_s*b_s*S_re",
    },
    "circle": {"null_c**2*v_n**2": "null_n**2*v_c**2 + null_d**2*v_s**2"},
    "ellipse": {"null_d**2*v_n**2": "null_n**2*v_d**2 + null_c**2*v_s**2"},
    "shift_circle": {"null_c**2*b_n**2": "null_n**2*b_c**2 - null_d**2*b_s**2"},
    "shift_ellipse": {"null_d**2*b_n**2": "null_n**2*b_d**2 - null_c**2*b_s**2"},
    "sn_slope": {"(dv_s*v_n - v_s*dv_n)*null_c*null_d": "v_c*v_d*null_n*null_s"},
    "cn_slope": {"(dv_c*v_n - v_c*dv_n)*null_c*null_n": "-v_s*v_d*null_s*null_d"},
    "dn_slope": {"(dv_d*v_n - v_d*dv_n)*null_d*null_n": "-v_s*v_c*null_s*null_c"},
}
UNITS = ("null_c", "null_d", "null_n", "null_s", "b_n", "v_n", "v_n**2*b_n**2 + v_s**2*b_s**2")
# Modulus and scale; sn, cn, dn of v/g, and of b/g but for factors I; zeta functions of both.
JACOBI = {
    "root_k": "null_c/null_d",
    "k_1": "root_k**2",
    "g": "null_n*null_c/(null_d*null_s)",
    "s": "null_d*v_s/(null_c*v_n)",
    "c": "null_n*v_c/(null_c*v_n)",
    "d": "null_n*v_d/(null_d*v_n)",
    "x": "null_d*b_s/(null_c*b_n)",
    "y": "null_n*b_c/(null_c*b_n)",
    "z": "null_n*b_d/(null_d*b_n)",
    "Z_u": "g*dv_n/v_n",
    "zeta": "g*db_n/b_n",
}


def prove(builder: LedgerBuilder, context: str, family: Family) -> None:
    """Prove the laws in a context that declares the functions of a family."""
    a, _, c, d = ARGUMENTS
    v, b = family.v, family.b
    at_v = {"a": v, "b": v, "c": "0", "d": "0"}
    at_b = {"a": b, "b": b, "c": "0", "d": "0"}
    at_both = {"a": v, "b": v, "c": b, "d": b}
    chained = {"a": "0", "b": f"{v} + {b}", "c": v, "d": b}
    relation = family.riemann
    proofs = {
        "modulus": (f"{relation('nnnn')} - ({relation('ssss')})", at_both),
        "addition": (relation("sncd"), at_both),
        "zeta_addition": (f"2*({relation('nnnn', a)}) - 2*({relation('ssss', a)})", chained),
        "circle": (f"2*({relation('nncc')})", at_v),
        "ellipse": (f"2*({relation('nndd')})", at_v),
        "shift_circle": (f"2*({relation('nncc')})", at_b),
        "shift_ellipse": (f"2*({relation('nndd')})", at_b),
        "sn_slope": (relation("sncd", c, d), at_v),
        "cn_slope": (relation("cncn", c, d), at_v),
        "dn_slope": (relation("dndn", c, d), at_v),
    }
    for name, (identity, forms) in proofs.items():
        builder.theta(f"{context}.{name}", LAWS[name], identity, forms)
