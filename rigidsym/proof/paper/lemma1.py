"""How Lemma 1 and its lines are put: vocabularies and senses of (10) to (17)."""

from dataclasses import replace

from rigidsym.proof.paper.conditions import stated
from rigidsym.proof.paper.equation import Sense
from rigidsym.proof.paper.printed import Second, Vocabulary
from rigidsym.proof.paper.words import (
    AXES,
    IN_MOMENTUM,
    IN_RATE,
    QUARTIC_AS_PRINTED,
    SINE,
    exchanged,
)

TRIPLE = (("sn", "cn", "dn"),)
# Where nothing is divided by s_i, and where something is.
UNDIVIDED, DIVIDED = "printed_sine", "printed_sine_divided"


def _sense(number: str, vocabulary: Vocabulary, *only: int, context: str = DIVIDED) -> Sense:
    """A line about a motion, s_i and s_j being roots of (14) as it is printed."""
    return Sense(context, vocabulary, of=number, only=only)


def _mended(sense: Sense, amplitude: int) -> Sense:
    """The same with (14) mended: roots in (c_i Omega_i)^2, the amplitude so much larger."""
    words = sense.vocabulary.words
    small = words["s_i"] == IN_RATE["s_i"]
    mended = {**words, **(IN_MOMENTUM if small else exchanged(IN_MOMENTUM))}
    when = sense.vocabulary.when.replace("s_j - s_i", "c_i**2*(s_j - s_i)")
    roots = list(sense.vocabulary.roots)
    roots[amplitude] = f"c_i*{roots[amplitude]}"
    return replace(
        sense, vocabulary=replace(sense.vocabulary, words=mended, roots=tuple(roots), when=when)
    )


