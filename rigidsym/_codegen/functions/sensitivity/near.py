"""The integrals of S_t^2 and S_t^2/D_t^2 for short times, by Taylor's series in t^2.

Both squares y satisfy y'' = 2 + 4 A y + 6 B y^2: A = -(p + r), B = p r for S_t^2, and A = 2 r - p,
B = -r (p - r) for S_t^2/D_t^2.  Their poles are at lambda t = pi/2 or farther, which p t^2 <= 1/16
stays a sixth of: each term is below a thirty-ninth of the one before, and TERMS leave out less than
2^-52 of what is there.
"""

from rigidsym._codegen.ir import Let, let
from rigidsym._codegen.special_functions.polynomials import horner

TERMS = 10
# Up to here p t^2 is small; and so small that S_t is t.
NEAR, TINY = "1/16", "1/18014398509481984"
_SOURCE = "DLMF 22.10"
COEFFICIENTS = tuple(f"{x}_{n}" for x in "EF" for n in range(TERMS))


def coefficients() -> list[Let]:
    """State the coefficients of t^3 t^(2 n) in both integrals, from p, r and p - r."""
    lets = [
        let("p_d = rounded(p)"),
        let("r_d = rounded(r)"),
        let("apart_d = rounded(apart)"),
        let("E_one = -4*(p_d + r_d)", _SOURCE),
        let("E_two = 6*(p_d*r_d)", _SOURCE),
        let("F_one = 4*(r_d - apart_d)", _SOURCE),
        let("F_two = -6*(r_d*apart_d)", _SOURCE),
    ]
    return [*lets, *_of("E"), *_of("F")]


def _of(name: str) -> list[Let]:
    """State those of one: square_n of t^(2 n + 2) in the square, and it over 2 n + 3."""
    square = f"{name}_square"
    lets = [let(f"{square}_0 = 1", _SOURCE), let(f"{name}_0 = 1/3", _SOURCE)]
    for n in range(1, TERMS):
        products = " + ".join(f"{square}_{i}*{square}_{n - 2 - i}" for i in range(n - 1))
        more = f" + {name}_two*({products})" if products else ""
        lets += [
            let(
                f"{square}_{n} = ({name}_one*{square}_{n - 1}{more})/{(2 * n + 2) * (2 * n + 1)}",
                _SOURCE,
            ),
            let(f"{name}_{n} = {square}_{n}/{2 * n + 3}", _SOURCE),
        ]
    return lets


def growth() -> list[Let]:
    """State p t^2, by which times are near."""
    return [let("t2 = t*t", _SOURCE), let("growth = p*t2", _SOURCE)]


def sine(far: str) -> Let:
    """State S_t, which is t where p t^2 is tiny: p may be below what products keep then."""
    return let(f"S_t = choose(growth, {TINY}, t, {far})", "DLMF 22.2.4")


def root() -> Let:
    """State S_t as the root of E_t's slope, where the far form would be a difference."""
    square = horner("t2", [f"{2 * n + 3}*E_{n}" for n in range(TERMS)])
    return let(f"S_near = t*sqrt(size({square}))", _SOURCE)


def values() -> list[Let]:
    """State both integrals near t = 0."""
    rows = {x: [f"{x}_{n}" for n in range(TERMS)] for x in "EF"}
    return [
        let(f"E_near = t*t2*({horner('t2', rows['E'])})", _SOURCE),
        let(f"F_near = t*t2*({horner('t2', rows['F'])})", _SOURCE),
    ]
