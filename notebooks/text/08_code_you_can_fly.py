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
# # 8. Code you can fly
#
# The derivation is exact, the flight computer is not. Between them stands a generator: it takes the
# proved formulas from the ledger and prints them as C99, with libm alone, without allocation or
# global variables. This notebook
#
# 1. generates the C source and looks at a line of it,
# 2. follows that line back to its equation and to the fact that proves it,
# 3. spoils a sign, and sees the seal refuse the text,
# 4. compiles a main program and compares it with forty digits,
# 5. and lets it race against SciPy.

# %%
import shutil
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import mpmath
import numpy as np

import rigidsym

generated = rigidsym.generate("c")
for name, text in generated.files.items():
    print(f"{name}: {len(text.splitlines())} lines")
source = generated.files["torque_free.c"].splitlines()

# %% [markdown]
# `generate` is a pure function: it returns texts, a map from lines to equations, and a manifest
# with digests; the same today as tomorrow. Nothing is on disk until `generated.write(directory)`.
#
# ## One line
#
# The heart of the solution is the rate at which the body turns about its momentum,
#
# $$\dot\psi = \frac{2H + K|\Omega_a|}{K + c_a|\Omega_a|} ,$$
#
# whose denominator never falls below $K$. At the extreme of the polhode, where $|\Omega_a| = A_a$,
# it is called $\psi_0$. Where is that in the C source?

# %%
places = generated.map["torque_free.c"]
place = next(p for p in places if p["facts"] == ["descended.psi_0"])
print(source[place["line"] - 1].strip())
print("equations:", ", ".join(f"({number})" for number in place["equations"]))
print("facts:    ", ", ".join(place["facts"]))

# %% [markdown]
# `dd_…` are operations on *pairs* of doubles, unevaluated sums with some thirty digits: constants
# of the motion are carried so, states are plain doubles. `_dx` says double times pair.
#
# The comment in the source, the map and `rigidsym trace torque_free.c:LINE` tell the same. Every
# derived line says what it is: a *fact* of the ledger by its name, *classical*, or *arithmetic*.
# (Some have a *definition* instead, what a symbol is short for, a *reading*: they compute the
# standard function that it stands for; or a *choice*, a row of the table that decides axes and signs.)

# %%
from collections import Counter

from rigidsym.proof.kernel import Grade
from support import sealed, show

ledger = sealed()
noted = {fact for place in places for fact in place["facts"]}
said = Counter(fact.split()[0] for fact in noted if " " in fact)
named = {fact for fact in noted if " " not in fact}
print(f"{len(places)} derived lines, which name {len(named)} facts", dict(said))
show(ledger, "descended.psi_0")

# %% [markdown]
# And the other way round: which lines stand or fall with equation (34), the integral of
# $\varphi_1$?

# %%
from rigidsym._codegen.trace import lines_of_equation

lines = lines_of_equation("34")
for line in lines[:4]:
    print(f"{line:.96}")

# %% [markdown]
# ## The seal
#
# A generator is a program, and programs have bugs. So what it prints is *read back*: the kernel
# that proved the formulas decides that the lines, put together again, are the formulas of the
# ledger.

# %%
from rigidsym._codegen.seal import seal, seal_text
from rigidsym.solution import sealed as solution

decisions, read_back = seal(solution()), seal_text(generated, solution())
print(f"{decisions} decisions about formulas, {read_back} lines read back")

# %% [markdown]
# Would it notice? Turn one plus of the line above into a minus:

# %%
from dataclasses import replace

old = source[place["line"] - 1]
new = old.replace("dd_add_xx(K,", "dd_sub_xx(K,")
spoilt = {**generated.files, "torque_free.c": "\n".join(source).replace(old, new) + "\n"}
try:
    seal_text(replace(generated, files=spoilt), solution())
    noticed = False
except rigidsym.InputError as error:
    noticed = True
    print(error.rule)

# %% [markdown]
# What the seal takes on trust is that a series (of a theta function, of the nome) is that of its
# function, and the runtime around them. These are measured instead: that is
# the next notebook.
#
# ## A program
#
# Two calls are enough for flight code: prepare a motion once, then ask for states. Both return 0, or a
# code that `torque_free_message` puts into words.

