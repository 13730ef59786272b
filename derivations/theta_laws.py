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
some of which agree, with names put in for the values.  At four arguments that differ it says that
two series have the same terms.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

from sympy import (
    Add,
    Expr,
    Function,
    I,
    Integer,
    Matrix,
    Mul,
    Symbol,
    factor_terms,
    symbols,
    sympify,
)

from rigidsym.proof.algebra import LedgerBuilder, named
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps._names import symbols as real

ARGUMENTS = a, b, c, d = symbols("a b c d")
_SIGNS = Matrix([[1, 1, 1, 1], [1, 1, -1, -1], [1, -1, 1, -1], [1, -1, -1, 1]])
HALF_SUMS = [*(_SIGNS * Matrix(ARGUMENTS) / 2)]
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
null_s, null_c, null_d, null_n = NULLS = real("null_s null_c null_d null_n")
v_s, v_c, v_d, v_n = AT_V = real("v_s v_c v_d v_n")
dv_s, dv_c, dv_d, dv_n = SLOPES = real("dv_s dv_c dv_d dv_n")
b_s, b_c, b_d, b_n = AT_B = real("b_s b_c b_d b_n")
S_re, S_im, N_re, N_im, dN_re, dN_im = SHIFTED = real("S_re S_im N_re N_im dN_re dN_im")
db_n, g = real("db_n g")
S, N, dN = S_re + I * S_im, N_re + I * N_im, dN_re + I * dN_im
# The shift of v is u: -I b in the circular family, b in the hyperbolic one.
v, u = symbols("v u")
# Values of s, c, d, n, then of their derivatives, in the circular family.
MEANT = {
    0: ((0, null_c, null_d, null_n), (null_s, 0, 0, 0)),
    v: (AT_V, SLOPES),
    u: ((-I * b_s, b_c, b_d, b_n), (None, None, None, -I * db_n)),
    v + u: ((S, None, None, N), (None, None, None, dN)),
    v - u: ((S.conjugate(), None, None, N.conjugate()), (None,) * 4),
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


Equations: TypeAlias = list[tuple[Computation, Computation]]


@dataclass(frozen=True, slots=True)
class Law:
    """A sum of Riemann's relations at arguments some of which agree, or its derivative along some.

    `left` are the names on the left side.
    """

    tops: Mapping[str, int]
    at: tuple[Any, ...]
    left: tuple[Symbol, ...]
    along: tuple[Symbol, ...] = ()


BOTH, ONE, SHIFT = (v, v, u, u), (v, v, 0, 0), (u, u, 0, 0)
OF = {
    "addition": Law({"sncd": 1}, BOTH, (S_re, S_im, N_re, N_im)),
    "modulus": Law({"nnnn": 1, "ssss": -1}, BOTH, (N_re, N_im)),
    "zeta_addition": Law(
        {"nnnn": 1, "ssss": -1}, (0, v + u, v, u), (N_re, N_im, dN_re, dN_im), (a,)
    ),
    "circle": Law({"nncc": 1}, ONE, (v_n,)),
    "ellipse": Law({"nndd": 1}, ONE, (v_n,)),
    "shift_circle": Law({"nncc": 1}, SHIFT, (b_n,)),
    "shift_ellipse": Law({"nndd": 1}, SHIFT, (b_n,)),
    "sn_slope": Law({"sncd": 1}, ONE, (dv_s, dv_n), (c, d)),
    "cn_slope": Law({"cncn": 1}, ONE, (dv_c, dv_n), (c, d)),
    "dn_slope": Law({"dndn": 1}, ONE, (dv_d, dv_n), (c, d)),
}


@dataclass(frozen=True)
class Family:
    """The theta functions that are s, c, d, n, the arguments v and b, and the nome."""

    column: int
    functions: tuple[int, ...]
    v: str
    b: str
    nome: str

    def of(self, role: str, argument: Any, order: int = 0) -> Expr:
        """Return a function or its derivative."""
        function: Any = Function(self._name(role, order))
        return function(argument, Symbol(self.nome))

    def _name(self, role: str, order: int) -> str:
        return f"{'d' * order}theta{self.functions['scdn'.index(role)]}"

    def declared(self) -> dict[str, str]:
        """Return the declarations of the names."""
        at = {name: parts[self.column] for name, parts in PLACES.items()}

        def part(name: str, role: str, order: int = 0) -> str:
            which, argument = at.get(f"{name}_{role}", at.get(name, "re(0)")).rstrip(")").split("(")
            return f"{which}({self._name(role, order)}({argument}, {self.nome}))"

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

    def relation(self, top: str, *along: Symbol) -> Expr:
        """Return Riemann's relation for a product, or its derivative along arguments."""
        terms = 2 * self._product(top, HALF_SUMS, along)
        for roles, sign in RIEMANN[top].items():
            turns = abs(roles.count("s") - top.count("s")) // 2 if self.column else 0
            terms -= sign * (-1) ** turns * self._product(roles, ARGUMENTS, along)
        return terms

    def riemann(self, top: str, *along: Symbol) -> str:
        """Return the text of Riemann's relation."""
        return str(self.relation(top, *along))

    def _product(self, roles: str, forms: Any, along: tuple[Symbol, ...]) -> Expr:
        """Return a product, or its derivative."""
        pairs = [*zip(roles, forms, strict=True)]
        if not along:
            return Mul(*(self.of(*pair) for pair in pairs))
        speeds = (sum(form.coeff(x) for x in along) for _, form in pairs)
        return Add(
            *(
                speed * Mul(*(self.of(*pair, int(k == place)) for k, pair in enumerate(pairs)))
                for place, speed in enumerate(speeds)
            )
        )

    def identity(self, law: Law) -> Expr:
        """Return the sum of relations that a law is."""
        return Add(*(sign * self.relation(top, *law.along) for top, sign in law.tops.items()))

    @cached_property
    def laws(self) -> dict[str, tuple[Expr, Equations]]:
        """Return the identity behind each law, and the law's equations between the names."""
        found = {}
        for name, law in OF.items():
            identity = self.identity(law)
            unit = self._unit(next(iter(law.tops)), len(law.along))
            at = named(ARGUMENTS, law.at)
            factor, whole = (self.named(identity, at) / unit).expand().primitive()
            equations = []
            for part in (whole.coeff(I, k) for k in (0, 1)):
                right, left = part.as_independent(*law.left, as_Add=True)
                if left.value != 0:
                    equations.append((left.apply(factor_terms), -right))
            found[name] = identity / factor.value, equations
        return found

    def named(self, expression: Expr, at: Mapping[Symbol, Any]) -> Computation:
        """Return an expression in the functions by the names of their values at arguments."""
        return compute(expression).subs(at).xreplace(self._values).expand()

    def texts(self, at: Mapping[Symbol, Any]) -> dict[str, str]:
        """Return arguments as texts, with those of this family for v and u."""
        return {str(x): str(sympify(form).subs({v: self.v, u: self.b})) for x, form in at.items()}

    def _unit(self, roles: str, order: int) -> Expr:
        """Return what a product of this family has more than that of the circular one."""
        return (I ** roles.count("s") * (-I) ** min(order, 1)) if self.column else Integer(1)

    @cached_property
    def _values(self) -> dict[Expr, Expr]:
        """Return the values of the functions by the names."""
        found = {}
        for argument, rows in MEANT.items():
            for order, row in enumerate(rows):
                for role, value in zip("scdn", row, strict=True):
                    if value is None:
                        continue
                    odd = (role == "s") != bool(order)
                    here = self._unit(role, order) * value
                    found[self.of(role, argument, order)] = here
                    found[self.of(role, -argument, order)] = -here if odd else here
        return found


CIRCULAR = Family(0, (1, 2, 3, 4), "v", "-I*b", "nome_m**2")
HYPERBOLIC = Family(1, (1, 4, 3, 2), "I*v", "b", "nome_c")
# The order is that in which normal forms are found.
VALUES = ("null_c", "null_d", "null_n", "null_s", "S_re", "S_im", "db_n", "dv_n", "v_n", "b_n")
MORE = ("N_re", "N_im", "b_s", "b_c", "b_d", "v_s", "v_c", "v_d", "dv_s", "dv_c", "dv_d")
NAMES = (*VALUES, *MORE, "dN_re", "dN_im")
LAWS = {name: equations for name, (_, equations) in CIRCULAR.laws.items()}
UNITS = (
    *(null_c, null_d, null_n, null_s, b_n, v_n),
    v_n**2 * b_n**2 + v_s**2 * b_s**2,
)
# Modulus and scale; sn, cn, dn of v/g, and of b/g but for factors I; zeta functions of both.
JACOBI = {
    "root_k": null_c / null_d,
    "k_1": real("root_k")[0] ** 2,
    g: null_n * null_c / (null_d * null_s),
    "s": null_d * v_s / (null_c * v_n),
    "c": null_n * v_c / (null_c * v_n),
    "d": null_n * v_d / (null_d * v_n),
    "x": null_d * b_s / (null_c * b_n),
    "y": null_n * b_c / (null_c * b_n),
    "z": null_n * b_d / (null_d * b_n),
    "Z_u": g * dv_n / v_n,
    "zeta": g * db_n / b_n,
}


def prove(builder: LedgerBuilder, context: str, family: Family) -> None:
    """Prove the laws in a context that declares the functions of a family."""
    for name, (identity, equations) in family.laws.items():
        at = named(ARGUMENTS, OF[name].at)
        builder.theta(f"{context}.{name}", equations, str(identity), family.texts(at))
