"""Generation of numeric modules from the ledger's formulas, in stages, for several languages.

* `functions`.  Input: the solution's formula sequences.  Output: functions made of lets, names set
  to expressions, with the facts behind each.
* `passes`.  Input: lets.  Output: lets, selected, renamed, without powers, shared.
* `special_functions`.  Input: a number of terms.  Output: lets of nome, thetas and angles, with the
  proved bound of what they leave out.
* `routines`.  Input: texts of `runtime`, which has checks, decisions and loops once for all
  targets.  Output: functions with statements.
* `scalar`, `objects`, `pieces`.  Input: routines.  Output: those of one body and one time after
  another; those of languages without types; short ones.
* `targets`.  Input: functions, routines and named numbers.  Output: a module's files, and the let
  behind each line; one folder for each language.
* `flight`.  Input: the same.  Output: C for flight software, its tests, checks and records.
* `generate`.  Input: the name of a target.  Output: files, map from lines to equations, and
  manifest, as values; writing them is separate.
* `seal`.  Input: lets, routines, and files read back.  Output: the number of derived lines, or
  the first statement that is not the derived or the represented one.
* `trace`.  Input: a line, or an equation.  Output: the facts behind it, or its lines.
"""

from rigidsym._codegen.generate import Generated, generate
from rigidsym._codegen.targets import TARGETS

__all__ = ["TARGETS", "Generated", "generate"]
