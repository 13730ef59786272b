"""Reusable parts of contexts, such as an angle or Jacobi's three functions.

A part is names with hypotheses about them: a context without a name of its own.  `join` merges
parts in order and names the whole; later parts may use what earlier ones introduced.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import sympify

from rigidsym.proof.algebra._computation import Computation, computed, plain
from rigidsym.proof.algebra._printing import printed, reading
from rigidsym.proof.kernel import Context


@dataclass(frozen=True, slots=True)
class Part:
    """Part of a context: names with hypotheses about them.

    `names` are the generators, in order, with their meanings if they have some; `reading` has the
    meanings of other names.  Names are texts or symbols, and expressions are texts, SymPy's or
    computations; `join` prints them with the names in the context's order.
    The builder of a ledger finds a rational point that satisfies all hypotheses.  `witness` has
    values that it should prefer; further names there are generators, too.
    """

    names: Mapping[Any, Any] | tuple[Any, ...] = ()
    units: tuple[Any, ...] = ()
    definitions: Mapping[Any, Any] = field(default_factory=dict)
    relations: tuple[Any, ...] = ()
    rates: Mapping[Any, Any] = field(default_factory=dict)
    nonnegative: tuple[Any, ...] = ()
    start: tuple[Any, ...] = ()
    thetas: Mapping[Any, Any] = field(default_factory=dict)
    reading: Mapping[Any, Any] = field(default_factory=dict)
    witness: Mapping[Any, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Keep the generators in `names`, and all meanings in `reading`."""
        meant = self.names if isinstance(self.names, Mapping) else {}
        object.__setattr__(self, "names", (*dict.fromkeys((*self.names, *self.witness)),))
        object.__setattr__(self, "reading", {**meant, **self.reading})


_TABLES = ("definitions", "rates", "thetas", "reading", "witness")
_LISTS = ("units", "relations", "nonnegative", "start")


def part_of(context: Context, *names: str) -> Part:
    """Extract a reusable part from a context.

    If names are given, hypotheses other than their definitions and rates are left out.
    """
    chosen = {*names} or {*context.generators, *context.definitions}
    found: dict[str, Any] = {} if names else {key: getattr(context, key) for key in _LISTS}
    for key in _TABLES:
        table = getattr(context, key) or {}
        found[key] = {name: text for name, text in table.items() if name in chosen}
    return Part(tuple(x for x in context.generators if x in chosen), **found)


def join(name: str, *parts: Part, static: bool = False) -> Context:
    """Join parts into one context.

    `static` leaves out the time derivative.  Its witness has the preferred values only.
    """
    tables = tuple(key for key in _TABLES if not (static and key == "rates"))
    merged: dict[str, Any] = {
        key: {str(x): text for part in parts for x, text in getattr(part, key).items()}
        for key in tables
    }
    generators = tuple(dict.fromkeys(str(x) for part in parts for x in part.names))
    for key in _LISTS:
        merged[key] = [x for part in parts for x in getattr(part, key)]
    names = (*generators, *merged["definitions"])
    for key in tables:
        printer = reading if key in ("thetas", "reading") else printed
        merged[key] = {x: text(side, names, printer) for x, side in merged[key].items()}
    for key in _LISTS:
        merged[key] = tuple(dict.fromkeys(text(x, names) for x in merged[key]))
    if static:
        merged["rates"] = None
    return Context(name, generators, **merged)


def text(side: Any, names: Iterable[str], printer: Callable[..., str] = printed) -> str:
    """Convert a number, an expression or a computation to text that the kernel can parse.

    Names are printed in the given order.  Texts are returned unchanged.
    """
    if isinstance(side, str):
        return side
    first = side.order if isinstance(side, Computation) else ()
    order = dict.fromkeys((*first, *names))
    return computed(printer(sympify(plain(side)), order), side)


def named(names: Iterable[Any], values: Iterable[Any]) -> dict[Any, Any]:
    """Return a table of as many values as names."""
    return dict(zip(names, values, strict=True))


def extend(name: str, context: Context, *parts: Part) -> Context:
    """Extend a context by parts, under a new name.

    Parts may override definitions.
    """
    return join(name, part_of(context), *parts, static=context.rates is None)


def sign(name: str, reading: str) -> Part:
    """Return the part that introduces a constant equal to +1 or -1."""
    return Part({name: reading}, relations=(f"{name}**2 - 1",))


def unit_quaternion(name: str, reading: str) -> Part:
    """Return the part that introduces the components 0 to 3 of a unit quaternion.

    `reading` says what quaternion it is.
    """
    return Part(
        {f"{name}{k}": f"component {k} of {reading}" for k in range(4)},
        relations=(f"{name}3**2 + {name}2**2 + {name}1**2 + {name}0**2 - 1",),
    )


def half_angle(name: str, rate: str = "") -> Part:
    """Return the part that introduces cos and sin of half an angle and of the angle.

    `rate` is the time derivative of the whole angle.
    """
    return _doubled(f"half_{name}", name, f"{name}/2", name, f"({rate})/2" if rate else "")


def double_angle(name: str, rate: str = "") -> Part:
    """Return the part that introduces cos and sin of an angle and of its double.

    `rate` is the time derivative of the single angle.
    """
    return _doubled(name, f"2{name}", name, f"2*{name}", rate)


def _doubled(name: str, double: str, angle: str, twice: str, rate: str) -> Part:
    cosine, sine = f"cos_{name}", f"sin_{name}"
    return Part(
        {cosine: f"cos({angle})", sine: f"sin({angle})"},
        definitions={
            f"cos_{double}": f"{cosine}**2 - {sine}**2",
            f"sin_{double}": f"2*{sine}*{cosine}",
        },
        relations=(f"{sine}**2 + {cosine}**2 - 1",),
        rates={cosine: f"-({rate})*{sine}", sine: f"({rate})*{cosine}"} if rate else {},
        reading={f"cos_{double}": f"cos({twice})", f"sin_{double}": f"sin({twice})"},
    )


def circle(cosine: str, sine: str, angle: str, rate: str = "") -> Part:
    """Return the part that introduces cos and sin of an angle.

    `rate` is the time derivative of the angle.
    """
    return Part(
        {sine: f"sin({angle})", cosine: f"cos({angle})"},
        relations=(f"{cosine}**2 + {sine}**2 - 1",),
        rates={cosine: f"-({rate})*{sine}", sine: f"({rate})*{cosine}"} if rate else {},
    )


def jacobi(sn: str, cn: str, dn: str, argument: str, parameter: str, rate: str) -> Part:
    """Return the part that introduces Jacobi's functions sn, cn and dn.

    They are taken at (argument | parameter) (DLMF 22.6, 22.13).
    `rate` is the time derivative of the argument.
    """
    return Part(
        {
            sn: f"jacobi_sn({argument}, {parameter})",
            cn: f"jacobi_cn({argument}, {parameter})",
            dn: f"jacobi_dn({argument}, {parameter})",
        },
        relations=(f"{cn}**2 + {sn}**2 - 1", f"{dn}**2 + ({parameter})*{sn}**2 - 1"),
        rates={
            sn: f"({rate})*{cn}*{dn}",
            cn: f"-({rate})*{sn}*{dn}",
            dn: f"-({rate})*({parameter})*{sn}*{cn}",
        },
    )
