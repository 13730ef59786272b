"""Links within the repository made links within the site, or words where there is no page."""

import re
from collections.abc import Mapping

_LINK = re.compile(r"(?<!\!)\[((?:[^\[\]]|\[[^\]]*\])+)\]\(([^()\s]+)\)")


def within(text: str, pages: Mapping[str, str]) -> str:
    """Markdown whose relative links lead to pages, by the last part of what they name."""
    # Links may hold code in their words; code may hold what looks like a link.
    blocks = re.split(r"(```.*?```)", text, flags=re.DOTALL)
    return "".join(x if k % 2 else _LINK.sub(lambda m: _led(m, pages), x)
                   for k, x in enumerate(blocks))  # fmt: skip


def _led(found: re.Match[str], pages: Mapping[str, str]) -> str:
    words, target = found.groups()
    if re.match(r"[a-z]+:|#", target):
        return found[0]
    place, _, anchor = target.partition("#")
    page = pages.get(place.rstrip("/").rpartition("/")[2])
    if page is None:
        return words
    return f"[{words}]({page}{f'#{anchor}' if anchor else ''})"


def pictures(text: str) -> list[str]:
    """The files of the repository that Markdown or HTML in it shows as pictures."""
    found = re.findall(r"!\[[^\]]*\]\(([^()\s]+)\)|(?:src|srcset)=\"([^\"]+)\"", text)
    names = (markdown or html for markdown, html in found)
    return list(dict.fromkeys(name for name in names if not re.match(r"[a-z]+:", name)))
