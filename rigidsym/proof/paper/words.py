"""The paper's words in the language of contexts: what several vocabularies share."""

from collections.abc import Mapping

from rigidsym.proof.paper.printed import Vocabulary

Words = Mapping[str, str]


def same(text: str) -> Words:
    """Names that a context writes as the print does, but for the bar below an index."""
    return {name: name.replace("_", "") for name in text.split()}


def plain(text: str) -> Words:
    """Names that a context writes as the print does."""
    return {name: name for name in text.split()}


def su2(a: str, b: str, c: str, d: str) -> str:
    """The matrix (1) of the quaternion a + b i + c j + d k."""
    first, second = f"{a} + imaginary*({b})", f"{c} + imaginary*({d})"
    return f"matrix({first}, {second}, -({c}) + imaginary*({d}), {a} - imaginary*({b}))"


def algebra(x: str, y: str, z: str) -> str:
    """x A_1 + y A_2 + z A_3"""
    return su2("0", f"{x}/2", f"{y}/2", f"{z}/2")


RATES = same("Omega_1 Omega_2 Omega_3")
INERTIA = same("c_1 c_2 c_3")
BODY: Words = {**RATES, **INERTIA}
MOMENTUM: Words = {"M": algebra("M1", "M2", "M3"), "at(M, t)": algebra("M1", "M2", "M3")}
ROTATION: Words = {name: su2("q0", "q1", "q2", "q3") for name in ("R", "at(R, t)")}
# R M R^-1, which is constant; M(0) as it is by (22).
SEEN_FROM_SPACE = "*".join((ROTATION["R"], MOMENTUM["M"], su2("q0", "-q1", "-q2", "-q3")))
ANGLES: Words = {
    **{f"{f}(phi_{k})": f"{f}_phi{k}" for f in ("cos", "sin") for k in (1, 2, 3)},
    **{f"{f}(phi_{k} / 2)": f"{f}_half_phi{k}" for f in ("cos", "sin") for k in (1, 2, 3)},
    "e**(imaginary * phi_3)": "cos_phi3 + imaginary*sin_phi3",
    "e**(-(imaginary * phi_3))": "cos_phi3 - imaginary*sin_phi3",
}
ANGLE_RATES: Words = {f"D(phi_{k})": f"phi{k}_rate" for k in (1, 2, 3)}
BASIS = {f"A_{k}": f"A_{k}" for k in (1, 2, 3)}
THREE_TURNS = {**BASIS, "Rbar": "Rbar"}
REDUCED = Vocabulary({**BODY, **MOMENTUM, **ANGLES, "K": "K"})
AXES: Words = {
    **plain("c_i c_j c_k Omega_i Omega_j Omega_k H delta_i"),
    "at(Omega_i, t)": "Omega_i",
    "K**2": "K_squared",
}
# A motion with Omega_i = sqrt(s_i) sn, s_i and s_j being roots in Omega_i^2.
SINE: Words = {
    **plain("c_i Omega_i C_i t"),
    "at(Omega_i, 0)": "Omega_i",
    "at(D(Omega_i), 0)": "D(Omega_i)",
}
IN_RATE: Words = {"s_i": "s_i", "s_j": "s_j", "alpha": "alpha"}
# What (14) makes of them, mended: roots in (c_i Omega_i)^2.
IN_MOMENTUM: Words = {"s_i": "c_i**2*s_i", "s_j": "c_i**2*s_j", "alpha": "alpha/c_i**2"}
QUARTIC_AS_PRINTED = {name: f"{name}_printed" for name in ("alpha", "beta", "chi")}


def exchanged(words: Words) -> Words:
    """Two roots by each other's names."""
    first, second, *_ = words
    return {**words, first: words[second], second: words[first]}
