"""Recordings as files of other programs: each is read by the program's own reader, and compared with the recording."""

import json
import shutil
import subprocess
import sysconfig
import warnings
from pathlib import Path

import numpy as np
import pytest
from recorded import program, record, table_of

import mimo
from mimo import bids, by_field, export, nwb
from mimo.kept import Kept

SECONDS = 6  # so that no row of a field is longer than the run, which NWB's inspector takes for a mistake


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A run that keeps everything."""
    options = ["--scene", "reach", "--seconds", str(SECONDS), "--senses", "all", "--vision", "15", "--touch", "0.2"]
    return record(tmp_path_factory.mktemp("run") / "run.h5", *options, "--keep", "all", "--seed", "3")


@pytest.fixture(scope="module")
def written(run, tmp_path_factory):
    """The same run as NWB, with all extensions that are installed."""
    pytest.importorskip("pynwb", reason="PyNWB is not installed")
    file = tmp_path_factory.mktemp("nwb") / "run.nwb"
    assert export.main(["--nwb", str(file), str(run)]) == 0
    return file


def names_of(run, dataset):
    h5py = pytest.importorskip("h5py")
    with h5py.File(run) as file:
        return file[dataset].attrs["names"].decode().split("\n")


# ---- What a recording says -------------------------------------------------------------------------------------------


def test_columns_have_the_names_units_and_frames_of_the_layout(run):
    with Kept(run) as kept, mimo.Recording(run) as recording, recording.world(eyes=15) as world:
        tables = {table.name: table for table in kept.tables}
        for name, field in world.layout.fields.items():
            if name not in tables:
                continue
            table = tables[name]
            assert (table.unit, table.frame, table.shape) == (field.unit, field.frame, field.shape), name
            assert table.late == field.end
            if field.labels:
                assert tuple(column.name for column in table.columns) == field.labels
        assert len(tables) > 30
        force = tables["touch/force"]
        assert len(force.columns) == 3 * len(force.receptors)
        assert force.columns[4].name == f"{force.receptors[1][0]}/1/y"
        assert kept.rate == pytest.approx(100)
        (infant,) = kept.infants
        assert (infant.age, infant.sex, infant.mass) == (18, "U", pytest.approx(world.agents[0].mass))


def test_slides_are_told_from_hinges(tmp_path):
    """MJCF's own words: the first joint moves along x, the second turns."""
    text = """<mujoco><worldbody><geom type="plane" size="1 1 .1"/>
      <body name="cart" pos="0 0 .5"><joint name="along" type="slide" axis="1 0 0"/><geom size=".1"/>
        <body name="pole"><joint name="around" axis="0 1 0"/><geom size=".1"/>
          <body name="end"><joint name="back" type="slide" axis="0 0 1"/><geom size=".1"/></body></body>
        <body name="cup" pos="0 .5 0"><joint name="any" type="ball"/><geom size=".1"/></body></body>
    </worldbody></mujoco>"""
    scene = mimo.Scene(xml=text)
    pytest.importorskip("h5py", reason="h5py is not installed")
    with mimo.World(scene) as world:
        world.reset(seed=1)
        with mimo.Recorder(world, tmp_path / "cart.h5"):
            world.step()
    with Kept(tmp_path / "cart.h5") as kept:
        (positions, velocities) = (table for table in kept.tables if table.name.startswith("joints/"))
        units = {column.name: (column.unit, column.frame) for column in positions.columns}
        assert [units[name][0] for name in ("along", "around", "back")] == ["m", "rad", "m"]
        assert units["any/qw"] == ("", "parent")
        assert {column.name: column.unit for column in velocities.columns} == {
            "along": "m/s",
            "around": "rad/s",
            "back": "m/s",
            **{f"any/w{axis}": "rad/s" for axis in "xyz"},
        }


