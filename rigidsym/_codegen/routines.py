"""Functions with statements: parsing, expansion and types.

Runtime decisions and loops are written once, in the files of `runtime`, in a small typed language
with the syntax of Python.  A function of it is represented by its `ast.FunctionDef`; a target
prints it by one table of the node classes of `ast`.  Derived functions become such functions, too.

Annotations are types: double, int, size, bits, bool, text, pair (a double-double), structs by their
names, and arrays of these, `double[3]` or of unknown length `double[...]`.  `out[...]` is around
what a function writes to, `maybe[...]` around what may be None, and `alone[...]` around what
overlaps nothing else.  A class whose members have values is an enumeration, others are structs.
"""

import ast
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from copy import copy
from dataclasses import dataclass, field, replace
from functools import cache, wraps
from importlib import resources
from typing import Any, TypeVar

from rigidsym._codegen.ir import Constant, Function, Let, is_extended
from rigidsym.language._expression import Call, Expression, Name, Operation, to_text
from rigidsym.language._expression import Number as Whole

# What is around a type in an annotation, and the property of the type that it says.
_MARKS = {"out": "is_out", "maybe": "may_be_none", "alone": "is_alone"}
NUMBERS = ("double", "int", "size", "bits", "bool")
# Primitives whose value is not of the type of their first argument.
_VALUES = {
    **dict.fromkeys(("isfinite", "isnan"), "bool"),
    **dict.fromkeys(("double", "from_bits"), "double"),
    **dict.fromkeys(("size", "sizeof", "shuffled", "shuffled4"), "size"),
    **dict.fromkeys(("int", "exponent"), "int"),
    **dict.fromkeys(("pair", "two_sum", "two_product", "quick_sum", "mantissa"), "pair"),
    **dict.fromkeys(("bits", "bits_of"), "bits"),
}
# Primitives on doubles; those that `arithmetic` has on pairs have names of their own there.
PRIMITIVES = (
    *("abs", "sqrt", "min", "max", "copysign", "isfinite", "isnan", "log", "log2", "exp2"),
    *("sin", "cos", "sinh", "cosh", "asinh", "hypot", "remainder", "exponent", "ldexp"),
    *("nearest", "alternating", "power_of_two", "fused", "product_error", "bits_of"),
    *(
        "from_bits",
        "hidden",
        "pair",
        "prefetch",
        "sizeof",
        "choose",
        "double",
        "int",
        "size",
        "bits",
    ),
    *("rounded", "mantissa", "cleared", "shuffled", "shuffled4"),
)
_SYMBOLS = {"+": ast.Add, "-": ast.Sub, "*": ast.Mult, "/": ast.Div}
_VERBS: dict[type, str] = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div"}
# Routines that primitives of some targets call.
_BEHIND = {"product_error": "split_product_error"}
# What the names of functions of extended numbers begin with, and the type of these.
KINDS = {"dd": "pair", "exact": "exact"}
# Functions of pairs, by the primitive that they are.
OF_PAIRS = {
    **{"sqrt": "dd_sqrt", "abs": "dd_size", "rounded": "dd_rounded", "choose": "dd_choose"},
    **{"exponent": "dd_exponent", "mantissa": "dd_mantissa"},
}


@dataclass(frozen=True, slots=True)
class Type:
    """Type of a value: its name, the lengths of an array, and what an annotation says more.

    shape: the length of each dimension as text, "..." where it is not known.
    """

    name: str
    shape: tuple[str, ...] = ()
    is_out: bool = False
    may_be_none: bool = False
    is_alone: bool = False
    members: tuple[str, ...] = ()

    @property
    def is_number(self) -> bool:
        """Return True for a plain number, which is handed on by value."""
        return self.name in NUMBERS and not self.shape

    @property
    def is_pair(self) -> bool:
        """Return True for a single double-double."""
        return self.name == "pair" and not self.shape

    @property
    def is_struct(self) -> bool:
        """Return True for a single struct."""
        return not (self.shape or self.name in ("pair", "exact", "void", "text", "raw", *NUMBERS))

    @property
    def is_object(self) -> bool:
        """Return True for a single struct or exact number, which is more than one number."""
        return self.is_struct or (self.name == "exact" and not self.shape)

    @property
    def is_result(self) -> bool:
        """Return True for a single number or pair that is written to."""
        return self.is_out and not (self.shape or self.is_struct)

    def element(self) -> "Type":
        """Return the type of an array's elements."""
        return replace(self, shape=self.shape[1:])


DOUBLE, INT, SIZE, BOOL, PAIR = map(Type, ("double", "int", "size", "bool", "pair"))


