"""The packages of the extra `app`, or one line that says which are missing."""

from importlib.util import find_spec


def require(user: str, *names: str) -> None:
    """Raise ImportError, in one line, for the packages of these names that are not installed."""
    missing = [name for name in names if find_spec(name) is None]
    if missing:
        needed = ", ".join(missing)
        message = f"{user} needs {needed} (extra app): pip install 'rigidsym[app]'"
        raise ImportError(message, name=missing[0])
