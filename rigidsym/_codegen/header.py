"""The head of every generated module: domain, conventions, grades, measured errors."""

import hashlib
import json
import re
from pathlib import Path

from rigidsym._codegen.forms import PI, STEP, THETA, limits
from rigidsym._codegen.special_functions import (
    angles,
    carlson,
    exponential,
    landen,
    nome,
    reduction,
    short_time,
    theta_circular,
    theta_hyperbolic,
)
from rigidsym._version import __version__
from rigidsym.errors import InputError

DIGEST = "@digest@"
# Written by `rigidsym validate TARGET --record`.
MEASURED_FILE = Path(__file__).with_name("measured.json")
MEASURED = "@measured@"
SHARES = "@shares@"
_OF_MOTIONS = """\
Domain: positive principal moments of inertia, none below 2^{min_moment_ratio} of another; finite
rates and attitude; |omega0 t| up to 2^{max_angle} rad, and less for motions that binary64 cannot
tell from the separatrix, or from spin about the middle axis.  What lies outside is refused.
Numbers mean their exact binary64 values.
Conventions: quaternions are scalar first, unit, body to inertial, with q' = q (0, omega)/2 and
continuous in the double cover from the attitude given; omega in body axes, rad/s; inertia in
kg m^2; t in s."""
_OF_STEPS = """\
Domain: positive principal moments of inertia, none below 2^{min_moment_ratio} of another; finite
rates and attitude; steps of |omega dt| up to 2^{max_step} rad, forwards or back.  What lies outside
is refused.  Numbers mean their exact binary64 values.
Conventions: quaternions are scalar first, unit, body to inertial, with q' = q (0, omega)/2 and
continuous in the double cover from the attitude given; omega in body axes, rad/s; inertia in
kg m^2; dt in s."""
_DOMAINS = {THETA: _OF_MOTIONS, PI: _OF_MOTIONS, STEP: _OF_STEPS}
_LINES = """\
A comment says what its line is.  `fact`: the ledger has it, as a proved fact, as `definition` (what
a quantity is short for), as `reading` (the standard function that it is) or as `choice` (the sign
that makes a theorem's hypothesis hold); then come equations of the paper that this carries.
`classical`: a formula of the Digital Library of Mathematical Functions (DLMF).  `arithmetic`: sums,
products, quotients, roots and reductions; exact ones of doubles are Knuth's (The Art of Computer
Programming, 4.2.2), Dekker's (1971) and Sterbenz's (1974).
{shares}

{grades}"""
_GRADES = {
    THETA: """\
Grades: facts are PROVED by normal form; the thetas' slopes and Watson's identity, hypotheses there,
are PROVED by Fourier coefficients.  Special functions (Landen's ladder, nome, theta series, angles
and their reduction) are truncated as follows; `rigidsym._codegen.special_functions` proves the
bounds in exact or ball arithmetic, `pytest tests/codegen/special_functions` holds them against
mpmath:""",
    PI: """\
Grades: facts are PROVED by normal form; that the integral grows equally in every half period, by
uniqueness of solutions.  Special functions (Landen's ladder, the arithmetic-geometric mean,
Carlson's R_J, angles and their reduction) are truncated as follows;
`rigidsym._codegen.special_functions` proves the bounds in exact or ball arithmetic, but for those
said to be measured, and `pytest tests/codegen/special_functions` holds all against mpmath:""",
    STEP: """\
Grades: facts are PROVED by normal form.  Special functions (series for short times, sine and
cosine) are truncated as follows, for bodies that can exist; `rigidsym._codegen.special_functions`
proves the bounds in exact or ball arithmetic, `pytest tests/codegen/special_functions` holds them
against mpmath:""",
}


def special_functions(form: str) -> list[str]:
    """Return the error bounds of the special functions, a line each."""
    return [*_LADDERS[form](), *_everywhere()]


def _everywhere() -> list[str]:
    """Return the bounds that every form has."""
    sine = reduction.sine_bound(reduction.sine_coefficients(reduction.TERMS))
    cosine = reduction.cosine_bound(reduction.cosine_coefficients(reduction.TERMS))
    return [
        f"  arctangent and logarithm       relative, below {_up(float(angles.series_tail()))}",
        f"  sin(pi f), cos(pi f)           absolute, below {_up(sine)} and {_up(cosine)}",
        "  reduction by half turns        argued, not proved: within 2^-54 half turns below 2^46",
    ]


def _landen() -> str:
    return (
        f"  Landen's ladder, {landen.STEPS} steps       modulus left, squared, below "
        f"{_up(float(landen.modulus_left()))}"
    )


