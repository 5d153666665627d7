"""The calls that build a scene, and the scene with two infants."""

import pickle

import numpy as np
import pytest

import mimo

CUP = """<mujoco><worldbody><body name="cup"><geom size="0.04" mass="0.1"/><body name="lid" pos="0 0 0.1">
<joint name="lid" axis="0 1 0" range="0 90" limited="true"/><geom size="0.03" mass="0.01"/></body></body></worldbody>
</mujoco>"""


def furnished():
    scene = mimo.Scene()
    scene.set_room("playroom")
    scene.add_agent(name="anna", vision=False, touch=False)
    scene.add_model("red", xml=CUP, position=[1, 0, 0.2])
    scene.add_model("blue", xml=CUP, position=[1, 1, 0.2], fixed=True)
    scene.set_pose("red/lid", 0.5)
    scene.lock("anna/robot:left_elbow", -1)
    scene.weld("red/cup")
    scene.weld("anna/left_hand", "anna/head", [0.2, 0, 0.1, 1, 0, 0, 0])
    return scene


@pytest.mark.parametrize("start", ["name", "file", "xml"])
def test_empty_starts_are_refused(start):
    """For C "" is nothing, and nothing is an empty world."""
    with pytest.raises(ValueError, match=f"^{start} is '', expected"):
        mimo.Scene(**{start: ""})


def test_a_task_needs_infants(caplog):
    """A task needs somebody; a room may be empty, which is told."""
    with pytest.raises(mimo.ArgumentError, match=r'task "reach" is for agents.*add_agents adds its infants'):
        mimo.World(mimo.Scene("reach"))
    with caplog.at_level("INFO", "mimo"):
        mimo.World(mimo.Scene("benchmark"))
    assert ['scene "benchmark" has no agents' in message for message in caplog.messages] == [True]


def test_furniture():
    assert mimo.rooms() == ["playroom"]
    world = mimo.World(furnished())
    world.reset(seed=1)
    assert world.joints("red/lid").position[0] == 0.5
    assert world.joints("blue/lid").position[0] == 0
    assert world.locked("anna/robot:left_elbow") == pytest.approx(-1)
    for _ in range(30):
        world.step()
    np.testing.assert_allclose(world.bodies("red/cup").position[0], [1, 0, 0.2], atol=0.01)
    assert world.bodies("anna/head").position[0][2] < 0.7  # nobody holds the infant itself


def test_models_from_files(tmp_path, monkeypatch):
    (tmp_path / "cup.xml").write_text(CUP)
    monkeypatch.chdir(tmp_path)
    scene = mimo.Scene("free")
    scene.add_model("cup", file="cup.xml")
    monkeypatch.chdir("/")
    assert 'name="cup/lid"' in scene.copy().xml  # a path stays what it was


def test_saved_scenes_are_the_same_in_mujoco(tmp_path):
    scene = furnished()
    scene.save(tmp_path / "saved")
    again = mimo.World(mimo.Scene(file=tmp_path / "saved" / "scene.xml"), renderer="none")
    assert again.bodies().names == mimo.World(scene, renderer="none").bodies().names
    with pytest.raises(mimo.FileError, match="other content"):
        mimo.Scene("free").save(tmp_path / "saved")
    with pytest.raises(TypeError):
        scene.save(3)


def test_infants_without_a_place_stand(caplog):
    floor = '<mujoco><worldbody><geom name="floor" type="plane" size="5 5 1"/></worldbody></mujoco>'
    scene = mimo.Scene(xml=floor)
    scene.add_agent(vision=0)
    world = mimo.World(scene, renderer="none")
    assert world.bodies("mimo_location").position[0, 2] == pytest.approx(0.33, abs=0.005)
    assert not caplog.records
    scene = mimo.Scene(xml=floor)
    scene.add_agent(vision=0, position=[0, 0, 0.2])
    mimo.World(scene, renderer="none")
    assert 'inside of geom "floor"' in caplog.text
    caplog.clear()  # expected


@pytest.mark.skipif(mimo.mujoco_version().startswith("4"), reason="which knows the attribute")
def test_an_error_of_a_document_is_logged_once(caplog):
    scene = mimo.Scene(xml="<mujoco><option ls_iterations='9'/><worldbody><geom size='.1'/></worldbody></mujoco>")
    mimo.World(scene, renderer="none")
    mimo.World(scene.copy(), renderer="none")
    assert [record.getMessage() for record in caplog.records] == [
        "xml text, line 1: MuJoCo 2.2.2 does not know the attribute ls_iterations of <option>; it is left out"
    ]
    caplog.clear()  # expected


