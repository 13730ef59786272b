"""Functions that run the commands `validate` and `compare-forms`."""

import signal
from argparse import Namespace
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from rigidsym._cli.output import progress, reader_may_leave, say, table
from rigidsym.errors import InputError
from rigidsym.io._files import probe, write_text

if TYPE_CHECKING:
    from rigidsym.validate._campaign import Campaign, Progress
    from rigidsym.validate._sensitivities import Sensitive

# Options of a campaign that mean nothing elsewhere.
_NOT_WITH = {
    "case": ("cases", "stratum", "workers", "scheduler", "record"),
    "faults": ("peer", "workers", "scheduler", "record"),
    "sensitivity": ("digits", "peer", "workers", "scheduler", "record", "output", "json"),
    "fits": ("targets", "digits", "peer", "workers", "scheduler", "record", "output", "json"),
    "torques": ("targets", "digits", "peer", "workers", "scheduler", "record", "output", "json"),
}
# Applications by the options that measure them.
_APPLICATIONS = {"fits": "rigidsym.validate._fits", "torques": "rigidsym.validate._torques"}


def compare_forms(options: Namespace) -> int:
    """Measure and print the costs and errors of the solution's three forms."""
    from rigidsym.validate._forms import COLUMNS, STRATA_COLUMNS, compare_forms

    if options.output:
        probe(options.output)
    found = compare_forms(progress("compare-forms"))
    if options.output:
        written = {"json": found.to_json(), "md": found.to_markdown(), "svg": found.to_svg()}
        for kind, text in written.items():
            write_text(options.output / f"forms.{kind}", text)
    with reader_may_leave():
        if options.json:
            print(found.to_json(), end="")
        else:
            table("rigidsym compare-forms", COLUMNS, [one.row() for one in found.costs])
            title = "worst errors by stratum, in NumPy"
            table(title, STRATA_COLUMNS, [one.row() for one in found.strata])
            print(found.conclusion)
    return 0


def validate(options: Namespace) -> int:
    """Run the validation that the options select, and print its report.

    This measures modules, injected faults, sensitivities, fits or torques.  Returns 1 if an error
    bound is broken.
    """
    from rigidsym.validate import _session as session

    mode = next((name for name in _NOT_WITH if getattr(options, name)), "")
    for name in _NOT_WITH.get(mode, ()):
        if getattr(options, name) not in (None, False, []):
            raise InputError(name, "given", f"is not for --{mode}")
    if options.output and not options.resume:
        probe(options.output)
    # What a batch system sends is an interrupt, too.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    if mode in _APPLICATIONS:
        return _validate_application(mode, options)
    done = session.begin(_chosen(options), None if mode else options.output, options.resume)
    if options.case:
        return _validate_case(done.campaign, options)
    if options.sensitivity:
        return _validate_sensitivity(done.campaign)
    return _validate_faults(done.campaign, options) if options.faults else _run(done, options)


def _chosen(options: Namespace) -> dict[str, Any]:
    """Convert the command's options to the arguments of a validation campaign.

    Without targets these are all that can be measured on this machine.
    """
    from rigidsym import _engines as engines
    from rigidsym.validate._implementations import missing
    from rigidsym.validate.faults import TARGETS as FAULTY

    targets = options.targets
    if not (targets or options.resume):
        reasons = missing(FAULTY if options.faults else engines.ENGINES)
        for target, reason in reasons.items():
            if reason:
                say(f"{target} is not measured: {reason}")
        targets = [target for target, reason in reasons.items() if not reason]
    chosen = {
        "targets": targets or (None if options.resume else targets),
        "peers": options.peer,
        "strata": options.stratum,
        "cases": options.cases,
        "digits": options.digits,
        "seed": options.seed,
    }
    return {name: value for name, value in chosen.items() if value is not None}


