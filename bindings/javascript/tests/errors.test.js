import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { Worker } from "node:worker_threads";
import * as mimo from "../src/index.js";
import { structs } from "../src/generated/structs.js";
import { instantiate } from "../src/loader.js";
import { buffer, data, within } from "../src/memory.js";
import { needed, wasmPath } from "./support.js";

const { MimoError, Scene, Status, World } = mimo;

test("what the library refuses is an exception with its status and message", needed, () => {
  assert.throws(
    () => new World("nowhere"),
    (error) => error instanceof MimoError && error.status === Status.NOT_FOUND && error.code === "NOT_FOUND" && /"nowhere"/.test(error.message),
  );
  const world = new World("reach");
  assert.throws(() => world.layout.find("touch/nothing"), { code: "NOT_FOUND" });
  world.close();
  world.close();
  assert.throws(() => world.time(), { code: "BAD_HANDLE", message: "this World is closed" });
});

test("nothing is ignored: unknown options, wrong types and wrong lengths", needed, () => {
  assert.throws(() => new World("reach", { frameskip: 1 }), /there is no option frameskip; there are frameSkip/);
  const scene = new Scene("reach");
  assert.throws(() => scene.addAgent({ touch: "all" }), /touch is "all", expected a whole number/);
  assert.throws(() => scene.addAgent({ position: [1, 2] }), /position is \[1,2\], expected 3 numbers/);
  assert.throws(() => scene.addAgent({ normalizeActions: 1 }), /normalizeActions is 1, expected true or false/);
  assert.throws(() => scene.setTouch(0, 5, 0.1), /body is 5, expected a string/);
  assert.throws(() => scene.addAgent({ growth: { age: 30 } }), { code: "INVALID_ARGUMENT", message: /age/ });
  scene.close();
  const world = new World("reach");
  assert.throws(() => world.step([0]), /the action has 1 numbers, expected 8/);
  assert.throws(() => world.step(Array(8).fill("1")), /action 0 is 1, expected a number/);
  assert.throws(() => world.reset({ seed: -1 }), /seed is -1, expected a whole number from 0 to 2\^64 - 1/);
  world.reset({ seed: 2n ** 64n - 1n });
  world.close();
});

test("the module has one thread, and says so", needed, () => {
  const refused = { code: "UNSUPPORTED", message: /^thread 1 of [24] cannot be started: this build of the library has no threads/ };
  assert.throws(() => new mimo.Batch("reach", { worlds: 2, threads: 2 }), refused);
  assert.throws(() => new mimo.Stage({ threads: 4 }), refused);
  for (const renderer of ["ray", "auto"]) {
    assert.throws(() => new World("standup", { renderer, renderThreads: 2 }).render(), refused);
  }
  const batch = new mimo.Batch("reach", { worlds: 2 });
  assert.equal(batch.threads, 1);
  batch.reset();
  const actions = new Float32Array(2 * batch.layout.actions.length);
  assert.throws(() => batch.send(actions), { code: "UNSUPPORTED", message: /no threads besides the caller's/ });
  batch.step(actions);
  batch.close();
});

test("the library fills each struct with defaults, which it refuses for a struct of another size", needed, () => {
  const filled = Object.entries(structs).filter(([, { init }]) => init);
  assert.ok(filled.length > 10, `${filled.length}`);
  within((frame) => filled.forEach(([name, { size }]) => assert.equal(data().getUint32(frame.empty(name), true), size, name)));
});

test("or-ed bits may have the highest one, which makes them negative in JavaScript", needed, () => {
  const scene = new Scene("reach");
  const growth = { age: 6, maturity: mimo.Mature.BODY | mimo.Mature.ALL };
  assert.ok(growth.maturity < 0);
  scene.addAgent({ growth });
  new World(scene).close();
  scene.close();
});

test("what is no module, and a module that is not there, are refused with a sentence", async () => {
  await assert.rejects(instantiate(new TextEncoder().encode("<html>")), { code: "FILE", message: /^mimo.wasm cannot be used here: / });
  const empty = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0);
  await assert.rejects(instantiate(empty), { code: "FILE", message: "the module is not mimo.wasm" });
  await assert.rejects(instantiate(new URL("file:///nowhere/mimo.wasm")), { code: "NOT_FOUND", message: /cannot be read from file:\/\/\/nowhere/ });
});

test("a browser without SIMD is told so", async () => {
  const { validate } = WebAssembly;
  WebAssembly.validate = () => false;
  try {
    await assert.rejects(instantiate(new Uint8Array()), { code: "UNSUPPORTED", message: /no WebAssembly with SIMD/ });
  } finally {
    WebAssembly.validate = validate;
  }
});

test("a worker steps a world of its own, from bytes", needed, async () => {
  const source = `
    const { parentPort, workerData } = require("node:worker_threads");
    import(workerData.package).then(async (mimo) => {
      await mimo.load(workerData.bytes);
      const world = new mimo.World("reach");
      world.reset({ seed: 7 });
      parentPort.postMessage(world.step(new Float32Array(8)).reward[0]);
    });`;
  const workerData = { package: new URL("../src/index.js", import.meta.url).href, bytes: await readFile(wasmPath) };
  const worker = new Worker(source, { eval: true, workerData });
  const [reward] = await new Promise((resolve, reject) => {
    worker.once("message", (...all) => resolve(all));
    worker.once("error", reject);
  });
  await worker.terminate();
  const world = new World("reach");
  world.reset({ seed: 7 });
  assert.equal(reward, world.step(new Float32Array(8)).reward[0]);
  world.close();
});

test("a log is kept as long as what it belongs to", needed, async () => {
  setFlagsFromString("--expose-gc");
  const collect = runInNewContext("gc");
  const gone = async (make) => {
    const log = new WeakRef(make());
    for (let i = 0; i < 10 && log.deref(); i++) {
      await new Promise(setImmediate);
      collect();
    }
    return log.deref() === undefined;
  };
  const refused = (make) => () => {
    const log = () => {};
    assert.throws(() => make(log));
    return log;
  };
  assert.ok(await gone(refused((log) => new Scene({ name: "nowhere", log }))));
  assert.ok(await gone(refused((log) => new World("reach", { task: "nothing", log }))));
  assert.ok(await gone(refused((log) => new mimo.Batch("reach", { worlds: 0, log }))));
  assert.ok(await gone(refused((log) => new mimo.Stage({ threads: 4, log }))));
  const closed = () => {
    const log = () => {};
    new World("reach", { log }).close();
    return log;
  };
  assert.ok(await gone(closed));
  let open;
  const kept = () => {
    const log = () => {};
    open = new World("reach", { log });
    return log;
  };
  assert.ok(!(await gone(kept)));
  open.close();
});

test("worlds that are made and closed leave no memory behind", needed, () => {
  const sizes = [];
  for (let i = 0; i < 30; i++) {
    const world = new World("reach");
    world.reset();
    world.close();
    sizes.push(buffer().byteLength);
  }
  assert.ok(sizes.at(-1) - sizes[15] < 1 << 20, `${sizes}`); // one world takes several megabytes;
});
