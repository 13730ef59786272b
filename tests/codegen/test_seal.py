"""The seal decides every formula of the generated code, and refuses code that is not derived."""

import ast
from dataclasses import replace
from functools import cache, partial
from itertools import count

import pytest

from rigidsym import InputError, generate
from rigidsym._codegen import routines
from rigidsym._codegen.functions import assembly, common, pi, theta
from rigidsym._codegen.ir import Let
from rigidsym._codegen.passes import expand, share
from rigidsym._codegen.seal import bodies, is_equal, seal, seal_text, structure, text
from rigidsym._codegen.seal.states import claims as of_states
from rigidsym._codegen.special_functions import landen
from rigidsym._codegen.targets.c import derived
from rigidsym._codegen.targets.c.printer import Printer
from rigidsym._codegen.targets.javascript.printer import Printer as JavaScript
from rigidsym._codegen.targets.numpy import emit as numpy_emit
from rigidsym._codegen.targets.rust.printer import Printer as Rust
from rigidsym.language._expression import Call, Number, names, parse
from rigidsym.solution import sealed

made = cache(generate)


@cache
def derived_functions(form="theta"):
    return assembly.functions(sealed(), form)


@cache
def decided(target):
    """Return how many lines of a module that nothing has spoiled are sealed."""
    return seal_text(made(target), sealed())


@pytest.mark.parametrize(("form", "least", "facts"), [("theta", 450, 80), ("pi", 500, 100)])
def test_every_formula_of_the_generated_code_is_decided(form, least, facts):
    everything = derived_functions(form)
    formulas = [formula for function in everything for formula in function.formulas]
    states = list(of_states(sealed(), everything, form))
    if form == "theta":
        assert len(states) == 2 * (4 + 1 + 2 + 3) + 2  # attitude, norm, phase, rates; half an angle
    assert seal(sealed(), form) > len(formulas) + len(states) * (form == "theta") + facts
    assert len(formulas) > least


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
        ("x/a + y/(a*b)", "(b*x + y)/(b*a)", True),
        ("x/a + y/(a*b)", "(b*x - y)/(b*a)", False),
    ],
)
def test_equality_is_decided_as_of_rational_functions_of_names_and_calls(left, right, equal):
    assert is_equal(parse(left), parse(right)) is equal


# --- formulas


def changed(change):
    """Return a way to spoil a function: its result is changed."""
    return lambda function: lambda *given, **options: change(function(*given, **options))


def negating(name, turn=0, turns=1):
    """Spoil the sign of a let, in one of the turns in which a function gives it."""
    given = count()

    def negated(lets):
        lets = tuple(lets)
        if not sets(lets, name) or next(given) % turns != turn:
            return lets
        return tuple(
            replace(let, expression=Call("neg", (let.expression,))) if name in let.targets else let
            for let in lets
        )

    return changed(negated)


def sets(lets, name):
    return any(name in let.targets for let in lets)


def renaming(**names):
    """Spoil a renaming: some names get the new names of others."""
    return lambda renamed: lambda lets, new: renamed(lets, new | names)


def said_to_be(name, **provenance):
    """Spoil the provenance of one let, or of all."""
    return changed(
        lambda lets: tuple(
            replace(let, **provenance) if let.targets == (name,) or not name else let
            for let in lets
        )
    )


def set_to(name, expression):
    return said_to_be(name, expression=parse(expression))


def as_facts(lets):
    """Name definitions as if they were facts."""
    return tuple(
        replace(let, facts=tuple(name.removeprefix("definition ") for name in let.facts))
        for let in lets
    )


def dropping(name):
    return changed(lambda lets: tuple(let for let in lets if name not in let.targets))


def adding(name, where="", value="2", first=False):
    """Add a line, at the beginning or the end, where another name is set."""
    stray = Let((name,), parse(value), ("1",), ())

    def added(lets):
        if where and not sets(lets, where):
            return lets
        return (stray, *lets) if first else (*lets, stray)

    return changed(added)


