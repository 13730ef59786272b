"""Printer of decisions as Python functions over NumPy arrays, where a number is one of each body.

The same functions take floats.  A choice computes both values, and takes one for each body.
"""

import ast
from collections.abc import Collection, Iterable, Iterator
from textwrap import wrap
from typing import Any

from rigidsym._codegen.routines import SIZE, Program, Routine, Scope, Type, copied
from rigidsym._codegen.targets.numpy.inlining import inlined

# Functions of the module, by the primitives and operations that they are.
CALLS = {
    **{"sqrt": "_sqrt", "dd_sqrt": "_sqrt", "dd_size": "abs", "dd_rounded": "_rounded"},
    **{"choose": "_choose", "dd_choose": "_choose", "pair": "_DoubleDouble"},
    **{"dd_of": "_DoubleDouble", "scaled_by": "_ldexp"},
    **{"product_error": "_product_error", "exponent": "_power", "ldexp": "_ldexp"},
    **{"split_product_error": "_product_error"},
    **{"bits_of": "_bits_of", "from_bits": "_from_bits", "abs": "abs"},
    **{
        "copysign": "np.copysign",
        "log": "np.log",
        "log2": "np.log2",
        "exp2": "np.exp2",
        "discriminant_dd": "_discriminant",
    },
}
OPERATIONS = {"add": ast.Add, "sub": ast.Sub, "mul": ast.Mult, "div": ast.Div}
_CONDITIONS = {"isfinite": "abs({}) < math.inf", "isnan": "{0} != {0}"}


def decisions(program: Program, roots: Iterable[str], own: Collection[str]) -> list[Routine]:
    """Return the routines that a runtime calls, each after what it calls itself.

    own: the names of those that the module has otherwise.
    """
    apart = {*own, *CALLS} | {name for name in program.routines if name.startswith("dd_")}
    found, queue = dict[str, Routine](), [*roots]
    while queue:
        name = queue.pop()
        if name not in found:
            found[name] = inlined(program.routines[name], program, CALLS)
            queue += found[name].calls() & program.routines.keys() - apart
    return [found[name] for name in program.in_order().routines if name in found]


def text(one: Routine, program: Program) -> str:
    """Return the text of a routine as a function of arrays."""
    return _Printed(one, program).text()


def name_of(one: Routine) -> str:
    """Return the name of a routine's function."""
    name = f"_{one.name}"
    return name if one.name.startswith("dd_") else CALLS.get(one.name, name)


def fresh(one: Routine) -> set[str]:
    """Return the names of sums and products, which may change in place: nobody else has them."""
    declared = (part for part in one.statements() if isinstance(part, ast.AnnAssign))
    return {ast.unparse(part.target) for part in declared if isinstance(part.value, ast.BinOp)}


