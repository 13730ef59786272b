"""What `numpy_runtime` finds around it in the generated module, for linters and type checkers."""

RESULTS = ()


def _excess(*values):
    raise NotImplementedError


def _plan(*values):
    raise NotImplementedError


def _state(t, *values):
    raise NotImplementedError


def _quarter_period(mc):
    raise NotImplementedError


def _complete_j(n, mc):
    raise NotImplementedError


def _steady(*values):
    raise NotImplementedError
