"""The specification: both readers agree on it, and refuse every ledger that proves less."""

import json
import random
import re
from types import SimpleNamespace

import pytest
from document_texts import rows, words
from ledgers import LEDGER, OUTSIDE, TEXT, forger, hollow, written

from rigidsym._codegen import TARGETS
from rigidsym._codegen.lines import beside
from rigidsym.errors import LedgerError
from rigidsym.io.ledger import specification_text
from rigidsym.language._specification import (
    Proved,
    Unproved,
    Values,
    parse,
    read,
    require,
    sequences,
    theorems,
)
from rigidsym.proof._audit import audit, totals
from rigidsym.proof._mutants import Edit
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.checker import Refused
from rigidsym.proof.checker import require as require_again
from rigidsym.proof.checker._language import Forms
from rigidsym.proof.checker._notation import Residues
from rigidsym.proof.checker._specification import blocks
from rigidsym.proof.derivation import DerivationError, require_specified
from rigidsym.solution import load

SPECIFICATION = specification_text()
CIRCULATING = ("prolate_motion", "oblate_motion", "separatrix_motion", "largest", "smallest")
STEADY = {
    "q0": "p0*cos_half_theta - p1*r1 - p2*r2 - p3*r3",
    "q1": "p0*r1 + p1*cos_half_theta + p2*r3 - p3*r2",
    "q2": "p0*r2 + p2*cos_half_theta + p3*r1 - p1*r3",
    "q3": "p0*r3 + p3*cos_half_theta + p1*r2 - p2*r1",
}


def data():
    """Return the sealed ledger to change."""
    return json.loads(TEXT)


def refused(ledger):
    """Return why both readers refuse a ledger; "" where they do not."""
    try:
        require(SPECIFICATION, ledger)
    except Unproved as error:
        with pytest.raises(Refused):
            require_again(SPECIFICATION, ledger)
        return str(error)
    require_again(SPECIFICATION, ledger)
    return ""


def part(ledger, kind, name):
    return next(x for x in ledger[kind] if x["id" if kind == "facts" else "name"] == name)


def redefined(name, text, changed):
    """Return the ledger with one definition of a name replaced everywhere."""
    return forger().forge([Edit("=", (((name, text), ((changed, 1),)),))])


def with_context(context):
    """Return the ledger with that context in place of the one of its name."""
    others = LEDGER["contexts"]
    return {**LEDGER, "contexts": [context if x["name"] == context["name"] else x for x in others]}


def test_it_can_be_audited_by_eye():
    lines = [line for line in SPECIFICATION.splitlines() if line and not line.startswith("#")]
    assert len(lines) <= 244
    assert f"{len(theorems(SPECIFICATION))} theorems in at most 244 lines" in words("trust.md")
    assert max(map(len, SPECIFICATION.splitlines())) <= 150


def test_the_sealed_ledger_proves_it():
    assert refused(LEDGER) == ""


def test_both_readers_read_the_same():
    first = {name: block.is_theorem for name, block in read(SPECIFICATION).items()}
    again = blocks(SPECIFICATION)
    assert first == {name: is_theorem for name, (is_theorem, _) in again.items()}
    for name, block in read(SPECIFICATION).items():
        other = again[name][1]
        assert [len(block.then), len(block.cases)] == [len(other.stated), len(other.cases)]
        assert {*block.let} == {*other.named}
        for clause in ("zero", "nonzero", "nonnegative"):
            assert len(getattr(block, clause)) == len(other.assumed.get(clause, ()))
        assert {*(block.moving or {})} == {*(other.rates or {})}


def test_every_published_sequence_is_in_a_theorem():
    named = {sequence for t in theorems(SPECIFICATION).values() for sequence, _ in t.formulas}
    assert named == {*sequences(LEDGER)}


@pytest.mark.parametrize("name", theorems(SPECIFICATION))
def test_a_theorem_is_missed_with_its_context(name):
    ledger = data()
    ledger["facts"] = [f for f in ledger["facts"] if name not in (f["context"], *f["rhs"])]
    ledger["contexts"] = [c for c in ledger["contexts"] if c["name"] != name]
    assert refused(ledger).startswith("theorem ")


def test_chapters_that_prove_less_seal_nothing():
    with pytest.raises(DerivationError, match=r"theorem steady \(.*: its hypotheses are not in"):
        require_specified(LedgerBuilder().ledger.to_text())


def test_a_formula_about_itself_is_refused():
    assert "is about itself" in refused(hollow())


