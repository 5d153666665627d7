// The scenario of tests/capi/same.c, which gives the same hashes in every language. All blocks go to a file in the folder
// that is given, for tests/same/fnv1a to hash; names of scenes and sums of rewards are printed.
import { appendFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Form, Kind, Lamp, load, Outcome, Quantity, Scene, Stage, TextureType, World } from "../../bindings/javascript/src/index.js";

/** The task "own" of tests/capi/same.c. */
const height = {
  terms: ["height", "effort"],
  fields: ["desired_goal", "achieved_goal"].map((name) => ({ name, unit: "m", frame: "world" })),
  memory: 1,
  reset(world, { memory, fields }) {
    memory[0] = 0.2 + 0.2 * world.random(1)[0];
    fields[0] = memory[0];
  },
  evaluate(world, { memory, fields, action }) {
    const hand = world.get(Quantity.BODY_POSITION, [world.find(Kind.BODY, "left_hand")])[2];
    const effort = action.reduce((sum, one) => sum + one * one, 0);
    fields[1] = hand;
    const outcome = hand > memory[0] ? Outcome.SUCCESS : Outcome.NONE;
    return { terms: [hand - memory[0], -0.01 * effort], outcome, goesOn: true };
  },
};

function make(name) {
  if (name !== "own") return new World(name);
  const scene = new Scene("benchmark");
  scene.addAgent({ vision: 0 });
  scene.setTask(height);
  return new World(scene);
}

/** The picture of tests/capi/same.c. */
function drawStage() {
  const upright = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const stage = new Stage({
    geoms: {
      objectType: 5,
      forms: [Form.PLANE, Form.SPHERE],
      sizes: [0, 0, 0, 0.5, 0, 0],
      colors: [1, 1, 1, 1, 0.9, 0.2, 0.1, 1],
      materials: [0, -1],
    },
    textures: {
      types: [TextureType.FLAT],
      widths: [2],
      heights: [2],
      pixels: [200, 30, 90, 20, 180, 60, 40, 80, 220, 250, 240, 130],
      srgb: [1],
    },
    materials: { colors: [1, 1, 1, 1], textures: [0] },
    lights: { types: [Lamp.SUN] },
  });
  const poses = {
    geomPositions: [0, 0, 0, 0, 0, 0.5],
    geomRotations: [...upright, ...upright],
    lightPositions: [0, 0, 5],
    lightDirections: [0, 0.6, -0.8],
  };
  const view = { width: 64, height: 48, position: [0, 0, 4], rotation: upright, depth: true, segmentation: true };
  const { rgba, depth, segmentation } = stage.draw(poses, view);
  stage.close();
  const rgb = Uint8Array.from(rgba.filter((_, i) => i % 4 !== 3));
  writeFileSync(join(process.argv[2], "stage"), Buffer.concat([rgb, depth, segmentation].map((one) => Buffer.from(one.buffer))));
  console.log("stage", rgb.reduce((sum, one) => sum + one, 0).toFixed(6));
}

await load(process.env.MIMO_WASM);
for (const name of ["reach", "standup", "selfbody", "benchmark", "own"]) {
  const world = make(name);
  const file = join(process.argv[2], name);
  const action = new Float32Array(world.layout.actions.length);
  world.reset({ seed: 7 });
  writeFileSync(file, world.block);
  let total = 0;
  for (let step = 0; step < 100; step++) {
    for (let i = 0; i < action.length; i++) action[i] = (((7 * step + 3 * i) % 21) - 10) / 10;
    total += world.step(action).reward[0];
    appendFileSync(file, world.block);
  }
  console.log(name, total.toFixed(6));
  world.close();
}
drawStage();
