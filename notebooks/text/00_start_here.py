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
# Throw a book, flat, spinning about its longest edge: it spins on. About its shortest edge: it spins
# on. About the edge between: it turns over, again and again. The motion has been known in closed form
# since Jacobi; one paper gives its attitude as quaternions, by integrating a Lax pair on SU(2). These
# chapters derive that again, every claim decided by a small kernel, and turn it into code that flies.
#
# Run the next cell, and play: six sliders, the body's moments of inertia and the rates it begins with.
# (On a page that only shows this, there is the picture without them: `jupyter lab notebooks` has both.)

# %%
from support.play import Play

play = Play(inertia=(0.0109, 0.04, 0.0506), omega0=(0.05, 0.03, -0.02))
play

# %% [markdown]
# On the left is the sphere on which the momentum moves, seen from the body: one curve for each
# motion, and the body takes the thick one. On the right the body itself, a box of these moments, in
# space; ▶ lets it go. Five things to try:
#
# 1. **Spin about the middle axis.** $\Omega_1=\Omega_3=0$: nothing moves on the sphere. Then
#    $\Omega_1=0.001$: the body turns over.
# 2. **The separatrix.** Move $\Omega_3$ alone until the curve goes round the other axis: the
#    regime's name changes, and where it does the period has no bound.
# 3. **A symmetric body.** $c_2=c_3$: the curves are circles, and the separatrix is one of them.
# 4. **A book.** $c=(0.01,\,0.04,\,0.05)$ is flat: $c_1+c_2=c_3$. Thinner than that nothing is:
#    $c_3=0.06$ is refused, and the line says why.
# 5. **A needle.** $c_1=0.005$, $c_2=c_3=0.1$, and $\Omega_1$ large: it precesses.
#
# Elsewhere than in a notebook, the same motion in three lines:

# %%
import rigidsym

motion = rigidsym.TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
motion([0.0, 90.0, 180.0])[0].round(4)  # attitudes: quaternions, scalar first, body to inertial

# %% [markdown]
# ## What each chapter earns
#
# | | you have in the end |
# |---|---|
# | [1. The paper, line by line](01_the_paper_line_by_line.ipynb) | a verdict on everything that is printed: what holds, under which conditions, what is a misprint, and its repair |
# | [2. From the Lax pair to $K\cdot A_1$](02_from_lax_pair_to_k_a1.ipynb) | Euler's equations as a Lax pair, and the turn of the momentum onto an axis, found and not looked up |
# | [3. The $\varphi_1$ integral and $\Pi$](03_the_phi1_integral_and_pi.ipynb) | the one angle that takes an elliptic integral of the third kind |
# | [4. No sign functions](04_no_sign_functions.ipynb) | an attitude that is smooth for all times, without the paper's signs |
# | [5. Edges](05_edges.ipynb) | separatrix, symmetric bodies, spins and rest as limits |
# | [6. Theta functions](06_theta_functions.ipynb) | the same attitude as two series that two terms of suffice for |
# | [7. Fifty digits, and a proof](07_fifty_digits_and_a_proof.ipynb) | any number of digits, every one certain |
# | [8. Code you can fly](08_code_you_can_fly.ipynb) | C and NumPy, each line with the equation that it comes from |
# | [9. Validation](09_validation.ipynb) | how wrong that code is, at worst, in every regime |
# | [10. A manoeuvre, from start to stop](10_a_manoeuvre_from_start_to_stop.ipynb) | from one attitude to another by two bursts: planned, flown, compared |
# | [11. Derive your own](11_derive_your_own.ipynb) | the derivation in other conventions, or with a wheel inside |
# | [12. Toutatis from twelve looks](12_toutatis_from_twelve_looks.ipynb) | which motion it is, from attitudes, with its errors |
# | [13. How a tumbling body forgets](13_how_a_tumbling_body_forgets.ipynb) | what errors of the start grow to, and what a motion shows of its body |
#
# Chapters 2 to 6 are the derivation, and each stands on those before; 7 to 13 can be read in any order.
#
# ## I have … I want …
#
# | I have | I want | |
# |---|---|---|
# | a satellite: moments, rates, an attitude | where it points, at any time | [propagate my satellite](howto_propagate_my_satellite.ipynb) |
# | a motion | more digits than a double has | [get fifty digits](howto_fifty_digits.ipynb) |
# | flight code | the solution in C, with its provenance | [generate C](howto_c_for_my_flight_code.ipynb) |
# | an integrator | to know how wrong it is | [validate my integrator](howto_validate_my_integrator.ipynb) |
# | an equation | to know whether it holds | [add an equation](howto_add_an_equation.ipynb) |
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