def test_poses_are_those_of_a_replay(run):
    with Kept(run) as kept, mimo.Recording(run) as recording, recording.world(eyes=0) as world:
        names, parents, poses = kept.poses()
        assert names == world.bodies().names
        assert [names[parents[names.index(it)]] for it in ("left_hand", "head")] == ["left_lower_arm", "upper_body"]
        recording.move_to(world, 250)
        world.update()
        np.testing.assert_allclose(poses[249], world.bodies().read("pose", now=True), atol=2e-6)


def test_ends_of_episodes_are_events(tmp_path):
    pytest.importorskip("h5py", reason="h5py is not installed")
    with mimo.World("reach", vision=False, touch=False, max_steps=20) as world:
        world.reset(seed=1)
        with mimo.Recorder(world, tmp_path / "two.h5"):
            for _ in range(45):
                world.step(np.zeros(len(world.action_names)))
                if world.truncated.any():
                    world.reset()
    with Kept(tmp_path / "two.h5") as kept:
        events = [(round(it.time, 6), it.name) for it in kept.events()]
    assert events == [(0.2, "changed"), (0.2, "truncated"), (0.4, "changed"), (0.4, "truncated")]


# ---- Neurodata Without Borders ---------------------------------------------------------------------------------------


def test_nwb_has_every_field_as_it_is(run, written):
    import pynwb

    with Kept(run) as kept, pynwb.NWBHDF5IO(str(written), "r") as io:
        file = io.read()
        told = file.processing["behavior"]["columns"].to_dataframe()
        for table in kept.tables:
            series = file.acquisition[table.name.replace("/", "_")]
            expected = kept.read(table)
            np.testing.assert_array_equal(np.reshape(series.data[()], expected.shape), expected, table.name)
            lines = told[told.series == series.name]
            assert list(zip(lines.label, lines.unit, lines.frame)) == list(table.columns)
        joints = told[told.series == "joints_position"].set_index("label")
        elbow = file.acquisition["joints_position"].data[:, joints.column["robot:left_elbow"]]
        whole = table_of(run, "joints/position")
        np.testing.assert_array_equal(elbow, whole[:, names_of(run, "joints/position").index("robot:left_elbow")])
        assert joints.unit["robot:left_elbow"] == "rad"


def test_nwb_has_the_times_of_the_layout(written):
    """A step is 10 ms; pictures and contacts belong to the start of the last physics step, 5 ms before its end."""
    import pynwb

    with pynwb.NWBHDF5IO(str(written), "r") as io:
        file = io.read()
        joints, eye, ear = (
            file.acquisition[name] for name in ("joints_position", "vision_eye_left", "hearing_ear_left")
        )
        assert (joints.starting_time, joints.rate) == (pytest.approx(0.01), pytest.approx(100))
        assert eye.starting_time == pytest.approx(0.005)
        assert eye.data.shape == (100 * SECONDS, 15, 15, 3)
        # 160 samples of 1/16000 s end there.
        assert (ear.starting_time, ear.rate, len(ear.data)) == (pytest.approx(-0.005), 16000, 16000 * SECONDS)


def test_nwb_says_who_it_was(written):
    import pynwb

    with pynwb.NWBHDF5IO(str(written), "r") as io:
        subject = io.read().subject
        assert (subject.age, subject.sex, subject.species) == ("P548D", "U", "Homo sapiens")  # 18 x 30.4375 days


def test_nwb_has_poses_by_ndx_pose(run, written):
    pytest.importorskip("ndx_pose", reason="ndx-pose is not installed")
    import pynwb

    with Kept(run) as kept, pynwb.NWBHDF5IO(str(written), "r") as io:
        names, _, poses = kept.poses()
        behavior = io.read().processing["behavior"]
        hand = behavior["bodies_over_time"]["left_hand"]
        np.testing.assert_array_equal(hand.data[()], poses[:, names.index("left_hand"), :3])
        skeleton = behavior["Skeletons"]["bodies"]
        nodes, edges = list(skeleton.nodes), {tuple(edge) for edge in skeleton.edges[()].tolist()}
        assert (nodes.index("left_lower_arm"), nodes.index("left_hand")) in edges


