"""The packages of extras, `app` first, or one line that says which are missing."""

from importlib.util import find_spec


def require(user: str, *names: str, extra: str = "app") -> None:
    """Raise ImportError, in one line, for the packages of these names that are not installed."""
    missing = [name for name in names if find_spec(name) is None]
    if missing:
        needed = ", ".join(missing)
        message = f"{user} needs {needed} (extra {extra}): pip install 'rigidsym[{extra}]'"
        raise ImportError(message, name=missing[0])
