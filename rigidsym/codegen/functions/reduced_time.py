"""The argument at t = 0 and at any time, reduced by half periods: the same in every form.

v is u_1 in half turns of 2 K_1; near the separatrix y is u_1 in units of 2 K_c/pi, K_c being the
quarter period of the complementary modulus, and a half period of it is what grows without end.
"""

from rigidsym.codegen.ir import EXACT_SUM, Let, let
from rigidsym.codegen.special_functions import reduction


def circular_time() -> list[Let]:
    """v in half turns: the whole ones, and the rest."""
    return [
        *reduction.product("p", "v_rate", extra="v_lo"),
        *reduction.total("v", "p", "v_hi"),
        *reduction.whole("v", "v"),
        let("v_turns = v_rest + (p_error + v_error)", reduction.TURNS),
    ]


def hyperbolic_time(half_period: str) -> list[Let]:
    """y less its nearest half period; half_period: the reference for what one of them does."""
    return [
        *reduction.product("p_y", "y_rate", extra="y0_lo"),
        let("periods = nearest((p_y + y0_hi)*period_inverse)", half_period),
        *reduction.product("back", "period", "periods", later=False),
        *reduction.total("ahead", "p_y", "-back"),
        *reduction.total("y_near", "ahead", "y0_hi"),
        let("y = y_near + (y_near_error + (ahead_error + (p_y_error - back_error)))", half_period),
    ]


def elapsed_time(half_period: str) -> list[Let]:
    """The same from y = 0 at t = 0, as y + y_lo."""
    return [
        *reduction.product("p_y", "y_rate"),
        let("periods = nearest(p_y*period_inverse)", half_period),
        *reduction.product("back", "period", "periods", later=False),
        *reduction.total("ahead", "p_y", "-back"),
        let("y_rest = ahead_error + (p_y_error - back_error)", half_period),
        let("y = ahead + y_rest", half_period),
        let("y_lo = (ahead - y) + y_rest", EXACT_SUM),
    ]


def elapsed_phase(half_period: str) -> list[Let]:
    """The same from the phase that there was, as z + z_lo, after `elapsed_time`."""
    return [
        let("turns = nearest((p_y + z0_hi)*period_inverse)", half_period),
        *reduction.product("behind", "period", "turns", later=False),
        *reduction.total("beyond", "p_y", "-behind"),
        *reduction.total("z_near", "beyond", "z0_hi"),
        let("z_rest = z_near_error + (beyond_error + ((p_y_error + z0_lo) - behind_error))"),
        let("z = z_near + z_rest", half_period),
        let("z_lo = (z_near - z) + z_rest", EXACT_SUM),
    ]


def hyperbolic_turns() -> list[Let]:
    """What Lambda and the half periods turn, in half turns: the whole ones, and the rest."""
    return [
        *reduction.product("L", "Lambda_rate"),
        *reduction.whole("L", "L"),
        *reduction.product("j", "jump", "periods", later=False),
        *reduction.whole("j", "j"),
        *reduction.total("turned", "L_rest", "j_rest"),
        *reduction.whole("turned", "turned"),
        let("turns = turned_rest + (turned_error + (L_error + j_error))", reduction.TURNS),
        let("whole = L_whole + (j_whole + turned_whole)", reduction.TURNS),
    ]


def imaginary_phase(ladder: str) -> list[Let]:
    """sinh(y) at t = 0, at the bottom of the ladder of the complementary modulus."""
    return [
        # Past K/2 the phase is reflected to K - u: sc(K - u) = cs(u)/k' (DLMF 22.4(iii)).
        let("size_s = size(s)", "DLMF 22.4.3"),
        let("near = rounded(c*c)", "DLMF 22.4.3"),
        let("far = rounded(kc_1*(s*s))", "DLMF 22.4.3"),
        let("above = choose(far, near, size_s, c)", "DLMF 22.4.3"),
        let("below = choose(far, near, c, kc_1*size_s)", "DLMF 22.4.3"),
        let("xi = above/below", "DLMF 22.6.7"),
        let(ladder, "DLMF 19.8.12"),
    ]


def period_bounds(vanished: str, half_period: str) -> list[Let]:
    """The half period of y where it ends, and its inverse; `vanished` is 0 on the separatrix."""
    return [
        let(f"period_far = choose({vanished}, 0, never, rounded(period))", half_period),
        let(f"period_d = rounded(choose({vanished}, 0, 1, period))", half_period),
        let(f"period_inverse = choose({vanished}, 0, 0, 1/period_d)", half_period),
    ]


def phase_at_start(*parity: str) -> list[Let]:
    """y at t = 0, from its hyperbolic sine; parity: the reference for what its sign does."""
    return [
        let("cosh_y = sqrt(1 + Y_b*Y_b)", "DLMF 4.35.11"),
        let("y_b = _logarithm(Y_b + cosh_y)", "DLMF 4.37.16"),
        let("y_size = choose(far, near, y_b, period/2 - y_b)", "DLMF 22.4.3"),
        let("side = choose(0, rounded(s), 1, -1)", *parity),
        let("y0 = side*y_size"),
        let("y_rate = mu*gc"),
    ]