class _Printed(ast.NodeTransformer):
    """Change of a decision to a function of arrays."""

    def __init__(self, one: Routine, program: Program) -> None:
        self.one, self.program, self.scope = one, program, Scope(one, program)
        self.own = {*one.parameters, *one.locals()}
        self.fresh = fresh(one)

    def text(self) -> str:
        """Return the text of the function."""
        body = [line for part in self.one.body for line in self._lines(part, "    ")]
        head = f"def {name_of(self.one)}({', '.join(self.one.parameters)}):"
        words = [f"    {line}".rstrip() for line in f'"""{self.one.summary}'.splitlines()]
        words[-1] += '"""' if len(words) == 1 else '\n    """'
        return "\n".join([head, *words, *body])

    def _lines(self, node: ast.stmt, indent: str) -> Iterator[str]:
        self.scope.declare(node)
        if words := getattr(node, "note", ""):
            yield from wrap(
                words, 100, initial_indent=f"{indent}# ", subsequent_indent=f"{indent}# "
            )
        match node:
            case ast.If() if self._is_plain(node.test):
                yield f"{indent}if {ast.unparse(node.test)}:"
                for part in node.body:
                    yield from self._lines(part, f"{indent}    ")
                yield f"{indent}else:"
                for part in node.orelse:
                    yield from self._lines(part, f"{indent}    ")
            case ast.If(
                test=test,
                body=[ast.Assign(targets=[target], value=ast.Call(func=called, args=given))],
                orelse=[],
            ):
                # Where this is rare: for the bodies concerned alone.
                names, function = ast.unparse(target), f"_{ast.unparse(called)}"
                values = ", ".join(map(self._value, given))
                known = f"{self._value(test)}, {function}, {names}, ({values})"
                yield f"{indent}{names.strip('()')} = _only({known})"
            case ast.For():
                yield f"{indent}for {ast.unparse(node.target)} in {ast.unparse(node.iter)}:"
                for part in node.body:
                    yield from self._lines(part, f"{indent}    ")
            case ast.AnnAssign(target=target, value=None):
                # Elements are set one by one.
                if shape := self.scope.of(target).shape:
                    yield f"{indent}{ast.unparse(target)} = [None] * {shape[0]}"
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield f"{indent}{ast.unparse(target)} = {self._value(value)}"
            case ast.Assign(targets=[target], value=value):
                names, found = ast.unparse(target).strip("()"), self._value(value)
                paired = f"_paired({found})" if self._has_halves(value) else found
                yield f"{indent}{names} = {paired}"
            case ast.AugAssign(target=ast.Name(id=name), value=value) if name in self.fresh:
                symbol = ast.unparse(node).split()[1]
                yield f"{indent}{name} {symbol} {self._value(value)}"
            case ast.AugAssign(target=target, op=op, value=value):
                # Not in place: the array may be a caller's.
                whole = ast.BinOp(target, op, value)
                yield f"{indent}{ast.unparse(target)} = {self._value(whole)}"
            case ast.Return(value=ast.Tuple(elts=parts)):
                yield f"{indent}return {', '.join(map(self._value, parts))}"
            case ast.Return(value=ast.expr() as value):
                yield f"{indent}return {self._value(value)}"
            case _:
                raise ValueError(f"{self.one.name}: {ast.unparse(node)}: is no line of a decision")

    def _is_plain(self, test: ast.expr) -> bool:
        """Return True for a condition on the counts of loops alone."""
        names = [x.id for x in ast.walk(test) if isinstance(x, ast.Name)]
        return all(self.scope.types.get(name) == SIZE for name in names)

    def _has_halves(self, node: ast.expr) -> bool:
        """Return True for a call of a derived function that returns pairs as their halves."""
        match node:
            case ast.Call(func=ast.Name(id=name)) if name in self.program.routines:
                one = self.program.routines[name]
                several = len(one.results) > 1 and bool(one.names)
                return several and all(x.is_pair for x in one.results)
        return False

    def _value(self, node: ast.expr) -> str:
        return ast.unparse(self.visit(copied(node)))

    def _type(self, node: ast.expr) -> Type:
        return self.scope.of(node)

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Write limits in capitals."""
        if node.id == "inf":
            return ast.Attribute(ast.Name("math", ast.Load()), "inf", ast.Load())
        if node.id in self.program.numbers and node.id not in self.own:
            return ast.Name(node.id.upper(), node.ctx)
        return node

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        """Select the element of each body where the place differs between bodies."""
        value, place = self.visit(node.value), self.visit(node.slice)
        if self._type(node.slice).name == "int" and not isinstance(node.slice, ast.Constant):
            return _call("_taken", value, place)
        return ast.Subscript(value, place, node.ctx)

    def visit_IfExp(self, node: ast.IfExp) -> ast.expr:
        """Compute both values."""
        return _call("_where", *map(self.visit, (node.test, node.body, node.orelse)))

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """Combine conditions element by element."""
        operation: Any = ast.BitAnd() if isinstance(node.op, ast.And) else ast.BitOr()
        first, *others = map(self.visit, node.values)
        for other in others:
            first = ast.BinOp(first, operation, other)
        return first

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        """Negate conditions element by element."""
        operand = self.visit(node.operand)
        if isinstance(node.op, ast.Not):
            return ast.BinOp(operand, ast.BitXor(), ast.Constant(True))
        return ast.UnaryOp(node.op, operand)

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        """Keep 64 bits of what may have more."""
        changed = ast.BinOp(self.visit(node.left), node.op, self.visit(node.right))
        if isinstance(node.op, ast.Mult | ast.LShift) and self._type(node).name == "bits":
            return ast.BinOp(changed, ast.BitAnd(), ast.Name("_MASK", ast.Load()))
        return changed

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Call what the module has."""
        name, given = ast.unparse(node.func), [self.visit(one) for one in node.args]
        kind, _, verb = name.partition("_")
        operation = verb.partition("_")[0]
        if kind == "dd" and operation in OPERATIONS:
            return ast.BinOp(given[0], OPERATIONS[operation](), given[1])
        if name == "dd_neg":
            return ast.UnaryOp(ast.USub(), given[0])
        if name in _CONDITIONS:
            text = _CONDITIONS[name].format(ast.unparse(given[0]))
            return ast.parse(text, mode="eval").body
        if name in CALLS or name == "range":
            return _call(CALLS.get(name, name), *given)
        if name not in self.program.routines:
            raise ValueError(f"{self.one.name}: {name}: the module has no such function")
        return _call(f"_{name}", *given)


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])