def type_of_annotation(node: ast.expr) -> Type:
    """Convert an annotation to a type.

    Raises ValueError for what is none.
    """
    match node:
        case ast.Name(id=name):
            return Type(name)
        case ast.Subscript(value=ast.Name(id=mark), slice=inner) if mark in _MARKS:
            return replace(type_of_annotation(inner), **{_MARKS[mark]: True})
        case ast.Subscript(value=ast.Name(id="union"), slice=ast.Tuple(elts=parts)):
            return Type("union", members=tuple(ast.unparse(part) for part in parts))
        case ast.Subscript(value=ast.Name(id=name), slice=ast.Tuple(elts=lengths)):
            return Type(name, tuple(map(_length, lengths)))
        case ast.Subscript(value=ast.Name(id=name), slice=length):
            return Type(name, (_length(length),))
        case ast.Constant(value=str(declaration)):
            return Type("raw", members=(declaration,))
    raise ValueError(f"{ast.unparse(node)}: is no type")


def _length(node: ast.expr) -> str:
    is_unknown = isinstance(node, ast.Constant) and node.value is ...
    return "..." if is_unknown else ast.unparse(node)


@dataclass(frozen=True, slots=True)
class Field:
    """Member of a struct: its name, type and comment."""

    name: str
    type: Type
    comment: str = ""


@dataclass(frozen=True, slots=True)
class Struct:
    """Struct with its members; public ones stand in the interface."""

    name: str
    summary: str
    fields: tuple[Field, ...]
    is_public: bool = False

    def types(self) -> dict[str, Type]:
        """Map the name of each member to its type."""
        return {field.name: field.type for field in self.fields}


@dataclass(frozen=True, slots=True)
class Routine:
    """Function with statements.

    results: the types of its values, none or several; `names` are those of derived functions'
    results.  decorators: "public", "inline" and "flat" say how it is to be printed.
    """

    name: str
    summary: str
    parameters: Mapping[str, Type]
    results: tuple[Type, ...]
    body: tuple[ast.stmt, ...]
    decorators: frozenset[str] = frozenset()
    names: tuple[str, ...] = ()
    function: Function | None = None

    @property
    def is_public(self) -> bool:
        """Return True for a function of the interface."""
        return "public" in self.decorators

    def prints(self, function: Function) -> bool:
        """Return True if it prints a derived function."""
        return self.function is not None and self.function.name == function.name

    def calls(self) -> set[str]:
        """Return the names of the functions that it calls."""
        found = {
            node.func.id
            for node in parts(self.body)
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        }
        return found | {_BEHIND[name] for name in found & _BEHIND.keys()}

    def locals(self) -> set[str]:
        """Return the names that it declares."""
        declared = (x.target for x in self.statements() if isinstance(x, ast.AnnAssign))
        return {target.id for target in declared if isinstance(target, ast.Name)}

    def statements(self) -> Iterator[ast.stmt]:
        """Yield all statements in their order, those within others after these."""
        queue = list(reversed(self.body))
        while queue:
            statement = queue.pop()
            yield statement
            if isinstance(statement, ast.If | ast.For):
                queue += reversed([*statement.body, *statement.orelse])


@dataclass(frozen=True, slots=True)
class Number:
    """Named number, or array of numbers, of a runtime."""

    name: str
    type: Type
    value: ast.expr
    comment: str = ""


def numbered(constant: Constant) -> Number:
    """Return a named number of the derivation as one of a program."""
    if constant.lo is None:
        return Number(constant.name, DOUBLE, ast.Constant(constant.hi), constant.meaning)
    value = ast.parse(f"pair({constant.hi!r}, {constant.lo!r})", mode="eval").body
    return Number(constant.name, PAIR, value, constant.meaning)


@dataclass(frozen=True, slots=True)
class Enumeration:
    """Whole numbers of the interface, with a comment on each."""

    summary: str
    numbers: tuple[Number, ...]


@dataclass(slots=True)
class Program:
    """Structs, named numbers and routines that a target prints, in their order.

    known: the types of names that the target's own text defines.  names: what names are called in
    the target's language, where that differs.
    """

    enumerations: dict[str, Enumeration] = field(default_factory=dict)
    structs: dict[str, Struct] = field(default_factory=dict)
    numbers: dict[str, Number] = field(default_factory=dict)
    routines: dict[str, Routine] = field(default_factory=dict)
    known: dict[str, Type] = field(default_factory=dict)
    names: dict[str, str] = field(default_factory=dict)

    def numbers_of(self, routines: Iterable[Routine]) -> list[Number]:
        """Return the named numbers that routines use, and those that these are made from."""
        used: set[str] = set()
        for one in routines:
            used |= {node.id for node in parts(one.body) if type(node) is ast.Name} - one.locals()
        for number in reversed(self.numbers.values()):
            if number.name in used:
                own = parts([number.value, *map(annotation, number.type.shape)])
                used |= {node.id for node in own if isinstance(node, ast.Name)}
        return [number for name, number in self.numbers.items() if name in used]

    def in_order(self) -> "Program":
        """Put what others use before these: structs before structs, routines before callers."""
        structs = {
            name: {kind for field in one.fields for kind in (field.type.name, *field.type.members)}
            for name, one in self.structs.items()
        }
        routines = {name: one.calls() for name, one in self.routines.items()}
        return replace(
            self,
            structs={name: self.structs[name] for name in _after(structs)},
            routines={name: self.routines[name] for name in _after(routines)},
        )

    def without_idle(self, kept: Iterable[str] = ()) -> "Program":
        """Drop the routines that neither a public routine nor one to be kept needs."""
        wanted = {name for name, one in self.routines.items() if one.is_public} | {*kept}
        queue = list(wanted)
        while queue:
            new = self.routines[queue.pop()].calls() & self.routines.keys() - wanted
            wanted |= new
            queue += new
        routines = {name: one for name, one in self.routines.items() if name in wanted}
        numbers = {number.name: number for number in self.numbers_of(routines.values())}
        return replace(self, routines=routines, numbers=numbers)


