"""Long formulas are broken into rows that fit, and keep every letter."""

import json
import re

import pytest

from rigidsym.io.ledger import ledger_text
from rigidsym.language._expression import parse
from rigidsym.language._latex import Printer, place
from rigidsym.language._lines import rows, width
from rigidsym.view._statements import aligned_rows

SUM = " + ".join(rf"a_{{{k}}} x^{{{k}}}" for k in range(30))
PRINTER = Printer(place, None)


def test_a_short_formula_is_one_row():
    assert rows("x + y", 20) == ["x + y"]


@pytest.mark.parametrize("most", [20, 40, 60])
@pytest.mark.parametrize(
    "text",
    [
        SUM,
        rf"\left({SUM}\right) \left({SUM.replace('a', 'b')}\right)",
        rf"\frac{{{SUM}}}{{{SUM.replace('a', 'b')}}}",
        rf"\sqrt{{{SUM}}}",
        " ".join(rf"\Omega_{{{k}}}" for k in range(40)),
    ],
)
def test_rows_fit_and_keep_all_letters(text, most):
    found = rows(text, most)
    assert len(found) > 1
    assert max(map(width, found)) <= most + 2
    whole = " ".join(found)
    letters = re.compile(r"[a-z]_\{\d+\}|\+")
    assert letters.findall(whole) == letters.findall(text)
    assert whole.count("(") == whole.count(")")


def test_brackets_stretch_only_inside_a_row():
    for row in rows(rf"\left({SUM}\right) \left(x + y\right)", 40):
        assert row.count(r"\left") == row.count(r"\right")


def test_no_row_begins_or_ends_in_the_middle_of_a_function():
    text = " + ".join(rf"c_{{{k}}} \cos \phi_{{{k}}} \sin {{\psi_{{{k}}}}}" for k in range(20))
    for row in rows(text, 20):
        assert not re.search(r"\\(cos|sin|cdot)$|[=,(]$", row)


def test_a_long_left_side_does_not_move_the_others():
    short, long = aligned_rows([("x", "=", "1"), (SUM[:200], "=", "2")])[:2]
    assert short == "x &= 1"
    assert long.startswith("&a_{0}")


def test_rows_of_the_sealed_ledger_fit():
    contexts = json.loads(ledger_text())["contexts"]
    texts = {text for context in contexts for text in context["definitions"].values()}
    printed = [PRINTER.of(parse(text)) for text in texts]
    assert sum(width(text) > 60 for text in printed) > 20
    assert all(width(row) <= 62 for text in printed for row in rows(text, 60))


def test_a_matrix_is_not_broken_and_is_as_wide_as_its_columns():
    entry = "x + y + z + 10"
    matrix = rf"\left[\begin{{matrix}}{entry} & 1 \\ 1 & {entry}\end{{matrix}}\right]"
    assert rows(f"x + {matrix} + y", width(matrix) + 5) == [f"x + {matrix}", "+ y"]
    assert width(matrix) >= 2 * width(entry)
    assert width(matrix + entry) == width(matrix) + width(entry)
