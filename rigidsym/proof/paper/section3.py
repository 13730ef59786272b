"""Section III, Lemma 1 to (17): the angular velocities."""

from rigidsym.proof.paper.conditions import DISTINCT, IMAGINARY, OVER_C_I, S_I, S_J
from rigidsym.proof.paper.equation import Condition, Equation, Flaw, Reading

SECTION_3: tuple[Equation, ...] = (
    Equation(
        "Lemma 1",
        r"\Omega_i(t)\ \text{is (10) or (11), with (12) to (14)}",
        "the smallest repair is in (14): c_i^2 goes from the denominator of chi to that of alpha, "
        "and (13) gives the roots in (c_i Omega_i)^2 that (10) to (12), (16), (20), (21) expect",
        (
            "axis.momentum_quartic",
            "distinct_axis.roots",
            "sine.with_14_mended",
            "sine.slope_with_14_mended",
            "start.value_with_14_mended",
            "start.sign",
            "reciprocal.footnote",
        ),
        ("sine.over_inertia", "distinct_axis.not_roots_in_momentum"),
        conditions=(*DISTINCT, S_I, S_J),
        repair=r"\alpha=-\frac{(c_i-c_j)(c_i-c_k)}{c_i^2c_jc_k},\ "
        r"\chi=-\frac{(2c_jH-K^2)(2c_kH-K^2)}{c_jc_k}",
        readings=(
            Reading(
                "the second argument of sn is the parameter",
                "(10), (20) mended and footnote 1 hold; (35) and (36) do not",
                ("sine.with_14_mended", "reciprocal.footnote", "amplitude.repaired"),
            ),
            Reading(
                "the second argument of sn is the modulus",
                "(35) and (36) hold as they are printed; (10) and footnote 1 do not",
                ("amplitude_of_modulus.printed",),
                ("sine.modulus", "reciprocal.modulus"),
            ),
            Reading(
                "the constants are real, i is the middle axis",
                "both roots and alpha times either are squares",
                ("middle_axis.roots", "middle_axis.rates"),
            ),
            Reading(
                "the constants are real, i is the third axis",
                "one root is minus a square; it has to be s_j, which (13) does not always say",
                ("third_axis.roots", "third_axis.rates"),
                ("negative_root.amplitude",),
            ),
            Reading(
                "the constants are real, i is the circulation axis",
                "the rate sqrt(alpha s) is imaginary for both roots, and so C_i is complex",
                ("circulating_axis.roots", "circulating_axis.outer", "circulating_axis.inner"),
                ("circulating_axis.real_rate", "circulating_axis.real_start"),
            ),
        ),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "10",
        r"\Omega_i(t)=\frac{\sqrt{s_i}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_j}\,t+C_i,\ "
        r"\frac{s_i}{s_j}\right)\ \text{when}\ \left|\frac{s_i}{s_j}\right|\le1",
        "Omega_i = sqrt(s_i) sn solves the quartic of (14); divided by c_i it does not",
        ("sine.solves",),
        ("sine.over_inertia",),
        repair=r"\Omega_i(t)=\sqrt{s_i}\,\mathrm{sn}(\pm\sqrt{\alpha s_j}\,t+C_i,\ s_i/s_j)",
        repair_form="Omega_printed = zeta*sn",
        conditions=(S_J,),
        readings=(
            Reading(
                "sqrt(s_i) over c_i, s_i by (13) and (14)",
                "too small by the factor c_i",
                ("sine.solves",),
                ("sine.over_inertia",),
            ),
            Reading(
                "sqrt of s_i/c_i, s_i by (13) and (14)",
                "too small by the factor sqrt(c_i)",
                ("sine.solves",),
                ("sine.inertia_under_root",),
            ),
            Reading(
                "sqrt(s_i) over c_i, s_i a root in (c_i Omega_i)^2, alpha by (14)",
                "the right amplitude, at c_i times the rate",
                ("sine.with_14_mended",),
                ("sine.roots_in_momentum",),
            ),
        ),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "11",
        r"\Omega_i(t)=\frac{\sqrt{s_j}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_i}\,t+"
        r"\sqrt{\tfrac{s_i}{s_j}}\,C_i,\ \frac{s_j}{s_i}\right)\ \text{otherwise}",
        "(10) by footnote 1",
        ("sine.solves", "reciprocal.footnote"),
        ("sine.over_inertia",),
        repair=r"\Omega_i(t)=\sqrt{s_j}\,\mathrm{sn}(\pm\sqrt{\alpha s_i}\,t+"
        r"\sqrt{s_i/s_j}\,C_i,\ s_j/s_i)",
        repair_form="Omega_printed = zeta*sn",
        conditions=(S_I, S_J),
        flaws={**OVER_C_I, **IMAGINARY},
    ),
    Equation(
        "footnote 1",
        r"\sqrt\mu\,\mathrm{sn}(\zeta,\mu)=\mathrm{sn}(\sqrt\mu\,\zeta,\mu^{-1})",
        "mu is the parameter; both sides satisfy the same equations and vanish together",
        ("reciprocal.footnote",),
        conditions=(Condition("mu != 0", ("sqrt_mu",), ("spinning.root",)),),
        flaws={Flaw.TWICE: "zeta, the argument here, is the amplitude in (34)"},
    ),
    Equation(
        "12",
        r"C_i=\mathrm{sn}^{-1}\!\left(\frac{c_i\Omega_i(0)}{\sqrt{s_i}},\ \frac{s_i}{s_j}\right)",
        "where (10) starts",
        ("start.value",),
        ("start.over_inertia",),
        repair=r"C_i=\mathrm{sn}^{-1}(\Omega_i(0)/\sqrt{s_i},\ s_i/s_j)",
        repair_form="sn = Omega_i/zeta",
        conditions=(S_I, S_J),
        flaws={**OVER_C_I, Flaw.BRANCH: "sn takes the value at two real points a period"},
    ),
    Equation(
        "footnote 2",
        r"\text{the domain of an inverse elliptic function is}\ \mathbb C^2\ \text{as well}",
        "sn takes each value twice a period, with opposite cn; (12) does not say which is meant",
        ("start.other_value", "start.sign"),
        conditions=(S_I, S_J),
        readings=(
            Reading(
                "complex arguments are allowed but not needed: C_i is real",
                "not on the circulation axis, where c_i Omega_i/sqrt(s_i) is out of reach of sn",
                ("circulating_axis.start",),
                ("circulating_axis.real_start",),
            ),
            Reading(
                "complex where it has to be, and the principal value",
                "Omega_i starts in the wrong direction where cn < 0, unless the sign is changed",
                (),
                ("start.principal_value",),
            ),
            Reading(
                "complex where it has to be, any value, with the sign of Remark 1",
                "the other value with the other sign is the same motion",
                ("start.other_value", "start.sign"),
            ),
        ),
        flaws={Flaw.BRANCH: "an inverse function on C^2 has several values"},
    ),
    Equation(
        "13",
        r"s_i=\frac{-\beta+\sqrt{\beta^2-4\alpha\chi}}{2\alpha},\ "
        r"s_j=\frac{-\beta-\sqrt{\beta^2-4\alpha\chi}}{2\alpha}",
        "roots in Omega_i^2 of the quadratic (14), not in (c_i Omega_i)^2",
        ("distinct_axis.roots", "distinct_axis.discriminant"),
        conditions=DISTINCT,
    ),
    Equation(
        "14",
        r"\alpha=-\frac{(c_i-c_j)(c_i-c_k)}{c_jc_k},\ "
        r"\beta=\frac{4c_jc_kH-2c_i(c_j+c_k)H+2c_iK^2-(c_j+c_k)K^2}{c_ic_jc_k},\ "
        r"\chi=-\frac{(2c_jH-K^2)(2c_kH-K^2)}{c_i^2c_jc_k}",
        "Omega_i'^2 = alpha Omega_i^4 + beta Omega_i^2 + chi",
        ("axis.quartic",),
    ),
    Equation("15", r"H,\ K^2\ \text{of (6) at}\ t=0", "they are conserved", ("body.conserved",)),
    Equation(
        "Remark 1",
        r"\text{The sign}\ \pm\ \text{in (11) is dependent on the initial conditions}",
        "the sign is that of cn at the start over that of cn at C_i",
        ("start.sign", "start.other_value"),
        conditions=(S_I, S_J),
        readings=(
            Reading(
                "the sign of (11) only, + in (10)",
                "(10) starts in the wrong direction where cn < 0",
                (),
                ("start.principal_value",),
            ),
            Reading(
                "the sign of whichever of (10) and (11) is used",
                "(17) always decides it, and either value of C_i will do",
                ("start.sign", "start.other_value"),
            ),
            Reading(
                "s_j >= s_i is the condition of (10), |s_i/s_j| <= 1",
                "they differ on the third axis, where s_i < -s_j < 0",
                ("two_conditions.names",),
                ("two_conditions.differ",),
            ),
            Reading(
                "s_j >= s_i is another condition, for (16) alone",
                "both lines are the same function, so either condition will do",
                ("reciprocal.footnote",),
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
        ("sine.slope",),
        ("sine.slope_over_inertia",),
        repair=r"\dot\Omega_i(0)=\pm\sqrt{\alpha s_j}\sqrt{s_i}\,\mathrm{cn}(C_i,s_i/s_j)\,"
        r"\mathrm{dn}(C_i,s_i/s_j)",
        repair_form="D(Omega_i) = xi*zeta*cn*dn",
        conditions=(S_J,),
        flaws={**OVER_C_I, Flaw.TWO_WAYS: "|s_i/s_j| <= 1 in (10), s_j >= s_i here"},
    ),
    Equation(
        "17",
        r"\dot\Omega_i(0)=\delta_i\Omega_l(0)\Omega_k(0),\ l\ne k\ne i",
        "(5) at t = 0",
        ("axis.rate",),
        readings=(
            Reading("l, k and i are three axes", "it is (5) at t = 0", ("axis.rate",)),
            Reading(
                "l differs from k, and k from i",
                "l = i is allowed, where it fails",
                (),
                ("axis.rate_with_l_i",),
            ),
        ),
        flaws={Flaw.WEAK: "l != k != i does not say that l != i"},
    ),
)