def parts(nodes: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """Yield all nodes of some trees, in any order; as `ast.walk`, in a third of the time."""
    queue = list(nodes)
    while queue:
        node = queue.pop()
        yield node
        for value in vars(node).values():
            if isinstance(value, ast.AST):
                queue.append(value)
            elif type(value) is list:
                queue += (part for part in value if isinstance(part, ast.AST))


Tree = TypeVar("Tree", bound=ast.AST)
Made = TypeVar("Made")


def copied(node: Tree) -> Tree:
    """Copy a tree with all that was noted at its nodes."""
    found = copy(node)
    for name, value in vars(node).items():
        if isinstance(value, ast.AST):
            setattr(found, name, copied(value))
        elif type(value) is list:
            setattr(found, name, [copied(x) if isinstance(x, ast.AST) else x for x in value])
    return found


def is_same(one: Any, other: Any) -> bool:
    """Return True if two trees, or parts of them, say the same, wherever they stand.

    Truth values are 1 and 0, and their type is that of whole numbers, as in C.
    """
    if isinstance(one, list):
        return isinstance(other, list) and len(one) == len(other) and all(map(is_same, one, other))
    if not isinstance(one, ast.AST):
        return one == other and (
            type(one) is type(other) or {type(one), type(other)} == {bool, int}
        )
    if type(one) is not type(other):
        return False
    if isinstance(one, ast.Name):
        return one.id == other.id or {one.id, other.id} == {"int", "bool"}
    fields = (name for name in one._fields if name not in ("ctx", "kind", "type_comment"))
    return all(is_same(getattr(one, x, None), getattr(other, x, None)) for x in fields)


def _after(uses: Mapping[str, set[str]]) -> Iterator[str]:
    """Yield names such that each comes after those that it uses."""
    done: set[str] = set()

    def visit(name: str) -> Iterator[str]:
        if name in done:
            return
        done.add(name)
        for other in uses:
            if other in uses[name]:
                yield from visit(other)
        yield name

    for name in uses:
        yield from visit(name)


# --- reading


@cache
def _parsed(name: str) -> ast.Module:
    """Parse a file, and note at each statement the comment before it."""
    text = resources.files("rigidsym._codegen.runtime").joinpath(f"{name}.py").read_text("utf-8")
    found, lines = ast.parse(text, f"{name}.py"), text.splitlines()
    for node in ast.walk(found):
        if isinstance(node, ast.stmt):
            first = node.lineno - 1
            while first and lines[first - 1].lstrip().startswith("#"):
                first -= 1
            words = (line.lstrip(" #") for line in lines[first : node.lineno - 1])
            setattr(node, "note", " ".join(words))  # noqa: B010
    return found


@cache
def files() -> tuple[str, ...]:
    """Return the names of the files of the runtime."""
    home = resources.files("rigidsym._codegen.runtime")
    found = (path.name for path in home.iterdir() if path.name.endswith(".py"))
    return tuple(sorted(name.removesuffix(".py") for name in found))


def defined(names: Iterable[str]) -> Iterator[str]:
    """Yield the names of the functions that files of the runtime define."""
    for name in names:
        yield from (node.name for node in _parsed(name).body if isinstance(node, ast.FunctionDef))


def definition(file: str, name: str) -> ast.FunctionDef | None:
    """Return the tree of a function in a file of the runtime, or None."""
    found = {node.name: node for node in _parsed(file).body if isinstance(node, ast.FunctionDef)}
    return found.get(name)


_REPLACED: ContextVar[Mapping[tuple[str, str], ast.FunctionDef]] = ContextVar("replaced")


@contextmanager
def replaced(by: Mapping[tuple[str, str], ast.FunctionDef]) -> Generator[None]:
    """Replace functions of the runtime in all programs that are read inside a `with` block.

    by: what stands for them, by the names of file and function.
    """
    token = _REPLACED.set(by)
    try:
        yield
    finally:
        _REPLACED.reset(token)


def cached(make: Callable[..., Made]) -> Callable[..., Made]:
    """Cache what a function makes of programs, but not while a function is replaced."""
    known = cache(make)

    @wraps(make)
    def found(*given: Any) -> Made:
        return (make if _REPLACED.get({}) else known)(*given)

    return found


def read(names: Iterable[str], program: Program, constants: Mapping[str, Any]) -> Program:
    """Add what files of the runtime define to a program, expanded and with operations lowered.

    names: the files.  program: what is there already, with the derived functions.  constants:
    values of names that are known when code is generated.
    """
    made = replace(
        program,
        enumerations={**program.enumerations},
        structs={**program.structs},
        numbers={**program.numbers},
        routines={**program.routines},
        known={**program.known},
    )
    raw: list[ast.FunctionDef] = []
    for name in names:
        before: ast.stmt | None = None
        for node in _parsed(name).body:
            before, node_before = node, before
            match node:
                case ast.ClassDef() if values := _members(node):
                    own = Enumeration(ast.get_docstring(node) or "", values)
                    made.enumerations[node.name] = own
                    made.known |= {number.name: number.type for number in values}
                case ast.ClassDef():
                    made.structs[node.name] = _struct(node)
                case ast.FunctionDef():
                    own = _REPLACED.get({}).get((name, node.name), node)
                    raw.append(own)
                    made.routines[node.name] = routine(own)
                case ast.AnnAssign(target=ast.Name(id=target), value=ast.expr() as value):
                    kind = type_of_annotation(node.annotation)
                    made.numbers[target] = Number(target, kind, value)
                case ast.Expr(value=ast.Constant(value=str(text))):
                    if made.numbers and isinstance(node_before, ast.AnnAssign):
                        last = next(reversed(made.numbers))
                        made.numbers[last] = replace(made.numbers[last], comment=text)
                case _:
                    raise ValueError(f"{name}.py:{node.lineno}: {ast.unparse(node)}")
    for node in raw:
        expanded = _Expansion(made, constants, node.name).visit(copied(node))
        made.routines[node.name] = lowered(routine(expanded), made)
    return made


def _members(node: ast.ClassDef) -> tuple[Number, ...]:
    """Return the numbers of an enumeration, a class whose members have values."""
    found: list[Number] = []
    for part in node.body:
        match part:
            case ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value):
                found.append(Number(name, INT, value))
            case ast.Expr(value=ast.Constant(value=str(text))) if found:
                found[-1] = replace(found[-1], comment=text)
    return tuple(found)