def _theta() -> list[str]:
    """Return the bounds that the theta form alone has."""
    imaginary = float(theta_hyperbolic.series_tail())
    return [
        _landen(),
        f"  nome                           relative, below {_up(float(nome.series_tail()))}",
        "  theta series in a state        what is left out below "
        f"{_up(theta_circular.series_tail())}, of imaginary time {_up(imaginary)}",
    ]


def _pi() -> list[str]:
    """Return the bounds that the Pi form alone has."""
    return [
        _landen(),
        f"  complete integrals, {landen.MEANS} means   "
        f"relative, {_up(landen.MEANS_MEASURED)} measured",
        f"  of it in a state, {landen.STATE_STEPS} steps      modulus left, squared, below "
        f"{_up(float(landen.modulus_left(landen.STATE_STEPS)))}",
        f"  R_J, {carlson.STEPS} duplications           in psi/2, {_up(carlson.MEASURED)} measured",
    ]


def _step() -> list[str]:
    """Return the bounds that steps alone have."""
    return [
        f"  X and Y, {short_time.TERMS} terms of series    "
        f"relative, below {_up(float(short_time.elapsed_tail()))} up to 8 rad",
        f"  J, {short_time.J_TERMS} terms of series         in psi/2 after all doublings, "
        f"below {_up(float(short_time.third_kind_tail()))} up to 8 rad",
    ]


_LADDERS = {THETA: _theta, PI: _pi, STEP: _step}


def _exponential() -> str:
    """Return the error bound of the exponential, which NumPy brings itself."""
    left_out = exponential.bound(exponential.coefficients(exponential.TERMS))
    return f"  exp(x), x <= 0                 relative, below {_up(left_out)}"


def _up(value: float) -> str:
    """Round a bound up to two digits."""
    text = f"{value:.1e}"
    return text if float(text) >= value else f"{value * 1.05:.1e}"


def text(target: str, form: str) -> str:
    """Return the head, with marks for shares of lines, the digest and measured errors."""
    bounds = [
        *special_functions(form),
        *([_exponential()] if target == "c" and form != STEP else []),
    ]
    ends = [f"rigidsym {__version__}, emitter {target}/2", f"digest {DIGEST}"]
    domain = _DOMAINS[form].format(**{limit.name: limit.exponent for limit in limits(form)})
    lines = _LINES.format(shares=SHARES, grades=_GRADES[form])
    return "\n".join([domain, "", lines, *bounds, "", MEASURED, "", *ends])


def sealed(files: dict[str, str], target: str) -> tuple[dict[str, str], str]:
    """Return the files with digest and measured errors in place, and the digest.

    It covers everything but itself and the measured errors, which hold for one digest alone.
    """
    covered = "\0".join(f"{name}\0{text}" for name, text in files.items())
    digest = hashlib.sha256(covered.encode()).hexdigest()
    return {name: filled(text, target, digest) for name, text in files.items()}, digest


def filled(text: str, target: str, digest: str) -> str:
    """Put the digest, and the errors measured of code that has it, in place of their marks."""
    return text.replace(MEASURED, _measured(target, digest)).replace(DIGEST, digest)


def unsealed(text: str, target: str, digest: str) -> str:
    """Put the marks back: the inverse of `filled`."""
    return text.replace(digest, DIGEST).replace(_measured(target, digest), MEASURED)


def digest_in(file: str, text: str) -> str:
    """Return the digest that a file names; raise InputError where it names none, or several."""
    found = set(re.findall(r"\b[0-9a-f]{64}\b", text))
    if len(found) != 1:
        raise InputError(file, f"{len(found)} digests", "a module names its own, and no other")
    return found.pop()


def _measured(target: str, digest: str) -> str:
    """Return the worst errors by regime, of exactly this code."""
    return "\n".join(_measured_lines(target, digest))


def _measured_lines(target: str, digest: str) -> list[str]:
    known = json.loads(MEASURED_FILE.read_text("utf-8")) if MEASURED_FILE.is_file() else {}
    found = known.get(target)
    if not found or found["digest"] != digest:
        return [
            f"Errors: not measured since this code changed; `rigidsym validate {target} --record`"
        ]
    lines = [
        f"Worst errors measured by `{found['command']}`:",
        "rotation angle in rad, |domega|/|omega|",
    ]
    return lines + [f"  {name:22} {angle:.1e}  {rate:.1e}" for name, angle, rate in found["worst"]]
