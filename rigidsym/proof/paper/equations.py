"""The paper's equations as printed, misprints kept: values, never functions.

`senses` put an equation into the language of contexts, where the kernel is asked whether it holds;
`conditions` or `repair` mend it.  Where the print can be read in several ways, `readings` says what
each implies.  The verdict is computed from the ledger by `rigidsym.proof.paper.verdicts`; it is not
written here.
"""

from rigidsym.proof.paper.equation import Equation
from rigidsym.proof.paper.proof import PROOF
from rigidsym.proof.paper.section2 import SECTION_2
from rigidsym.proof.paper.section3 import SECTION_3
from rigidsym.proof.paper.section4 import SECTION_4

EQUATIONS: tuple[Equation, ...] = (*SECTION_2, *SECTION_3, *SECTION_4, *PROOF)