def _struct(node: ast.ClassDef) -> Struct:
    fields: list[Field] = []
    for part in node.body:
        match part:
            case ast.AnnAssign(target=ast.Name(id=name)):
                fields.append(Field(name, type_of_annotation(part.annotation)))
            case ast.Expr(value=ast.Constant(value=str(text))) if fields:
                fields[-1] = replace(fields[-1], comment=text)
    is_public = any(ast.unparse(mark) == "public" for mark in node.decorator_list)
    return Struct(node.name, ast.get_docstring(node) or "", tuple(fields), is_public)


def routine(node: ast.FunctionDef) -> Routine:
    """Convert a function's syntax tree to a routine, without expansion."""
    parameters = {
        one.arg: type_of_annotation(one.annotation) for one in node.args.args if one.annotation
    }
    match node.returns:
        case None:
            results: tuple[Type, ...] = ()
        case ast.Subscript(value=ast.Name(id="tuple"), slice=ast.Tuple(elts=parts)):
            results = tuple(map(type_of_annotation, parts))
        case one:
            results = (type_of_annotation(one),)
    summary = ast.get_docstring(node)
    body = tuple(node.body[1:] if summary is not None else node.body)
    marks = frozenset(ast.unparse(mark) for mark in node.decorator_list)
    return Routine(node.name, summary or "", parameters, results, body, marks)


# --- expansion


