# ---
# jupyter:
#   jupytext:
#     cell_metadata_filter: tags,-all
#     formats: ipynb,py:percent
#     notebook_metadata_filter: kernelspec,jupytext,-jupytext.text_representation.jupytext_version
#     text_representation:
#       extension: .py
#       format_name: percent
#       format_version: '1.3'
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # The $\phi_1$ integral and $\Pi$
#
# [Notebook 2](02_from_lax_pair_to_k_a1.ipynb) turned the momentum onto the axis $A_1$ and read two of
# the three angles of $\bar R=\exp(\phi_1A_1)\exp(\phi_2A_2)\exp(\phi_3A_1)$ off the momentum in the
# body. The angle $\phi_1$ that is left is the turn
# about the momentum itself. In the words of Euler's angles: $\phi_3$ is the spin of the body about
# its own first axis, $\phi_2$ the nutation of that axis, and $\phi_1$ its precession about the momentum.
#
# Here $\phi_1$ is found, along equations (30) to (36): its rate from the kinematics, the rate as a
# function of $\Omega_1$ alone, and its integral as Legendre's integral of the third kind. The
# derivation is in `derivations/kinematics.py`, `phi1_integral.py` and `winding.py`, which the next
# cell runs.

# %%
import matplotlib.pyplot as plt
import mpmath as mp
import numpy as np
from IPython.display import display

from derivations.conjugacy import rotation
from rigidsym import TorqueFreeMotion
from rigidsym.io.cases import paper_case
from rigidsym.proof.algebra.jacobi_functions import NUMPY
from rigidsym.proof.kernel import Grade
from support import definitions, derived, grades, printed, sealed, show

ledger = derived("kinematics", "phi1_integral", "winding")
f"{len(ledger.facts)} facts in {len(ledger.contexts)} contexts"

# %% [markdown]
# ## The angular velocity in terms of the angles
#
# Put $\bar R$ into $\bar R^{-1}\dot{\bar R}=\Omega$. In the context `turning` the half angles move by
# $D\cos\frac{\phi_k}2=-\frac12\dot\phi_k\sin\frac{\phi_k}2$ and so on, with rates that nothing is said
# about. The diagonal of $\bar R^{-1}\dot{\bar R}$, multiplied out in half angles:

# %%
turning = ledger.rings["turning"]
R = rotation(turning)
velocity = R.inverse() @ R.rate()
print("terms of the upper left entry, imaginary part:", len(velocity.a.imag.numerator))
print("after division by the relations:              ", end=" ")
print(len(turning.reduce(velocity.a.imag.numerator)[1]))
display(printed("R^-1 dR/dt"))
display(show(ledger, "turning.display"))

assert grades(ledger, "turning.display") == {Grade.PROVED}

# %% [markdown]
# Its off-diagonal entries, compared with those of $\Omega$, are (30). Each equation of (31) is one of
# (30) times the phase that makes the right side free of $\phi_3$; their sum has no $\dot\phi_2$ left:
#
# $$\dot\phi_1\sin\phi_2=\Omega_2\sin\phi_3+\Omega_3\cos\phi_3 .$$
#
# Here enters notebook 2, with $c_2\Omega_2=K\sin\phi_2\sin\phi_3$ and
# $c_3\Omega_3=K\sin\phi_2\cos\phi_3$.

# %%
display(printed("30", "31", "32"))
display(show(ledger, "line32.sum_of_31", "line32.rate"))

assert grades(ledger, "turning.off_diagonal", "turning.companion") == {Grade.PROVED}
assert grades(ledger, "turning.divided", "turning.sum") == {Grade.PROVED}
assert grades(ledger, "line32.sum_of_31", "line32.rate") == {Grade.PROVED}

# %% [markdown]
# The quotient (32) needs $\sin\phi_2\ne0$: where the momentum points along axis 1, numerator and
# denominator both vanish, and the angles $\phi_1$ and $\phi_3$ turn about the same axis. The
# *definition* that the derivation moves the angles by is regular even there,

# %%
definitions(ledger, "three_angle_motion", "phi1_rate", "phi2_rate", "phi3_rate")

# %% [markdown]
# so $\dot\phi_1$ always lies between $K/c_2$ and $K/c_3$: **$\phi_1$ never turns back.** That these
# three rates make up a motion, satisfying both the kinematics (3) and Euler's equations (5), is the
# converse that the paper leaves to its reader. It is proved as well.

# %%
display(show(ledger, "three_angle_motion.euler", "on_axis.denominators"))

assert grades(ledger, "three_angle_motion.kinematics", "three_angle_motion.euler") == {Grade.PROVED}
assert grades(ledger, "on_axis.denominators") == {Grade.PROVED}

