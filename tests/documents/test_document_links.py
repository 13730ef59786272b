"""Links of README and pages lead to files; the README is one screen with its picture."""

import importlib.util
import re
import sys
from xml.etree import ElementTree

import pytest
from document_texts import PATHS, README, ROOT, TEXTS

SITE = ROOT / "notebooks" / "site"
LINES = 90
LINK = re.compile(r"\[(?:[^\[\]]|\[[^\]]*\])+\]\(([^()\s]+)\)")
LINKING = [*PATHS, *sorted((ROOT / "notebooks").glob("text/*.py"))]


def test_the_readme_is_one_screen():
    assert len(README.splitlines()) <= LINES


@pytest.mark.parametrize("path", LINKING, ids=lambda path: path.stem)
def test_relative_links_lead_to_files(path):
    for link in LINK.findall(path.read_text("utf-8")):
        if not re.match(r"[a-z]+:|#", link):
            # Texts of notebooks link as the notebooks do, which lie above them.
            place = path.parents[1] if path.suffix == ".py" else path.parent
            assert (place / link.partition("#")[0]).exists(), link


def test_every_page_is_linked_from_the_readme():
    pages = {path.relative_to(ROOT).as_posix() for path in PATHS} - {"README.md"}
    assert pages <= set(re.findall(r"\(([\w./]+)\)", README))


@pytest.mark.parametrize("name", TEXTS)
def test_a_page_is_plain_markdown(name):
    """Check that a code host can show the page, without substitutions and directives."""
    assert not re.search(r"\{\{|@@|^:::|^```\{|^\([\w-]+\)=", TEXTS[name], re.MULTILINE)


def test_the_picture_is_there_on_white():
    (name,) = re.findall(r"!\[[^\]]*\]\((.*?)\)", README)
    data = (ROOT / name).read_bytes()
    assert len(data) < 300_000
    assert ElementTree.fromstring(data).tag == "{http://www.w3.org/2000/svg}svg"
    first = re.search(rb'<path d="M 0 [\d.]+ \nL [^"]*" style="fill: #(\w+)', data)
    assert first[1] == b"ffffff"
    assert not re.search(rb"<dc:date>|<image|https?://(?!www\.w3\.org|purl\.org|creative)", data)


def test_drawing_it_again_gives_the_same(tmp_path):
    for package in ("matplotlib", "scipy"):
        pytest.importorskip(package, reason=f"{package} is not installed: extra `lab`")
    script = importlib.util.spec_from_file_location("readme_picture", SITE / "picture.py")
    module = importlib.util.module_from_spec(script)
    sys.modules[script.name] = module
    script.loader.exec_module(module)
    for name in ("one", "two"):
        assert module.main(["-o", str(tmp_path / f"{name}.svg")]) == 0
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()
    assert module.FILE.relative_to(ROOT).as_posix() in README
