"""The reference of file formats: fields and samples of files that the tool writes right now.

Every field has to be explained here, and everything explained has to occur: else building fails.
"""

import json
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from unittest.mock import patch

from generate import fits, manoeuvres
from generate.form import Format
from generate.outline import paths, sample
from generate.text import code, fenced, prose, table
from rigidsym._codegen import generate
from rigidsym.io import _tables as states
from rigidsym.io.cases import _KEYS, PAPER, parse_case
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.precise import _comparison as comparison
from rigidsym.proof.derivation import derive
from rigidsym.proof.kernel import _rules as ledgers
from rigidsym.proof.paper import Verdict, judged, verdicts
from rigidsym.proof.paper._verdicts import Ruling
from rigidsym.validate import _campaign as campaigns
from rigidsym.validate import validate
from rigidsym.validate._executors import local
from rigidsym.validate._report import SCHEMA as VALIDATION
from rigidsym.validate.faults import _detection as detection
from rigidsym.validate.faults import _injection as faults
from rigidsym.validate.faults import by_hand

_HEAD = """# File formats

All files are UTF-8. JSON names its schema in `schema`; a number after the slash that changes says
that something old was changed, not only added. Samples on this page were written by this version of
the tool when the page was built; where `// and so on` stands, entries were left out.
"""
STRATUM = "paper"


def page() -> str:
    """Files in TOML and tables, then a section for each schema."""
    return "\n".join([_HEAD, _case(), manoeuvres.files(), _tables(), *map(_section, FORMATS)])


def _section(form: Format) -> str:
    data = _masked(form.make(), form.masked)
    kinds: dict[str, set[str]] = {}
    for path, kind in paths(data, form.named):
        kinds.setdefault(path, set()).add(kind)
    check(form, set(kinds))
    rows = [
        (code(path), " or ".join(sorted(kinds[path])), prose(words))
        for path, words in form.fields.items()
    ]
    return "\n".join(
        [
            f"## {code(form.title)}\n",
            f"Written by {form.written}.\n",
            table(("field", "", ""), rows),
            fenced("javascript", sample(data, form.named)),
        ]
    )


def check(form: Format, found: set[str]) -> None:
    """Raise ValueError for a field that is not explained, and for an explanation of none."""
    for path in found:
        if path != "schema" and not any(_covers(known, path) for known in form.fields):
            raise ValueError(f"{form.title}: {path} is not explained")
    for path in form.fields:
        if path not in found:
            raise ValueError(f"{form.title}: {path} does not occur")


def _covers(known: str, path: str) -> bool:
    """A field, what leads to it, and what is in it where that is not explained apart."""
    return path == known or known.startswith((f"{path}.", f"{path}[")) or (
        path.startswith((f"{known}.", f"{known}["))
    )  # fmt: skip


def _masked(data: Any, masks: Mapping[str, Any], path: str = "") -> Any:
    if path in masks and data is not None:
        return masks[path]
    if isinstance(data, Mapping):
        return {k: _masked(x, masks, f"{path}.{k}".lstrip(".")) for k, x in data.items()}
    if isinstance(data, list):
        return [_masked(x, masks, f"{path}[]") for x in data]
    return data


_CASE = {
    "inertia": "three principal moments, kg m²",
    "omega0": "three body rates at t = 0, rad/s",
    "attitude0": "quaternion, scalar first, body to inertial, normalised; the identity if absent",
    "times": "seconds: a list, or a table of `start`, `stop` and `count`, both ends included",
    "degrees": "optional: true where `omega0` is in deg/s",
    "message": "optional, for `--format aem`, under options of the command line: `epoch`, "
    "`time_system`, `object_name`, `object_id`, `originator`, `creation_date`, `ref_frame_a`, "
    "`ref_frame_b`",
}


def _paper() -> str:
    from importlib import resources

    return resources.files("rigidsym.io").joinpath(PAPER).read_text("utf-8")


