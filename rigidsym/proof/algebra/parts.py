"""Parts that contexts are put together from: a rigid body, an angle, Jacobi's three functions.

A part is a context without a name.  `join` merges parts in order and names the whole; later
parts may use what earlier ones introduced.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

from rigidsym.proof.kernel import Context


@dataclass(frozen=True, slots=True)
class Part:
    """The same fields as a `Context`; `witness` gives the generators and their order."""

    witness: Mapping[str, str] = field(default_factory=dict)
    units: tuple[str, ...] = ()
    definitions: Mapping[str, str] = field(default_factory=dict)
    relations: tuple[str, ...] = ()
    rates: Mapping[str, str] = field(default_factory=dict)
    nonnegative: tuple[str, ...] = ()
    reading: Mapping[str, str] = field(default_factory=dict)


def join(name: str, *parts: Part, static: bool = False) -> Context:
    """One context from parts; `static` leaves out the time derivative."""
    merged: dict[str, dict[str, str]] = {
        key: {name: text for part in parts for name, text in getattr(part, key).items()}
        for key in ("witness", "definitions", "rates", "reading")
    }
    rates = None if static else merged["rates"]
    return Context(
        name=name,
        generators=tuple(merged["witness"]),
        witness=merged["witness"],
        units=tuple(unit for part in parts for unit in part.units),
        definitions=merged["definitions"],
        relations=tuple(relation for part in parts for relation in part.relations),
        rates=rates,
        nonnegative=tuple(sign for part in parts for sign in part.nonnegative),
        reading=merged["reading"],
    )


def extend(name: str, context: Context, *parts: Part) -> Context:
    """A context with more to it, by another name; parts may define anew what it defines."""
    whole = Part(
        context.witness,
        context.units,
        context.definitions,
        context.relations,
        context.rates or {},
        context.nonnegative,
        context.reading,
    )
    return join(name, whole, *parts, static=context.rates is None)


def sign(name: str, reading: str) -> Part:
    """A constant that is +1 or -1."""
    return Part({name: "1"}, relations=(f"{name}**2 - 1",), reading={name: reading})


def half_angle(name: str, rate: str = "") -> Part:
    """cos and sin of half an angle; `rate` is the angle's time derivative."""
    cosine, sine = f"cos_half_{name}", f"sin_half_{name}"
    return Part(
        witness={cosine: "1", sine: "0"},
        definitions={
            f"cos_{name}": f"{cosine}**2 - {sine}**2",
            f"sin_{name}": f"2*{sine}*{cosine}",
        },
        relations=(f"{sine}**2 + {cosine}**2 - 1",),
        rates={cosine: f"-({rate})*{sine}/2", sine: f"({rate})*{cosine}/2"} if rate else {},
        reading={cosine: f"cos({name}/2)", sine: f"sin({name}/2)"},
    )


def jacobi(sn: str, cn: str, dn: str, argument: str, parameter: str, rate: str) -> Part:
    """sn, cn, dn of (argument | parameter), the argument growing at `rate` (DLMF 22.6, 22.13)."""
    return Part(
        witness={sn: "0", cn: "1", dn: "1"},
        relations=(f"{cn}**2 + {sn}**2 - 1", f"{dn}**2 + ({parameter})*{sn}**2 - 1"),
        rates={
            sn: f"({rate})*{cn}*{dn}",
            cn: f"-({rate})*{sn}*{dn}",
            dn: f"-({rate})*({parameter})*{sn}*{cn}",
        },
        reading={
            sn: f"jacobi_sn({argument}, {parameter})",
            cn: f"jacobi_cn({argument}, {parameter})",
            dn: f"jacobi_dn({argument}, {parameter})",
        },
    )
