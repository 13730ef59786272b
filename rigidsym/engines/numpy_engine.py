"""The engine on the generated NumPy module: works everywhere, one compiler less to trust."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from rigidsym.engines import arrays
from rigidsym.engines.protocol import Outputs, States
from rigidsym.generated import torque_free


@dataclass(frozen=True, slots=True)
class NumpyEngine:
    """`rigidsym.generated.torque_free`, or a module like it, as an `Engine`."""

    module: Any = torque_free

    def plan(self, inertia: Any, omega0: Any, attitude0: Any) -> dict[str, Any]:
        """See `Engine`."""
        return self.module.plan(inertia, omega0, attitude0)

    def exact_plan(
        self,
        inertia: Sequence[Fraction],
        omega0: Sequence[Fraction],
        attitude0: Sequence[Fraction],
    ) -> dict[str, Any]:
        """See `Engine`."""
        # Here, because doubles need nothing of it.
        from rigidsym.engines.exact_pairs import exact_pairs

        return self.module.plan_from_pairs(*exact_pairs(inertia, omega0, attitude0))

    def states(self, plan: dict[str, Any], t: Any, out: Outputs = None) -> States:
        """See `Engine`."""
        if out is not None:
            times = np.asarray(t, float)
            arrays.outputs(out, (*plan["shape"], *times.shape), times)
        return self.module.states(plan, t, out)

    def grid(
        self,
        plan: dict[str, Any],
        start: float,
        step: float,
        count: int,
        out: Outputs = None,
    ) -> States:
        """See `Engine`; at the doubles nearest to these times."""
        return self.states(plan, start + step * np.arange(arrays.count(count)), out)

    def propagate(
        self, inertia: Any, omega0: Any, attitude0: Any, t: Any, out: Outputs = None
    ) -> States:
        """See `Engine`."""
        return self.states(self.module.plan(inertia, omega0, attitude0), t, out)
