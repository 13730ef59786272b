"""What is printed is what was derived: the kernel decides, and would notice."""

from dataclasses import replace
from functools import cache, partial
from itertools import count

import pytest

from rigidsym import InputError, generate
from rigidsym._codegen.functions import assembly, common, theta
from rigidsym._codegen.ir import Let
from rigidsym._codegen.passes import expand, share
from rigidsym._codegen.seal import is_equal, seal, seal_text, structure, text
from rigidsym._codegen.seal.states import claims as of_states
from rigidsym._codegen.special_functions import landen
from rigidsym._codegen.targets.c import emit as c_emit
from rigidsym._codegen.targets.c import read_back as c_text
from rigidsym._codegen.targets.numpy import emit as numpy_emit
from rigidsym.language._expression import Call, Number, names, parse
from rigidsym.solution import sealed

made = cache(generate)


@cache
def derived_functions():
    return assembly.functions(sealed())


@cache
def decided(target):
    """Return how many lines of a module that nothing has spoiled are sealed."""
    return seal_text(generate(target), sealed())


def test_every_formula_of_the_generated_code_is_decided():
    everything = assembly.functions(sealed())
    formulas = [formula for function in everything for formula in function.formulas]
    states = list(of_states(sealed(), everything))
    assert len(states) == 2 * (4 + 1 + 2 + 3) + 2  # attitude, norm, phase and rates; half an angle
    decided = seal(sealed())
    assert decided > len(formulas) + len(states) + 80  # and the facts
    assert len(formulas) > 450


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


def turned(lets, name):
    """The lets with another sign in one of them."""
    lets = tuple(lets)
    assert any(name in let.targets for let in lets)
    return tuple(negated(let) if name in let.targets else let for let in lets)


def negated(let):
    return Let(let.targets, Call("neg", (let.expression,)), let.source, let.facts)


def where(lets, name):
    """Whether there is something to spoil."""
    return any(name in let.targets for let in lets)


def spoiling(function, name, turn, turns):
    """Return the function with another sign of one let, in one of the turns that give it."""
    given = count()

    def spoiled(*arguments, **options):
        lets = tuple(function(*arguments, **options))
        spoil = where(lets, name) and next(given) % turns == turn
        return turned(lets, name) if spoil else lets

    return spoiled


# The circular branch is made first, then the hyperbolic one; where no turn is named, in all.
SIGNS = [
    (theta, "state_lets", "q_0", 0, 2),
    (theta, "state_lets", "q_0", 1, 2),
    (theta, "state_lets", "Omega_b", 1, 2),
    (theta, "_rows", "row_0_P1_re"),
    (theta, "_rows", "row_d_P4_im"),
    (theta, "gains", "gain_a", 0, 2),
    (theta, "gains", "gain_d", 1, 2),
    (theta, "select", "Lambda"),
    (theta, "select", "qbar_a"),
    (theta, "select", "p_b"),
    (theta, "select", "P1_im"),
    (theta, "select", "tau"),
    (theta, "specialise", "P4_re"),
    (theta, "inlined", "q_a"),
    (theta, "front", "over_N", 0, 2),
    (theta, "front", "W", 0, 2),
    (theta, "secular", "Lambda_rate", 1, 2),
    # Each branch takes its parts for the constants, then for the state.
    (theta, "parts", "P4_im", 1, 4),
    (common, "select", "E_d"),
    (common, "select", "B_d"),
    (common, "renamed", "s"),
    (landen, "select", "S"),
    (common, "select", "q2"),
    (common, "select", "axis3"),
    (assembly, "live", "T4_re"),
    (assembly, "live", "v_error"),
    (assembly, "products", "K"),
    (assembly, "share", "L_error"),
]


@pytest.mark.parametrize(
    "place", SIGNS, ids=lambda x: f"{x[0].__name__}-{'-'.join(map(str, x[1:]))}"
)
def test_another_sign_is_refused(monkeypatch, place):
    module, name, line, turn, turns = *place, *(0, 1)[: 5 - len(place)]
    monkeypatch.setattr(module, name, spoiling(getattr(module, name), line, turn, turns))
    with pytest.raises(InputError, match=r"what is printed is not what was derived|not seen"):
        seal(sealed())