@pytest.mark.parametrize(
    ("said", "formula"),
    [
        ("; alpha_b*excess_{x} = alpha_{x}*excess_b", "excesses: excess_a"),
        ("k*rest_k = -2*rho*a*sinh_b", "fourier_rest: rest_k"),
        ("phi1 = K*t/c1 + kappa*Pi;", "theorem1: H"),
        ("w_re*one = n_d;", "projection: w_re"),
    ],
)
def test_every_published_formula_is_determined(said, formula):
    """Leave out an equation: the theorem says too little of a formula."""
    assert SPECIFICATION.count(said) == 1
    with pytest.raises(Unproved, match=f"{formula} is determined by no theorem"):
        require(SPECIFICATION.replace(said, ""), LEDGER)


@pytest.mark.parametrize(
    ("clause", "components"),
    [
        ("quaternions q | then D(q) = q*v/2", ["-(q1*v1 + q2*v2 + q3*v3)/2"]),
        ("then c*D(v) = cross(c*v, v)", ["c2*v2*v3 - c3*v3*v2", "c3*v3*v1 - c1*v1*v3"]),
        ("complex z w | then z = z/w", ["(z_re*w_re + z_im*w_im)/(w_re**2 + w_im**2)"]),
        ("derivatives d: v | then c = d(v*v)", ["2*v1*dv1", "2*v2*dv2", "2*v3*dv3"]),
        (
            "derivatives d_x: v by c | then d_x(v1) = d_x(v1**2/c1)",
            ["2*v1*v1_by_c1/c1 - v1**2/c1**2"],
        ),
        ("matrices R | then v = R*v", ["R11*v1 + R12*v2 + R13*v3"]),
        ("then cis(a) = cis(b)**2", ["cos_b**2 - sin_b**2", "2*cos_b*sin_b"]),
        ("write w = v1 + c1 | then c1 = w**2", ["(v1 + c1)**2"]),
        ("then for x y = 1 2, 2 3: c{x} = v{y}; v{x} = c{x}", ["v2", "c1", "v3", "c2"]),
        (
            "derivatives d_x: c by v1; c2 by v1 = 1 | varied c1 = v1**2*c2",
            ["v1**2*c2", "2*v1*c2 + v1**2"],
        ),
        ("derivatives d_x: c_t by v1 | then D(d_x(c_t)) = d_x(c_t**2)", ["2*c_t*c_v1"]),
    ],
)
def test_both_readers_write_notation_out_alike(clause, components):
    text = f"theorem a: b\n    vectors c v along 1 2 3 | {clause}"
    names = re.findall(r"[a-zA-Z_]\w*", " ".join(components))
    drawn, forms = Values("seed", names, {}, None), Residues("seed", names, {}, None)
    first, second = read(text)["a"].then, blocks(text)["a"][1].stated
    for component, (_, _, one), (_, _, two) in zip(components, first, second, strict=False):
        assert drawn.of(parse(one)) == drawn.of(parse(component))
        assert forms.of(two) == forms.of(Forms().read(component))


def test_a_theorem_has_to_be_proved():
    ledger = data()
    part(ledger, "facts", "steady.solution")["grade"] = "ENCLOSED"
    assert refused(ledger) == (
        "theorem steady (constant rates, |q| = 1, q' = q (0, Omega)/2, Euler's equations): "
        "D(q0) = -(q1 * Omega1 + q2 * Omega2 + q3 * Omega3) / 2 is not proved under its hypotheses"
    )


def without(name):
    """Return the ledger without a fact and all that rests on it."""
    kept, dropped = [], {name}
    for fact in LEDGER["facts"]:
        if fact["id"] in dropped or dropped & {*fact["premises"]}:
            dropped.add(fact["id"])
        else:
            kept.append(fact)
    return {**LEDGER, "facts": kept}


def of_rules(*rules):
    return [fact["id"] for fact in LEDGER["facts"] if fact["rule"] in rules]


@pytest.mark.parametrize("name", of_rules("theta", "start", "assumption"))
def test_no_fact_on_functions_is_left_out(name):
    assert refused(without(name)).startswith("theorem ")


@pytest.mark.parametrize("name", ["descended_start", *(f"{x}_constants" for x in CIRCULATING)])
def test_the_chain_from_a_body_to_its_attitude_has_all_links(name):
    links = [x for x in of_rules("model") if x.startswith(f"{name}.")]
    for link in links:
        assert refused(without(link)).startswith(f"theorem {name} ")
    assert links