# %% [markdown]
# ## One function of time is enough
#
# By the conserved quantities (6), $c_2\Omega_2^2+c_3\Omega_3^2=2H-c_1\Omega_1^2$ and
# $(c_2\Omega_2)^2+(c_3\Omega_3)^2=K^2-(c_1\Omega_1)^2$. So the rate of $\phi_1$ depends on
# $\Omega_1$ alone:

# %%
display(show(ledger, "line32.by_invariants"))

assert grades(ledger, "line32.by_invariants") == {Grade.PROVED}

# %% [markdown]
# By Lemma 1, $\Omega_1=\zeta\,\mathrm{sn}(\xi t+\gamma\,|\,\mu)$, and partial fractions split the
# integrand into a constant and the integrand of an elliptic integral of the third kind. The
# hypothesis that this costs is that the momentum does not meet axis 1, $c_1\Omega_1\ne\pm K$.

# %%
display(show(ledger, "sine_motion.split"))
print("not zero:", ", ".join(ledger.contexts["sine_motion"].units))
display(show(ledger, "pole_plus.denominator", "pole_minus.denominator"))

assert grades(ledger, "sine_motion.split") == {Grade.PROVED}
assert grades(ledger, "pole_plus.denominator", "pole_minus.denominator") == {Grade.PROVED}

# %% [markdown]
# ## The amplitude, and a misprint
#
# Take the amplitude $\vartheta=\mathrm{am}(\xi t+\gamma\,|\,\mu)$ as the new variable. Since
# $\dot\vartheta=\xi\,\mathrm{dn}$ and $\mathrm{dn}^2=1-\mu\,\mathrm{sn}^2$, there is a $\mu$ under the
# root. The paper prints $\mu^2$. That would be right if $\mu$ were the *modulus* $k$; everywhere else
# in the paper it is the *parameter* $m=k^2$, as its footnote 1 shows. A point with rational
# coordinates settles it, and the ledger holds both: the refuted print, and the print proved for the
# other meaning of $\mu$.

# %%
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.proof.paper import verdicts

verdict = {v.equation.number: v for v in verdicts(ledger_data(ledger_text()))}
everything = sealed()
display(verdict["35"])

assert grades(ledger, "amplitude.printed", "amplitude.repaired") == {Grade.PROVED}
assert ledger.facts["amplitude.printed"].kind == "unequal"
assert grades(ledger, "amplitude_of_modulus.printed") == {Grade.PROVED}

# %% [markdown]
# ## Legendre's integral of the third kind
#
# With
#
# $$\Pi(n;\vartheta\,|\,m)=\int_0^\vartheta\frac{d\theta}{(1-n\sin^2\theta)\sqrt{1-m\sin^2\theta}},
# \qquad \frac{d}{dt}\Pi(n;\mathrm{am}(\xi t+\gamma)\,|\,\mu)=\frac{\xi}{1-n\,\mathrm{sn}^2}$$
#
# the integral is done. The context `third_kind` has a generator `Pi` that moves by the right side of
# that second formula; what the name stands for is its *reading*, the one thing the kernel cannot
# check and a reader should.

# %%
third_kind = ledger.contexts["third_kind"]
print("Pi reads:", third_kind.reading["Pi"])
display(definitions(ledger, "third_kind", "n", "kappa", "phi1"))
display(show(ledger, "third_kind.phi1"))

assert grades(ledger, "third_kind.phi1", "third_kind.integral") == {Grade.PROVED}
assert ledger.facts["third_kind.left_side"].kind == "unequal"
assert grades(ledger, "third_kind.left_side") == {Grade.PROVED}

# %% [markdown]
# So $\phi_1=\frac K{c_1}t+\kappa\,\Pi(n;\vartheta\,|\,m)+D$, as Theorem 1 has it, with
# $n=(c_1\zeta/K)^2=c_1^2s_1/K^2$. Theorem 1 prints $n=s_1/K^2$ and lacks the $c_1^2$:

# %%
display(show(everything, "theorem1_phi1.n", "theorem1_phi1.rate"))
display(verdict["20"])

assert grades(everything, "theorem1_phi1.n", "theorem1_phi1.rate") == {Grade.PROVED}
assert everything.facts["theorem1_printed.n"].kind == "unequal"

# %% [markdown]
# ## How $\Pi$ winds
#
# $\vartheta$ grows without end, and tables and programs know $\Pi(n;\vartheta|m)$ up to a quarter turn,
# or up to some branch of their own. Beyond it each half turn adds the same amount,
#
# $$\Pi(n;\vartheta+k\pi\,|\,m)=2k\,\Pi(n\,|\,m)+\Pi(n;\vartheta\,|\,m).$$
#
# Algebra proves that both sides grow alike, and that the integrand has no pole on the way for
# $n<1$. That they agree at one point is a statement about a definite integral, beyond polynomials: it
# is quoted from the literature and tested with rigorous balls. Its grade says so, and whatever rests
# on it cannot have a better one.

