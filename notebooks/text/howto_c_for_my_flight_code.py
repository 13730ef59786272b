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
# # How to generate C for my flight code
#
# The generated code is two files of C99 that depend only on libm.

# %%
import tempfile
from pathlib import Path

import rigidsym

with tempfile.TemporaryDirectory() as folder:
    written = rigidsym.generate("c").single_file().write(folder)
    print(*sorted(path.name for path in written), sep="\n")
    header = (Path(folder) / "torque_free.h").read_text()

# %% [markdown]
# In a shell, use `rigidsym codegen c --single-file -o src/attitude`. Before it writes, the kernel
# decides that the printed text is what was derived. `c.map.json` lists the equations and facts of each
# line; it is for reviewers, not for the compiler.
#
# ## The interface
#
# The header documents all functions:

# %%
import re

functions = re.findall(r"^[a-z][\w ]* \*?(torque_free_\w+)\(", header, re.M)
print(*functions, sep="\n")

# %% [markdown]
# * Call `torque_free_motion_init` once per motion. It takes some microseconds and makes all decisions.
# * Call `torque_free_state_at` for one time, `_states_at` for an array of times, `_states_on_grid` for a
#   uniform grid (which needs no sine per sample), and `_propagate` for many bodies.
# * Each function returns 0 or a code that `torque_free_message` explains. The functions print nothing,
#   allocate nothing and have no state, so threads may share a prepared motion.
#
# ## How to compile
#
# Use `-std=c99 -O3 -ffp-contract=off -fno-math-errno -fno-trapping-math`, as `engine="c"` does, and
# `-march=native` or the name of your processor. Options that break extended precision are refused:
#
# * `-ffast-math`, and x87 arithmetic on old 32-bit targets (use `-msse2 -mfpmath=sse`), at compile time;
# * options that define no macro, such as `-fassociative-math`, at run time by `torque_free_motion_init`.

# %%
import shutil
import subprocess

PROGRAM = r"""
#include <stdio.h>
#include "torque_free.h"

int main(void)
{
    const double inertia[3] = {0.0109, 0.04, 0.0506}, omega0[3] = {0.05, 0.03, -0.02};
    const double attitude0[4] = {1, 0, 0, 0};
    torque_free_motion motion;
    double q[4], omega[3];
    int code = torque_free_motion_init(&motion, inertia, omega0, attitude0);
    if (code == 0)
        code = torque_free_state_at(&motion, 180.0, q, omega);
    if (code != 0)
        return puts(torque_free_message(code)), code;
    printf("%a %a %a %a\n", q[0], q[1], q[2], q[3]);
    return 0;
}
"""
FLAGS = ["-std=c99", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"]
STRICT = ["-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]
compiler = next(filter(None, map(shutil.which, ("cc", "gcc", "clang"))), None)
expected = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))(180.0)[0]

if compiler is None:
    print("no C compiler here: nothing to try")
else:
    with tempfile.TemporaryDirectory() as folder:
        rigidsym.generate("c").single_file().write(folder)
        (Path(folder) / "main.c").write_text(PROGRAM)
        command = [compiler, *FLAGS, *STRICT, "main.c", "torque_free.c", "-lm", "-o", "main"]
        subprocess.run(command, cwd=folder, check=True)
        answer = subprocess.run([f"{folder}/main"], capture_output=True, text=True, check=True)
    q = [float.fromhex(x) for x in answer.stdout.split()]
    print("C and NumPy agree to 1e-15:", max(abs(q - expected)) < 1e-15)
    assert max(abs(q - expected)) < 1e-15

# %% [markdown]
# ## How to qualify it
#
# * The file's head states the domain, the bounds of every series and the worst errors measured.
# * `rigidsym validate c` measures it again on your machine, with your compiler (`CC=…`).
# * `rigidsym codegen c --single-file -o src/attitude --check` in your CI exits 1 if the files were edited.
# * `rigidsym trace torque_free.c:800` shows a reviewer the equations and facts of a line.

# %% tags=["hide-cell"]
assert {"torque_free.h", "torque_free.c", "c.map.json"} == {path.name for path in written}
assert {"torque_free_motion_init", "torque_free_state_at"} <= set(functions)
head = header[: header.index("*/")]
assert "Domain:" in head
assert "digest " + rigidsym.generate("c").manifest["digest"] in head
