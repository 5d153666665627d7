import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";
import * as mimo from "../src/index.js";
import { Block } from "../src/memory.js";
import { needed } from "./support.js";

const { Axes, Kind, Movement, Outcome, Quantity, Scene, Status, World } = mimo;

test("a step moves time on by its length and fills the observation", needed, () => {
  const world = new World("reach");
  world.reset({ seed: 7 });
  const before = world.observation["proprioception/position"].slice();
  const { reward, terminated } = world.step(world.layout.actions.map((one) => one.high));
  assert.equal(world.time(), world.layout.stepSeconds);
  assert.equal(world.frameSkip() * world.timestep(), world.layout.stepSeconds);
  assert.equal(reward.length, 1);
  assert.equal(terminated[0], 0);
  assert.notDeepEqual(world.observation["proprioception/position"], before);
  world.close();
});

test("the observation lies in the module's memory, also after it has grown", needed, () => {
  const world = new World("reach");
  world.reset({ seed: 7 });
  const old = world.observation;
  assert.equal(world.observation, old);
  const blocks = [];
  while (old["proprioception/position"].length > 0) blocks.push(new Block(64 << 20)); // a grown memory empties old views
  const { observation } = world;
  assert.notEqual(observation, old);
  assert.equal(observation["proprioception/position"].length, 47);
  world.step(new Float32Array(world.layout.actions.length));
  assert.equal(world.observation, observation);
  assert.ok(Number.isFinite(world.results.reward[0]));
  blocks.forEach((block) => block.free());
  world.close();
});

test("the same seed and actions give the same bytes, a state and a clone go on alike", needed, () => {
  const worlds = [new World("standup"), new World("standup")];
  const actions = new Float32Array(worlds[0].layout.actions.length).fill(0.25);
  for (const world of worlds) {
    world.reset({ seed: 3 });
    for (let i = 0; i < 5; i++) world.step(actions);
  }
  assert.deepEqual(worlds[0].block, worlds[1].block);
  const state = worlds[0].saveState();
  const clone = worlds[0].clone();
  worlds[0].step(actions);
  worlds[1].loadState(state);
  worlds[1].step(actions);
  clone.step(actions);
  assert.deepEqual(worlds[1].block, worlds[0].block);
  assert.deepEqual(clone.block, worlds[0].block);
  [...worlds, clone].forEach((world) => world.close());
});

test("a kept state of a 64-bit system is unchanged after loading and saving", needed, async () => {
  // As tests/states/worlds.c makes these worlds: the scene's infant, which sees nothing.
  const kept = { free: {}, reach: {}, standup: {}, catch: {}, position: { actuation: mimo.Actuation.POSITION }, muscle: { actuation: mimo.Actuation.MUSCLE } };
  for (const [name, options] of Object.entries(kept)) {
    const state = new Uint8Array(await readFile(new URL(`../../../tests/states/1.0/${name}.state`, import.meta.url)));
    const scene = new Scene("actuation" in options ? "free" : name);
    scene.addAgent({ vision: 0, ...options });
    const world = new World(scene);
    world.loadState(state);
    assert.deepEqual(world.saveState(), state, name);
    world.close();
    scene.close();
  }
});

test("named access reads and writes: gravity is that of the earth, a face stays", needed, () => {
  const world = new World("standup");
  world.reset();
  assert.deepEqual([...world.get(Quantity.WORLD_GRAVITY)], [0, 0, -9.81]);
  const hand = world.id(Kind.BODY, "right_hand");
  assert.equal(world.name(Kind.BODY, hand), "right_hand");
  assert.equal(world.get(Quantity.BODY_POSITION, [hand]).length, 3);
  const face = mimo.faces().at(-1);
  world.setFace(face);
  assert.equal(world.get(Quantity.AGENT_FACE)[0], world.find(Kind.FACE, face));
  assert.equal(world.names(Kind.JOINT).length, world.count(Kind.JOINT));
  world.close();
});

test("another age is another body: a newborn weighs less than a child of two years", needed, () => {
  const scene = new Scene("reach");
  scene.addAgent({ growth: { age: 24 } });
  const world = new World(scene);
  scene.close();
  world.reset({ seed: 1 });
  const child = world.agent(0).mass;
  world.reset({ age: 0 });
  const newborn = world.agent(0).mass;
  // WHO's medians of weight, mean of girls and boys: 3.29 kg at birth, 11.81 kg at two years.
  assert.ok(Math.abs(newborn / 3.29 - 1) < 0.05, `${newborn} kg`);
  assert.ok(Math.abs(child / 11.81 - 1) < 0.05, `${child} kg`);
  world.close();
});