def test_nwb_s_inspector_and_validator_find_nothing(written):
    inspector = pytest.importorskip("nwbinspector", reason="nwbinspector is not installed")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = list(inspector.inspect_nwbfile(nwbfile_path=str(written)))
    suggestions = {"check_experimenter_exists", "check_institution"}  # nobody made it
    suggestions.add(
        "check_timestamp_of_the_first_sample_is_not_negative"
    )  # the first sound began before the first step
    bad = [it for it in found if it.check_function_name not in suggestions]
    assert [(it.importance.name, it.check_function_name, it.message) for it in bad] == []


def test_nwb_without_extensions(run, tmp_path, monkeypatch):
    pynwb = pytest.importorskip("pynwb", reason="PyNWB is not installed")
    monkeypatch.setattr(nwb, "_extension", lambda name: None)
    nwb.write(run, tmp_path / "plain.nwb", fields=["hearing"])
    with pynwb.NWBHDF5IO(str(tmp_path / "plain.nwb"), "r") as io:
        file = io.read()
        assert file.acquisition["hearing_ear_left"].unit == "Pa"
        assert file.processing["behavior"]["bodies"]["left_hand"].unit == "meters"
        assert "touch_force" not in file.acquisition


def test_nwb_of_one_of_two_infants(tmp_path):
    pynwb = pytest.importorskip("pynwb", reason="PyNWB is not installed")
    run = record(tmp_path / "two.h5", "--scene", "playdate", "--seconds", "1")
    nwb.write(run, tmp_path / "second.nwb", infant=1)
    with Kept(run) as kept, pynwb.NWBHDF5IO(str(tmp_path / "second.nwb"), "r") as io:
        file = io.read()
        first, second = (it.name for it in kept.infants)
        assert file.subject.subject_id == second
        told = file.processing["behavior"]["columns"].to_dataframe()
        labels = list(told[told.series == "joints_position"].label)
        assert any(label.startswith(f"{second}/") for label in labels)
        assert not any(label.startswith(f"{first}/") for label in labels)
        (table,) = (it for it in kept.tables if it.name == "proprioception/position" and it.infant == 1)
        np.testing.assert_array_equal(file.acquisition["proprioception_position"].data[()], kept.read(table))
    with pytest.raises(ValueError, match="infant is 2, expected 0 to 1"):
        nwb.write(run, tmp_path / "third.nwb", infant=2)


# ---- BIDS ------------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def dataset(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("bids") / "dataset"
    assert export.main(["--bids-motion", str(folder), str(run)]) == 0
    return folder


def problems(folder):
    """What the validator of the BIDS community calls errors."""
    pytest.importorskip("bids_validator_deno", reason="bids-validator-deno is not installed")
    program = Path(sysconfig.get_path("scripts")) / "bids-validator-deno"
    tool = subprocess.run([program, "--format", "json", str(folder)], capture_output=True, text=True)
    report = json.loads(tool.stdout)
    return [
        (it["code"], it.get("location"), it.get("issueMessage"))
        for it in report["issues"]["issues"]
        if it["severity"] == "error"
    ]


def test_bids_validator_finds_no_errors(dataset):
    assert problems(dataset) == []


def test_bids_validator_finds_errors(dataset, tmp_path):
    shutil.copytree(dataset, tmp_path / "bad")
    (channels,) = (tmp_path / "bad").glob("sub-*/motion/*_channels.tsv")
    channels.write_text(channels.read_text().replace("JNTANG", "ANGLE"))
    assert problems(tmp_path / "bad") != []


