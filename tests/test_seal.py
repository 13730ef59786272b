"""What is printed is what was derived: the kernel decides, and would notice."""

import pytest

from rigidsym import InputError
from rigidsym.codegen import functions as assembled
from rigidsym.codegen.ir import Let
from rigidsym.codegen.passes import expand, share
from rigidsym.seal import is_equal, seal
from rigidsym.solution import sealed
from rigidsym.solution.expression import parse


def test_every_formula_of_the_generated_code_is_decided():
    everything = sum(len(f.formulas) for f in assembled.functions(sealed()))
    assert seal(sealed()) == everything + 7  # the attitude and the rates, multiplied out
    assert everything > 450


@pytest.mark.parametrize(
    ("left", "right", "equal"),
    [
        ("a/(b + c)", "1/(c + b)*a", True),
        ("(a + b)**2", "a*a + 2*a*b + b*b", True),
        ("sqrt(a*b) + 1", "1 + sqrt(b*a)", True),
        ("a/(b + c)", "a/(b - c)", False),
        ("sqrt(a*b)", "sqrt(a*b + 1)", False),
        ("sqrt(a)*sqrt(a)", "a", False),
        ("f(a)", "g(a)", False),
    ],
)
def test_equality_is_decided_as_of_rational_functions_of_names_and_calls(left, right, equal):
    assert is_equal(parse(left), parse(right)) is equal


def test_a_wrong_line_is_named(monkeypatch):
    def spoiled(lets):
        return tuple(
            Let(x.targets, parse("mu*phase"), x.source, x.facts) if x.targets == ("B_d",) else x
            for x in share(lets)
        )

    monkeypatch.setattr(assembled, "share", spoiled)
    with pytest.raises(InputError, match=r"_start = B_d = .*: what is printed is not what was"):
        seal(sealed())


def test_sharing_can_be_undone_and_keeps_the_order():
    for function in assembled.functions(sealed()):
        known = set(function.parameters) | {c.name for c in assembled.constants()}
        for let in function.lets:
            assert set(assembled.names(let.expression)) <= known
            known |= set(let.targets)
        put_back = [let.targets for let in expand(function.lets)]
        assert put_back == [formula.targets for formula in function.formulas]


def test_provenance_of_what_is_shared_is_the_union_over_its_users():
    lets = (
        Let(("u",), parse("(a + b)*c"), ("10",), ("f",)),
        Let(("v",), parse("(a + b)*d"), ("12",), ("g",)),
    )
    common, *_ = share(lets)
    assert str(common) == "common_1 = a + b"
    assert (common.source, common.facts) == (("10", "12"), ("f", "g"))
