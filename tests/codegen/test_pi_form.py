"""The paper's own form, generated: sealed, traced, without a theta, and refused where unknown."""

import re
import subprocess
from dataclasses import replace

import numpy as np
import pytest
from compilers import PLAIN, STRICT, either

from rigidsym import InputError, generate
from rigidsym._codegen import TARGETS, forms
from rigidsym._codegen.functions import functions, pi
from rigidsym._codegen.seal import seal, seal_text
from rigidsym._codegen.trace import lines_of_equation
from rigidsym.generated import torque_free_pi
from rigidsym.language._expression import parse
from rigidsym.solution import sealed


def test_every_formula_is_decided():
    formulas = [let for function in functions(sealed(), "pi") for let in function.formulas]
    assert len(formulas) > 500
    assert seal(sealed(), "pi") > len(formulas) + 100  # and the facts


@pytest.mark.parametrize("target", TARGETS)
def test_files_read_back_and_name_their_form(target):
    generated = generate(target, form="pi")
    assert seal_text(generated, sealed()) > 500
    assert generated.manifest["target"] == forms.key(target, "pi")
    for name, text in generated.files.items():
        assert name.startswith("torque_free_pi.")
        assert f"rigidsym codegen {target} --form pi" in text or name.endswith(".c")


@pytest.mark.parametrize("target", TARGETS)
def test_no_theta_function_and_no_nome(target):
    for text in generate(target, form="pi").files.values():
        assert not re.search(r"theta\d|_root_ratio|root_ratio|\bnome", text)
        assert not re.search(r"DLMF 20\.", text)


def test_c_modules_of_both_forms_have_no_name_in_common():
    """What a header declares or defines, and what the linker sees."""
    own = re.compile(r"\b(?:torque_free|TORQUE_FREE)_\w+")
    names = {
        form: {*own.findall("\n".join(generate("c", form=form).files.values()))}
        for form in forms.FORMS
    }
    assert not names["theta"] & names["pi"]
    assert all(name.lower().startswith("torque_free_pi") for name in names["pi"])


def test_both_c_modules_go_into_one_programme(here):
    """Their states of one motion agree."""
    compiler = either()
    made, said = compiler.compiled(here / "both.c", *STRICT)
    assert (made.exists(), said) == (True, "")
    sources = ("both.c", "torque_free.c", "torque_free_pi.c")
    program = compiler.linked(here, *PLAIN, sources=sources)
    told = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    one, other = ([float(x) for x in line.split()] for line in told.splitlines())
    assert one == pytest.approx(other, abs=3e-15)


def test_a_name_of_another_form_is_refused():
    generated = generate("c", form="pi")
    name = "torque_free_pi.c"
    text = generated.files[name].replace("torque_free_pi_state_at(", "torque_free_state_at(", 1)
    changed = replace(generated, files={**generated.files, name: text})
    with pytest.raises(InputError, match=r"torque_free_pi.c:\d+ = .*has another form's name"):
        seal_text(changed, sealed())


def test_equation_36_has_lines_in_both_languages():
    files = {line.split(":")[0] for line in lines_of_equation("36")}
    assert files == {f"torque_free_{form}.{end}" for form in ("pi", "step") for end in ("py", "c")}


def test_a_body_that_is_refused_leaves_those_beside_it():
    inertia = np.array([[np.nan] * 3, [1.0, 2.0, 2.5], [2.5, 1.0, 2.0]])
    rates, start = np.full((3, 3), 0.3), np.tile([1.0, 0.0, 0.0, 0.0], (3, 1))
    together = torque_free_pi.prepare(inertia, rates, start, errors="nan")
    q, omega = torque_free_pi.states(together, [0.0, 7.0])
    assert np.isnan(q[0]).all()
    others = torque_free_pi.prepare(inertia[1:], rates[1:], start[1:])
    alone = torque_free_pi.states(others, [0.0, 7.0])
    assert np.array_equal(q[1:], alone[0])
    assert np.array_equal(omega[1:], alone[1])


def test_a_form_that_there_is_not():
    with pytest.raises(InputError, match=r"form = 'phi': must be one of: theta, pi|phi"):
        generate("numpy", form="phi")


def test_the_seal_would_notice_a_turn_the_other_way(monkeypatch):
    made = pi._half_psi

    def turned(solution):
        first, *others = made(solution)
        other_way = replace(first, expression=parse("turn_re*arc_re + turn_im*arc_im"))
        return (other_way, *others)

    monkeypatch.setattr(pi, "_half_psi", turned)
    with pytest.raises(InputError, match="what is printed is not what was derived"):
        seal(sealed(), "pi")
