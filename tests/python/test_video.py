"""Videos: read back, a picture compared with what the world shows, the sound with what the ears heard."""

import sys

import numpy as np
import pytest
from recorded import record, table_of

from mimo import video
from mimo.view import Recorded

FULL_SCALE = 20.0  # Pa; nothing of the run is cut
ENCODED = 4.0  # of 255, by which a compressed picture differs in the mean


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    options = ["--scene", "showroom", "--senses", "hearing", "--keep", "hearing", "--seconds", "1", "--seed", "3"]
    return record(tmp_path_factory.mktemp("video") / "run.h5", *options)


def called(monkeypatch, capsys, *arguments):
    pytest.importorskip("av", reason="PyAV is not installed")
    monkeypatch.setattr(sys, "argv", ["mimo.video", *map(str, arguments)])
    return video.main(), *capsys.readouterr()


def test_a_recording_is_filmed(run, tmp_path, monkeypatch, capsys):
    path = tmp_path / "run.mp4"
    told = called(monkeypatch, capsys, run, "--out", path, "--eyes", "32", "--full-scale", FULL_SCALE)
    assert told == (0, f"{path}: 1 s in 25 pictures\n", "")
    import av

    with av.open(str(path)) as file:
        pictures = [frame.to_ndarray(format="rgb24") for frame in file.decode(video=0)]
        assert float(file.streams.video[0].average_rate) == 25
    with av.open(str(path)) as file:
        sound = np.concatenate([frame.to_ndarray() for frame in file.decode(audio=0)], axis=1)
        assert file.streams.audio[0].rate == 16000

    assert len(pictures) == 25
    source = Recorded(run, 32)
    frame = video.Frame(source.world)
    for step in range(77):  # the camera follows the infant, so that all are drawn
        if step % 4 == 0:
            expected = frame.draw()
        source.advance(None, True)
    source.close()
    difference = np.abs(pictures[19].astype(int) - expected).mean()
    assert difference < ENCODED
    assert np.abs(pictures[0].astype(int) - expected).mean() > 2 * difference

    heard = np.array([table_of(run, f"fields/hearing/ear_{side}").ravel() for side in ("left", "right")])
    assert 0 <= sound.shape[1] - heard.shape[1] <= 2 * 1024  # a whole number of AAC's frames, and one that is primed
    assert 0.1 < abs(heard).max() < FULL_SCALE
    level, expected_level = (np.sqrt((wave**2).mean()) for wave in (sound[:, : heard.shape[1]], heard / FULL_SCALE))
    assert 20 * np.log10(level / expected_level) == pytest.approx(0, abs=1)  # dB


def test_a_piece_of_a_run_without_ears(tmp_path, monkeypatch, capsys):
    deaf = record(tmp_path / "deaf.h5", "--scene", "reach", "--seconds", "1.2")
    path = tmp_path / "deaf.mkv"
    code, _, _ = called(monkeypatch, capsys, deaf, "--out", path, "--start", "0.5", "--eyes", "0", "--rate", "50")
    assert code == 0
    import av

    with av.open(str(path)) as file:
        assert len(file.streams.audio) == 0
        assert sum(1 for _ in file.decode(video=0)) == 35


def test_a_scene_is_filmed(tmp_path, monkeypatch, capsys):
    path = tmp_path / "live.mp4"
    told = called(monkeypatch, capsys, "--scene", "playdate", "--seconds", "0.2", "--infant", "1", "--out", path)
    assert told == (0, f"{path}: 0.2 s in 5 pictures\n", "")


def test_impossible_videos_are_refused(run, tmp_path, monkeypatch, capsys):
    def refused(*arguments):
        code, out, errors = called(monkeypatch, capsys, *arguments)
        assert (code, out, errors.count("\n")) == (1, "", 1)
        return errors

    path = tmp_path / "no.mp4"
    assert "--start is 9, but" in refused(run, "--out", path, "--start", "9")
    assert "--infant is 3, expected 0 to 0" in refused(run, "--out", path, "--infant", "3")
    assert "--rate is 1000, expected 1 to 100" in refused(run, "--out", path, "--rate", "1000")
    assert "--seconds is -1" in refused("--out", path, "--seconds", "-1")
    assert "--full-scale is 0" in refused(run, "--out", path, "--full-scale", "0")
    assert "the file does not exist" in refused(tmp_path / "none.h5", "--out", path)
    assert 'no scene named "nosuch"' in refused("--scene", "nosuch", "--out", path)
    assert "there is no folder" in refused(run, "--out", tmp_path / "nowhere" / "no.mp4")
    for end in ("no.txt", "no.gif", "no"):
        expected = "cannot be written as a video: expected a name that ends with .mp4, .m4v, .mov, .mkv"
        assert expected in refused(run, "--out", tmp_path / end)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setitem(sys.modules, "av", None)
    assert video.main() == 1
    assert "pip install 'mimo[video]'" in capsys.readouterr().err