# %%
MAIN = r"""
#include <stdio.h>
#include "torque_free.h"

int main(void)
{
    const double inertia[3] = {0.0109, 0.04, 0.0506}; /* kg m^2 */
    const double omega0[3] = {0.05, 0.03, -0.02};     /* rad/s */
    const double attitude0[4] = {1, 0, 0, 0};         /* scalar first, body to inertial */
    torque_free_motion motion;
    double q[4], omega[3];
    int code = torque_free_motion_init(&motion, inertia, omega0, attitude0);
    for (int k = 0; code == 0 && k <= 1000; k++) {
        code = torque_free_state_at(&motion, 3.6 * k, q, omega);
        printf("%.17g %.17g %.17g %.17g\n", q[0], q[1], q[2], q[3]);
    }
    return code == 0 ? 0 : (puts(torque_free_message(code)), code);
}
"""
FLAGS = ["-std=c99", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"]
STRICT = ["-Wall", "-Wextra", "-pedantic"]


def compiled_states(compiler):
    """Compile the program in a temporary directory, run it, and return what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        generated.write(folder)
        (Path(folder) / "main.c").write_text(MAIN)
        command = [compiler, *FLAGS, *STRICT, "main.c", "torque_free.c", "-o", "main", "-lm"]
        built = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
        print("warnings:", built.stderr or "none")
        done = subprocess.run([f"{folder}/main"], capture_output=True, text=True, check=True)
    return np.array([line.split() for line in done.stdout.splitlines()], dtype=float)


times = 3.6 * np.arange(1001)
compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
if compiler:
    q = compiled_states(compiler)
else:
    print("no C compiler on this machine: NumPy's module, from the same formulas, stands in")
    q = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))(times)[0]

# %% [markdown]
# An hour of flight, 1001 attitudes. How wrong are they? The reference is the same motion to forty
# digits; the difference is taken before anything is rounded.

# %%
motion = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
exact = motion.precise(times, digits=40)[0]


def angle_between(given, exact):
    """The angle of the rotation between quaternions (rad), their sign included."""
    with mpmath.workdps(40):
        chords = [mpmath.norm(list(y - x)) for x, y in zip(given, exact, strict=True)]
        return np.array([float(4 * mpmath.asin(chord / 2)) for chord in chords])


errors = angle_between(q, exact)
print("every attitude of the hour is right to 2e-15 rad:", bool(errors.max() < 2e-15))

# %% [markdown]
# ## Against an integrator
#
# The usual way to such states is numerical integration. SciPy's best for smooth problems is Dormand
# and Prince's method of order 8; at a tolerance of $10^{-12}$ it is careful. Its error *grows* with
# time, since each step starts from where the last one ended. A closed form has no last step.

# %%
from scipy.integrate import solve_ivp


def rates(t, y):
    """q' = q (0, omega)/2, and Euler's equations."""
    (q0, q1, q2, q3, w1, w2, w3), (c1, c2, c3) = y, (0.0109, 0.04, 0.0506)
    return [
        (-q1 * w1 - q2 * w2 - q3 * w3) / 2,
        (q0 * w1 + q2 * w3 - q3 * w2) / 2,
        (q0 * w2 + q3 * w1 - q1 * w3) / 2,
        (q0 * w3 + q1 * w2 - q2 * w1) / 2,
        (c2 - c3) / c1 * w2 * w3,
        (c3 - c1) / c2 * w3 * w1,
        (c1 - c2) / c3 * w1 * w2,
    ]


def integrated():
    """The same states by SciPy's DOP853."""
    start = [1, 0, 0, 0, 0.05, 0.03, -0.02]
    found = solve_ivp(rates, (0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-12)
    return found.y[:4].T


drifted = angle_between(integrated(), exact)
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
# A logarithmic axis has no place for errors of exactly nothing.
axes.semilogy(times[1:], np.maximum(drifted, 1e-17)[1:], label="SciPy, DOP853 at 1e-12")
axes.semilogy(times[1:], np.maximum(errors, 1e-17)[1:], ".", markersize=2, label="generated C")
axes.axhline(2e-15, color="grey", linestyle=":", label="documented bound")
axes.set_xlabel("t (s)")
axes.set_ylabel("error of the attitude (rad)")
axes.set_title("One hour of the paper's spacecraft")
axes.set_ylim(1e-17, None)
axes.grid(alpha=0.3)
axes.legend()
plt.show()

# %% [markdown]
# And the time it takes? `engine="c"` is this very source. A wheel brings it compiled; otherwise it is
# compiled once for this machine and kept in the user's cache. Timings differ from run to run, so here are only coarse statements; the
# page [How accurate, how fast](site/pages/accuracy.md) has figures, and
# `python tests/benchmarks/generated.py` measures them.

# %%
import warnings
from time import perf_counter


def seconds(work, repeats):
    """The shortest of some runs."""
    found = []
    for _ in range(repeats):
        start = perf_counter()
        work()
        found.append(perf_counter() - start)
    return min(found)


with warnings.catch_warnings():
    # Without a compiler NumPy stands in, with a warning.
    warnings.simplefilter("ignore")
    fast = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02), engine="c")
    fast(times)

closed_form, integrator = seconds(lambda: fast(times), 50), seconds(integrated, 3)
print("faster than the integrator by more than 10 x:", integrator > 10 * closed_form)

# %% [markdown]
# An integrator also has to pass through all times before; the closed form has not. A year from now
# costs as much as a second from now, and is as exact:

# %%
year = 365.25 * 86400
q_year = fast(year)[0]
error = angle_between(q_year[None], motion.precise([year], digits=40)[0])[0]
print("right to 2e-15 rad after a year:", bool(error < 2e-15))

# %% [markdown]
# Next: how one knows that this holds for *every* body, *every* motion and *every* time, and not
# just for the paper's spacecraft. That is [validation](09_validation.ipynb). To take the source
# home, see [C for my flight code](howto_c_for_my_flight_code.ipynb).

# %% tags=["hide-cell"]
assert generated.manifest["target"] == "c"
assert set(place["equations"]) == {"33", "34"}
assert {"definition", "reading"} < set(said) <= {"choice", "definition", "reading"}
assert {ledger.facts[name].grade for name in named} == {Grade.PROVED}
assert lines
assert all(line.startswith(("torque_free", "torque-free")) for line in lines)
assert read_back == len(places)
assert new != old
assert noticed
assert q.shape == (1001, 4)
assert errors.max() < 2e-15
assert drifted[-1] > 100 * errors.max()
assert error < 2e-15