@pytest.mark.slow
def test_no_link_and_no_published_fact_is_left_out():
    """Leave out each formula, each model and each partition, with all that rests on it."""
    listed = [entry for entries in sequences(LEDGER).values() for entry in entries]
    formulas = {entry["fact"] for entry in listed if "fact" in entry}
    links = of_rules("model", "partition")
    accepted = [name for name in (*formulas, *links) if not refused(without(name))]
    # Forms that are not published, and parts of other proofs.
    unpublished = {"both_forms", "pi_far", "separatrix", "step", "symmetric"}
    assert {name.partition(".")[0] for name in accepted} == unpublished


@pytest.mark.parametrize("names", [["sigma"], ["chi"], ["sigma", "chi"]])
@pytest.mark.parametrize("context", ["theta_form", "hyperbolic_form", "descended"])
def test_a_theorem_for_less_is_another(context, names):
    ledger = data()
    part(ledger, "contexts", context)["relations"] += [f"{name} - 1" for name in names]
    assert "the ledger assumes this beyond it" in refused(ledger)


@pytest.mark.parametrize("context", ["theta_form", "descended", "steady_start"])
def test_a_theorem_declares_no_functions_and_no_start(context):
    for field, more in (("start", ["rho"]), ("thetas", {"K": "re(theta3(0, k_1))"})):
        ledger = data()
        part(ledger, "contexts", context)[field] = more
        assert f"theorem {context} (" in refused(ledger)


@pytest.mark.parametrize("field", ["units", "nonnegative", "relations"])
@pytest.mark.parametrize("context", [*theorems(SPECIFICATION)])
def test_hypotheses_are_exactly_those(context, field):
    given = part(LEDGER, "contexts", context)
    items = given[field]
    values = Proved(LEDGER).values(theorems(SPECIFICATION)[context])
    meant = [{values.of(parse(text)) for text in texts} for texts in (items, items[1:])]
    for changed in ([*items, f"{given['generators'][0]} + 7"], items[1:]):
        if changed != items and (len(changed) > len(items) or meant[0] != meant[1]):
            assert f"theorem {context} (" in refused(with_context({**given, field: changed}))


@pytest.mark.parametrize("rate", [None, "0", "2*({})", "?"])
def test_a_root_moves_as_what_it_is_the_root_of(rate):
    ledger = data()
    rates = part(ledger, "contexts", "pi_near")["rates"]
    old = rates.pop("R")
    assert refused(ledger).startswith("theorem pi_near ")
    if rate:
        rates["R"] = rate.format(old)
        assert refused(ledger).startswith("theorem pi_near ")


def test_rates_are_exactly_those():
    ledger = data()
    part(ledger, "contexts", "descended")["rates"]["s"] = "(mu)*c*d*2"
    assert "theorem descended" in refused(ledger)
    part(ledger, "contexts", "descended")["rates"] = None
    assert "theorem descended" in refused(ledger)


def test_a_sign_of_q0_is_noticed():
    """Change two characters of the definition, and wherever it is restated."""
    changed = STEADY["q0"].replace("- p1*r1", "+ p1*r1")
    ledger = redefined("q0", STEADY["q0"], changed)
    assert "theorem steady (" in refused(ledger)
    with pytest.raises(LedgerError, match=r"theorem steady \("):
        load(written(ledger))


@pytest.mark.parametrize("name", OUTSIDE)
def test_what_changes_together_is_noticed(name):
    """Forge the ledgers of an outside attack: laws hold, but starts or signs are others."""
    assert "is not proved" in refused(forger().forge(OUTSIDE[name]))


@pytest.mark.parametrize("name", STEADY)
def test_another_quaternion_is_noticed(name):
    assert refused(redefined(name, STEADY[name], f"7 - ({STEADY[name]})"))


def test_a_formula_is_one_that_is_proved():
    """Double A_a as a fact: the start of the motion no longer rests on it."""
    ledger = data()
    part(ledger, "facts", "regular.A_a")["rhs"] = ["4*E_d/(c_a*c_ad)"]
    assert "its formula A_a = sqrt(4*E_d/(c_a*c_ad)) is not proved" in refused(ledger)


class Here:
    """A pool of processes that is this one."""

    def __init__(self, *_, **__):
        pass

    __enter__, __exit__ = (lambda self: self), (lambda *_: None)

    def submit(self, work):
        return SimpleNamespace(result=work)


@pytest.mark.parametrize(
    "command", ["check", "check --independent", "errata", "codegen numpy --check"]
)
def test_commands_replay_and_require(command, monkeypatch, run):
    """Double A_a wherever it is stated: no checker accepts it, and nothing is made of it."""
    text = TEXT.replace('"E_d/(c_a*c_ad)"', '"4*E_d/(c_a*c_ad)"')
    for place in ("rigidsym.io.ledger.ledger_text", "rigidsym.solution._formulas.sealed_text"):
        monkeypatch.setattr(place, lambda: text)
    # Another process would replay the ledger as it is.
    monkeypatch.setattr("rigidsym._cli.code.ProcessPoolExecutor", Here)
    said = run(command, status=1 if command.startswith("check") else 2).err
    assert "refused" in said or "in the ledger it is 4*E_d/(c_a*c_ad)" in said