def early(lets):
    """Move the first line to the end, behind lines that need it."""
    first, *rest = lets
    return (*rest, first)


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
NAMES = r"_initial_state = (landen|kc_1|root_kc|s|c) ?.*"
MISSED = r"used before it is known|is returned and never set"
# The same in a ring, where the error of a rounding vanishes in any order.
REGROUPED = "p_y - ahead + ahead_other + (-back - ahead_other)"
SPOILT = [
    *(
        (module, name, negating(*line), "what is printed is not what was derived|not seen")
        for module, name, *line in SIGNS
    ),
    (common, "renamed", renaming(s="cn", c="sn"), NAMES),
    (common, "renamed", renaming(s_next="c", c_next="s"), NAMES),
    (common, "renamed", said_to_be("", facts=()), NAMES),
    (common, "renamed", changed(as_facts), "landen.kc_next: the ledger has no such formula"),
    (assembly, "share", adding("common_1", "common_1"), "set again|nothing needs"),
    (assembly, "share", adding("k_1", "row_0_P4_re", "2*K", first=True), "set again"),
    (assembly, "share", adding("stray"), "nothing needs"),
    (assembly, "share", adding("common_99"), "nothing needs"),
    (assembly, "share", changed(lambda lets: lets[::-1]), "before it is known"),
    (assembly, "share", changed(early), "before it is known"),
    (
        *(assembly, "share", set_to("ahead_error", REGROUPED)),
        "_hyperbolic_angles = ahead_error .* what is printed is not what",
    ),
    (
        *(assembly, "share", set_to("B_d", "mu*phase")),
        "_initial_state = B_d = .*phase: phase: used before it is known",
    ),
    (assembly, "share", dropping("E_a"), "E_a: used before it is known"),
    (assembly, "share", dropping("row_0_P1_re"), "row_0_P1_re: is returned and never set"),
    *(
        (assembly, "share", said_to_be(name, facts=facts), " = .*: is by ")
        for name, facts in (
            *(("E_a", ("regular.E_d",)), ("E_a", ()), ("T4_re_0", ("regular.E_a",))),
            *(("common_4", ("regular.E_a",)), ("common_4", ())),
        )
    ),
    *(
        (assembly, "live", dropping(name), MISSED)
        for name in ("E_a", "K_1", "gain_b", "q_0", "X_im")
    ),
]


def seal_spoilt(monkeypatch, module, name, how, form="theta"):
    monkeypatch.setattr(module, name, how(getattr(module, name)))
    seal(sealed(), form)


@pytest.mark.parametrize(("module", "name", "how", "message"), SPOILT)
def test_a_formula_that_is_not_derived_is_refused(monkeypatch, module, name, how, message):
    with pytest.raises(InputError, match=message):
        seal_spoilt(monkeypatch, module, name, how)


def test_a_turn_the_other_way_is_refused(monkeypatch):
    other = changed(
        lambda lets: (
            replace(lets[0], expression=parse("turn_re*arc_re + turn_im*arc_im")),
            *lets[1:],
        )
    )
    with pytest.raises(InputError, match="what is printed is not what was derived"):
        seal_spoilt(monkeypatch, pi, "_half_psi", other, "pi")


@pytest.mark.parametrize(
    ("name", "provenance", "message"),
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
    monkeypatch, name, provenance, message
):
    monkeypatch.setattr(structure, "_check_stated", lambda *_: None)
    with pytest.raises(InputError, match=message):
        seal_spoilt(monkeypatch, assembly, "live", said_to_be(name, **provenance))


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


# --- printed text


def numpy_zero(printed, expression):
    return "0" if expression == parse("theta4_v*watson") else printed(expression)


def c_zero(syntax, expression):
    return syntax(Number(0) if expression == parse("theta4_v*watson") else expression)


def less(fuse, function):
    """Drop the second factor of fused products."""
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


def changing(old, new):
    """Change a piece of the text of each routine."""

    def changed(routine, printer, one):
        lines = routine(printer, one)
        return replace(lines, text=tuple(line.replace(old, new) for line in lines.text))

    return changed


def blurred_in_c(number, printer, one):
    value = one.value
    if isinstance(value, ast.Constant) and isinstance(value.value, float):
        one = replace(one, value=ast.Constant(value.value * (1 + 2**-50)))
    return number(printer, one)


def longer(routine, printer, one):
    lines = routine(printer, one)
    return replace(lines, text=(*lines.text[:-2], "    const double again = 1.0;", "}", ""))


