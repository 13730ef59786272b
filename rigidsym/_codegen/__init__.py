"""Generation of numeric modules in C and Python from the ledger's formulas, in stages.

* `functions`.  Input: the solution's formula sequences.  Output: functions made of lets, names set
  to expressions, with the facts behind each.
* `passes`.  Input: lets.  Output: lets, selected, renamed, without powers, shared.
* `special_functions`.  Input: a number of terms.  Output: lets of nome, thetas and angles, with the
  proved bound of what they leave out.
* `routines`.  Input: texts of `runtime`, which has checks, decisions and loops once for all
  targets.  Output: functions with statements.
* `targets`.  Input: functions, routines and named numbers.  Output: a module's files, and the let
  behind each line; one folder for each language.
* `generate`.  Input: the name of a target.  Output: files, map from lines to equations, and
  manifest, as values; writing them is separate.
* `seal`.  Input: lets, and files read back.  Output: the number of statements for which the
  kernel decided that the printed code is the derived code, or the first for which it is not.
* `trace`.  Input: a line, or an equation.  Output: the facts behind it, or its lines.
"""

from rigidsym._codegen.generate import Generated, generate
from rigidsym._codegen.targets import TARGETS

__all__ = ["TARGETS", "Generated", "generate"]