@pytest.mark.parametrize("checker", [[], ["--independent"]])
def test_what_is_only_assumed_is_no_success(checker, tmp_path, run):
    """Admit 0 = 1 with a reference as ASSUMED: `check` says so, and fails."""
    ledger = data()
    fact = part(ledger, "facts", "period_functions.complete")
    claim = {**fact, "id": "period_functions.wrong", "lhs": ["0"], "rhs": ["1"], "grade": "ASSUMED"}
    claim["certificate"] = {"reference": "hearsay"}
    ledger["facts"].append(claim)
    path = tmp_path / "ledger.json"
    path.write_text(written(ledger))
    told = run("check", path, *checker, status=1)
    assert "1 ASSUMED facts" in told.out
    assert told.err == "rigidsym check: 1 ASSUMED: facts must be ENCLOSED at least\n"


def edit(ledger, random):
    """Make one random change of what theorems rest on: a context, a fact, or a publication."""
    named = [*theorems(SPECIFICATION)]
    kind = random.choice(["contexts", "facts", "published"])
    if kind == "facts":
        facts = [f for f in ledger["facts"] if f["context"] in named and f["lhs"]]
        fact = random.choice(facts)
        if random.random() < 0.2:
            fact["grade"] = "ENCLOSED"
        side, k = fact[random.choice(["lhs", "rhs"])], random.randrange(len(fact["lhs"]))
        side[k % len(side)] = f"2*({side[k % len(side)]})"
        return
    if kind == "published":
        listed = sequences(ledger)
        items = listed[random.choice([*listed])]
    else:
        context = part(ledger, "contexts", random.choice(named))
        field = random.choice(["generators", "units", "relations", "nonnegative", "definitions"])
        items = context[field]
    if isinstance(items, dict):
        name = random.choice([*items] or [""])
        items |= {name: f"2*({items[name]})"} if name else {"more": "1"}
    elif items and random.random() < 0.5:
        del items[random.randrange(len(items))]
    elif items:
        items.insert(0, items[-1]) if isinstance(items[0], dict) else items.append(f"{items[0]}7")


def refused_edits(seeds):
    """Count the edited ledgers that are refused; the two readers must not differ on any."""
    count = 0
    for seed in seeds:
        ledger = data()
        edit(ledger, random.Random(seed))
        count += bool(refused(ledger))
    return count


def test_both_readers_agree_on_random_edits():
    """Some edits are none: a name or a definition that no theorem mentions."""
    assert refused_edits(range(40)) >= 12


@pytest.mark.slow
def test_both_readers_agree_on_many_random_edits():
    assert refused_edits(range(2000)) >= 600


def test_what_is_trusted_does_not_grow():
    """Compare with `rigidsym audit`: its counts are at most those of the page."""
    audits = audit(SPECIFICATION, LEDGER)
    assert [one.theorem for one in audits] == [*theorems(SPECIFICATION)]
    said = {row[0]: int(row[1]) for row in rows("trust.md") if len(row) == 2 and row[1].isdigit()}
    found = {f"{kind}:": count for kind, count in totals(audits).items()}
    names = {"numpy": "generated NumPy", "c": "generated C", "javascript": "generated JavaScript"}
    names |= {"rust": "generated Rust", "c_single": "single-precision C"}
    found |= {names[target]: beside(target) for target in TARGETS}
    for label, count in found.items():
        (told,) = (number for text, number in said.items() if label in text)
        assert count <= told, label


@pytest.mark.usefixtures("replayed_once")
def test_audit_is_a_command(run):
    told = json.loads(run("audit --json").out)
    assert told["totals"] == totals(audit(SPECIFICATION, LEDGER))
    text = run("audit").out
    assert "theta_form: nome of k_1^2" in text
    assert text.splitlines()[-1].startswith("by hand: ")


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("lemma a: b", "no block"),
        ("theorem a: b\n\ntheorem a: c", "no block"),
        ("theorem a: b\n    given x", "no clause"),
    ],
)
def test_a_specification_out_of_order_is_refused(text, rule):
    with pytest.raises(ValueError, match=rule):
        read(text)
    with pytest.raises(Refused, match="specification"):
        blocks(text)
