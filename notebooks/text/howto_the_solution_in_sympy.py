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
# # How to hold the solution in SymPy
#
# This notebook holds a motion as a SymPy expression of the time: evaluate it, differentiate it, expand it,
# print it, or turn it into functions. Every expression is built from formulas of the ledger.

# %%
import numpy as np
import sympy as sp

import rigidsym

motion = rigidsym.TorqueFreeMotion((2, 4, 3), (1, 2, 1))  # kg m^2, rad/s
solution = motion.symbolic()
t = solution.t
print(f"the form {solution.form!r}, for {motion.regime}")
solution.omega()

# %% [markdown]
# `omega()` is a column of three rates, `q()` one of four components, scalar first. Names such as `mu` are
# exact numbers, each defined by those before it: `constants` lists them, and `explicit` inserts them.

# %%
for symbol in ("k_1", "mu", "phase"):
    (value,) = [x for name, x in solution.constants.items() if str(name) == symbol]
    display(sp.Eq(sp.Symbol(symbol), value))  # noqa: F821
energy = solution.explicit(solution.quantities["energy"])
print("energy", energy, "J")

# %% [markdown]
# **Numbers**: use `subs` and `evalf`, with any number of digits. `motion.precise` gives the same fifty
# digits some thousand times as fast.

# %%
first = solution.omega(sp.Rational(7, 3))[0].evalf(50)
print(first)
print(motion.precise("7/3", digits=50)[1][0])

# %% [markdown]
# **Derivatives**: q' = q (0, ω)/2, here for its first component, after seven thirds of a second.

# %%
later = sp.Rational(7, 3)


def at(expression):
    """To thirty digits, then."""
    return sp.N(expression.subs(t, later), 30)


q, omega = solution.q(), solution.omega()
slope = at(q[0].diff(t))
product = -sum(at(q[k + 1]) * at(omega[k]) for k in range(3)) / 2
print(slope, product, sep="\n")

# %% [markdown]
# **Series**: `taylor` returns the first terms of both columns, exactly, from the equations of motion.
# (SymPy's own `series` takes more than minutes for such an expression.)

# %%
near, rates = solution.taylor(4)
sp.Eq(sp.Symbol("Omega_1"), rates[0])

# %% [markdown]
# **Functions**: `lambdify` makes functions of arrays, with NumPy, SciPy or mpmath.

# %%
states = sp.lambdify(t, [*q, *omega], "numpy")
times = np.linspace(0, 20, 5)
found = np.array([np.broadcast_to(x, times.shape) for x in states(times)])
gap = np.max(np.abs(found[:4].T - motion(times)[0]))
print(f"as the generated module has it: {gap < 1e-14}")

# %% [markdown]
# **Algebra**: SymPy 1.14 lacks Jacobi's elliptic functions, so `rigidsym.language.functions` has them. `simplify` uses
# sn² + cn² = 1 and dn² + m sn² = 1, quarter periods have their values, and `expand_func` applies addition theorems.

# %%
from rigidsym.language.functions import jacobi_cn, jacobi_dn, jacobi_sn

u, v, m = sp.symbols("u v m")
K, across = sp.elliptic_k(m), sp.I * sp.elliptic_k(1 - m)
sn, cn, dn = (function(u, m) for function in (jacobi_sn, jacobi_cn, jacobi_dn))
print(sp.simplify(sn**2 + cn**2), sp.simplify((1 - m * sn**2) / dn))
print(
    jacobi_dn(K, m),
    jacobi_sn(across, m),
    jacobi_cn(u + 2 * K, m),
    sp.expand_func(jacobi_sn(u + K, m)),
)
sp.expand_func(jacobi_dn(u + v, m))

# %% [markdown]
# So SymPy can check solutions. Here are Euler's equations for the moments 3, 2 and 1, and their solution for any two
# amplitudes A and C.

# %%
A, C = sp.symbols("A C", positive=True)
x, y, z = (sp.Function(name)(t) for name in "xyz")
euler = [x.diff(t) - y * z / 3, y.diff(t) + x * z, z.diff(t) - x * y]
argument = C * t / sp.sqrt(3), 3 * A**2 / C**2
turning = [
    A * jacobi_cn(*argument),
    -sp.sqrt(3) * A * jacobi_sn(*argument),
    C * jacobi_dn(*argument),
]
checked = sp.checkodesol(euler, [sp.Eq(*pair) for pair in zip((x, y, z), turning, strict=True)])
print(checked)

# %% [markdown]
# C, Fortran and JAX have no such functions, and their printers say so; with `user_functions` they call yours.

# %%
try:
    sp.ccode(sn)
except NotImplementedError as refused:
    print(refused)
sp.ccode(sn**2, user_functions={"jacobi_sn": "my_sn"})

# %% [markdown]
# **Periods**: after a period the rates have their initial values, and the body has turned about its
# momentum by the phase: 2HT/K less the solid angle that the momentum sweeps (Montgomery's formula).

# %%
for name in ("period", "mean_circulation_rate", "precession_rate", "phase_per_period"):
    print(f"{name:22} {float(solution.quantities[name]):.12f}")
print("phase less whole turns", round(motion.phase_per_period % (2 * np.pi), 12), "rad")

# %% [markdown]
# **Without numbers**: `rigidsym.symbolic("pi")` has free symbols, with their conditions and the meaning of its
# signs. On the separatrix and for symmetric bodies the functions are elementary.

# %%
rigidsym.symbolic("separatrix").omega()

# %%
for symbol, meaning in rigidsym.symbolic("pi").choices.items():
    print(f"{symbol}: {meaning}")
print(sp.latex(rigidsym.symbolic("symmetric").omega()[1]))

# %% [markdown]
# [The solution in SymPy](site/pages/symbolic.md) lists all forms and their domains.

# %% tags=["hide-cell"]
assert abs(first - sp.Float(str(motion.precise("7/3", digits=50)[1][0]), 60)) < 1e-45
assert abs(slope - product) < 1e-28
assert abs(rates[0].subs(t, sp.Rational(1, 1000)) - solution.omega(0.001)[0].evalf(20)) < 1e-11
assert gap < 1e-14
assert checked == (True, [0, 0, 0])