_SMALL, _LARGE = {**SINE, **IN_RATE}, {**SINE, **exchanged(IN_RATE)}
_PHASE, _OTHER_PHASE = ("xi*t + C_i",), ("xi*t + root_s/zeta*C_i",)
_MOVING = Vocabulary(_SMALL, ("zeta", "xi"), TRIPLE, arguments=_PHASE, when="1 - (s_i/s_j)**2")
TEN = _sense("10", _MOVING, context=UNDIVIDED)
TEN_MENDED = _mended(TEN, 0)
# The other way to read the broken fraction: the root of s_i/c_i.
TEN_UNDER_ROOT = replace(
    TEN,
    of="",
    latex=r"\Omega_i(t)=\sqrt{\tfrac{s_i}{c_i}}\,\mathrm{sn}(\pm\sqrt{\alpha s_j}\,t+C_i,s_i/s_j)",
    vocabulary=replace(_MOVING, roots=("root_over_c", "xi")),
    context="printed_under_root",
)
# s_i and s_j are roots in (c_i Omega_i)^2, but alpha is that of (14) as it is printed.
TEN_MIXED = replace(
    TEN_MENDED,
    vocabulary=Vocabulary(
        {**SINE, **IN_MOMENTUM, "alpha": "alpha"},
        ("c_i*zeta", "c_i*xi"),
        TRIPLE,
    ),
)
TEN_MODULUS = replace(TEN_MENDED, vocabulary=replace(TEN_MENDED.vocabulary, second=Second.MODULUS))
ELEVEN = _sense(
    "11", Vocabulary(_LARGE, ("zeta", "xi", "root_s/zeta"), TRIPLE, arguments=_OTHER_PHASE)
)
ELEVEN_MENDED = _mended(ELEVEN, 0)
TWELVE = _sense("12", Vocabulary(_SMALL, ("zeta",), TRIPLE))
TWELVE_MENDED = _mended(TWELVE, 0)
AT_0 = Vocabulary(_SMALL, ("xi", "zeta"), TRIPLE, arguments=("C_i",), moves=False)
SIXTEEN = (
    _sense("16", replace(AT_0, when="s_j - s_i"), 0, 2, context=UNDIVIDED),
    _sense(
        "16",
        replace(
            AT_0, words=_LARGE, roots=("xi", "zeta", "root_s/zeta"), arguments=("root_s/zeta*C_i",)
        ),
        3,
    ),
)
SIXTEEN_MENDED = tuple(_mended(sense, 1) for sense in SIXTEEN)
THIRTEEN = Sense(
    "printed_13",
    Vocabulary({**AXES, "s_i": "root_j", "s_j": "root_k"}, ("root_of_discriminant",)),
    QUARTIC_AS_PRINTED,
    given=("14",),
    of="13",
)
THIRTEEN_MENDED = replace(
    THIRTEEN,
    context="printed_13_mended",
    vocabulary=replace(
        THIRTEEN.vocabulary, words={**AXES, "s_i": "c_i**2*root_j", "s_j": "c_i**2*root_k"}
    ),
    mended=("Lemma 1",),
)
FOURTEEN = Sense(
    "printed_14",
    Vocabulary(AXES),
    QUARTIC_AS_PRINTED,
    (r"\dot\Omega_i^2=\alpha\Omega_i^4+\beta\Omega_i^2+\chi",),
)
_IN_MOMENTUM = r"(c_i\dot\Omega_i)^2=\alpha(c_i\Omega_i)^4+\beta(c_i\Omega_i)^2+\chi"
FOURTEEN_IN_MOMENTUM = replace(FOURTEEN, says=(_IN_MOMENTUM,))
# Lemma 1: (10) with (12), differentiated, squared and put at t = 0.
LEMMA = replace(FOURTEEN_IN_MOMENTUM, given=("14",), latex="")
LEMMA_MENDED = replace(LEMMA, context="printed_14_mended", mended=("Lemma 1",))
# Mended, (14) has the alpha of IN_MOMENTUM.
ALPHA_MENDED = replace(LEMMA_MENDED, says=(), texts={"alpha_printed": "alpha/c_i**2"})
# What makes it a motion: the quadratic with the roots s_i and s_j.
SOLVES = stated("sine", {"D(Omega_i)**2": "alpha*(s_i - Omega_i**2)*(s_j - Omega_i**2)"})
FOOTNOTE_1 = Sense(
    "printed_footnote_1",
    Vocabulary(
        {"mu": "mu", "zeta": "u"}, ("sqrt_mu",), (("sn", "cn", "dn"), ("sqrt_mu*sn", "dn", "cn"))
    ),
    of="footnote 1",
)
FOOTNOTE_1_MODULUS = replace(
    FOOTNOTE_1, vocabulary=replace(FOOTNOTE_1.vocabulary, second=Second.MODULUS)
)
SEVENTEEN = Sense(
    "axis",
    Vocabulary(
        {
            **AXES,
            "at(D(Omega_i), 0)": "D(Omega_i)",
            "at(Omega_l, 0)": "Omega_j",
            "at(Omega_k, 0)": "Omega_k",
        }
    ),
)
SEVENTEEN_WITH_L_I = replace(
    SEVENTEEN, vocabulary=Vocabulary({**SEVENTEEN.vocabulary.words, "at(Omega_l, 0)": "Omega_i"})
)
CIRCULATING_ROOTS = stated("circulating_axis", {"root_d": "A_a**2", "root_b": "m_1*A_a**2"})
REAL_RATE = stated(
    "circulating_axis", {"alpha_a*root_d": "lambda_**2", "alpha_a*root_b": "lambda_**2*m_1"}
)
REAL_START = stated("circulating_axis", {"root_b - Omega_a**2": "m*(A_a*cn)**2"})
MIDDLE_REAL = (
    stated("middle_axis", {"root_a": "A_b**2", "m*root_d": "A_b**2"}),
    stated("middle_axis", {"alpha_b*root_d": "lambda_**2", "alpha_b*root_a": "m*lambda_**2"}),
)
THIRD_REAL = stated("negative_root", {"s_i": "0"})
SIGN = stated("start", {"D(Omega_i)": "half*xi*zeta*cn_principal*dn"})
OTHER_VALUE = stated(
    "start",
    {
        "C**2 + S**2": "1",
        "E**2 + mu*S**2": "1",
        "D(S)": "-xi*C*E",
        "D(C)": "xi*S*E",
        "D(E)": "xi*mu*S*C",
    },
)
PRINCIPAL = stated("start", {"D(Omega_i)": "xi*zeta*cn_principal*dn"})
CONDITIONS_DIFFER = stated("two_conditions", {"s_i**2": "s_j**2"})
# On the third axis, with principal roots: s_i = -r^2 < 0 < s_j = q^2 and alpha s_j = -v^2 < 0, so
# that sqrt(s_i) sqrt(alpha s_j) is -r v and sqrt(s_j) sqrt(alpha s_i) is +r v.
_THIRD = {
    **SINE,
    "s_i": "-((c_i*r)**2)",
    "s_j": "(c_i*q)**2",
    "alpha": "-(v**2/(c_i*q)**2)",
}
_BY_LINE_1 = Vocabulary(
    _THIRD, ("imaginary*v", "imaginary*c_i*r"), (("-(imaginary*x)", "y", "w/q"),), moves=False
)
_BY_LINE_2 = replace(
    _BY_LINE_1, roots=("v*r/q", "c_i*q", "imaginary*r/q"), jacobi=(("x*r/q", "w/q", "y"),)
)
ON_THIRD_AXIS = (
    Sense("printed_third_axis", _BY_LINE_1, of="16", only=(0,)),
    Sense("printed_third_axis", _BY_LINE_2, of="16", only=(3,)),
)
