"""The generated numeric modules; `rigidsym codegen TARGET --check` proves them current."""

from rigidsym._lazy import lazily

__getattr__, __dir__ = lazily(__name__, {})
