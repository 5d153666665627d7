// The scenario of tests/capi/same.c, which gives the same hashes in every language. All blocks go to a file in the folder
// that is given, for tests/same/fnv1a to hash; names of scenes and sums of rewards are printed.
import { appendFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Kind, load, Outcome, Quantity, Scene, World } from "../../bindings/javascript/src/index.js";

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