# %%
display(show(ledger, "windings.slope", "windings.path", "windings.rule"))

assert grades(ledger, "windings.slope", "windings.path") == {Grade.PROVED}
assert grades(ledger, "windings.rule") == {Grade.ENCLOSED}

# %% [markdown]
# ## Seen on a motion
#
# *From here on: illustrations in numbers, not proofs.* Lemma 1 is real on the middle axis, so let the
# middle axis of the paper's spacecraft be called 1: the cyclic order $(2,3,1)$ of its moments and
# rates is the same body and the same motion, with other names.

# %%
original = paper_case().motion
order = (1, 2, 0)
c = [original.inertia[k] for k in order]
w = [original.omega0[k] for k in order]
motion = TorqueFreeMotion(c, w)
print("inertia:        ", *map(float, c), "kg m^2")
print("rates at t = 0: ", *map(float, w), "rad/s")
print(motion.regime)

mp.mp.dps = 40
c1, c2, c3 = (mp.mpf(str(x)) for x in c)
w1, w2, w3 = (mp.mpf(str(x)) for x in w)
H = (c1 * w1**2 + c2 * w2**2 + c3 * w3**2) / 2
K2 = (c1 * w1) ** 2 + (c2 * w2) ** 2 + (c3 * w3) ** 2
K = mp.sqrt(K2)

# %% [markdown]
# The roots of (13) without its square root are in the fact `distinct_axis.roots`; the smaller one is
# $\zeta^2$, and $\xi^2$ is $\alpha$ times the other. The start $\gamma$ follows from
# $\Omega_1(0)=\zeta\,\mathrm{sn}\,\gamma$ and the sign of $\dot\Omega_1(0)$, as in Remark 1.

# %%
alpha = -(c1 - c2) * (c1 - c3) / (c2 * c3)
roots = [(K2 - 2 * H * c2) / (c1 * (c1 - c2)), (K2 - 2 * H * c3) / (c1 * (c1 - c3))]
s1, s2 = sorted(roots)
zeta, mu = mp.sqrt(s1), s1 / s2
rising = 1 if (c2 - c3) * w2 * w3 > 0 else -1
xi = rising * mp.sqrt(alpha * s2)
gamma = mp.ellipf(mp.asin(w1 / zeta), mu)
n, kappa = c1**2 * s1 / K2, (2 * H * c1 - K2) / (K * c1 * xi)
for name, value in {"zeta": zeta, "xi": xi, "mu": mu, "n": n, "kappa": kappa}.items():
    print(f"{name:>5} = {mp.nstr(value, 12)}")

assert grades(everything, "distinct_axis.roots", "middle_axis.roots") == {Grade.PROVED}
assert grades(everything, "middle_axis.rates") == {Grade.PROVED}


# %%
def amplitude(u, m):
    """am(u|m), continuous in u."""
    half_turns = mp.nint(u / (2 * mp.ellipk(m)))
    v = u - half_turns * 2 * mp.ellipk(m)
    return half_turns * mp.pi + mp.asin(mp.ellipfun("sn", v, m=m))


def third_kind_integral(n, theta, m):
    """Pi(n; theta|m), wound by the rule above."""
    half_turns = mp.nint(theta / mp.pi)
    rest = mp.ellippi(n, theta - half_turns * mp.pi, m)
    return 2 * half_turns * mp.ellippi(n, m) + rest


def phi1(t):
    """The closed form, from phi1(0) = 0."""
    ends = [third_kind_integral(n, amplitude(xi * s + gamma, mu), mu) for s in (t, 0)]
    return K / c1 * t + kappa * (ends[0] - ends[1])


def rate(t):
    """The integrand of (33)."""
    rate1 = zeta * mp.ellipfun("sn", xi * t + gamma, m=mu)
    return K * (2 * H - c1 * rate1**2) / (K2 - (c1 * rate1) ** 2)


times = [mp.mpf(20) * k for k in range(10)]
summed = mp.quad(rate, times)
print(f"phi1(180 s) by quadrature of (33): {mp.nstr(summed, 30)} rad")
print(f"phi1(180 s) by Pi:                 {mp.nstr(phi1(180), 30)} rad")
print("they agree to 30 digits:", bool(abs(summed - phi1(180)) < mp.mpf(10) ** -30 * abs(summed)))

