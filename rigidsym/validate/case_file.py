"""Samples as case files, which `rigidsym propagate` takes."""

from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path

from rigidsym.files import write_text
from rigidsym.validate.strata import Sample

FIELDS = ("inertia", "omega0", "attitude0", "times")


def hexadecimal(sample: Sample) -> dict[str, list[str]]:
    """Its numbers without loss: doubles in hexadecimal, others as fractions."""
    return {name: [_text(x) for x in getattr(sample, name)] for name in FIELDS}


def toml(sample: Sample, remarks: Iterable[str] = ()) -> str:
    """The text of a case file."""
    lines = [f"# {remark}" for remark in remarks]
    for name, values in hexadecimal(sample).items():
        listed = ", ".join(f'"{x}"' for x in values)
        lines.append(f"{name} = [{listed}]")
    return "\n".join(lines) + "\n"


def write(directory: Path, sample: Sample, remarks: Iterable[str] = ()) -> Path:
    """Write it under a name made of stratum and index."""
    name = "-".join(sample.stratum.replace(",", "").split())
    return write_text(directory / f"{name}-{sample.index}.toml", toml(sample, remarks))


def _text(value: float | Fraction) -> str:
    return str(value) if isinstance(value, Fraction) else float(value).hex()