class _Expansion(ast.NodeTransformer):
    """Expansion of what depends on derived functions and on known constants."""

    def __init__(self, program: Program, constants: Mapping[str, Any], place: str) -> None:
        self.program, self.constants, self.place = program, constants, place
        # Names that stand for all results of a derived function, and the names of these.
        self.together: dict[str, tuple[str, ...]] = {}

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a known constant by its value."""
        if isinstance(node.ctx, ast.Load) and node.id in self.constants:
            value = self.constants[node.id]
            if isinstance(value, int | float) and value < 0:
                return ast.UnaryOp(ast.USub(), ast.Constant(-value))
            return ast.Constant(value)
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        """Expand the body alone."""
        node.body = list(self._all(node.body))
        return node

    def _all(self, statements: Iterable[ast.stmt]) -> Iterator[ast.stmt]:
        for statement in statements:
            match self.visit(statement):
                case None:
                    pass
                case list(several):
                    yield from several
                case one:
                    yield one

    def visit_If(self, node: ast.If) -> Any:
        """Keep one branch where the condition is known."""
        node.test = self.visit(node.test)
        match _value(node.test):
            case None:
                node.body = list(self._all(node.body)) or [ast.Pass()]
                node.orelse = list(self._all(node.orelse))
                return node
            case known:
                return list(self._all(node.body if known else node.orelse))

    def visit_IfExp(self, node: ast.IfExp) -> ast.expr:
        """Keep one value where the condition is known."""
        test = self.visit(node.test)
        known = _value(test)
        if known is None:
            return ast.IfExp(test, self.visit(node.body), self.visit(node.orelse))
        return self.visit(node.body if known else node.orelse)

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """Leave out what is known, or keep it alone where it decides."""
        decides = isinstance(node.op, ast.Or)
        values = [self.visit(value) for value in node.values]
        known = [bool(x.value) for x in values if isinstance(x, ast.Constant)]
        rest = [value for value in values if not isinstance(value, ast.Constant)]
        if decides in known or not rest:
            return ast.Constant(decides in known if decides else decides not in known)
        return rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)

    def visit_For(self, node: ast.For) -> Any:
        """Write a loop over the members of a struct out."""
        match node:
            case ast.For(
                target=ast.Name(id=variable),
                iter=ast.Call(func=ast.Name(id="members"), args=[ast.Name(id=struct)]),
            ):
                found: list[ast.stmt] = []
                for member in self.program.structs[struct].types():
                    for statement in node.body:
                        changed = _Renamed(variable, member).visit(copied(statement))
                        found += self._all([changed])
                return found
        node.iter = self.visit(node.iter)
        node.body = list(self._all(node.body))
        return node

    def visit_Assign(self, node: ast.Assign) -> ast.Assign:
        """Write out all results of a derived function, where one name stands for them."""
        self.generic_visit(node)
        match node:
            case ast.Assign(
                targets=[ast.Name(id=name)], value=ast.Call(func=ast.Name(id=called))
            ) if called in self.program.routines and self.program.routines[called].names:
                self.together[name] = self.program.routines[called].names
                found: list[ast.expr] = [ast.Name(x, ast.Store()) for x in self.together[name]]
                node.targets = [ast.Tuple(found, ast.Store())]
        return node

    def visit_Call(self, node: ast.Call) -> ast.Call:
        """Write out arguments that follow from the parameters of the function called."""
        if not any(isinstance(argument, ast.Starred) for argument in node.args):
            node.args = [self.visit(argument) for argument in node.args]
            return node
        called = self.program.routines.get(ast.unparse(node.func))
        if called is None:
            raise ValueError(f"{self.place}: {ast.unparse(node)}: unknown function")
        least = sum(not isinstance(argument, ast.Starred) for argument in node.args)
        stars = len(node.args) - least
        parameters, found = list(called.parameters), []
        for k, argument in enumerate(node.args):
            if not isinstance(argument, ast.Starred):
                found.append(self.visit(argument))
                continue
            if isinstance(argument.value, ast.Name):
                found += [ast.Name(x, ast.Load()) for x in self.together[argument.value.id]]
                continue
            later = sum(not isinstance(one, ast.Starred) for one in node.args[k + 1 :])
            count = _count(argument.value)
            if count is not None:
                own = parameters[len(found) : len(found) + count]
            elif stars == 1:
                own = parameters[len(found) : len(parameters) - later]
            else:
                own = _run(called, len(found))
            found += [self.visit(one) for one in _starred(argument.value, own)]
        return ast.Call(node.func, found, [])


def _count(node: ast.expr) -> int | None:
    """Return how many arguments `rows(array, apart, count)` asks for, where it says so."""
    match node:
        case ast.Call(func=ast.Name(id="rows"), args=[_, _, ast.Constant(value=int(count))]):
            return count
    return None


def _run(called: Routine, first: int) -> list[str]:
    """Return the parameters from a place on that are all read, or all written."""
    items = list(called.parameters.items())[first:]
    kind = items[0][1].is_out
    found: list[str] = []
    for name, type_ in items:
        if type_.is_out != kind or not type_.shape:
            break
        found.append(name)
    return found


def _starred(node: ast.expr, parameters: list[str]) -> list[ast.expr]:
    match node:
        case ast.Call(func=ast.Name(id="rows"), args=[array, apart, *_]):
            return [_row(array, apart, k) for k in range(len(parameters))]
        case ast.Call(func=ast.Name(id="named"), keywords=keywords):
            given = {str(one.arg): one.value for one in keywords}
            of = given.pop("from_", None)
            if of is not None:
                return [ast.Attribute(of, name, ast.Load()) for name in parameters]
            return [given.get(name) or ast.Name(name, ast.Load()) for name in parameters]
    raise ValueError(f"{ast.unparse(node)}: neither rows(...) nor named(...)")


def _row(array: ast.expr, apart: ast.expr, k: int) -> ast.expr:
    """Return row k of an array, rows `apart` from each other, or where `places[...]` says."""
    match apart:
        case ast.Subscript(value=places, slice=ast.Constant(value=value)) if value is ...:
            place = ast.Subscript(places, ast.Constant(k), ast.Load())
            return ast.Subscript(array, ast.Slice(place, None, None), ast.Load())
    if not k:
        return array
    begin = apart if k == 1 else ast.BinOp(ast.Constant(k), ast.Mult(), apart)
    match array:
        case ast.Subscript(value=whole, slice=ast.Slice(lower=ast.expr() as lower)):
            array, begin = whole, ast.BinOp(lower, ast.Add(), begin)
    return ast.Subscript(array, ast.Slice(begin, None, None), ast.Load())


class _Renamed(ast.NodeTransformer):
    """Replacement of a member's placeholder by its name."""

    def __init__(self, old: str, new: str) -> None:
        self.old, self.new = old, new

    def visit_Attribute(self, node: ast.Attribute) -> ast.Attribute:
        """Replace `.old` by `.new`."""
        self.generic_visit(node)
        return ast.Attribute(node.value, self.new if node.attr == self.old else node.attr, node.ctx)


