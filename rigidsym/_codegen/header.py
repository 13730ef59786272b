"""Header text of generated modules: domain, conventions, grades of proof, and errors."""

import hashlib
import json
import re
from fractions import Fraction
from functools import cache
from pathlib import Path

from rigidsym._codegen.formats import BINARY64, Format
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
_DOMAIN = """\
Domain: positive principal moments of inertia, none below 2^{min_moment_ratio} of another; finite
rates and attitude; {reach}
Conventions: quaternions are scalar first, unit, body to inertial, with q' = q (0, omega)/2 and
continuous in the double cover from the attitude given; omega in body axes, rad/s; inertia in
kg m^2; {time} in s."""
_OF_MOTIONS = """\
|omega0 t| up to 2^{max_angle} rad, and less for motions that binary64 cannot
tell from the separatrix, or from spin about the middle axis.  What lies outside is refused.
Numbers mean their exact binary64 values."""
_OF_STEPS = """\
steps of |omega dt| up to 2^{max_step} rad, forwards or back.  What lies outside
is refused.  Numbers mean their exact binary64 values."""
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


@cache
def special_functions(form: str, binary: Format = BINARY64) -> tuple[str, ...]:
    """Return the error bounds of a form's special functions, as lines of text."""
    sine = reduction.sine_bound(reduction.sine_coefficients(binary.trigonometric, binary))
    cosine = reduction.cosine_bound(reduction.cosine_coefficients(binary.trigonometric, binary))
    turns = next(x.exponent for x in limits(THETA, binary) if x.name == "max_angle")
    everywhere = [
        f"  arctangent and logarithm       relative, below {_up(angles.series_tail(binary))}",
        f"  sin(pi f), cos(pi f)           absolute, below {_up(sine)} and {_up(cosine)}",
        "  reduction by half turns        argued, not proved: within "
        f"2^-{binary.digits + 1} half turns below 2^{turns}",
    ]
    if form == STEP:
        own = [
            f"  X and Y, {binary.elapsed} terms of series    "
            f"relative, below {_up(short_time.elapsed_tail(binary))} up to 8 rad",
            f"  J, {binary.third_kind} terms of series         in psi/2 after all doublings, "
            f"below {_up(short_time.third_kind_tail(binary))} up to 8 rad",
        ]
        return (*own, *everywhere)
    own = [
        f"  Landen's ladder, {binary.landen} steps       modulus left, squared, below "
        f"{_up(landen.modulus_left(binary.landen))}"
    ]
    if form == THETA:
        own += [
            f"  nome                           relative, below {_up(nome.series_tail(binary))}",
            "  theta series in a state        what is left out below "
            f"{_up(theta_circular.series_tail(binary))}, of imaginary time "
            f"{_up(theta_hyperbolic.series_tail(binary))}",
        ]
    else:
        own += [
            f"  complete integrals, {landen.MEANS} means   "
            f"relative, {_up(landen.MEANS_MEASURED)} measured",
            f"  of it in a state, {landen.STATE_STEPS} steps      modulus left, squared, below "
            f"{_up(landen.modulus_left(landen.STATE_STEPS))}",
            f"  R_J, {carlson.STEPS} duplications           "
            f"in psi/2, {_up(carlson.MEASURED)} measured",
        ]
    return (*own, *everywhere)


def _up(bound: float | Fraction) -> str:
    """Format a bound, rounded up to two significant digits."""
    value = float(bound)
    text = f"{value:.1e}"
    return text if float(text) >= value else f"{value * 1.05:.1e}"


def text(target: str, form: str, binary: Format = BINARY64) -> str:
    """Return the header text of a module, with placeholders for numbers not yet known.

    These are the counts of lines, the digest and the measured errors.
    """
    bounds = [*special_functions(form, binary)]
    if target != "numpy" and form != STEP:
        # NumPy brings the exponential itself.
        left_out = exponential.bound(exponential.coefficients(binary))
        bounds.append(f"  exp(x), x <= 0                 relative, below {_up(left_out)}")
    ends = [f"rigidsym {__version__}, emitter {target}/2", f"digest {DIGEST}"]
    known = {limit.name: limit.exponent for limit in limits(form, binary)}
    reach, time = (_OF_STEPS, "dt") if form == STEP else (_OF_MOTIONS, "t")
    domain = _DOMAIN.format(reach=reach.format(**known), time=time, **known)
    lines = _LINES.format(shares=SHARES, grades=_GRADES[form])
    domain = domain.replace(BINARY64.name, binary.name)
    if binary is not BINARY64:
        lines = lines.replace("exact ones of doubles", "exact ones of floats")
    return "\n".join([domain, "", lines, *bounds, "", MEASURED, "", *ends])


def sealed(files: dict[str, str], target: str) -> tuple[dict[str, str], str]:
    """Fill in the digest and the measured errors in the files of a module.

    Returns the files and the digest.  The digest covers all but itself and the measured errors,
    which hold for one digest alone.
    """
    covered = "\0".join(f"{name}\0{text}" for name, text in files.items())
    digest = hashlib.sha256(covered.encode()).hexdigest()
    return {name: filled(text, target, digest) for name, text in files.items()}, digest


def filled(text: str, target: str, digest: str) -> str:
    """Fill a text's placeholders with a digest and with the errors measured for that digest."""
    return text.replace(MEASURED, _measured(target, digest)).replace(DIGEST, digest)


def unsealed(text: str, target: str, digest: str) -> str:
    """Replace the digest and the measured errors in a text by placeholders.

    This is the inverse of `filled`.
    """
    return text.replace(digest, DIGEST).replace(_measured(target, digest), MEASURED)


def digest_in(file: str, text: str) -> str:
    """Return the digest in a file.

    Raises InputError for none or several.
    """
    found = set(re.findall(r"\b[0-9a-f]{64}\b", text))
    if len(found) != 1:
        raise InputError(file, f"{len(found)} digests", "a module names its own, and no other")
    return found.pop()


def _measured(target: str, digest: str) -> str:
    """Format the worst measured errors of a module, by regime.

    Errors hold only for the code with this digest.
    """
    known = json.loads(MEASURED_FILE.read_text("utf-8")) if MEASURED_FILE.is_file() else {}
    found = known.get(target)
    if not found or found["digest"] != digest:
        return (
            f"Errors: not measured since this code changed; `rigidsym validate {target} --record`"
        )
    lines = [
        f"Worst errors measured by `{found['command']}`:",
        "rotation angle in rad, |domega|/|omega|",
        *(f"  {name:22} {angle:.1e}  {rate:.1e}" for name, angle, rate in found["worst"]),
    ]
    return "\n".join(lines)