def _case() -> str:
    if _CASE.keys() != _KEYS:
        raise ValueError(f"case files: {sorted(_CASE.keys() ^ _KEYS)}")
    rows = [(code(key), prose(words)) for key, words in _CASE.items()]
    return "\n".join(
        [
            "## Case files: TOML\n",
            "Read by `rigidsym propagate` and `rigidsym methods`, written for failures by "
            "`rigidsym validate`. Numbers may be TOML floats, which mean their exact binary64 "
            'value, or strings, which are taken exactly: decimals, fractions (`"1/3"`), '
            'hexadecimal doubles (`"0x1.8p-3"`) and, for `--enclose`, uncertain '
            'ones (`"0.0109 +/- 1e-6"`).\n',
            table(("key", ""), rows),
            fenced("toml", _paper()),
        ]
    )


def _example(times: str = "times = [0, 180]") -> Any:
    head = _paper().partition("[times]")[0]
    return parse_case(f"{times}\n{head}")


def _tables() -> str:
    """CSV and NPZ, of the same states."""
    case = _example()
    plain_csv = states.to_csv(states.doubles(case)).decode()
    balls = states.to_csv(states.balls(case, 6)).decode()
    return "\n".join(
        [
            "## States as CSV and NPZ\n",
            "Written by `rigidsym propagate`, with `--format csv`, the default, or `npz`. "
            "Numbers are the shortest decimals that stand for the doubles, or `--digits` "
            "significant digits. With `--enclose` each number takes two columns.\n",
            fenced("text", plain_csv),
            fenced("text", balls),
            "NPZ files hold float64 arrays `t` (N,), `q` (N, 4) and `omega` (N, 3).\n",
        ]
    )


def _json(data: bytes | str) -> Any:
    return json.loads(data)


def _states() -> Any:
    return _json(states.to_json(states.doubles(_example())))


def _balls() -> Any:
    return _json(states.to_json(states.balls(_example("times = [180]"), 12)))


def _errata() -> Any:
    ruled = [v for v in verdicts(ledger_data(ledger_text())) if _is_full(v)]
    prose = [claim.to_json() for claim in judged(ledger_data(ledger_text()))][:1]
    equations = [verdict.to_json() for verdict in ruled]
    return {"schema": "rigidsym.errata/2", "equations": equations, "prose": prose}


def _is_full(verdict: Verdict) -> bool:
    """A misprint in which every field says something."""
    every = (verdict.ruling == Ruling.MISPRINT, verdict.repairs, verdict.conditions)
    return all((*every, verdict.needed_by, verdict.readings, verdict.right_with))


def _ledger() -> Any:
    data = ledger_data(ledger_text())
    shown = ("line32", "line32.by_invariants")
    published = {**data["published"]}
    published["sequences"] = {"constants": published["sequences"]["constants"]}
    return {
        "schema": ledgers.SCHEMA,
        "contexts": [c for c in data["contexts"] if c["name"] == shown[0]],
        "facts": [f for f in data["facts"] if f["id"] == shown[1]],
        "published": published,
    }


def _methods() -> Any:
    """Return a comparison at a time that Taylor series reach soon, at two distances, run once."""
    with patch.multiple(comparison, DISTANCES=("1e-1", "0"), REPEATS=1):
        return _json(comparison.compare(_example('times = ["0.1"]'), [15]).to_json())


def _validation() -> Any:
    return _json(validate(["numpy"], cases=1, strata=[STRATUM]).to_json())


def _campaign() -> Any:
    with tempfile.TemporaryDirectory() as folder, local(1) as place:
        campaign = campaigns.Campaign.of(["numpy"], cases=1, strata=[STRATUM])
        progress = campaigns.Progress(campaign, directory=Path(folder))
        campaigns.complete(progress, place)
        progress.save()
        return _json(Path(folder, campaigns.NAME).read_text("utf-8"))