def _value(node: ast.expr) -> Any:
    """Return the value of a condition of constants, or None."""
    if any(isinstance(part, ast.Name | ast.Call) for part in parts([node])):
        return None
    try:
        return bool(eval(compile(ast.Expression(ast.fix_missing_locations(node)), "", "eval")))
    except TypeError:
        return None


# --- types


class Scope:
    """Types of the names in a routine, and of expressions of them."""

    def __init__(self, one: Routine, program: Program) -> None:
        self.program = program
        numbers = {name: number.type for name, number in program.numbers.items()}
        self.types = {**program.known, **numbers, **one.parameters}

    def of(self, node: ast.expr) -> Type:
        """Return the type of an expression.

        Raises ValueError for names that are not known.
        """
        match node:
            case ast.Constant(value=value):
                return {bool: BOOL, int: INT, float: DOUBLE}.get(type(value), Type("void"))
            case ast.Name(id="inf" | "nan"):
                return DOUBLE
            case ast.Name(id=name):
                if name not in self.types:
                    raise ValueError(f"{name}: is not defined")
                return self.types[name]
            case ast.Attribute(value=value, attr=name):
                of = self.of(value)
                if of.is_pair and name in ("hi", "lo"):
                    return DOUBLE
                if of.name == "union":
                    return Type(name)
                return replace(self.program.structs[of.name].types()[name], is_out=of.is_out)
            case ast.Subscript(value=value, slice=ast.Slice()):
                return replace(self.of(value), shape=("...",))
            case ast.Subscript(value=value, slice=ast.Tuple(elts=parts)):
                found = self.of(value)
                for _ in parts:
                    found = found.element()
                return found
            case ast.Subscript(value=value):
                return self.of(value).element()
            case ast.UnaryOp(op=ast.Not()) | ast.Compare() | ast.BoolOp():
                return BOOL
            case ast.UnaryOp(operand=operand):
                return self.of(operand)
            case ast.IfExp(body=body, orelse=other) | ast.BinOp(left=body, right=other):
                return _wider(self.of(body), self.of(other))
            case ast.Call(func=ast.Name(id=name), args=arguments):
                return self._of_call(name, arguments)
            case ast.Call() | ast.List():
                return Type("void")
        raise ValueError(f"{ast.unparse(node)}: is no expression of a runtime")

    def _of_call(self, name: str, arguments: list[ast.expr]) -> Type:
        if name in self.program.routines:
            results = self.program.routines[name].results
            return results[0] if len(results) == 1 else Type("void")
        kind = name.partition("_")[0]
        if kind in KINDS:
            return DOUBLE if name in ("dd_rounded", "dd_exponent") else Type(KINDS[kind])
        if name == "exponent" and self.of(arguments[0]).is_pair:
            return DOUBLE
        if name in _VALUES:
            return Type(_VALUES[name])
        if name == "choose":
            return _wider(self.of(arguments[2]), self.of(arguments[3]))
        if name == "rounded":
            return DOUBLE
        if name in PRIMITIVES:
            found = self.of(arguments[0])
            return DOUBLE if found.name == "int" and name not in ("min", "max", "abs") else found
        raise ValueError(f"{name}: is called and not known")

    def declare(self, statement: ast.stmt) -> None:
        """Add the names that a statement defines."""
        match statement:
            case ast.AnnAssign(target=ast.Name(id=name), annotation=annotation):
                self.types[name] = type_of_annotation(annotation)
            case ast.For(target=ast.Name(id=name)):
                self.types[name] = SIZE
            case ast.Assign(
                targets=[ast.Tuple(elts=targets)], value=ast.Call(func=ast.Name(id=called))
            ):
                results = self.program.routines[called].results
                for target, type_ in zip(targets, results, strict=True):
                    if isinstance(target, ast.Name):
                        self.types.setdefault(target.id, type_)


