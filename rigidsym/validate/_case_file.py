"""Samples as case files, which `rigidsym propagate` reads."""

from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path

from rigidsym import _inputs as inputs
from rigidsym.io._files import write_text
from rigidsym.io.cases import load_case
from rigidsym.validate.strata import Sample
from rigidsym.view._report_data import Numbers

FIELDS = ("inertia", "omega0", "attitude0", "times")


def hexadecimal(sample: Sample) -> Numbers:
    """Return the exact numbers of a sample: doubles in hexadecimal, others as fractions."""
    return {
        "inertia": list(map(_text, sample.inertia)),
        "omega0": list(map(_text, sample.omega0)),
        "attitude0": list(map(_text, sample.attitude0)),
        "times": list(map(_text, sample.times)),
    }


def toml(sample: Sample, remarks: Iterable[str] = ()) -> str:
    """Return the text of a case file."""
    lines = [f"# {remark}" for remark in remarks]
    numbers = hexadecimal(sample)
    for name in FIELDS:
        listed = ", ".join(f'"{x}"' for x in numbers[name])
        lines.append(f"{name} = [{listed}]")
    return "\n".join(lines) + "\n"


def write(path: Path, sample: Sample, remarks: Iterable[str] = ()) -> Path:
    """Write a case file."""
    return write_text(path, toml(sample, remarks))


def file_name(sample: Sample) -> str:
    """Return a file name made of stratum and index."""
    return f"{'-'.join(sample.stratum.replace(',', '').split())}-{sample.index}.toml"


def read(path: str) -> Sample:
    """Read the sample of a case file, with times rounded to doubles; raises InputError for none."""
    case = load_case(path)
    numbers = (tuple(map(_number, values)) for values in case.motion.exact.values())
    return Sample(path, 0, *numbers, tuple(inputs.doubles("times", case.times)))


def _number(value: Fraction) -> float | Fraction:
    """A double where that says it."""
    nearest = float(value) if abs(value) < 2**1023 else 0.0
    return nearest if Fraction(nearest) == value else value


def _text(value: float | Fraction) -> str:
    return str(value) if isinstance(value, Fraction) else float(value).hex()