EMITTERS = [
    ("numpy", numpy_emit, "printed", numpy_zero),
    ("numpy", numpy_emit, "_results", reversed_results),
    ("numpy", numpy_emit, "constant_text", blurred),
    ("c", routines, "syntax", c_zero),
    ("c", derived, "fuse", less),
    ("c", Printer, "number", blurred_in_c),
    ("c", Printer, "routine", longer),
    *(
        ("c", Printer, "routine", changing(*pair))
        for pair in (
            ("*s5_out = s5;", "*s5_out = c5;"),
            ("motion->v_hi[i] = v.hi;", "motion->v_hi[i] = v.lo;"),
            ("k < 3;", "k < 2;"),
            (" && ", " || "),
            ("dd_add_xx", "dd_sub_xx"),
            ("const double *restrict t,", "double *restrict t,"),
            ("double_double k, double_double kc", "double_double kc, double_double k"),
        )
    ),
]


def replacing(old, new):
    """Change a piece of a printed definition."""

    def changed(print_, *given):
        found = print_(*given)
        return found.replace(old, new) if isinstance(found, str) else [found_in(found)]

    def found_in(lines):
        return "\n".join(lines).replace(old, new)

    return changed


EMITTERS += [
    *(("javascript", JavaScript, "number", how) for how in (blurred_in_c, replacing("12;", "11;"))),
    ("javascript", JavaScript, "enumeration", replacing("TIME = 6", "TIME = 7")),
    ("javascript", JavaScript, "head", replacing("(x, y, one, other", "(y, x, one, other")),
    ("javascript", JavaScript, "head", replacing("export function", "function")),
    ("javascript", JavaScript, "struct", replacing("max_angle: 0", "max_angle: 1")),
    *(("rust", Rust, "number", how) for how in (blurred_in_c, replacing("i32 = 12", "i32 = 11"))),
    ("rust", Rust, "head", replacing("(x: f64, y: f64, one", "(y: f64, x: f64, one")),
    ("rust", Rust, "head", replacing("-> f64", "-> f32")),
    ("rust", Rust, "struct", replacing("is_blurred: bool", "is_blurred: i32")),
]


@pytest.mark.parametrize(("target", "emitter", "name", "how"), EMITTERS)
def test_what_an_emitter_spoils_is_refused(monkeypatch, target, emitter, name, how):
    assert decided(target) > 500
    whole = getattr(emitter, name)
    monkeypatch.setattr(emitter, name, lambda *given: how(whole, *given))
    seal(sealed())
    with pytest.raises(InputError):
        seal_text(generate(target), sealed())


def test_what_fusing_spoils_is_refused(monkeypatch):
    for module in (derived, bodies):
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
    for function in derived_functions():
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
    other = replace(generated, manifest={**generated.manifest, "target": "fortran"})
    with pytest.raises(InputError, match="target = fortran: has no read_back"):
        seal_text(other, sealed())


# --- interfaces


def exchanged(which, first, second):
    """Exchange two parameters or results of a function."""

    def change(function):
        new = {first: second, second: first}
        return replace(function, **{which: tuple(new.get(x, x) for x in getattr(function, which))})

    return change, "is not what it (takes|returns)"


def given_another(function):
    return replace(function, parameters=(*function.parameters, "stray"))


def without(result):
    return lambda f: replace(f, results=tuple(x for x in f.results if x != result))


@pytest.mark.parametrize(
    ("name", "change", "message"),
    [
        ("_discriminant", *exchanged("parameters", "c_a", "c_d")),
        ("_steady_constants", *exchanged("parameters", "p1", "p2")),
        ("_circular_angles", *exchanged("parameters", "t", "t_lo")),
        ("_circular_angles", *exchanged("results", "sin_v", "cos_v")),
        ("_circular_state", *exchanged("parameters", "X_im", "X_re")),
        ("_hyperbolic_state", *exchanged("parameters", "w", "p")),
        ("_hyperbolic_state", *exchanged("results", "q_a", "Omega_a")),
        ("_steady_state", *exchanged("results", "q0", "q1")),
        *(
            (name, given_another, "= stray: is nothing that it is given")
            for name in ("_initial_state", "_circular_constants", "_hyperbolic_state")
        ),
        ("_initial_state", without("k_1"), "= k_1.*: is nothing that it returns"),
        ("_circular_constants", without("v"), "= v.*: is nothing that it returns"),
    ],
)
def test_runtimes_count_on_names_and_their_order(name, change, message):
    every = derived_functions()
    structure.check_interfaces(every)
    other = tuple(change(f) if f.name == name else f for f in every)
    with pytest.raises(InputError, match=f"^{name} .*{message}"):
        structure.check_interfaces(other)
