/** Messages of the library, for the function `log` of a scene's or a world's options. */
import { addFunction } from "./loader.js";
import { readStruct } from "./structs.js";
import { data, shown, wasm } from "./memory.js";

/** @typedef {(record: import("./generated/types.js").LogRecord) => void} Log */

/** @type {Map<number, Log>} */
const logs = new Map();
let last = 0;
/** @type {WeakMap<object, number>} the function of C for each module */
const receivers = new WeakMap();

/**
 * Makes something with a log. What is refused has none afterwards; else the second function forgets it.
 * @template T
 * @param {Log | undefined} log
 * @param {number} at where the member log of its config is
 * @param {() => T} make
 * @returns {[T, () => void]}
 */
export function withLog(log, at, make) {
  const forget = receive(log, at);
  try {
    return [make(), forget];
  } catch (error) {
    forget();
    throw error;
  }
}

/**
 * Puts a function into the members log and log_user of a config; returns a function that forgets it.
 * @param {Log | undefined} log
 * @param {number} at
 */
function receive(log, at) {
  if (log === undefined) return () => {};
  if (typeof log !== "function") throw new TypeError(`log is ${shown(log)}, expected a function`);
  const module = wasm();
  if (!receivers.has(module)) receivers.set(module, addFunction(module, told, 2, false));
  const id = ++last;
  logs.set(id, log);
  data().setUint32(at, /** @type {number} */ (receivers.get(module)), true);
  data().setUint32(at + 4, id, true);
  return () => logs.delete(id);
}

/**
 * @param {number} user
 * @param {number} record
 */
function told(user, record) {
  try {
    logs.get(user)?.(/** @type {any} */ (readStruct("mimo_log_record", record)));
  } catch (error) {
    // The library cannot pass an exception on; the program hears of it where it hears of all its own.
    queueMicrotask(() => {
      throw error;
    });
  }
}