# %% [markdown]
# And with $\phi_2$ and $\phi_3$ from the momentum, pulled back by (37), $\phi_1$ gives the attitude
# that the generated code gives. (Continuous angles are used here. Theorem 1's own half angles, and
# how they fail, have a notebook to themselves.)

# %%
t = np.linspace(0, 180, 61)
q, omega = motion(t)
momentum = omega * np.array(list(map(float, c)))
with mp.workdps(20):
    first = np.array([float(phi1(mp.mpf(float(s)))) for s in t])
second = np.arccos(momentum[:, 0] / float(K))
third = np.unwrap(np.arctan2(momentum[:, 1], momentum[:, 2]))


def product(p, q):
    """Products of quaternions, scalar first."""
    p0, p1, p2, p3 = np.moveaxis(p, -1, 0)
    q0, q1, q2, q3 = np.moveaxis(q, -1, 0)
    return np.stack(
        [
            p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
            p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
            p0 * q2 + p2 * q0 + p3 * q1 - p1 * q3,
            p0 * q3 + p3 * q0 + p1 * q2 - p2 * q1,
        ],
        axis=-1,
    )


def about(angle, axis):
    """exp(angle A_axis) as a quaternion."""
    turned = np.zeros((*np.shape(angle), 4))
    turned[..., 0], turned[..., axis] = np.cos(angle / 2), np.sin(angle / 2)
    return turned


Rbar = product(product(about(first, 1), about(second, 2)), about(third, 1))
start = Rbar[0] * [1, -1, -1, -1]
pulled_back = product(start, Rbar)
print("the same attitude, to 1e-13:", bool(np.abs(pulled_back - q).max() < 1e-13))

# %% tags=["hide-input"]
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8))
fine = [mp.mpf(k) for k in range(0, 181, 2)]
x = np.array(list(map(float, fine)))
mp.mp.dps = 15
wave = np.array([float(phi1(s) - K / c1 * s) for s in fine])
left.plot(x, wave, color="C0", lw=2, label=r"$\kappa\,\Pi$, wound")
ends = [amplitude(xi * s + gamma, mu) for s in fine]
branch = [mp.ellippi(n, mp.asin(mp.sin(theta)), mu) for theta in ends]
unwound = [float(kappa * (value - branch[0])) for value in branch]
left.plot(x, unwound, color="C3", lw=1, ls="--", label=r"$\kappa\,\Pi$ of $\arcsin\mathrm{sn}$")
left.set(xlabel="time (s)", ylabel=r"$\phi_1-\frac{K}{c_1}t$ (rad)")
left.legend(fontsize=9)
rates = np.array([float(rate(s)) for s in fine])
right.plot(x, rates, color="C0", lw=2, label=r"$\dot\phi_1$")
for value, name in ((K / c2, "K/c_2"), (K / c3, "K/c_3")):
    right.axhline(float(value), color="0.5", lw=1, ls=":")
    right.text(182, float(value), f"${name}$", va="center")
x = np.linspace(0, 180, 3601)
sn = NUMPY["jacobi_sn"](float(xi) * x + float(gamma), float(mu))
wrong = float(K / c1) + float(kappa * xi) / (1 - float(s1 / K2) * sn**2)
right.plot(
    x, np.where(abs(wrong) < 2, wrong, np.nan), color="C3", lw=1, ls="--", label="printed $n$"
)
top = float(K / min(c2, c3))
right.set(xlabel="time (s)", ylabel="rad/s", ylim=(-0.5 * top, 1.5 * top))
right.legend(fontsize=9)
figure.tight_layout()

# %% [markdown]
# Left: the part of $\phi_1$ that $\Pi$ contributes is a straight line with a wave on it; without the
# winding rule, on the branch that an inverse sine gives, it would fold back at every quarter period.
# Right: $\dot\phi_1$ stays between $K/c_2$ and $K/c_3$. With Theorem 1's printed $n$, too large by
# $1/c_1^2=625$ for this body, $1-n\,\mathrm{sn}^2$ has zeros and the rate has poles.
#
# ## What has been earned

# %%
steps = {
    "30": ["turning.off_diagonal", "turning.companion"],
    "31": ["turning.divided"],
    "32": ["turning.sum", "line32.rate"],
    "33": ["line32.by_invariants", "third_kind.phi1"],
    "34": ["sine_motion.split"],
    "35": ["amplitude.repaired"],
    "36": ["third_kind.integral"],
}
for name, facts in steps.items():
    assert grades(ledger, *facts) == {Grade.PROVED}, name
    assert all(name in ledger.facts[fact].source for fact in facts), name
assert grades(everything, "theorem1_amplitude.integrand", "theorem1_phi1.rate") == {Grade.PROVED}
assert grades(ledger, "windings.rule") == {Grade.ENCLOSED}
