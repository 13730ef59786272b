"""Files are moved into place; devices and pipes are written to."""

import os
import stat
from threading import Thread

import pytest

from rigidsym import InputError
from rigidsym.io import _files


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes")
def test_a_pipe_stays_a_pipe(tmp_path):
    pipe, received = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = Thread(target=lambda: received.append(pipe.read_bytes()), daemon=True)
    reader.start()
    assert _files.write_text(pipe, "states") == pipe
    reader.join(60)
    assert received == [b"states"]
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_a_file_is_replaced_and_a_directory_is_not(tmp_path):
    file, folder = tmp_path / "states.csv", tmp_path / "folder"
    folder.mkdir()
    for text in ("before", "after"):
        _files.write_text(file, text)
    with pytest.raises(InputError, match="cannot be written: Is a directory"):
        _files.write_text(folder, "states")
    assert file.read_text() == "after"
    assert {*tmp_path.iterdir()} == {file, folder}