def test_long_compilations_are_logged_and_limited(caplog):
    many = mimo.Scene(xml="<mujoco><worldbody>" + "<site/>" * 25000 + "</worldbody></mujoco>")
    mimo.World(many, renderer="none")  # 25,000^2 comparisons, of 2 ns each
    assert [record.levelname for record in caplog.records] == ["WARNING"]
    assert "compiling may take 1.2" in caplog.text
    caplog.clear()  # expected
    with pytest.raises(mimo.ModelError, match=r"more than max_compile_ms \(1000\)"):
        mimo.World(mimo.Scene(xml=many.xml, max_compile_ms=1000), renderer="none")


def test_furnished_scenes_can_be_pickled():
    scene = furnished()
    again = pickle.loads(pickle.dumps(scene))
    assert again.xml == scene.xml
    assert again.agent_count == 1


def test_refusals_leave_the_scene():
    scene = furnished()
    before = scene.xml
    with pytest.raises(mimo.ArgumentError, match="room already"):
        scene.set_room("playroom")
    with pytest.raises(mimo.NotFoundError, match="there are: anna/robot:"):
        scene.set_pose("green/lid", 0)
    with pytest.raises(mimo.ArgumentError, match="radians"):
        scene.lock("red/lid", 2)
    with pytest.raises(ValueError, match="7 numbers"):
        scene.weld("red/cup", pose=[0, 0, 0])
    with pytest.raises(mimo.ModelError, match="0 bodies"):
        scene.add_model("green", xml="<mujoco/>")
    with pytest.raises(mimo.ArgumentError, match="none of file and xml"):
        scene.add_model("green")
    assert scene.xml == before


def test_playdate_has_two():
    scene = mimo.Scene("playdate")
    assert scene.add_agents(vision=False) == scene.agent_count == 2
    world = mimo.World("playdate", vision=False, touch=False)
    assert [agent.name for agent in world.agents] == ["anna", "ben"]
    assert mimo.World("free", name="carl", vision=False, touch=False).agents[0].name == "carl"
    with pytest.raises(ValueError, match="ParallelEnv"):
        mimo.make("playdate")


def test_an_infant_stands_where_its_soles_are_put():
    blind = {"place": "soles", "vision": False, "touch": False}
    world = mimo.World("free", position=[0.5, 0, 0.2], vestibular="acceleration", **blind)
    feet = world.bodies("left_foot", "right_foot").position
    np.testing.assert_allclose(np.mean(feet, axis=0)[:2], [0.5, 0], atol=1e-12)
    higher = mimo.World("free", position=[0.5, 0, 0.7], vestibular=False, **blind)
    np.testing.assert_allclose(higher.bodies("left_foot", "right_foot").position - feet, [[0, 0, 0.5]] * 2, atol=1e-9)
    assert [name for name in world.reset(seed=1) if "vestibular" in name] == ["vestibular/acceleration"]
    assert not any("vestibular" in name for name in higher.reset(seed=1))
    with pytest.raises(ValueError, match="place"):
        mimo.World("free", place="toes", position=[0, 0, 0])


def test_a_model_can_be_an_agent():
    scene = mimo.Scene("free")
    scene.add_agent(name="anna", vision=False)
    scene.add_model("red", xml=CUP, position=[1, 0, 0.2])
    scene.add_agent(name="red", body="scene", root="red/cup", vision=False, vestibular=False)
    scene.set_touch(None, 0.02, agent=1)
    world = mimo.World(scene)
    assert [agent.name for agent in world.agents] == ["anna", "red"]
    observation = world.reset(seed=1)
    assert observation["red/proprioception/position"].shape[0] >= 1
    assert len(observation["red/touch/force"]) > 10


def test_documents_have_limits(tmp_path):
    room = tmp_path / "room"
    room.mkdir()
    (tmp_path / "floor.xml").write_text("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
    (room / "room.xml").write_text("<mujoco>\n<option iterations='60'/><include file='../floor.xml'/></mujoco>")
    scene = mimo.Scene(file=room / "room.xml", max_iterations=59)
    with pytest.raises(mimo.Error, match=r"room.xml, line 2: iterations=\"60\" is more than max_iterations \(59\)"):
        mimo.World(scene.copy(), renderer="none")
    with pytest.raises(mimo.Error, match="lies outside the document's folder"):
        mimo.Scene(file=room / "room.xml", confined=True)
    with pytest.raises(TypeError, match=r"unexpected keyword argument 'max_width'.* There are: .*max_elements"):
        mimo.Scene(max_width=3)
    mimo.World(mimo.Scene(file=room / "room.xml", max_iterations=60), renderer="none").close()
