"""Section III, Lemma 1 to (17): the angular velocities."""

from dataclasses import replace

from rigidsym.proof.paper import lemma1
from rigidsym.proof.paper.conditions import DISTINCT, IMAGINARY, OVER_C_I, S_I, S_J, SPINNING
from rigidsym.proof.paper.equation import Condition, Equation, Flaw, Reading, Root, Sense
from rigidsym.proof.paper.printed import Vocabulary
from rigidsym.proof.paper.words import BODY

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
        (lemma1.LEMMA,),
        mended=(
            lemma1.LEMMA_MENDED,
            lemma1.THIRTEEN_MENDED,
            lemma1.ALPHA_MENDED,
            lemma1.SOLVES,
            lemma1.TEN_MENDED,
            lemma1.ELEVEN_MENDED,
            lemma1.TWELVE_MENDED,
            *lemma1.SIXTEEN_MENDED,
        ),
        roots=(Root.SCALE,),
        conditions=(*DISTINCT, S_I, S_J),
        repair=r"\alpha=-\frac{(c_i-c_j)(c_i-c_k)}{c_i^2c_jc_k},\ "
        r"\chi=-\frac{(2c_jH-K^2)(2c_kH-K^2)}{c_jc_k}",
        readings=(
            Reading(
                "the second argument of sn is the parameter",
                "(10), (20) mended and footnote 1 hold; (35) and (36) do not",
                (lemma1.TEN_MENDED, lemma1.FOOTNOTE_1),
            ),
            Reading(
                "the second argument of sn is the modulus",
                "(35) and (36) hold as they are printed; (10) and footnote 1 do not",
                (lemma1.TEN_MODULUS, lemma1.FOOTNOTE_1_MODULUS),
            ),
            Reading(
                "the constants are real, i is the middle axis",
                "both roots and alpha times either are squares",
                lemma1.MIDDLE_REAL,
            ),
            Reading(
                "the constants are real, i is the third axis",
                "one root is minus a square, and by (13) that is s_i: it is never s_j, so that "
                "sqrt(s_i) and sqrt(alpha s_j) are imaginary, and real only together",
                (lemma1.THIRD_REAL,),
            ),
            Reading(
                "the constants are real, i is the circulation axis",
                "the rate sqrt(alpha s) is imaginary for both roots, and so C_i is complex",
                (lemma1.REAL_RATE, lemma1.REAL_START),
            ),
        ),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "10",
        r"\Omega_i(t)=\frac{\sqrt{s_i}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_j}\,t+C_i,\ "
        r"\frac{s_i}{s_j}\right)\ \text{when}\ \left|\frac{s_i}{s_j}\right|\le1",
        "Omega_i = sqrt(s_i) sn solves the quartic of (14); divided by c_i it does not",
        (lemma1.TEN,),
        mended=(replace(lemma1.TEN, of=""), lemma1.SOLVES),
        with_mended={"14": (lemma1.TEN_MENDED,)},
        roots=(Root.SCALE,),
        repair=r"\Omega_i(t)=\sqrt{s_i}\,\mathrm{sn}(\pm\sqrt{\alpha s_j}\,t+C_i,\ s_i/s_j)",
        conditions=(S_J,),
        readings=(
            Reading(
                "sqrt(s_i) over c_i, s_i by (13) and (14)",
                "too small by the factor c_i",
                (lemma1.TEN,),
            ),
            Reading(
                "sqrt of s_i/c_i, s_i by (13) and (14)",
                "too small by the factor sqrt(c_i)",
                (lemma1.TEN_UNDER_ROOT,),
            ),
            Reading(
                "sqrt(s_i) over c_i, s_i a root in (c_i Omega_i)^2, alpha by (14)",
                "the right amplitude, at c_i times the rate",
                (lemma1.TEN_MIXED,),
            ),
            Reading(
                "sqrt(s_i) over c_i, s_i and alpha by (14) as mended for Lemma 1",
                "(10) is right as it is printed",
                (lemma1.TEN_MENDED,),
            ),
        ),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "11",
        r"\Omega_i(t)=\frac{\sqrt{s_j}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_i}\,t+"
        r"\sqrt{\tfrac{s_i}{s_j}}\,C_i,\ \frac{s_j}{s_i}\right)\ \text{otherwise}",
        "(10) by footnote 1",
        (lemma1.ELEVEN,),
        mended=(replace(lemma1.ELEVEN, of=""), lemma1.SOLVES),
        with_mended={"14": (lemma1.ELEVEN_MENDED,)},
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
        (lemma1.FOOTNOTE_1,),
        conditions=(Condition("mu != 0", ("sqrt_mu",), (SPINNING,)),),
        flaws={Flaw.TWICE: "zeta, the argument here, is the amplitude in (34)"},
    ),
    Equation(
        "12",
        r"C_i=\mathrm{sn}^{-1}\!\left(\frac{c_i\Omega_i(0)}{\sqrt{s_i}},\ \frac{s_i}{s_j}\right)",
        "where (10) starts",
        (lemma1.TWELVE,),
        mended=(replace(lemma1.TWELVE, of=""),),
        with_mended={"14": (lemma1.TWELVE_MENDED,)},
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
                (lemma1.REAL_START,),
            ),
            Reading(
                "complex where it has to be, and the principal value",
                "Omega_i starts in the wrong direction where cn < 0, unless the sign is changed",
                (lemma1.PRINCIPAL,),
            ),
            Reading(
                "complex where it has to be, any value, with the sign of Remark 1",
                "the other value with the other sign is the same motion",
                (lemma1.OTHER_VALUE, lemma1.SIGN),
            ),
        ),
        flaws={Flaw.BRANCH: "an inverse function on C^2 has several values"},
    ),
    Equation(
        "13",
        r"s_i=\frac{-\beta+\sqrt{\beta^2-4\alpha\chi}}{2\alpha},\ "
        r"s_j=\frac{-\beta-\sqrt{\beta^2-4\alpha\chi}}{2\alpha}",
        "roots in Omega_i^2 of the quadratic (14), not in (c_i Omega_i)^2",
        (lemma1.THIRTEEN,),
        conditions=DISTINCT,
    ),
    Equation(
        "14",
        r"\alpha=-\frac{(c_i-c_j)(c_i-c_k)}{c_jc_k},\ "
        r"\beta=\frac{4c_jc_kH-2c_i(c_j+c_k)H+2c_iK^2-(c_j+c_k)K^2}{c_ic_jc_k},\ "
        r"\chi=-\frac{(2c_jH-K^2)(2c_kH-K^2)}{c_i^2c_jc_k}",
        "Omega_i'^2 = alpha Omega_i^4 + beta Omega_i^2 + chi",
        (lemma1.FOURTEEN,),
        roots=(Root.SCALE,),
        readings=(
            Reading(
                "the quadratic is one in Omega_i^2",
                "alpha, beta and chi are right, and (10) to (12), (16), (20), (21) are not",
                (lemma1.FOURTEEN,),
            ),
            Reading(
                "the quadratic is one in (c_i Omega_i)^2, as (10) to (12) take its roots",
                "c_i^2 stands below chi and is missing below alpha; mended, (10) to (12), (16), "
                "(20) and (21) are right as they are printed",
                (lemma1.FOURTEEN_IN_MOMENTUM,),
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
                (lemma1.PRINCIPAL,),
            ),
            Reading(
                "the sign of whichever of (10) and (11) is used",
                "(17) always decides it, and either value of C_i will do",
                (lemma1.SIGN, lemma1.OTHER_VALUE),
            ),
            Reading(
                "s_j >= s_i is the condition of (10), |s_i/s_j| <= 1",
                "they differ on the third axis, where s_i < -s_j < 0",
                (lemma1.CONDITIONS_DIFFER,),
            ),
            Reading(
                "s_j >= s_i is another condition, for (16) alone",
                "on the third axis the lines of (16), with principal roots, have opposite signs "
                "where s_i < -s_j: a sign found from one line runs (11) backwards",
                lemma1.ON_THIRD_AXIS,
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
        lemma1.SIXTEEN,
        mended=(replace(lemma1.SIXTEEN[0], of="", only=()),),
        with_mended={"14": lemma1.SIXTEEN_MENDED},
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
            Reading("l, k and i are three axes", "it is (5) at t = 0", (lemma1.SEVENTEEN,)),
            Reading(
                "l differs from k, and k from i",
                "l = i is allowed, where it fails",
                (lemma1.SEVENTEEN_WITH_L_I,),
            ),
        ),
        flaws={Flaw.WEAK: "l != k != i does not say that l != i"},
    ),
)