def test_bids_channels_are_the_columns(run, dataset):
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    (motion,) = dataset.glob("sub-*/motion/*_motion.tsv")
    channels = pandas.read_csv(motion.with_name(motion.name.replace("_motion", "_channels")), sep="\t")
    values = pandas.read_csv(motion, sep="\t", header=None, na_values="n/a").to_numpy()
    assert values.shape == (100 * SECONDS, len(channels))
    assert channels.name.is_unique
    lines = channels.set_index("name")
    elbow = "joints/position/robot:left_elbow"
    assert tuple(lines.loc[elbow, ["type", "units", "reference_frame"]]) == ("JNTANG", "rad", "joint")
    names = list(channels.name)
    expected = table_of(run, "joints/position")[:, names_of(run, "joints/position").index("robot:left_elbow")]
    np.testing.assert_array_equal(values[:, names.index(elbow)], expected)
    with Kept(run) as kept:
        bodies, _, poses = kept.poses()
    places = values[:, [names.index(f"left_hand_pos_{axis}") for axis in "xyz"]].astype(np.float32)
    np.testing.assert_array_equal(places, poses[:, bodies.index("left_hand"), :3])
    acceleration = lines.loc["vestibular/acceleration/x"]
    assert (acceleration.type, acceleration.component, acceleration.units) == ("ACCEL", "x", "m/s^2")


def test_mne_reads_motion(dataset):
    mne = pytest.importorskip("mne", reason="MNE is not installed")
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    (motion,) = dataset.glob("sub-*/motion/*_motion.tsv")
    channels = pandas.read_csv(motion.with_name(motion.name.replace("_motion", "_channels")), sep="\t")
    sidecar = json.loads(motion.with_suffix(".json").read_text())
    values = pandas.read_csv(motion, sep="\t", header=None, na_values="n/a").to_numpy(np.float64)
    raw = mne.io.RawArray(values.T, mne.create_info(list(channels.name), sidecar["SamplingFrequency"]), verbose="error")
    hand = raw.copy().pick(["left_hand_pos_x"]).get_data()[0]
    np.testing.assert_array_equal(hand, values[:, list(channels.name).index("left_hand_pos_x")])
    assert raw.times[-1] == pytest.approx(SECONDS - 0.01)


def test_bids_says_what_stays_out(run, tmp_path):
    out = bids.write(run, tmp_path / "set", fields=["vestibular", "vision/eye_left", "hearing/ear_left", "touch/force"])
    assert [it.split(" ")[0] for it in out] == ["touch/force", "vision/eye_left", "hearing/ear_left"]


# ---- By field --------------------------------------------------------------------------------------------------------


def test_tables_open_in_pandas(run, tmp_path):
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    by_field.write_csv(run, tmp_path / "tables", ["vestibular", "touch/force"])
    told = json.loads((tmp_path / "tables/fields.json").read_text())
    for name, field in (("vestibular_otoliths", "vestibular/otoliths"), ("touch_force", "touch/force")):
        table = pandas.read_csv(tmp_path / f"tables/{name}.csv")
        expected = table_of(run, f"fields/{field}").reshape(100 * SECONDS, -1)
        np.testing.assert_array_equal(table.to_numpy()[:, 1:].astype(np.float32), expected)
        assert list(table.columns[1:]) == [column["name"] for column in told[f"{name}.csv"]["columns"]]
        assert table.time[0] == pytest.approx(0.01 - 0.005)
    assert {column["unit"] for column in told["touch_force.csv"]["columns"]} == {"N"}
    assert len(told["touch_force.csv"]["receptors"]) == expected.shape[1] // 3


def test_sounds_are_pascals(run, tmp_path):
    wavfile = pytest.importorskip("scipy.io.wavfile", reason="SciPy is not installed")
    assert export.main(["--wav", str(tmp_path / "sounds"), str(run)]) == 0
    rate, samples = wavfile.read(tmp_path / "sounds/hearing_ear_left.wav")
    assert (rate, samples.dtype) == (16000, np.float32)
    np.testing.assert_array_equal(samples, table_of(run, "fields/hearing/ear_left").ravel())


