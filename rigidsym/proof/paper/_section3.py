"""Equations of Section III on angular velocities, from Lemma 1 to (17)."""

from dataclasses import replace

from rigidsym.proof.paper._equation import Condition, Equation, Flaw, Reading, Root, Sense
from rigidsym.proof.paper._printed import Second, Vocabulary
from rigidsym.proof.paper._shared import (
    BODY,
    IMAGINARY,
    SPINNING,
    Words,
    plain,
    stated,
    vanishing,
)

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
# The same by the repaired (14): roots in (c_i Omega_i)^2.
IN_MOMENTUM: Words = {"s_i": "c_i**2*s_i", "s_j": "c_i**2*s_j", "alpha": "alpha/c_i**2"}
QUARTIC_AS_PRINTED = {name: f"{name}_printed" for name in ("alpha", "beta", "chi")}


def exchanged(words: Words) -> Words:
    """Return a mapping with the values of its first two keys exchanged."""
    first, second, *_ = words
    return {**words, first: words[second], second: words[first]}


DISTINCT = (
    Condition("c_i != c_j", ("c_i - c_j",), (vanishing("equal_axes_j", "alpha"),)),
    Condition("c_i != c_k", ("c_i - c_k",), (vanishing("equal_axes_k", "alpha"),)),
)
S_I = Condition("s_i != 0", ("zeta",), (SPINNING,))
S_J = Condition("s_j != 0", ("s_j", "root_s"), (SPINNING,))
OVER_C_I = {
    Flaw.VARIABLE: "s_i is a root in Omega_i^2; divided by c_i it would be in (c_i Omega_i)^2"
}

TRIPLE = (("sn", "cn", "dn"),)
# The contexts for lines that do not divide by s_i, and for those that do.
UNDIVIDED, DIVIDED = "printed_sine", "printed_sine_divided"


def _sense(number: str, vocabulary: Vocabulary, *only: int, context: str = DIVIDED) -> Sense:
    """Return the translation of a printed line, with equation (14) taken as printed.

    s_i and s_j are roots of (14).
    """
    return Sense(context, vocabulary, of=number, only=only)


def _mended(sense: Sense, amplitude: int) -> Sense:
    """Change the translation of a printed line to use equation (14) as repaired.

    The roots are in (c_i Omega_i)^2, and the amplitude is multiplied by c_i.
    """
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
# The repaired (14) has the alpha of IN_MOMENTUM.
ALPHA_MENDED = replace(LEMMA_MENDED, says=(), texts={"alpha_printed": "alpha/c_i**2"})
# The quadratic with the roots s_i and s_j, which makes it a motion.
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


CONSERVED = Sense(
    "printed_6",
    Vocabulary({**BODY, "t": "0"}),
    {"H": "H_printed", "K**2": "K_squared_printed"},
    given=("6",),
    texts={"D(H_printed)": "0", "D(K_squared_printed)": "0"},
)