def swapped(renamed, lets, new):
    return renamed(lets, new | {"s": new["c"], "c": new["s"]})


def swapped_results(renamed, lets, new):
    return renamed(lets, new | {"s_next": "c", "c_next": "s"})


def without_facts(renamed, lets, new):
    return tuple(Let(let.targets, let.expression, let.source, ()) for let in renamed(lets, new))


@pytest.mark.parametrize("how", [swapped, swapped_results, without_facts])
def test_other_names_are_refused(monkeypatch, how):
    monkeypatch.setattr(common, "renamed", partial(how, common.renamed))
    with pytest.raises(InputError, match=r"_initial_state = (landen|kc_1|root_kc|s|c) ?.*"):
        seal(sealed())


def test_what_the_ledger_does_not_publish_is_behind_no_line(monkeypatch):
    """A definition is no fact, and goes by no fact's name."""

    def as_facts(renamed, lets, new):
        return tuple(
            replace(let, facts=tuple(name.removeprefix("definition ") for name in let.facts))
            for let in renamed(lets, new)
        )

    monkeypatch.setattr(common, "renamed", partial(as_facts, common.renamed))
    with pytest.raises(InputError, match=r"landen.kc_next: the ledger has no such formula"):
        seal(sealed())


def dropping(name):
    return lambda lets: tuple(let for let in lets if name not in let.targets)


def setting_again(lets):
    """common_1 is another thing after its first use."""
    lets = share(lets)
    again = Let(("common_1",), Number(2), ("1",), ())
    return (*lets, again) if where(lets, "common_1") else lets


def shadowing(lets):
    lets = share(lets)
    return (Let(("k_1",), parse("2*K"), ("1",), ()), *lets) if where(lets, "row_0_P4_re") else lets


def stray(name):
    def spoiled(lets):
        lets = share(lets)
        return (*lets, Let((name,), Number(2), ("1",), ()))

    return spoiled


def backwards(lets):
    return tuple(reversed(share(lets)))


def early(lets):
    """A line before the one it needs."""
    first, *rest = share(lets)
    return (*rest, first)


def regrouped(lets):
    """The same in a ring, where the error of a rounding vanishes in any order."""
    other = parse("p_y - ahead + ahead_other + (-back - ahead_other)")
    return tuple(
        replace(let, expression=other) if let.targets == ("ahead_error",) else let
        for let in share(lets)
    )


def wrong(lets):
    return tuple(
        replace(let, expression=parse("mu*phase")) if let.targets == ("B_d",) else let
        for let in share(lets)
    )


SHARING = [
    (setting_again, "set again|nothing needs"),
    (shadowing, "set again"),
    (stray("stray"), "nothing needs"),
    (stray("common_99"), "nothing needs"),
    (backwards, "before it is known"),
    (early, "before it is known"),
    (regrouped, "_hyperbolic_angles = ahead_error .* what is printed is not what"),
    (wrong, "_initial_state = B_d = .*phase: phase: used before it is known"),
    (lambda lets: dropping("E_a")(share(lets)), "E_a: used before it is known"),
    (lambda lets: dropping("row_0_P1_re")(share(lets)), "row_0_P1_re: is returned and never set"),
]


@pytest.mark.parametrize(("spoiled", "message"), SHARING)
def test_other_lines_are_refused(monkeypatch, spoiled, message):
    monkeypatch.setattr(assembly, "share", spoiled)
    with pytest.raises(InputError, match=message):
        seal(sealed())


def said_to_be(name, **changed):
    """Another provenance of one let."""
    return lambda lets: tuple(
        replace(let, **changed) if let.targets == (name,) else let for let in lets
    )


