"""The paper's own form, generated: sealed, traced, without a theta, and refused where unknown."""

import re
from dataclasses import replace

import pytest

from rigidsym import InputError, generate
from rigidsym.codegen import TARGETS, forms
from rigidsym.codegen.functions import functions
from rigidsym.codegen.functions.pi import hyperbolic
from rigidsym.codegen.seal import seal, seal_text
from rigidsym.codegen.trace import lines_of_equation
from rigidsym.language.expression import parse
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


def test_equation_36_has_lines_in_both_languages():
    files = {line.split(":")[0] for line in lines_of_equation("36")}
    assert files == {"torque_free_pi.py", "torque_free_pi.c"}


def test_a_form_that_there_is_not():
    with pytest.raises(InputError, match=r"form = 'phi': must be one of: theta, pi|phi"):
        generate("numpy", form="phi")


def test_the_seal_would_notice_a_turn_the_other_way(monkeypatch):
    made = hyperbolic._half_psi

    def turned(solution):
        first, *others = made(solution)
        other_way = replace(first, expression=parse("turn_re*arc_re + turn_im*arc_im"))
        return (other_way, *others)

    monkeypatch.setattr(hyperbolic, "_half_psi", turned)
    with pytest.raises(InputError, match="what is printed is not what was derived"):
        seal(sealed(), "pi")