SECTION_3: tuple[Equation, ...] = (
    Equation(
        "Lemma 1",
        r"\Omega_i(t)\ \text{is (10) or (11), with (12) to (14)}",
        "the smallest repair is in (14): c_i^2 goes from the denominator of chi to that of alpha, "
        "and (13) gives the roots in (c_i Omega_i)^2 that (10) to (12), (16), (20), (21) expect",
        (LEMMA,),
        mended=(
            LEMMA_MENDED,
            THIRTEEN_MENDED,
            ALPHA_MENDED,
            SOLVES,
            TEN_MENDED,
            ELEVEN_MENDED,
            TWELVE_MENDED,
            *SIXTEEN_MENDED,
        ),
        roots=(Root.SCALE,),
        conditions=(*DISTINCT, S_I, S_J),
        repair=r"\alpha=-\frac{(c_i-c_j)(c_i-c_k)}{c_i^2c_jc_k},\ "
        r"\chi=-\frac{(2c_jH-K^2)(2c_kH-K^2)}{c_jc_k}",
        readings=(
            Reading(
                "the second argument of sn is the parameter",
                "(10), (20) mended and footnote 1 hold; (35) and (36) do not",
                (TEN_MENDED, FOOTNOTE_1),
            ),
            Reading(
                "the second argument of sn is the modulus",
                "(35) and (36) hold as they are printed; (10) and footnote 1 do not",
                (TEN_MODULUS, FOOTNOTE_1_MODULUS),
            ),
            Reading(
                "the constants are real, i is the middle axis",
                "both roots and alpha times either are squares",
                MIDDLE_REAL,
            ),
            Reading(
                "the constants are real, i is the third axis",
                "one root is minus a square, and by (13) that is s_i: it is never s_j, so that "
                "sqrt(s_i) and sqrt(alpha s_j) are imaginary, and real only together",
                (THIRD_REAL,),
            ),
            Reading(
                "the constants are real, i is the circulation axis",
                "the rate sqrt(alpha s) is imaginary for both roots, and so C_i is complex",
                (REAL_RATE, REAL_START),
            ),
        ),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "10",
        r"\Omega_i(t)=\frac{\sqrt{s_i}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_j}\,t+C_i,\ "
        r"\frac{s_i}{s_j}\right)\ \text{when}\ \left|\frac{s_i}{s_j}\right|\le1",
        "Omega_i = sqrt(s_i) sn solves the quartic of (14); divided by c_i it does not",
        (TEN,),
        mended=(replace(TEN, of=""), SOLVES),
        with_mended={"14": (TEN_MENDED,)},
        roots=(Root.SCALE,),
        repair=r"\Omega_i(t)=\sqrt{s_i}\,\mathrm{sn}(\pm\sqrt{\alpha s_j}\,t+C_i,\ s_i/s_j)",
        conditions=(S_J,),
        readings=(
            Reading(
                "sqrt(s_i) over c_i, s_i by (13) and (14)",
                "too small by the factor c_i",
                (TEN,),
            ),
            Reading(
                "sqrt of s_i/c_i, s_i by (13) and (14)",
                "too small by the factor sqrt(c_i)",
                (TEN_UNDER_ROOT,),
            ),
            Reading(
                "sqrt(s_i) over c_i, s_i a root in (c_i Omega_i)^2, alpha by (14)",
                "the right amplitude, at c_i times the rate",
                (TEN_MIXED,),
            ),
            Reading(
                "sqrt(s_i) over c_i, s_i and alpha by (14) as mended for Lemma 1",
                "(10) is right as it is printed",
                (TEN_MENDED,),
            ),
        ),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "11",
        r"\Omega_i(t)=\frac{\sqrt{s_j}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_i}\,t+"
        r"\sqrt{\tfrac{s_i}{s_j}}\,C_i,\ \frac{s_j}{s_i}\right)\ \text{otherwise}",
        "(10) by footnote 1",
        (ELEVEN,),
        mended=(replace(ELEVEN, of=""), SOLVES),
        with_mended={"14": (ELEVEN_MENDED,)},
        roots=(Root.SCALE,),
        repair=r"\Omega_i(t)=\sqrt{s_j}\,\mathrm{sn}(\pm\sqrt{\alpha s_i}\,t+"
        r"\sqrt{s_i/s_j}\,C_i,\ s_j/s_i)",
        conditions=(S_I, S_J),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "footnote 1",
        r"\sqrt\mu\,\mathrm{sn}(\zeta,\mu)=\mathrm{sn}(\sqrt\mu\,\zeta,\mu^{-1})",
        "mu is the parameter; both sides satisfy the same equations and vanish together",
        (FOOTNOTE_1,),
        conditions=(Condition("mu != 0", ("sqrt_mu",), (SPINNING,)),),
        flaws={Flaw.TWICE: "zeta, the argument here, is the amplitude in (34)"},
    ),
    Equation(
        "12",
        r"C_i=\mathrm{sn}^{-1}\!\left(\frac{c_i\Omega_i(0)}{\sqrt{s_i}},\ \frac{s_i}{s_j}\right)",
        "where (10) starts",
        (TWELVE,),
        mended=(replace(TWELVE, of=""),),
        with_mended={"14": (TWELVE_MENDED,)},
        roots=(Root.SCALE,),
        repair=r"C_i=\mathrm{sn}^{-1}(\Omega_i(0)/\sqrt{s_i},\ s_i/s_j)",
        conditions=(S_I, S_J),
        flaws={**OVER_C_I, Flaw.BRANCH: "sn takes the value at two real points a period"},
    ),
    Equation(
        "footnote 2",
        r"\text{the domain of an inverse elliptic function is}\ \mathbb C^2\ \text{as well}",
        "sn takes each value twice a period, with opposite cn; (12) does not say which is meant",
        (),
        conditions=(S_I, S_J),
        readings=(
            Reading(
                "complex arguments are allowed but not needed: C_i is real",
                "not on the circulation axis, where c_i Omega_i/sqrt(s_i) is out of reach of sn",
                (REAL_START,),
            ),
            Reading(
                "complex where it has to be, and the principal value",
                "Omega_i starts in the wrong direction where cn < 0, unless the sign is changed",
                (PRINCIPAL,),
            ),
            Reading(
                "complex where it has to be, any value, with the sign of Remark 1",
                "the other value with the other sign is the same motion",
                (OTHER_VALUE, SIGN),
            ),
        ),
        flaws={Flaw.BRANCH: "an inverse function on C^2 has several values"},
    ),
    Equation(
        "13",
        r"s_i=\frac{-\beta+\sqrt{\beta^2-4\alpha\chi}}{2\alpha},\ "
        r"s_j=\frac{-\beta-\sqrt{\beta^2-4\alpha\chi}}{2\alpha}",
        "roots in Omega_i^2 of the quadratic (14), not in (c_i Omega_i)^2",
        (THIRTEEN,),
        conditions=DISTINCT,
    ),
    Equation(
        "14",
        r"\alpha=-\frac{(c_i-c_j)(c_i-c_k)}{c_jc_k},\ "
        r"\beta=\frac{4c_jc_kH-2c_i(c_j+c_k)H+2c_iK^2-(c_j+c_k)K^2}{c_ic_jc_k},\ "
        r"\chi=-\frac{(2c_jH-K^2)(2c_kH-K^2)}{c_i^2c_jc_k}",
        "Omega_i'^2 = alpha Omega_i^4 + beta Omega_i^2 + chi",
        (FOURTEEN,),
        roots=(Root.SCALE,),
        readings=(
            Reading(
                "the quadratic is one in Omega_i^2",
                "alpha, beta and chi are right, and (10) to (12), (16), (20), (21) are not",
                (FOURTEEN,),
            ),
            Reading(
                "the quadratic is one in (c_i Omega_i)^2, as (10) to (12) take its roots",
                "c_i^2 stands below chi and is missing below alpha; mended, (10) to (12), (16), "
                "(20) and (21) are right as they are printed",
                (FOURTEEN_IN_MOMENTUM,),
            ),
        ),
    ),
    Equation("15", r"H,\ K^2\ \text{of (6) at}\ t=0", "they are conserved", (CONSERVED,)),
    Equation(
        "Remark 1",
        r"\text{The sign}\ \pm\ \text{in (11) is dependent on the initial conditions}",
        "the sign is that of cn at the start over that of cn at C_i",
        (),
        conditions=(S_I, S_J),
        readings=(
            Reading(
                "the sign of (11) only, + in (10)",
                "(10) starts in the wrong direction where cn < 0",
                (PRINCIPAL,),
            ),
            Reading(
                "the sign of whichever of (10) and (11) is used",
                "(17) always decides it, and either value of C_i will do",
                (SIGN, OTHER_VALUE),
            ),
            Reading(
                "s_j >= s_i is the condition of (10), |s_i/s_j| <= 1",
                "they differ on the third axis, where s_i < -s_j < 0",
                (CONDITIONS_DIFFER,),
            ),
            Reading(
                "s_j >= s_i is another condition, for (16) alone",
                "on the third axis the lines of (16), with principal roots, have opposite signs "
                "where s_i < -s_j: a sign found from one line runs (11) backwards",
                ON_THIRD_AXIS,
            ),
        ),
        flaws={
            Flaw.TWO_WAYS: "|s_i/s_j| <= 1 in (10), s_j >= s_i in (16)",
            Flaw.REFERENCE: "(11), where (10) and (11) are meant",
        },
    ),
    Equation(
        "16",
        r"\dot\Omega_i(0)=\pm\sqrt{\alpha s_j}\frac{\sqrt{s_i}}{c_i}\mathrm{cn}(C_i,"
        r"\tfrac{s_i}{s_j})\,\mathrm{dn}(C_i,\tfrac{s_i}{s_j})\ \text{when}\ s_j\ge s_i,\ "
        r"\pm\sqrt{\alpha s_i}\frac{\sqrt{s_j}}{c_i}\mathrm{cn}\!\left(\sqrt{\tfrac{s_i}{s_j}}"
        r"C_i,\tfrac{s_j}{s_i}\right)\mathrm{dn}\!\left(\sqrt{\tfrac{s_i}{s_j}}C_i,"
        r"\tfrac{s_j}{s_i}\right)\ \text{otherwise}",
        "the derivative of (10) at t = 0",
        SIXTEEN,
        mended=(replace(SIXTEEN[0], of="", only=()),),
        with_mended={"14": SIXTEEN_MENDED},
        roots=(Root.SCALE,),
        repair=r"\dot\Omega_i(0)=\pm\sqrt{\alpha s_j}\sqrt{s_i}\,\mathrm{cn}(C_i,s_i/s_j)\,"
        r"\mathrm{dn}(C_i,s_i/s_j)",
        conditions=(S_J,),
        flaws={**OVER_C_I, Flaw.TWO_WAYS: "|s_i/s_j| <= 1 in (10), s_j >= s_i here"},
    ),
    Equation(
        "17",
        r"\dot\Omega_i(0)=\delta_i\Omega_l(0)\Omega_k(0),\ l\ne k\ne i",
        "(5) at t = 0",
        (),
        readings=(
            Reading("l, k and i are three axes", "it is (5) at t = 0", (SEVENTEEN,)),
            Reading(
                "l differs from k, and k from i",
                "l = i is allowed, where it fails",
                (SEVENTEEN_WITH_L_I,),
            ),
        ),
        flaws={Flaw.WEAK: "l != k != i does not say that l != i"},
    ),
)
