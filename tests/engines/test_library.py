"""Calls from Python to C are checked against the prototypes in generated headers."""

import ctypes
import re

import numpy as np
import pytest

from rigidsym._engines import build
from rigidsym._engines.build import CompilerError
from rigidsym._engines.library import LibraryError, signatures

NAMES = ("c", "c-pi", "c-step")
STATE, RATES = np.array([1.0, 0, 0, 0]), np.array([0.3, 0.5, -0.7])
MOMENTS = np.array([1.0, 2.0, 2.5])


@pytest.fixture(scope="module", params=NAMES)
def library(request):
    return built(request.param)


@pytest.fixture(scope="module")
def theta():
    return built("c")


def built(name):
    try:
        return build.library([], name)
    except (CompilerError, LibraryError) as error:
        pytest.skip(f"needs a compiler: {error}")


def frozen(array):
    array = array.copy()
    array.flags.writeable = False
    return array


def example(parameter):
    """Return an argument that a parameter accepts."""
    kinds = {"double": float, "int": np.intc, "size_t": np.uintp}
    if parameter.is_pointer and parameter.type not in kinds:
        return ctypes.create_string_buffer(4096)
    if parameter.is_pointer:
        return np.ones(4096, kinds[parameter.type])
    return {"double": 0.5, "int": 1, "size_t": 1}[parameter.type]


def wrong(parameter):
    """Return arguments that a parameter must refuse, because they would crash or be misread."""
    if not parameter.is_pointer:
        whole = [1.5, -1, 1 << 70] if parameter.type == "size_t" else [1.5, 1 << 40]
        return ["1", None, STATE, True, *(whole if parameter.type != "double" else [1j])]
    found = [0, 7, 1.0, "text", b"bytes", [1.0, 2.0], STATE.astype("f4"), np.ones(99)[::-1]]
    if not parameter.may_be_null:
        found.append(None)
    if parameter.least > 1:
        found += [np.ones(parameter.least - 1), (ctypes.c_double * (parameter.least - 1))()]
    if parameter.type in ("double", "int", "size_t"):
        found.append(ctypes.create_string_buffer(999))
    if parameter.type == "torque_free_motion":
        found += [(ctypes.c_double * 3)(), np.ones(999)]
    if not parameter.is_const and parameter.type == "double":
        found.append(frozen(np.ones(99)))
    return found


def test_all_that_a_header_declares_can_be_called(library):
    assert len(library.signatures) >= 7
    for name, signature in library.signatures.items():
        assert getattr(library.raw, name).argtypes is not None
        assert len(getattr(library.raw, name).argtypes) == len(signature.parameters)


@pytest.mark.parametrize("name", NAMES)
def test_nothing_that_a_header_declares_is_left_out(name):
    header = next(text for file, text in build.package_sources(name).items() if file.endswith(".h"))
    code = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    assert [*signatures(header)] == re.findall(r"(torque_free_\w+)\((?!\*)", code)


def test_a_wrong_number_of_arguments_is_an_error(library):
    for name, signature in library.signatures.items():
        given = [example(x) for x in signature.parameters]
        for some in (given[:-1], [*given, 1]) if given else ([1],):
            with pytest.raises(TypeError, match=rf"{signature.name} takes {len(given)} arg"):
                getattr(library, name)(*some)


def test_an_argument_of_a_wrong_type_is_an_error(library):
    tried = 0
    for name, signature in library.signatures.items():
        given = [example(x) for x in signature.parameters]
        for k, parameter in enumerate(signature.parameters):
            for bad in wrong(parameter):
                with pytest.raises(TypeError, match=rf"^{parameter.name}: .* must be "):
                    getattr(library, name)(*given[:k], bad, *given[k + 1 :])
                tried += 1
    assert tried > 100


def test_engines_cannot_hand_over_what_is_no_address(library):
    for name, signature in library.signatures.items():
        for k, parameter in enumerate(signature.parameters):
            given: list[object] = [0] * len(signature.parameters)
            given[k] = "text" if not parameter.is_pointer else 1.5
            with pytest.raises(ctypes.ArgumentError):
                getattr(library.raw, name)(*given)
            with pytest.raises(TypeError):
                getattr(library.raw, name)(*given[:k])


def test_calls_compute(theta):
    motion = ctypes.create_string_buffer(theta.motion_size())
    assert theta.motion_init(motion, MOMENTS, RATES, frozen(STATE)) == 0
    q, omega, many = np.empty(4), (ctypes.c_double * 3)(), (np.empty((1, 4)), np.empty((1, 3)))
    assert theta.state_at(motion, 2, q, omega) == 0
    failed = ctypes.c_size_t()
    rest = np.array([2.0]), 0, *many, None, failed
    assert theta.propagate(1, MOMENTS, RATES, STATE, 1, *rest) == 0
    np.testing.assert_array_equal(many[0][0], q)
    np.testing.assert_array_equal(many[1][0], omega)
    bad = np.array([-1.0, 1.0, 1.0])
    assert theta.propagate(1, bad, RATES, STATE, 1, *rest) == 2
    codes = np.empty(1, np.intc)
    assert theta.propagate(1, bad, RATES, STATE, 1, *rest[:-2], codes, failed) == 0
    assert codes.tolist() == [2]


def test_another_kind_of_parameter_is_no_header_of_ours():
    with pytest.raises(LibraryError, match=r"^char \*\*names: a parameter of no kind"):
        signatures("int g(double x, char **names);")
