"""The partition of motions: read from the ledger, decided by formulas, or refused."""

import json
from dataclasses import replace
from fractions import Fraction
from itertools import permutations, product

import pytest
from ledgers import FACTS, TEXT

from rigidsym._codegen.seal import is_equal
from rigidsym.errors import LedgerError
from rigidsym.io.ledger import specification_text
from rigidsym.language._expression import names, parse, put
from rigidsym.language._sequence import FormulaSequence
from rigidsym.language._specification import read
from rigidsym.solution import _polhode as polhode
from rigidsym.solution import load, sealed
from rigidsym.solution._partition import GIVEN, ONES, ROOT, decisions, handedness

PARTITION = sealed().partition


def test_every_leaf_has_a_regime():
    assert set(PARTITION.leaves) == set(polhode._REGIMES)
    assert set(polhode._REGIMES.values()) == set(polhode.Regime)


@pytest.mark.parametrize("leaf", PARTITION.leaves.values(), ids=str)
def test_the_side_of_a_leaf_is_that_of_its_squares(leaf):
    """Find the side in the first statement, A_a^2 = E_d/(c_a c_ad), about that axis."""
    fact = FACTS[leaf.fact]
    assert (fact["context"], fact["grade"]) == (leaf.name, "PROVED")
    assert polhode._REGIMES[leaf.name].steady == (leaf.side == 0)
    first = parse(fact["lhs"][0])
    squares = {1: "E_3/(c_1*(c_1 - c_3))", -1: "-E_1/(c_3*(c_3 - c_1))"}
    assert [side for side, square in squares.items() if is_equal(first, parse(square))] == [
        *filter(None, [leaf.side])
    ]


# Moments for every pattern of equal ones, and rates that decide, each with its exact E_2.
MOTIONS = [
    ((2 + high, 2, 2 - low), rates)
    for high, low in product((0, Fraction(1, 4), 1), (0, 1))
    for rates in product((-4, 0, 1), (-1, 0, 1), (-3, -1, 0, 1, 6))
]


def decided(moments, rates):
    """Return the side of a motion by the formulas of the table."""
    c_1, c_2, c_3 = moments
    given = [c_1 - c_2, c_1 - c_3, c_2 - c_3, *rates]
    e_2 = c_1 * (c_1 - c_2) * rates[0] ** 2 - c_3 * (c_2 - c_3) * rates[2] ** 2
    known = dict(zip(GIVEN, [*(int(x != 0) for x in given), e_2], strict=True))
    functions = {"choose": lambda x, y, one, other: one if x <= y else other, "power": pow}
    return sealed().evaluated["decisions"].evaluate(known | ONES, functions)[ROOT]


def test_the_table_decides_by_zeros_what_the_partition_does_by_numbers():
    leaves = [PARTITION.leaf(*motion) for motion in MOTIONS]
    assert [decided(*motion) for motion in MOTIONS] == [leaf.side for leaf in leaves]
    assert {leaf.name for leaf in leaves} == set(PARTITION.leaves)


def test_a_quantity_that_is_not_seen_to_have_one_sign_is_no_row_of_the_table():
    formulas = [
        (name, parse("c_12*Omega_2**2 - c_13*Omega_3**2") if name == "E_1" else expression)
        for name, expression in PARTITION.quantities.formulas
    ]
    other = replace(PARTITION, quantities=FormulaSequence(formulas))
    with pytest.raises(LedgerError, match=r"Omega_3.* is not seen to have one sign"):
        decisions(other)


@pytest.mark.parametrize("axes", [*permutations(range(3))])
def test_epsilon_makes_the_equations_of_axes_a_b_d_those_of_axes_1_2_3(axes):
    """Compare the two ways in which the specification has the equations of motion."""
    blocks = read(specification_text())
    laws, steady = (
        {lhs: rhs for _, lhs, rhs in blocks[name].then if lhs.startswith("D(")}
        for name in ("motion_laws", "steady")
    )
    numbered = {"q_0": "q0", "epsilon": str(handedness(*axes))}
    for x, k in zip("abd", axes, strict=True):
        numbered |= {f"{name}_{x}": f"{name}{k + 1}" for name in ("c", "q", "Omega")}
    meaning = {name: parse(text) for name, text in numbered.items()}
    for lhs, rhs in laws.items():
        (name,) = names(put(parse(lhs.removeprefix("D")), meaning))
        assert is_equal(put(parse(rhs), meaning), parse(steady[f"D({name})"])), lhs


HALF, C_1 = Fraction(1, 2), Fraction(9, 4)


@pytest.mark.parametrize(
    ("moments", "rates", "leaf"),
    [
        ((3, 2, 1), (0, 0, 0), "rest"),
        ((2, 2, 2), (1, 0, 0), "spherical"),
        ((3, 2, 1), (1, HALF, 0), "largest"),
        ((3, 2, 1), (0, HALF, 1), "smallest"),
        ((3, 2, 1), (1, 0, 1), "largest"),
        ((C_1, 2, 1), (4, 1, Fraction(3, 2)), "largest"),
        ((C_1, 2, 1), (4, 1, 3), "separatrix_motion"),
    ],
)
def test_signs_of_differences_decide(moments, rates, leaf):
    assert PARTITION.leaf(moments, rates).name == leaf


def redefined(contexts, name, more):
    """Add a term to the definition of a name, wherever it is defined."""
    for context in contexts:
        if name in context["definitions"]:
            context["definitions"][name] += more


CASES, LEAVES = "sorted_body.cases", ["prolate_off_1", "prolate_off_1"]
PROVED = "sorted_body .*exactly one of"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda facts, _: facts[CASES].update(grade="ASSUMED"), f"theorem {PROVED}"),
        (lambda facts, _: facts.pop("off_1.cases"), "its leaves are not .*off_1"),
        (lambda facts, _: facts[CASES]["rhs"].remove("spin_2"), f"theorem {PROVED}"),
        (
            lambda facts, _: facts["prolate.cases"]["certificate"].update(cases=LEAVES),
            "prolate_off_1.cases: splits lead to it twice",
        ),
        (
            lambda _, contexts: redefined([contexts["oblate"]], "E_3", " + 1"),
            "oblate: its definitions are not those of sorted_body",
        ),
        (
            lambda _, contexts: contexts["sorted_body"]["generators"].reverse(),
            "sorted_body is not about c_3",
        ),
        (
            lambda _, contexts: redefined(contexts.values(), "off_middle", " + later"),
            "theorem sorted_body .*let off_middle = ",
        ),
        (
            lambda facts, _: facts["motion.cases"]["certificate"].pop("cases"),
            "its partition is not readable: KeyError",
        ),
    ],
)
def test_a_ledger_that_does_not_tell_motions_apart_is_refused(change, message):
    data = json.loads(TEXT)
    facts = {fact["id"]: fact for fact in data["facts"]}
    change(facts, {context["name"]: context for context in data["contexts"]})
    with pytest.raises(LedgerError, match=f"^ledger: .*{message}"):
        load(json.dumps({**data, "facts": [*facts.values()]}))