def _faults() -> Any:
    """One fault against one stratum."""
    cases = [detection.references(STRATUM, 1, 40, 1)]
    tried = ((x, detection.detections(x, cases)) for x in by_hand() if x.target == "numpy")
    outcome = next(faults.Outcome(x, tuple(found)) for x, found in tried if found)
    return faults.FaultReport(("numpy",), (STRATUM,), 1, 40, 1, (outcome,)).to_data()


def _map() -> Any:
    module = generate("c")
    (name,) = (name for name in module.texts() if name.endswith(".map.json"))
    return _json(module.texts()[name])


_CELL = "`count` figures, the worst of them in `units`, its `condition`, `case` and time `t`"
_CASE_DATA = (
    "a case in full: its numbers in hexadecimal, the errors of each implementation, `replay`"
)
_MEASURED = "one method with these digits, `null` where it was not run"
FORMATS = (
    Format(
        states.SCHEMA,
        "`rigidsym propagate --format json`",
        _states,
        {
            "states": "one for each time",
            "states[].t": "s",
            "states[].q": "attitude, scalar first, unit, body to inertial",
            "states[].omega": "body rates, rad/s",
        },
    ),
    Format(
        f"{states.SCHEMA} with --enclose",
        "`rigidsym propagate --enclose --format json`: every number a ball",
        _balls,
        {
            "states": "one for each time",
            "states[].t": "s; its radius is zero where the time is a decimal of that length",
            "states[].q": "attitude",
            "states[].q[].mid": "the middle",
            "states[].q[].rad": "the true value is at most so far from the middle",
            "states[].omega": "body rates, rad/s",
        },
    ),
    Format(
        "rigidsym.errata/2",
        "`rigidsym errata --json`",
        _errata,
        {
            "equations[].equation": "its number, or what the paper calls it",
            "equations[].latex": "as it is printed",
            "equations[].reading": "how it is read",
            "equations[].verdict": ", ".join(f"`{ruling.value}`" for ruling in Ruling),
            "equations[].conditions": "of the equation, or of its repair where it is a misprint",
            "equations[].repair": "what mends it, LaTeX; empty where nothing has to be",
            "equations[].repairs_found": "what a search over small edits found",
            "equations[].root_causes": "the independent slips that it comes from",
            "equations[].right_as_printed_with": "lines that make it right as printed once mended",
            "equations[].counterexample": "an exact `point` where it fails as printed, `left` and "
            "`right` side there, and the `motion` that is there; or `null`",
            "equations[].proved_by": "facts of the ledger that say what it says",
            "equations[].refuted_by": "facts that hold a counterexample",
            "equations[].repaired_by": "facts that say what its repair says",
            "equations[].conditions_needed_by": "facts that show a condition necessary",
            "equations[].readings": "ways to read the print, and whether it holds so",
            "equations[].flaws": "what is wrong with the print, whether or not it is false",
            "equations[].mutants": "what became of the statements made wrong on purpose",
            "prose[].claim": "what the paper claims in words",
            "prose[].where": "where the paper says so",
            "prose[].judgement": "whether it is so: a judgement",
            "prose[].reason": "why",
            "prose[].facts": "facts of the ledger that it rests on",
            "prose[].measured_by": "commands that measure what it rests on",
        },
        frozenset({f"equations[].{name}" for name in
                   ("counterexample", "conditions_needed_by", "flaws", "mutants")}),
    ),
    Format(
        "rigidsym.derive/3",
        "`rigidsym derive --json`",
        lambda: _json(derive(["lie_algebra"]).to_json()),
        {
            "chapters[].chapter": "the module under `derivations`",
            "chapters[].title": "its first words",
            "chapters[].computed": "how many of its facts have a side that SymPy computed",
            "chapters[].chosen": "how many name a root, say a relation again, or make a context "
            "a model of another or its cases",
            "chapters[].printed": "how many are lines of the paper",
            "chapters[].stated": "how many are laws that a result is held against",
            "chapters[].guessed": "how many were typed, and then decided by the kernel",
            "chapters[].facts[].id": "context and name",
            "chapters[].facts[].statement": "in one line",
            "chapters[].facts[].grade": "how it is known",
            "chapters[].facts[].source": "equations of the paper that it is about",
            "chapters[].facts[].standing": "computed, chosen, stated, printed or guessed",
            "chapters[].facts[].reasons": "why a guess was not computed, or which law is stated",
            "chapters[].facts[].joined": "typed expressions that arithmetic put beside what was "
            "computed",
        },
    ),
    Format(
        ledgers.SCHEMA,
        "`rigidsym derive`; read by `rigidsym check`, and by everything that needs numbers",
        _ledger,
        {
            "contexts[].name": "what facts refer to",
            "contexts[].generators": "names of quantities; later ones are larger in normal forms",
            "contexts[].witness": "a rational point that satisfies all hypotheses",
            "contexts[].units": "not zero",
            "contexts[].definitions": "abbreviations",
            "contexts[].relations": "zero",
            "contexts[].rates": "d/dt of the generators that are not constant; `null`: one instant",
            "contexts[].nonnegative": "at least zero",
            "contexts[].start": "zero at one instant",
            "contexts[].thetas": "generators that are parts of theta functions, and of which",
            "contexts[].reading": "what the names stand for; proves nothing",
            "facts[].id": "context and name",
            "facts[].context": "its hypotheses",
            "facts[].kind": "what `lhs` and `rhs` say: `equal`, `root`, `nonnegative`, `unequal`, "
            "`model` or `partition`",
            "facts[].lhs": "left sides, component by component",
            "facts[].rhs": "right sides",
            "facts[].rule": "the rule of the kernel that accepts it",
            "facts[].grade": "of the rule and the weakest premise",
            "facts[].premises": "facts it rests on",
            "facts[].source": "equations of the paper that it is about",
            "facts[].certificate": "what the rule checks: cofactors, a point, cases, "
            "an identity of theta functions with its arguments, or a reference",
            "published": "for readers; proves nothing",
            "published.sequences": "formulas in order of evaluation, by the name of the whole",
            "published.sequences.NAME[].fact": "the id of a proved formula, or instead of it",
            "published.sequences.NAME[].context": "the context that says so",
            "published.sequences.NAME[].definition": "a name and what that defines it as, or",
            "published.sequences.NAME[].reading": "a name and what that reads it as",
            "published.sequences.NAME[].source": "equations of the paper that it is about",
            "published.repairs": "equations that a search found for what is refuted",
            "published.repairs[].fact": "the refuted fact",
            "published.repairs[].lhs": "left side",
            "published.repairs[].rhs": "right side",
            "published.mutants": "by fact: how many mutants are refuted, refused or equivalent",
        },
        frozenset({"contexts[].witness", "contexts[].definitions", "contexts[].rates",
                   "contexts[].reading", "published.sequences", "published.mutants"}),
    ),
    Format(
        comparison.SCHEMA,
        "`rigidsym methods --json`, and as `methods.json` with `-o DIR`",
        _methods,
        {
            "motion": "exact numbers, as decimals or fractions",
            "neighbour": "a motion on the separatrix of nearly this body, or `null`",
            "time": "s",
            "by_digits": f"{_MEASURED}; `distance` is `null`",
            "by_distance": "the same on motions off the separatrix by `distance`",
            "by_digits[].method": ", ".join(f"`{name}`" for name in comparison.NAMES),
            "by_digits[].seconds": "set-up and one state, median",
            "by_digits[].seconds_more": "one more state, median",
            "by_digits[].error": "bound on that of the seven midpoints",
            "by_digits[].radius": "the largest; `null` for Taylor series",
        },
        masked={f"{part}[].{name}": 0.001
                for part in ("by_digits", "by_distance") for name in ("seconds", "seconds_more")},
    ),
    *manoeuvres.FORMATS,
    *fits.FORMATS,
    Format(
        VALIDATION,
        "`rigidsym validate --json`, and as `validation.json` with `-o DIR`",
        _validation,
        {
            "campaign": "what was measured: equal campaigns have equal reports, but for `run`",
            "command": "writes this report",
            "passed": "whether nothing is to be complained of",
            "complaints": "why it did not pass, a line for each reason",
            "unit": "of all figures",
            "bounds": "the documented bound of each measure",
            "meanings": "what each measure is",
            "strata": "cases and states of each, and how far the oracles disagree, "
            "as part of `agreement`",
            "agreement": "what the oracles have to agree to",
            "implementations[].name": "a target, or a peer with `peer` before it",
            "implementations[].peer": "whether it is one",
            "implementations[].digest": "of the module; `null` for peers",
            "implementations[].passed": "whether all is within the bounds",
            "implementations[].strata": f"by stratum and measure: {_CELL}",
            "implementations[].shares": "the same in parts of the bound; `count` is what was "
            "beyond it",
            "implementations[].share": "the largest of these in each stratum, \"inf\" where "
            "untested",
            "implementations[].regimes": "by regime of motion and measure",
            "implementations[].sizes": "histograms in half octaves, by stratum and measure",
            "implementations[].distance": "by measure and decade of the distance from the "
            "separatrix",
            "implementations[].turned": "by measure and decade of |omega0 t|",
            "implementations[].condition": "by measure and decade of the condition, up to 1e40",
            "worst": _CASE_DATA,
            "failures": "the worst broken bound of each target in each stratum, `simplest` a case",
            "run": "how and where: all that differs from run to run",
        },
        frozenset({"implementations[].share"} | {f"implementations[].{view}{inner}"
                   for view in ("strata", "shares", "regimes", "sizes", "distance", "turned",
                                "condition")
                   for inner in ("", ".NAME", ".NAME.NAME")}
                  | {"worst[].errors", "worst[].errors.NAME"})
        - {f"implementations[].{view}.NAME.NAME"
           for view in ("strata", "shares", "regimes", "distance", "turned", "condition")},
        masked={"run": {"place": "1 process", "seconds": 0.5}},
    ),
    Format(
        faults.SCHEMA,
        "`rigidsym validate --faults --json`, and as `faults.json` with `-o DIR`",
        _faults,
        {
            "targets": "whose texts were changed",
            "cases": "samples of each stratum",
            "digits": "of the oracle",
            "seed": "of the cases",
            "passed": "whether each fault was caught by some stratum",
            "kinds": "what kinds of faults there are",
            "strata": "how many faults each caught, how many no other did, `of` how many",
            "faults[].target": "whose text is changed",
            "faults[].name": "what is wrong",
            "faults[].kind": "one of `kinds`",
            "faults[].old": "the text that is replaced",
            "faults[].new": "by this",
            "faults[].options": "of the compiler, beyond the usual ones",
            "faults[].caught": "by stratum: the first case, and the measures that say so",
        },
        frozenset({"kinds", "strata", "faults[].caught"}),
    ),
    Format(
        campaigns.SCHEMA,
        f"`rigidsym validate -o DIR` every few seconds, as `{campaigns.NAME}`; read by "
        "`--resume`, and removed when the report is written",
        _campaign,
        {
            "campaign": "what is measured; `--resume` refuses another one",
            "sha256": "of the rest: what was changed is refused",
            "done": "by stratum, ranges of cases that are in the tally",
            "tally": "counts, and a list of cells: target, measure, view, part, count, worst, "
            "stratum, index, time, condition",
        },
    ),
    Format(
        "TARGET.map.json",
        "`rigidsym codegen`; read by `rigidsym trace`",
        _map,
        {
            "manifest": "target, digest of the module, SHA-256 of its files",
            "lines": "by file",
            "lines.NAME[].line": "its number, from 1",
            "lines.NAME[].equations": "of the paper, or of the DLMF",
            "lines.NAME[].facts": "of the ledger; `definition` or `reading` before the name says "
            "that its context does",
        },
        frozenset({"lines"}),
    ),
)  # fmt: skip
