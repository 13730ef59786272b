"""Tests that cut routines have the statements, names and types of the whole."""

import ast

import pytest

from rigidsym._codegen.pieces import pieces, read_in_place, shortened
from rigidsym._codegen.routines import Program, Type, routine

CHAIN = "\n".join(f"    x_{k}: double = x_{k - 1} * 0.5 + x_{k - 3}" for k in range(3, 40))
MORE = CHAIN.replace("x_", "y_")
TEXT = f'''
def whole(x: double, n: int, to: out[double[3]]) -> double:
    """Return a number."""
    x_0: double = x
    x_1: double = x + 1.0
    x_2: double = x + 2.0
{CHAIN}
    if n < 0:
        return x_39
    y_0: double = x_39
    y_1: double = x_4
    y_2: double = x
    to[0] = y_0
{MORE}
    for k in range(3):
        z: double = y_39 + double(k)
        to[k] = z * z + y_20
    return y_39 + x_5
'''


def parsed(text=TEXT):
    (node,) = ast.parse(text).body
    one = routine(node)
    return one, Program(routines={one.name: one})


def lines(one, program):
    """Count the lines of a routine as Python."""
    own = (part for part in one.body if not isinstance(part, ast.Pass))
    return 1 + sum(len(ast.unparse(part).splitlines()) for part in own)


def ran(routines, *given):
    """Run routines as Python, and return the last one's value."""
    text = "\n".join(
        f"def {one.name}({', '.join(one.parameters)}):\n"
        + "\n".join(
            f"    {line}" for part in one.body or [ast.Pass()] for line in plain(part).splitlines()
        )
        for one in routines
    )
    names = {"double": float, "Work": type("Work", (), {})}
    exec(text, names)
    return names[routines[-1].name](*given)


def plain(part):
    """Return a statement as Python that runs: a struct is declared by its name."""
    match part:
        case ast.AnnAssign(target=ast.Name(id=name), annotation=ast.Name(id=kind), value=None):
            return f"{name} = Work()" if kind.endswith("_work") else "pass"
    return ast.unparse(part)


@pytest.mark.parametrize("most", [50, 40, 20])
@pytest.mark.parametrize("n", [-1, 1])
def test_pieces_compute_what_the_whole_does(most, n):
    one, program = parsed()
    _, routines = pieces(one, program, lines, most)
    assert len(routines) > 1
    assert all(lines(piece, program) <= most for piece in routines)
    found, expected = [0.0] * 3, [0.0] * 3
    value = ran(routines, 1.5, n, found)
    assert value == ran([one], 1.5, n, expected)
    assert found == expected


def test_shared_names_have_their_types_and_others_stay_local():
    one, program = parsed()
    struct, (first, *_, last) = pieces(one, program, lines, 40)
    assert {field.type for field in struct.fields} == {Type("double")}
    assert set(first.parameters) == {"x", "work"}
    assert first.parameters["work"].is_out
    shared = {field.name for field in struct.fields}
    assert {"x_39", "x_5", "y_39"} <= shared
    assert len(shared) < 20
    assert last.name == "whole"
    assert last.results == one.results


def test_what_a_piece_writes_is_out_and_what_it_reads_is_not():
    one, program = parsed()
    _, routines = pieces(one, program, lines, 40)
    writing = [piece for piece in routines[:-1] if "to" in piece.parameters]
    assert len(writing) == 2
    assert all(piece.parameters["to"].is_out for piece in writing)
    assert not any(piece.parameters["x"].is_out for piece in routines if "x" in piece.parameters)


def test_short_routines_stay_as_they_are():
    _, program = parsed()
    assert shortened(program, lines, 200).routines == program.routines


def test_a_routine_that_ends_everywhere_is_not_cut():
    text = "def whole(x: double) -> double:\n" + "    if x < 1.0:\n        return x\n" * 20
    one, program = parsed(text + "    return x\n")
    with pytest.raises(ValueError, match="whole: 42 lines in a piece, of 30 at most"):
        pieces(one, program, lines, 30)


def test_members_are_read_in_place():
    text = """
def state(motion: circular, t: double) -> double:
    a: double = motion.a
    b: double = motion.b
    c: double = a * t
    return c + b
"""
    one, _ = parsed(text)
    short = read_in_place(one)
    assert [ast.unparse(x) for x in short.body] == [
        "c: double = motion.a * t",
        "return c + motion.b",
    ]