def _wider(one: Type, other: Type) -> Type:
    order = ("exact", "pair", "double", "bits", "size", "int", "bool")
    for name in order:
        if name in (one.name, other.name):
            return Type(name)
    return one


# --- operations on pairs


def lowered(one: Routine, program: Program) -> Routine:
    """Replace operations on double-doubles by calls of the functions for them."""
    scope = Scope(one, program)
    body = [_Lowering(scope, one).visit(statement) for statement in one.body]
    return replace(one, body=tuple(body))


class _Lowering(ast.NodeTransformer):
    """Replacement of operations on double-doubles by calls, in the order of statements."""

    def __init__(self, scope: Scope, one: Routine) -> None:
        self.scope, self.one = scope, one

    def visit(self, node: ast.AST) -> Any:
        """Change a node, after the names that it defines are known."""
        if isinstance(node, ast.stmt):
            try:
                self.scope.declare(node)
                found = super().visit(node)
            except (ValueError, KeyError) as error:
                raise ValueError(f"{self.one.name}: {ast.unparse(node)[:99]}: {error}") from None
            for name in ("let", "note"):
                if value := getattr(node, name, None):
                    setattr(found, name, value)
            return found
        return super().visit(node)

    def _value(self, node: ast.expr) -> ast.expr:
        """Change the value of a statement, which may be a pair of two doubles itself."""
        found = self.visit(node)
        match found:
            case ast.Call(func=ast.Name(id="dd_pair"), args=parts):
                return _call("pair", *parts)
        return found

    def _lifted(self, node: ast.expr, type_: Type) -> ast.expr:
        """Return an expression as a pair where one is asked for."""
        if type_.is_pair and not self.scope.of(node).is_pair:
            return _call("dd_of", _real(node))
        return _real(node) if type_.name == "double" else node

    def _given(self, node: ast.expr, type_: Type) -> ast.expr:
        """Return an argument; a routine that takes a double reads the first part of a pair."""
        if type_ == DOUBLE and self.scope.of(node).is_pair:
            return ast.Attribute(node, "hi", ast.Load())
        return self._lifted(node, type_)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.stmt:
        """Change the value, which becomes a pair where one is declared."""
        if node.value is not None:
            node.value = self._lifted(self._value(node.value), type_of_annotation(node.annotation))
        return node

    def visit_Assign(self, node: ast.Assign) -> ast.stmt:
        """Change targets and value, which becomes a pair where the target is one."""
        node.targets = [self.visit(target) for target in node.targets]
        value = self._value(node.value)
        (target,) = node.targets
        is_plain = not isinstance(target, ast.Tuple)
        node.value = self._lifted(value, self.scope.of(target)) if is_plain else value
        return node

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.stmt:
        """Change the value; a pair is assigned anew."""
        node.value = self.visit(node.value)
        if self.scope.of(node.target).is_pair:
            value = self.visit_BinOp(ast.BinOp(node.target, node.op, node.value), visited=True)
            return ast.Assign([node.target], value)
        node.value = self._lifted(node.value, self.scope.of(node.target))
        return node

    def visit_Return(self, node: ast.Return) -> ast.stmt:
        """Change the values, each to the type of the result."""
        match node.value:
            case None:
                return node
            case ast.Tuple(elts=parts):
                values = [
                    self._lifted(self._value(part), type_)
                    for part, type_ in zip(parts, self.one.results, strict=True)
                ]
                return ast.Return(ast.Tuple(values, ast.Load()))
            case value:
                return ast.Return(self._lifted(self._value(value), self.one.results[0]))

    def visit_BinOp(self, node: ast.BinOp, *, visited: bool = False) -> ast.expr:
        """Replace an operation on pairs by a call; whole numbers among doubles become doubles."""
        left = node.left if visited else self.visit(node.left)
        right = node.right if visited else self.visit(node.right)
        types = [self.scope.of(part) for part in (left, right)]
        if any(type_.name == "exact" for type_ in types):
            return _call(f"exact_{_VERBS[type(node.op)]}_xx", left, right)
        if any(type_.is_pair for type_ in types):
            kinds = "".join("x" if type_.is_pair else "d" for type_ in types)
            return _call(f"dd_{_VERBS[type(node.op)]}_{kinds}", _real(left), _real(right))
        if any(type_.name == "double" for type_ in types):
            left, right = _real(left), _real(right)
        return ast.BinOp(left, node.op, right)

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        """Compare doubles with doubles."""
        left, (right,) = self.visit(node.left), map(self.visit, node.comparators)
        if "double" in (self.scope.of(left).name, self.scope.of(right).name):
            left, right = _real(left), _real(right)
        return ast.Compare(left, node.ops, [right])

    def visit_IfExp(self, node: ast.IfExp) -> ast.expr:
        """Make both values of one type."""
        test, body, other = map(self.visit, (node.test, node.body, node.orelse))
        type_ = _wider(self.scope.of(body), self.scope.of(other))
        return ast.IfExp(test, self._lifted(body, type_), self._lifted(other, type_))

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        """Replace the sign of a pair by a call."""
        operand = self.visit(node.operand)
        if isinstance(node.op, ast.USub) and self.scope.of(operand).is_pair:
            return _call("dd_neg", operand)
        return ast.UnaryOp(node.op, operand)

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Call the function for pairs where a primitive is given some; lift what is to be one."""
        if not isinstance(node.func, ast.Name):
            node.args = [self.visit(argument) for argument in node.args]
            return node
        name, given = node.func.id, [self.visit(argument) for argument in node.args]
        if name == "pair":
            return _call("dd_pair", *map(_real, given))
        if name in OF_PAIRS and name != "choose" and self.scope.of(given[0]).is_pair:
            return _call(OF_PAIRS[name], *given)
        if name == "choose":
            type_ = _wider(self.scope.of(given[2]), self.scope.of(given[3]))
            given = [*map(_real, given[:2]), *(self._lifted(x, type_) for x in given[2:])]
            return _call("dd_choose" if type_.is_pair else name, *given)
        if name in self.scope.program.routines:
            types = list(self.scope.program.routines[name].parameters.values())
            if len(types) != len(given):
                raise ValueError(f"{name}: {len(given)} arguments, {len(types)} parameters")
            return _call(name, *map(self._given, given, types))
        if name == "range":
            return _call(name, *given)
        if name not in PRIMITIVES:
            raise ValueError(f"{name}: is called and not known")
        if name in ("min", "max"):
            one, other = map(_real, given) if DOUBLE in map(self.scope.of, given) else given
            sign = ast.LtE() if name == "min" else ast.GtE()
            return ast.IfExp(ast.Compare(one, [sign], [other]), one, other)
        if name in ("rounded",):
            return given[0]
        if name in ("copysign", "fused", "product_error", "hypot"):
            given = list(map(_real, given))
        return _call(name, *given)


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])


def _real(node: ast.expr) -> ast.expr:
    """Return a whole number as a double; other expressions unchanged."""
    match node:
        case ast.Constant(value=value) if type(value) is int:
            return ast.Constant(float(value))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return ast.UnaryOp(node.op, _real(operand))
    return node


def let_of(statement: ast.stmt) -> Let | None:
    """Return the derived assignment that a statement is, if it is one."""
    return getattr(statement, "let", None)


# --- derived functions

_PRINTED = {"fma": "fused", "size": "abs", "exp": "exponential"}


def assignments(function: Function, lets: Iterable[Let], number: str = "pair") -> list[ast.stmt]:
    """Convert the assignments of a derived function to statements.

    lets: those to print.  number: the type of extended numbers.
    """
    extended = function.all_extended()
    found: list[ast.stmt] = []
    for let in lets:
        value = syntax(let.expression)
        if len(let.targets) > 1:
            names: list[ast.expr] = [ast.Name(name, ast.Store()) for name in let.targets]
            statement: ast.stmt = ast.Assign([ast.Tuple(names, ast.Store())], value)
        else:
            kind = number if is_extended(let.expression, extended) else "double"
            statement = declaration(let.targets[0], kind, value)
        setattr(statement, "let", let)  # noqa: B010
        found.append(statement)
    return found


def syntax(expression: Expression) -> ast.expr:
    """Convert an expression of a derived assignment to a syntax tree."""
    match expression:
        case Whole(value):
            return ast.Constant(float(value))
        case Name(name):
            return ast.Name(name, ast.Load())
        case Call("neg", (operand,)):
            return ast.UnaryOp(ast.USub(), syntax(operand))
        case Call(function, arguments):
            name = _PRINTED.get(function, function.removeprefix("_"))
            return _call(name, *map(syntax, arguments))
        case Operation(symbol, left, right) if symbol in _SYMBOLS:
            return ast.BinOp(syntax(left), _SYMBOLS[symbol](), syntax(right))
    raise ValueError(f"{to_text(expression)}: cannot be printed")


def declaration(name: str, kind: str, value: ast.expr | str | None) -> ast.AnnAssign:
    """Return the declaration of a name, with its value as a syntax tree or as text."""
    if isinstance(value, str):
        value = ast.parse(value, mode="eval").body
    return ast.AnnAssign(ast.Name(name, ast.Store()), annotation(kind), value, simple=1)


@cache
def annotation(text: str) -> ast.expr:
    """Parse the annotation of a type."""
    return ast.parse(text, mode="eval").body


def statement(text: str) -> ast.stmt:
    """Parse one statement."""
    (found,) = ast.parse(text).body
    return found
