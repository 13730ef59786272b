"""The command line in this process."""

import shlex

import pytest

from rigidsym.cli import main


@pytest.fixture
def run(capsys):
    """Run a command; return what it prints as `out` and `err`.

    The first argument is split as a shell splits it, the others are taken as they are.
    """

    def run(command, *arguments, status=0):
        capsys.readouterr()
        try:
            found = main([*shlex.split(command), *map(str, arguments)])
        except SystemExit as leaving:
            found = leaving.code
        assert found == status
        return capsys.readouterr()

    return run


@pytest.fixture
def refused(run):
    """Run a command that is refused with status 2; return its one line of error."""

    def refused(command, *arguments, status=2):
        (error,) = run(command, *arguments, status=status).err.splitlines()
        return error

    return refused
