import runpy
import sys
from pathlib import Path

from rigidsym._codegen import targets
from rigidsym._codegen.functions import functions
from rigidsym.solution import sealed

HOW_TO = Path(__file__).parents[2] / "notebooks" / "text" / "howto_add_a_target.py"


def test_the_how_to_adds_a_target_and_takes_it_away(capsys):
    before = list(targets.TARGETS), list(targets.__path__)
    try:
        runpy.run_path(str(HOW_TO))
    finally:
        for name in [name for name in sys.modules if name.startswith(f"{targets.__name__}.floats")]:
            del sys.modules[name]
    assert (list(targets.TARGETS), list(targets.__path__)) == before
    said = capsys.readouterr().out
    printed = [f for f in functions(sealed()) if f.name.endswith(("_angles", "_state"))]
    assert f"{sum(len(f.lets) for f in printed)} lines read back" in said
    assert "not what was derived" in said
    assert "apart by less than 1e-15: True" in said
