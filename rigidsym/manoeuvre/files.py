"""Manoeuvre files, with the tables of the flight that tracks them."""

from importlib import resources
from pathlib import Path

from rigidsym.io import toml as toml_file
from rigidsym.manoeuvre.manoeuvre import Manoeuvre, load, parse

PAPER = "paper.toml"
# What `rigidsym.manoeuvre.flight.settings.Flight` consists of; those who only plan pass it by.
FLIGHT = frozenset(
    {
        *("orbit", "wheels", "thrusters", "controller", "spacecraft", "disturbances", "run"),
        "message",
    }
)


def open_manoeuvre(name: str) -> tuple[Manoeuvre, toml_file.TomlTable]:
    """What a file asks for, and all of its tables; `paper` is the file of the package.

    Raises InputError about the first bad thing of the manoeuvre itself.
    """
    if name != "paper":
        return load(Path(name), FLIGHT)
    text = resources.files("rigidsym.manoeuvre").joinpath(PAPER).read_text("utf-8")
    tables = toml_file.parse("manoeuvre", text)
    return parse(tables, FLIGHT), tables
