import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";
import { MimoError, Recorder, Recording, Replay, World } from "../src/index.js";
import { needed } from "./support.js";

const HDF5 = [0x89, ...Buffer.from("HDF\r\n\x1a\n")]; // the format's signature
const STEPS = 60;

/** Fixed actions: tenths from -1 to 1. */
const action = (world, step) => world.layout.actions.map((_, i) => (((7 * step + 3 * i) % 21) - 10) / 10);

function recorded() {
  const world = new World("reach");
  const recorder = new Recorder(world, { keep: "all", stateSeconds: 0.2, configuration: "sixty steps", seed: 7n });
  world.reset({ seed: 7 });
  const heads = [];
  for (let step = 0; step < STEPS; step++) {
    world.step(action(world, step));
    heads.push(world.observation["proprioception/position"].slice());
  }
  const bytes = recorder.finish();
  world.close();
  return { bytes, heads };
}

test("a recording is an HDF5 file in memory, and its replay gives the same numbers to the last bit", needed, () => {
  const { bytes, heads } = recorded();
  assert.deepEqual([...bytes.subarray(0, 8)], HDF5);
  const recording = new Recording(bytes);
  const { steps, configuration, seed, formatVersion } = recording.info;
  assert.deepEqual([steps, configuration, seed, formatVersion], [STEPS, "sixty steps", "7", 3]);
  const world = recording.world();
  assert.equal(recording.seek(world, 0, Replay.FIELDS), 0);
  for (const head of heads) {
    assert.equal(recording.step(world).reward.length, 1);
    assert.deepEqual(world.observation["proprioception/position"], head);
  }
  assert.equal(recording.step(world), null);
  const { identical, largestDifference } = recording.report;
  assert.deepEqual([Boolean(identical), largestDifference, recording.report.steps], [true, 0, STEPS]);
  recording.close();
  world.close();
});

test("a replay begins at a kept state, and the visitor takes over from any step", needed, () => {
  const recording = new Recording(recorded().bytes);
  const world = recording.world();
  const next = recording.seek(world, 40);
  assert.ok(next > 0 && next <= 40, `${next}`);
  recording.step(world);
  recording.close();
  world.step(action(world, 0));
  assert.ok(Number.isFinite(world.results.reward[0]));
  world.close();
});

test("actions and other datasets are read as typed arrays", needed, () => {
  const recording = new Recording(recorded().bytes);
  const { rows, rowBytes } = recording.size("actions");
  assert.equal(rows, STEPS);
  const actions = recording.read("actions", "f32");
  assert.equal(actions.length, (STEPS * rowBytes) / 4);
  assert.equal(actions[rowBytes / 4], Math.fround(-0.3)); // step 1, motor 0: (7 - 10) / 10
  assert.deepEqual([...recording.read("time", "f64", 1, 1)], [0.02 * 1]);
  assert.throws(() => recording.size("nothing"), { code: "NOT_FOUND" });
  assert.throws(() => recording.read("actions", "float"), /TypeError: kind is "float", expected u8, .* f32/);
  recording.close();
});

test("a recording of another program is read", needed, async () => {
  const file = new URL("../../../tests/states/1.0/recording.h5", import.meta.url);
  const recording = new Recording(new Uint8Array(await readFile(file)));
  const world = recording.world();
  assert.ok(recording.info.steps > 0);
  recording.seek(world);
  assert.notEqual(recording.step(world), null);
  recording.close();
  world.close();
});

test("bytes that are no recording are refused with a sentence", needed, () => {
  const refused = (name) => (error) => error instanceof MimoError && error.message.startsWith(`${name} is not a recording`);
  assert.throws(() => new Recording(new Uint8Array(1000), "run.h5"), refused("run.h5"));
  assert.throws(() => new Recording("run.h5"), TypeError);
  const { bytes } = recorded();
  assert.throws(() => new Recording(bytes.slice(0, bytes.length / 2)), MimoError);
});