def test_films_show_the_pictures(run, tmp_path):
    av = pytest.importorskip("av", reason="PyAV is not installed")
    pytest.importorskip("PIL", reason="Pillow is not installed")
    by_field.write_mp4(run, tmp_path / "films", ["vision/eye_left"])
    with av.open(str(tmp_path / "films/vision_eye_left.mp4")) as film:
        assert film.streams.video[0].average_rate == 100
        shown = [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]
    kept = table_of(run, "fields/vision/eye_left")
    assert len(shown) == len(kept)
    seen = np.array(shown)[:, :15, :15].astype(float)
    assert shown[0].shape == (16, 16, 3)  # H.264 has even edges
    # H.264 halves the colours' resolution; brightness stays within a few of 255 levels.
    np.testing.assert_allclose(seen.mean(axis=(1, 2, 3)), kept.mean(axis=(1, 2, 3)), atol=4)


# ---- What is refused -------------------------------------------------------------------------------------------------


def test_the_page_of_a_wheel_is_beside_the_program(run, tmp_path, monkeypatch, capsys):
    shutil.copy(program(), tmp_path / "mimo")
    monkeypatch.setenv("LD_LIBRARY_PATH", str(Path(mimo.library_path()).parent))
    monkeypatch.setattr(export, "native_file", lambda name: tmp_path / "mimo")
    (tmp_path / "recording.html").write_text("<p>before</p><!-- recording -->")
    out = tmp_path / "run.html"
    assert export.main(["--html", str(out), str(run)]) == 0
    assert capsys.readouterr().out == f"wrote {out}\n"
    assert out.read_text().startswith('<p>before</p><script type="text/plain" id="recording" data-name="run.h5">')


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--nwb", "{out}"], "a recording is missing"),
        (["--nwb", "{out}", "{run}", "--fields", "hering"], "keeps no 'hering'; did you mean"),
        (["--nwb", "{out}", "{run}", "--scene", "reach"], "--scene has no effect on recordings"),
        (["--csv", "{out}", "{run}", "--infant", "0"], "--infant has no effect on any but --nwb"),
        (["--nwb", "{out}", "{run}", "--start", "today"], "--start is 'today', expected a time as"),
        (["--nwb", "{out}", "{run}", "--start", "2026-05-01T12:00:00"], "with its time zone"),
        (["--nwb", "{out}", "{run}", "--infant", "1"], "infant is 1, expected 0 to 0"),
        (["--nwb", "{folder}", "{run}"], "it is a folder"),
        (["--csv", "{folder}", "{run}"], "the folder is not empty"),
        (["--csv", "{run}", "{run}"], "it is a file, expected a folder"),
        (["--bids-motion", "{out}/deeper", "{run}"], "there is no folder"),
        (["--wav", "{out}", "{run}", "--fields", "vestibular"], "keeps no sound"),
        (["--usd", "{out}", "{run}"], "--usd writes a scene, not the recording"),
        (["--nwb", "{out}", "{text}"], "text.h5"),
        (["--html", "{out}", "{run}"], "expected a name that ends in .html"),
        (["--html", "{out}", "{run}", "--fields", "touch"], "--fields has no effect on --html"),
    ],
)
def test_refused(run, tmp_path, capsys, arguments, message):
    if "--nwb" in arguments:
        pytest.importorskip("pynwb", reason="PyNWB is not installed")
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder/mine").write_text("stays")
    (tmp_path / "text.h5").write_text("no recording")
    before = sorted(tmp_path.rglob("*"))
    places = {"out": tmp_path / "out", "run": run, "folder": tmp_path / "folder", "text": tmp_path / "text.h5"}
    assert export.main([it.format(**places) for it in arguments]) == 1
    told = capsys.readouterr().err
    assert message in told
    assert told.count("\n") == 1
    assert sorted(tmp_path.rglob("*")) == before
