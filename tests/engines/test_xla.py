"""What JAX's calls of the engine do without a C compiler, and without JAX."""

import sys
from importlib import import_module

import pytest

from rigidsym._engines import xla


def test_without_a_compiler_nothing_is_registered(monkeypatch):
    pytest.importorskip("jax")
    monkeypatch.setenv("CC", "no-such-compiler")
    assert not xla._registered.__wrapped__()


def test_without_a_place_to_compile_nothing_is_registered(monkeypatch):
    pytest.importorskip("jax")

    def nowhere(*_, **__):
        raise FileNotFoundError("no temporary directory")

    monkeypatch.setattr(xla.tempfile, "TemporaryDirectory", nowhere)
    assert not xla._registered.__wrapped__()


@pytest.mark.parametrize("library", ["jax", "torch"])
def test_a_missing_library_is_named_with_its_extra(library, monkeypatch):
    monkeypatch.setitem(sys.modules, library, None)
    monkeypatch.delitem(sys.modules, f"rigidsym.{library}", raising=False)
    with pytest.raises(ImportError) as error:
        import_module(f"rigidsym.{library}")
    needed = (
        f"rigidsym.{library} needs {library} (extra {library}): pip install 'rigidsym[{library}]'"
    )
    assert str(error.value) == needed