test("pictures, shapes and poses", needed, () => {
  const world = new World("reach");
  world.reset();
  const picture = world.render({ width: 32, height: 24 }, { depth: true, segmentation: true });
  assert.equal(picture.rgba.length, 32 * 24 * 4);
  assert.ok(picture.rgba.every((one, i) => i % 4 !== 3 || one === 255));
  assert.equal(picture.depth.length, 32 * 24);
  assert.ok(new Set(picture.segmentation).size > 1);
  const geom = world.names(Kind.GEOM).findIndex((name) => name.includes("head"));
  const { positions, normals, indices } = world.mesh(geom, { axes: Axes.GLTF });
  assert.equal(normals.length, positions.length);
  for (let i = 0; i < normals.length; i += 3) assert.ok(Math.abs(Math.hypot(...normals.subarray(i, i + 3)) - 1) < 1e-5);
  assert.ok(Math.max(...indices) < positions.length / 3);
  assert.equal(world.poses(Kind.GEOM, Axes.GLTF).length, 7 * world.count(Kind.GEOM));
  world.close();
});

test("a foreign frame: glTF has y up and looks along z", needed, () => {
  // docs/engines.md: (x, y, z) of libmimo, x forward and z up, is (y, z, x) there.
  assert.deepEqual([...mimo.convertPoints([1, 2, 3], Axes.GLTF)], [2, 3, 1]);
  assert.throws(() => mimo.convertPoints([1, 2], Axes.GLTF), /points has 2 numbers, expected a multiple of 3/);
});

test("a batch does what its worlds do alone", needed, () => {
  const batch = new mimo.Batch("reach", { worlds: 2 });
  const alone = new World("reach");
  batch.reset({ seeds: [5, 6] });
  alone.reset({ seed: 6 });
  const count = alone.layout.actions.length;
  const actions = new Float32Array(2 * count).fill(0.1);
  for (let i = 0; i < 3; i++) {
    batch.step(actions);
    alone.step(actions.subarray(count));
  }
  assert.deepEqual(batch.blocks.slice(alone.block.length), alone.block);
  assert.equal(batch.results.reward[1], alone.results.reward[0]);
  assert.equal(batch.worldError(1).status, Status.OK);
  const joints = alone.get(Quantity.JOINT_POSITION);
  assert.deepEqual([...batch.get(Quantity.JOINT_POSITION, null, [false, true])], [...joints.map(() => 0), ...joints]);
  const states = batch.saveStates();
  batch.step(actions);
  batch.loadStates(states);
  assert.deepEqual(batch.get(Quantity.JOINT_POSITION).slice(joints.length), joints);
  batch.close();
  alone.close();
});

test("a task in JavaScript: its terms are the reward, its exception is the error's cause", needed, () => {
  const scene = new Scene("benchmark");
  scene.addAgent({ vision: 0 });
  let wrong = false;
  scene.setTask({
    terms: ["one", "two"],
    fields: [{ name: "desired_goal" }],
    memory: 2,
    reset: (world, { memory, fields }) => {
      memory[1] = 4;
      fields[0] = 0.5;
    },
    evaluate: (world, { memory, step }) => {
      if (wrong) throw new RangeError("no such thing");
      return { terms: [memory[1], step], outcome: step === 2 ? Outcome.SUCCESS : Outcome.NONE };
    },
  });
  const world = new World(scene);
  world.reset();
  const action = new Float32Array(world.layout.actions.length);
  assert.equal(world.step(action).reward[0], 5);
  assert.deepEqual([...world.step(action).terms], [4, 2]);
  assert.equal(world.results.terminated[0], 1);
  assert.equal(world.observation.desired_goal[0], 0.5);
  wrong = true;
  assert.throws(
    () => world.step(action),
    (error) => error.code === "TASK" && /no such thing/.test(error.message) && error.cause instanceof RangeError,
  );
  world.close();
  scene.close();
});

test("messages of the library come to the log", needed, () => {
  const told = [];
  const scene = new Scene({ name: "benchmark", log: (record) => told.push(record) });
  scene.addAgent({ vision: 0, place: mimo.Place.ROOT, position: [0, 0, 0] }); // half of the infant is in the floor
  new World(scene, { log: (record) => told.push(record) }).close();
  assert.ok(told.some(({ text, level }) => /inside|starts/.test(text) && level === mimo.LogLevel.WARNING), JSON.stringify(told));
  scene.close();
});

test("a behaviour says what it measures: WHO's window of sitting without support", needed, () => {
  const scene = new Scene("sit");
  const { measure, unit, atMost, holdSeconds, normEarly, normLate } = scene.behaviour();
  assert.deepEqual([measure, unit, atMost, holdSeconds, normEarly, normLate], ["tilt upper_body z", "deg", true, 10, 3.8, 9.2]);
  scene.close();
});

test("infants move by themselves, the same in the same episode", needed, () => {
  const world = new World("rollover");
  const count = world.layout.actions.length;
  const [one, same] = [0, 1].map(() => {
    world.reset({ seed: 1 });
    return world.spontaneous(count);
  });
  assert.ok(one.some((action) => action !== 0));
  assert.deepEqual(one, same);
  assert.ok(world.spontaneous(count, Movement.FIDGETS).every((action) => action === 0)); // at 18 months
  world.close();
});