@pytest.mark.parametrize(
    ("name", "changed", "message"),
    [
        ("E_a", {"facts": ("regular.E_d",)}, "regular.E_d: what is printed is not what was"),
        ("E_a", {"facts": (), "source": ()}, "E_a = .*: does not say what it comes from"),
        ("W", {"facts": ("theta_form.N_of_W",)}, "theta_form.N_of_W: what is printed is not"),
        ("rho", {"facts": ("choice start_signs.sigma",)}, "start_signs.sigma: what is printed is"),
        ("largest", {"facts": ("smallest.squares",)}, "smallest.squares: what is printed is not"),
        ("T4_re_0", {"facts": ("regular.H",)}, "T4_re_0 = .*: regular.H: what is printed is not"),
        ("v_rate", {"facts": ("descended.mu",)}, "v_rate = .*: descended.mu: what is printed is"),
        ("T4_re_0", {"source": ("18",)}, r"T4_re_0 = .*: \(18\): no fact of this line carries it"),
        ("E_a", {"source": ("6", "7", "15")}, r"E_a = .*: \(7\): no fact of this line carries it"),
    ],
)
def test_a_line_is_by_no_other_fact_and_by_no_equation_but_that_of_its_fact(
    monkeypatch, name, changed, message
):
    live = assembly.live
    monkeypatch.setattr(assembly, "live", lambda *given: said_to_be(name, **changed)(live(*given)))
    monkeypatch.setattr(structure, "_check_stated", lambda *_: None)
    with pytest.raises(InputError, match=message):
        seal(sealed())


@pytest.mark.parametrize(
    ("name", "facts"),
    [
        ("E_a", ("regular.E_d",)),
        ("E_a", ()),
        ("common_4", ("regular.E_a",)),
        ("common_4", ()),
        ("T4_re_0", ("regular.E_a",)),
    ],
)
def test_what_is_shared_is_by_the_facts_of_what_it_is_shared_by(monkeypatch, name, facts):
    monkeypatch.setattr(assembly, "share", lambda lets: said_to_be(name, facts=facts)(share(lets)))
    with pytest.raises(InputError, match=r" = .*: is by "):
        seal(sealed())


@pytest.mark.parametrize("target", ["numpy", "c"])
@pytest.mark.parametrize(
    "said",
    [
        {"kind": "fact"},
        {"kind": "arithmetic"},
        {"facts": ["regular.H"]},
        {"equations": ["18"]},
        {"line": 1},
    ],
    ids=str,
)
def test_a_map_that_tells_another_thing_is_refused(monkeypatch, target, said):
    # The map alone is changed: derive the functions once for all such changes.
    monkeypatch.setattr(text, "functions", lambda *_: derived_functions())
    generated = made(target)
    (file, places), *_ = generated.map.items()
    at = next(k for k, place in enumerate(places) if place["kind"] == "classical")
    others = [*places[:at], {**places[at], **said}, *places[at + 1 :]]
    with pytest.raises(InputError, match=rf"{file}:\d+ = .*: the line says "):
        seal_text(replace(generated, map={**generated.map, file: others}), sealed())
    with pytest.raises(InputError, match=rf"{file}:\d+ = no line: the line says "):
        seal_text(replace(generated, map={}), sealed())


@pytest.mark.parametrize("name", ["E_a", "K_1", "gain_b", "q_0", "X_im"])
def test_a_line_that_is_dropped_is_missed(monkeypatch, name):
    live = assembly.live
    monkeypatch.setattr(assembly, "live", lambda *given: dropping(name)(live(*given)))
    with pytest.raises(InputError, match=r"used before it is known|is returned and never set"):
        seal(sealed())


def numpy_zero(printed, expression):
    return "0" if expression == parse("theta4_v*watson") else printed(expression)


def c_zero(lowered, expression, extended, number):
    if expression == parse("theta4_v*watson"):
        return Call("dd_of", (Number(0),))
    return lowered(expression, extended, number)


def less(fuse, function):
    """The last factor of what is fused is forgotten."""
    forgotten = []
    for let in fuse(function):
        match let.expression:
            case Call("fma", (a, _, c)):
                let = replace(let, expression=Call("fma", (a, Number(1), c)))
        forgotten.append(let)
    return tuple(forgotten)


def reversed_results(results, function):
    return ", ".join(reversed(results(function).split(", ")))


def blurred(constant_text, constant):
    return constant_text(replace(constant, hi=constant.hi * (1 + 2**-50)))


def moved(function_lines, function, number, signature, ends):
    """The two results of a function change places."""
    ends = [line.replace("= s5;", "= c5;") for line in ends]
    return function_lines(function, number, signature, ends)


def longer(function_lines, function, number, signature, ends):
    extra = "    const double again = 1.0;"
    return function_lines(function, number, [*signature, extra], ends)