def _run(done: "Progress", options: Namespace) -> int:
    from rigidsym.validate import _executors as executors
    from rigidsym.validate import _session as session
    from rigidsym.validate import _validation as validation

    place = (
        executors.local(options.workers)
        if options.scheduler is None
        else executors.cluster(options.scheduler)
    )
    report = validation.run(done, place, progress("validate"))
    if options.output:
        say(f"report: {session.write(report, options.output)}")
        done.remove()
    if options.record:
        say(f"recorded: {session.record(report)}")
        report = replace(report, other_bits=())
    run = report.run
    say(
        f"{run['enclosed states']} states in {run['seconds']} s, "
        f"{run['enclosed states a second']} a second, {run['place']}"
    )
    for complaint in report.complaints:
        say(f"broken: {complaint}")
    title = f"{report.command}: worst errors in units of 2^-53"
    with reader_may_leave():
        if options.json:
            print(report.to_json(), end="", flush=True)
        else:
            table(title, *report.summary())
            print(report.conclusion)
    return 0 if report.passed else 1


def _validate_case(campaign: "Campaign", options: Namespace) -> int:
    import json

    from rigidsym.io._files import write_text
    from rigidsym.validate import _session as session
    from rigidsym.validate._finding import case_text, file_name
    from rigidsym.validate._report import case_table

    finding = session.replay(options.case, campaign)
    if options.output:
        path = options.output / file_name(finding.sample)
        say(f"case: {write_text(path, case_text(finding.sample))}")
    with reader_may_leave():
        if options.json:
            print(json.dumps(finding.to_data(), indent=1, sort_keys=True))
        else:
            print(case_text(finding.sample), end="")
            table(f"{options.case}, {finding.reference.regime.value}", *case_table(finding))
    return 0 if max(map(finding.share, campaign.targets)) <= 1 else 1


def _validate_sensitivity(campaign: "Campaign") -> int:
    from rigidsym.validate._sensitivities import HEADS, WIDER, by_stratum, references

    modules = {target: _sensitive(target) for target in campaign.targets}
    truth = references(campaign.cases, campaign.seed, campaign.strata)
    worst = [
        (target, found) for target, module in modules.items() for found in by_stratum(module, truth)
    ]
    broken = [(target, found) for target, found in worst if not found.is_within]
    for target, found in broken:
        say(f"broken: {target}: {found.stratum}: {found.error:.1e}")
    with reader_may_leave():
        title = "rigidsym validate --sensitivity: errors of columns"
        table(title, ("module", *HEADS), [(target, *found.row()) for target, found in worst])
        for stratum in dict.fromkeys(found.stratum for _, found in worst):
            if stratum in WIDER:
                print(f"{stratum}: {WIDER[stratum].why}")
    return 1 if broken else 0


def _validate_application(name: str, options: Namespace) -> int:
    from importlib import import_module

    from rigidsym.validate._applications import HEADS, Application
    from rigidsym.validate._campaign import CASES, SEED

    application: Application[object] = import_module(_APPLICATIONS[name]).APPLICATION
    cases = options.cases or CASES
    seed = SEED if options.seed is None else options.seed
    strata = options.stratum or list(application.strata)
    show, outcomes = progress(f"validate --{name}"), []
    for outcome in application.outcomes(cases, seed, strata):
        outcomes.append(outcome)
        show(len(outcomes), cases * len(strata))
    broken = list(application.goal.broken(outcomes))
    for sentence in broken:
        say(f"broken: {sentence}")
    with reader_may_leave():
        title = f"rigidsym validate --{name}: true error over the promised one"
        table(title, HEADS, list(application.rows(outcomes)))
    return 1 if broken else 0


def _sensitive(target: str) -> "Sensitive":
    from rigidsym._engines import EngineError
    from rigidsym.validate._implementations import implementation
    from rigidsym.validate._sensitivities import of_engine

    try:
        return of_engine(implementation(target))
    except EngineError as error:
        raise InputError("target", target, error.rule) from None


def _validate_faults(campaign: "Campaign", options: Namespace) -> int:
    from rigidsym.validate.faults import inject

    drawn = (campaign.targets, campaign.cases, campaign.digits, campaign.seed)
    report = inject(*drawn, progress=progress("validate --faults"), strata=campaign.strata)
    if options.output:
        write_text(options.output / "faults.json", report.to_json())
        write_text(options.output / "faults.md", report.to_markdown())
    for fault in report.missed:
        say(f"not caught: {fault.target}: {fault.name}")
    with reader_may_leave():
        if options.json:
            print(report.to_json(), end="", flush=True)
        else:
            print(f"{report.to_markdown()}\n{report.conclusion}", flush=True)
    return 0 if report.passed else 1
