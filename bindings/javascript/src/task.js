/** Tasks in JavaScript: the library calls them from within resets and steps. */
import { addFunction } from "./loader.js";
import { offsetOf } from "./structs.js";
import { data, guarded, shown, view, wasm } from "./memory.js";

/**
 * What a task's function gets. Its arrays lie in the module's memory and are valid until the function returns.
 * @typedef {object} Moment
 * @property {number} world number in the batch
 * @property {number} agent number of the agent
 * @property {number} step steps since the reset, including this one; 0 in reset
 * @property {Float64Array} memory this world's and agent's own numbers, part of its state
 * @property {Float32Array} fields values of the task's fields, one field after the other
 * @property {Float32Array} action the agent's actions of this step
 *
 * @typedef {object} Verdict
 * @property {number} [reward] the reward of a task without terms
 * @property {number[]} [terms] else the terms of the reward, in the order of the task's
 * @property {number} [outcome] one of Outcome
 * @property {boolean} [goesOn] the episode continues whatever the outcome
 * @property {boolean} [truncated] the episode is cut off
 *
 * @typedef {object} Task
 * @property {string[]} [terms] names of the terms whose sum is the reward
 * @property {import("./generated/types.js").TaskField[]} [fields] fields of one number each, or of `shape`
 * @property {number} [memory] how many numbers it remembers for each world and agent
 * @property {(world: import("./named.js").Named, moment: Moment) => void} [reset]
 * @property {(world: import("./named.js").Named, moment: Moment) => Verdict} evaluate
 */

/** @type {Task[]} what user is the index of: a task lives as long as the page, because worlds may use it that long */
const tasks = [];
/** @type {WeakMap<object, [number, number]>} */
const functions = new WeakMap();
/** @type {(pointer: number) => import("./named.js").Named} */
let worldAt;

/**
 * How a world is made of its address; named.js says it, which needs this file.
 * @param {typeof worldAt} make
 */
export function setWorldAt(make) {
  worldAt = make;
}

/**
 * A mimo_task.
 * @param {import("./memory.js").Frame} frame
 * @param {Task} task
 */
export function writeTask(frame, task) {
  if (typeof task?.evaluate !== "function") throw new TypeError(`evaluate is ${shown(task?.evaluate)}, expected a function`);
  const module = wasm();
  if (!functions.has(module)) {
    functions.set(module, [addFunction(module, reset, 3, true), addFunction(module, evaluate, 4, true)]);
  }
  const [onReset, onEvaluate] = /** @type {[number, number]} */ (functions.get(module));
  const { terms = [], fields = [], memory = 0 } = task;
  const at = frame.struct("mimo_task", { memoryBytes: 8 * memory, termCount: terms.length, fieldCount: fields.length });
  frame.point("mimo_task", at, "user", tasks.push(task) - 1);
  if (task.reset) frame.point("mimo_task", at, "reset", onReset);
  frame.point("mimo_task", at, "evaluate", onEvaluate);
  if (terms.length > 0) frame.point("mimo_task", at, "terms", frame.texts("terms", terms));
  if (fields.length > 0) frame.point("mimo_task", at, "fields", writeFields(frame, fields));
  return at;
}

/**
 * @param {import("./memory.js").Frame} frame
 * @param {(import("./generated/types.js").TaskField & {shape?: number[]})[]} fields
 */
function writeFields(frame, fields) {
  const size = frame.size("mimo_task_field");
  const all = frame.place(size * fields.length);
  fields.forEach(({ shape, ...options }, index) => {
    const one = frame.struct("mimo_task_field", { ...options, ...(shape && { ndim: shape.length }) });
    if (shape) frame.point("mimo_task_field", one, "shape", frame.array("size", "shape", shape));
    view("u8", all + index * size, size).set(view("u8", one, size));
  });
  return all;
}

/** @param {number} at @param {Task} task @returns {Moment} */
function momentAt(at, { memory = 0, fields = [] }) {
  const pointer = (/** @type {string} */ name) => data().getUint32(at + offsetOf("mimo_task_moment", name), true);
  const numbers = fields.reduce((sum, one) => sum + (/** @type {any} */ (one).shape ?? []).reduce((/** @type {number} */ all, /** @type {number} */ size) => all * size, 1), 0);
  return {
    world: pointer("world"),
    agent: pointer("agent"),
    step: Number(data().getBigUint64(at + offsetOf("mimo_task_moment", "step"), true)),
    memory: view("f64", pointer("memory"), memory),
    fields: view("f32", pointer("fields"), numbers),
    action: view("f32", pointer("action"), pointer("actionCount")),
  };
}

/** @param {number} user @param {number} env @param {number} moment */
function reset(user, env, moment) {
  const task = tasks[user];
  return guarded(() => task.reset?.(worldAt(env), momentAt(moment, task)));
}

/** @param {number} user @param {number} env @param {number} moment @param {number} verdict */
function evaluate(user, env, moment, verdict) {
  return guarded(() => {
    const task = tasks[user];
    const told = task.evaluate(worldAt(env), momentAt(moment, task));
    const { reward = 0, terms = [], outcome = 0, goesOn = false, truncated = false } = told;
    const member = (/** @type {string} */ name) => verdict + offsetOf("mimo_task_verdict", name);
    const count = task.terms?.length ?? 0;
    if (terms.length !== count) throw new TypeError(`terms are ${shown(terms)}, expected ${count} numbers`);
    if (count > 0) view("f64", data().getUint32(member("terms"), true), count).set(terms);
    data().setFloat64(member("reward"), reward, true);
    data().setInt32(member("outcome"), outcome, true);
    data().setUint32(member("goesOn"), Number(goesOn), true);
    data().setUint32(member("truncated"), Number(truncated), true);
  });
}