EMITTERS = [
    ("numpy", numpy_emit, "printed", numpy_zero),
    ("numpy", numpy_emit, "_results", reversed_results),
    ("numpy", numpy_emit, "constant_text", blurred),
    ("c", c_emit, "lowered", c_zero),
    ("c", c_emit, "fuse", less),
    ("c", c_emit, "constant_text", blurred),
    ("c", c_emit, "function_lines", moved),
    ("c", c_emit, "function_lines", longer),
]


@pytest.mark.parametrize(("target", "emitter", "name", "how"), EMITTERS)
def test_what_an_emitter_spoils_is_refused(monkeypatch, target, emitter, name, how):
    assert decided(target) > 500
    monkeypatch.setattr(emitter, name, partial(how, getattr(emitter, name)))
    seal(sealed())
    with pytest.raises(InputError):
        seal_text(generate(target), sealed())


def test_what_fusing_spoils_is_refused(monkeypatch):
    for module in (c_emit, c_text):
        monkeypatch.setattr(module, "fuse", partial(less, module.fuse))
    with pytest.raises(InputError, match="not what was fused"):
        seal_text(generate("c"), sealed())


@pytest.mark.parametrize("target", ["numpy", "c"])
@pytest.mark.parametrize(
    ("there", "instead"),
    [("P4_re = T4_re", "P4_re = T4_im"), ("W = ", "V = "), ("scale", "scala")],
)
def test_text_that_was_edited_is_refused(target, there, instead):
    generated = made(target)
    files = {n: x.replace(there, instead) for n, x in generated.files.items()}
    with pytest.raises(InputError):
        seal_text(replace(generated, files=files), sealed())


def test_sharing_can_be_undone_and_keeps_the_order():
    for function in assembly.functions(sealed()):
        known = set(function.parameters) | {c.name for c in assembly.constants()}
        for let in function.lets:
            assert set(names(let.expression)) <= known
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


def test_a_target_without_a_reader_is_refused():
    generated = generate("numpy")
    other = replace(generated, manifest={**generated.manifest, "target": "rust"})
    with pytest.raises(InputError, match="target = rust: has no read_back"):
        seal_text(other, sealed())


def exchanged(function, which, first, second):
    """A function that takes or returns two numbers in the other order."""
    names = list(getattr(function, which))
    i, j = names.index(first), names.index(second)
    names[i], names[j] = names[j], names[i]
    return replace(function, **{which: tuple(names)})


@pytest.mark.parametrize(
    ("name", "which", "first", "second"),
    [
        ("_discriminant", "parameters", "c_a", "c_d"),
        ("_steady_constants", "parameters", "p1", "p2"),
        ("_circular_angles", "parameters", "t", "t_lo"),
        ("_circular_angles", "results", "sin_v", "cos_v"),
        ("_circular_state", "parameters", "X_im", "X_re"),
        ("_hyperbolic_state", "parameters", "w", "p"),
        ("_hyperbolic_state", "results", "q_a", "Omega_a"),
        ("_steady_state", "results", "q0", "q1"),
    ],
)
def test_runtimes_count_on_an_order(name, which, first, second):
    every = assembly.functions(sealed())
    structure.check_interfaces(every)
    other = tuple(exchanged(f, which, first, second) if f.name == name else f for f in every)
    with pytest.raises(InputError, match=f"^{name} = .*is not what it (takes|returns)"):
        structure.check_interfaces(other)


@pytest.mark.parametrize("name", ["_initial_state", "_circular_constants", "_hyperbolic_state"])
def test_runtimes_know_what_they_give(name):
    every = assembly.functions(sealed())
    other = tuple(
        replace(f, parameters=(*f.parameters, "stray")) if f.name == name else f for f in every
    )
    with pytest.raises(InputError, match=f"^{name} = stray: is nothing that it is given"):
        structure.check_interfaces(other)


@pytest.mark.parametrize(
    ("name", "left_out"), [("_initial_state", "k_1"), ("_circular_constants", "v")]
)
def test_runtimes_find_what_they_read(name, left_out):
    every = assembly.functions(sealed())
    other = tuple(
        replace(f, results=tuple(x for x in f.results if x != left_out)) if f.name == name else f
        for f in every
    )
    with pytest.raises(InputError, match=f"^{name} = {left_out}.*: is nothing that it returns"):
        structure.check_interfaces(other)
