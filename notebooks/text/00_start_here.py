# ---
# jupyter:
#   jupytext:
#     cell_metadata_filter: tags,-all
#     formats: ipynb,text//py:percent
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
# # Start here
#
# Throw a book that spins about its longest edge: it keeps spinning. The same happens about its shortest
# edge. About the edge between, it turns over again and again. Jacobi found the closed form of this
# motion; one paper gives its attitude as quaternions, by integrating a Lax pair on SU(2). These
# chapters derive that solution again, with every claim decided by a small kernel, and turn it into code.
#
# Run the next cell and move the six sliders: the body's moments of inertia and its initial rates.
# (A web page shows the picture without sliders; `jupyter lab notebooks` has both.)

# %%
from support.play import Play

play = Play(inertia=(0.0109, 0.04, 0.0506), omega0=(0.05, 0.03, -0.02))
play

# %% [markdown]
# The left picture is the sphere of momenta in body axes. Each motion is a curve on it; the thick curve
# is this motion. The right picture is the body in space, drawn as a box with these moments; ▶ starts
# it. Five things to try:
#
# 1. **Spin about the middle axis.** With $\Omega_1=\Omega_3=0$ nothing moves on the sphere. With
#    $\Omega_1=0.001$ the body turns over.
# 2. **The separatrix.** Change $\Omega_3$ alone until the curve encircles the other axis: the regime
#    changes its name, and near that point the period grows without bound.
# 3. **A symmetric body.** With $c_2=c_3$ the curves are circles, and the separatrix is one of them.
# 4. **A book.** $c=(0.01,\,0.04,\,0.05)$ is flat: $c_1+c_2=c_3$. No rigid body can be thinner:
#    $c_3=0.06$ is refused, with the reason.
# 5. **A needle.** With $c_1=0.005$, $c_2=c_3=0.1$ and $\Omega_1$ large, it precesses.
#
# Three lines of Python compute the same motion:

# %%
import rigidsym

motion = rigidsym.TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
motion([0.0, 90.0, 180.0])[0].round(4)  # attitudes: quaternions, scalar first, body to inertial

# %% [markdown]
# ## The chapters
#
# | | result |
# |---|---|
# | [1. The paper, line by line](01_the_paper_line_by_line.ipynb) | a verdict on everything that is printed: what holds, under which conditions, what is a misprint, and its repair |
# | [2. From the Lax pair to $K\cdot A_1$](02_from_lax_pair_to_k_a1.ipynb) | Euler's equations as a Lax pair, and the turn of the momentum onto an axis, found and not looked up |
# | [3. The $\varphi_1$ integral and $\Pi$](03_the_phi1_integral_and_pi.ipynb) | the one angle that needs an elliptic integral of the third kind |
# | [4. No sign functions](04_no_sign_functions.ipynb) | an attitude that is smooth for all times, without the paper's signs |
# | [5. Edges](05_edges.ipynb) | separatrix, symmetric bodies, spins and rest as limits |
# | [6. Theta functions](06_theta_functions.ipynb) | the same attitude as two series, of which two terms suffice |
# | [7. Fifty digits, and a proof](07_fifty_digits_and_a_proof.ipynb) | any number of correct digits |
# | [8. Code you can fly](08_code_you_can_fly.ipynb) | C and NumPy, each line with the equation that it comes from |
# | [9. Validation](09_validation.ipynb) | the worst errors of that code in every regime |
# | [10. A manoeuvre, from start to stop](10_a_manoeuvre_from_start_to_stop.ipynb) | a manoeuvre of two bursts: planned, flown, compared |
# | [11. Derive your own](11_derive_your_own.ipynb) | the derivation in other conventions, or with a wheel inside |
# | [12. Toutatis from twelve looks](12_toutatis_from_twelve_looks.ipynb) | the motion of an asteroid from observed attitudes, with errors |
# | [13. How a tumbling body forgets](13_how_a_tumbling_body_forgets.ipynb) | the growth of initial errors, and the inputs that a motion shows |
#
# Chapters 2 to 6 are the derivation, and each needs those before it. Chapters 7 to 13 can be read in any order.
#
# ## I have … I want …
#
# | I have | I want | |
# |---|---|---|
# | a satellite: moments, rates, an attitude | its attitude at any time | [propagate my satellite](howto_propagate_my_satellite.ipynb) |
# | a motion | more digits than a double has | [get fifty digits](howto_fifty_digits.ipynb) |
# | flight code | the solution in C, traceable | [generate C](howto_c_for_my_flight_code.ipynb) |
# | an integrator | its errors | [validate my integrator](howto_validate_my_integrator.ipynb) |
# | limits, spins or thrusters | a manoeuvre that keeps to them | [limits and thrusters](howto_limits_and_thrusters.ipynb) |
# | an equation | a proof or a counterexample | [add an equation](howto_add_an_equation.ipynb) |
# | another language | the solution in it | [add a target](howto_add_a_target.ipynb) |

# %% tags=["hide-cell"]
import numpy as np

from rigidsym import InputError, Regime


def regime(moments, rates):
    """What the sliders say where they stand so; nothing is drawn."""
    for slider, value in zip(play.sliders, (*moments, *rates), strict=True):
        slider.value = value
    return play.motion().regime


for slider in play.sliders:
    slider.unobserve_all("value")
assert motion.regime is Regime.SMALLEST
assert regime((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)) is Regime.SMALLEST
assert regime((0.0109, 0.04, 0.0506), (0, 0.03, 0)) is Regime.SPIN
assert regime((0.0109, 0.04, 0.0506), (0.001, 0.03, 0)) is Regime.SMALLEST
assert regime((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.1)) is Regime.LARGEST
assert regime((0.0109, 0.05, 0.05), (0.05, 0.03, -0.02)) is Regime.SYMMETRIC
assert regime((0.01, 0.04, 0.05), (0.05, 0.03, -0.02)) is Regime.SMALLEST
refused = None
try:
    regime((0.01, 0.04, 0.06), (0.05, 0.03, -0.02))
except InputError as error:
    refused = str(error)
assert "larger than the sum of the other two" in refused
play.draw()
assert refused in play.said.value
regime((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
assert np.allclose(np.linalg.norm(motion([0.0, 90.0, 180.0])[0], axis=1), 1, rtol=0, atol=1e-15)
