"""Words for codes, and the digest of a module."""


@public
def message(code: int) -> text:
    """The message of a code, in one line: the field and its rule."""
    return MESSAGES[code] if code >= 0 and code < CODES else UNKNOWN


@public
def field(code: int) -> text:
    """The field of the input that a code is about, "" for none."""
    return FIELDS[code] if code >= 0 and code < CODES else ""


@public
def rule(code: int) -> text:
    """The rule of the input that a code says is broken."""
    return RULES[code] if code >= 0 and code < CODES else UNKNOWN


@public
def digest() -> text:
    """The digest of the header and the source, for callers of a shared library."""
    return DIGEST
