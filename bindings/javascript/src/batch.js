import { Handle } from "./handle.js";
import { Autoreset, Movement } from "./generated/constants.js";
import { layoutOf } from "./layout.js";
import { withLog } from "./log.js";
import { Block, check, integer, textAt, view, wasm, within } from "./memory.js";
import { idsOf, Named } from "./named.js";
import { Actions, growths, Results } from "./observed.js";
import { Scene } from "./scene.js";
import { offsetOf } from "./structs.js";
import { arraysOf, stepOf } from "./world.js";

/**
 * @typedef {import("./world.js").WorldOptions & {
 *   worlds: number, threads?: number, autoreset?: number, restartFailed?: boolean, ages?: import("./world.js").Age[]
 * }} BatchOptions
 *
 * @typedef {import("./world.js").Step & {status: Int32Array, wasReset: Uint8Array, finalWritten: Uint8Array}} BatchStep
 */

/** Many worlds of one scene, which step together. Arrays have the worlds one after the other. */
export class Batch extends Handle {
  #blocks;
  #final;
  #actions;
  #results;

  /**
   * @param {string | Scene} scene a built-in scene with all its infants, by name; or a scene
   * @param {BatchOptions} options
   */
  constructor(scene, { worlds, threads, autoreset, restartFailed, ages = [], log, ...options }) {
    const own = typeof scene === "string" ? new Scene(scene) : scene;
    const parts = /** @type {{free(): void}[]} */ ([]);
    const [pointer, forget] = within((frame) => {
      try {
        if (own !== scene) own.addAgents();
        const at = frame.place(4);
        const config = frame.struct("mimo_env_config", options);
        const many = frame.struct("mimo_batch_config", { worlds, threads, autoreset, restartFailed, cohortCount: ages.length });
        if (ages.length > 0) frame.point("mimo_batch_config", many, "cohort", growths(frame, ages));
        return withLog(log, config + offsetOf("mimo_env_config", "log"), () => {
          check(wasm().mimo_batch_create(own.pointer, config, many, at));
          return frame.numberAt("size", at);
        });
      } finally {
        if (own !== scene) own.close();
      }
    });
    super(pointer, () => {
      wasm().mimo_batch_destroy(pointer);
      forget();
      for (const part of parts) part.free();
    });
    /** Number of worlds. */
    this.worlds = worlds;
    /** Number of threads that step them. */
    this.threads = within((frame) => {
      const at = frame.place(8);
      check(wasm().mimo_batch_size(pointer, at, at + 4));
      return frame.numberAt("size", at + 4);
    });
    /** The fields, actions and terms of each world. */
    this.layout = layoutOf((at) => wasm().mimo_batch_layout(pointer, at));
    const { agents, terms, actions, blockBytes } = this.layout;
    this.#blocks = new Block(worlds * blockBytes);
    this.#final = new Block(autoreset === Autoreset.SAME_STEP ? worlds * blockBytes : 0);
    this.#actions = new Actions(worlds * actions.length);
    this.#results = new Results(
      "mimo_batch_results",
      {
        ...arraysOf(worlds * agents, worlds * terms.length),
        status: ["i32", worlds],
        wasReset: ["u8", worlds],
        finalWritten: ["u8", worlds],
      },
      { agentCount: worlds * agents, termCount: worlds * terms.length, worlds },
    );
    if (this.#final.bytes > 0) this.#results.point({ finalBlocks: this.#final.pointer, finalBytes: this.#final.bytes });
    parts.push(this.#blocks, this.#final, this.#actions, this.#results);
    /** @type {BatchStep} */
    this.results = stepOf(this.#results);
  }

  /** The observations of all worlds as bytes in the module's memory. @returns {Uint8Array} */
  get blocks() {
    return view("u8", this.#blocks.pointer, this.#blocks.bytes);
  }

  /**
   * One world's observation by fields, in the module's memory.
   * @param {number} world
   */
  observation(world) {
    return this.layout.views(this.#blocks.pointer + this.#number(world) * this.layout.blockBytes);
  }

  /**
   * With Autoreset.SAME_STEP: the last observation of the episode of a world that ended in this step.
   * @param {number} world
   */
  finalObservation(world) {
    if (this.#final.bytes === 0) throw new RangeError("there are final observations with Autoreset.SAME_STEP only");
    return this.layout.views(this.#final.pointer + this.#number(world) * this.layout.blockBytes);
  }

  /** @param {number} world */
  #number(world) {
    return integer("world", world, 0, this.worlds - 1);
  }

  /**
   * Starts episodes.
   * @param {{seeds?: (number | bigint)[], mask?: ArrayLike<boolean | number>, ages?: import("./world.js").Age[]}} [options]
   * one of each for every world
   */
  reset({ seeds, mask, ages } = {}) {
    within((frame) => {
      const config = frame.struct("mimo_batch_reset_config", { worlds: this.worlds });
      if (seeds) frame.point("mimo_batch_reset_config", config, "seeds", frame.array("u64", "seeds", seeds, this.worlds));
      if (mask) frame.point("mimo_batch_reset_config", config, "mask", this.#mask(frame, mask));
      if (ages) {
        if (ages.length !== this.worlds) throw new RangeError(`there are ${ages.length} ages, expected ${this.worlds}`);
        frame.point("mimo_batch_reset_config", config, "growth", growths(frame, ages));
      }
      check(wasm().mimo_batch_reset(this.pointer, config, this.#blocks.pointer, this.#blocks.bytes));
    });
    if (ages) this.layout.renew();
  }

  /**
   * @param {import("./memory.js").Frame} frame
   * @param {ArrayLike<boolean | number> | undefined} mask
   */
  #mask(frame, mask) {
    return mask === undefined ? 0 : frame.array("u8", "mask", mask, this.worlds);
  }

  /**
   * Steps all worlds.
   * @param {ArrayLike<number>} actions worlds x actions
   * @returns {BatchStep}
   */
  step(actions) {
    check(this.#call(wasm().mimo_batch_step, actions));
    return this.results;
  }

  /**
   * Starts a step and returns; `receive` waits for its end.
   * @param {ArrayLike<number>} actions worlds x actions
   */
  send(actions) {
    check(this.#call(wasm().mimo_batch_send, actions));
  }

  receive() {
    check(wasm().mimo_batch_receive(this.pointer));
    return this.results;
  }

  /**
   * @param {Function} call
   * @param {ArrayLike<number>} actions
   */
  #call(call, actions) {
    const at = this.#actions.write(actions);
    return call(this.pointer, at, this.#actions.count, this.#blocks.pointer, this.#blocks.bytes, this.#results.pointer);
  }

  /** Senses anew without a step. @param {ArrayLike<boolean | number>} [mask] */
  observe(mask) {
    within((frame) => {
      check(wasm().mimo_batch_observe(this.pointer, this.#mask(frame, mask), mask ? this.worlds : 0, this.#blocks.pointer, this.#blocks.bytes));
    });
  }

  /**
   * One of the worlds, for named access. It belongs to the batch.
   * @param {number} world
   */
  world(world) {
    return within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_batch_world(this.pointer, this.#number(world), at));
      return new Named(frame.numberAt("size", at), null);
    });
  }

  /**
   * Why a world did not do what was asked in the last call.
   * @param {number} world
   * @returns {{status: number, message: string}}
   */
  worldError(world) {
    return within((frame) => {
      const at = frame.place(8);
      check(wasm().mimo_batch_world_error(this.pointer, this.#number(world), at, at + 4));
      return { status: frame.numberAt("i32", at), message: textAt(frame.numberAt("size", at + 4)) };
    });
  }

  /**
   * Reads a quantity of all worlds, one after the other; of worlds outside the mask there are zeros.
   * @param {number} quantity one of Quantity
   * @param {ArrayLike<number> | null} [ids] null: all
   * @param {ArrayLike<boolean | number>} [mask]
   * @returns {Float64Array}
   */
  get(quantity, ids = null, mask = undefined) {
    return this.#get("f64", wasm().mimo_batch_get, quantity, ids, mask);
  }

  /**
   * The same in single precision.
   * @param {number} quantity
   * @param {ArrayLike<number> | null} [ids]
   * @param {ArrayLike<boolean | number>} [mask]
   * @returns {Float32Array}
   */
  getFloat(quantity, ids = null, mask = undefined) {
    return this.#get("f32", wasm().mimo_batch_get_float, quantity, ids, mask);
  }

  /**
   * @param {"f32" | "f64"} kind
   * @param {Function} call
   * @param {number} quantity
   * @param {ArrayLike<number> | null} ids
   * @param {ArrayLike<boolean | number> | undefined} mask
   */
  #get(kind, call, quantity, ids, mask) {
    const width = this.world(0).width(quantity, ids) * this.worlds;
    return within((frame) => {
      const at = frame.place(8 * Math.max(width, 1));
      frame.view(kind, at, width).fill(0);
      check(call(this.pointer, quantity, idsOf(frame, ids), ids?.length ?? 0, this.#mask(frame, mask), mask ? this.worlds : 0, at, width));
      return frame.view(kind, at, width).slice();
    });
  }

  /**
   * Writes a quantity in all worlds, or in those of a mask; there are values for all.
   * @param {number} quantity one of Quantity
   * @param {ArrayLike<number> | null} ids null: all
   * @param {ArrayLike<number>} values of the worlds one after the other
   * @param {ArrayLike<boolean | number>} [mask]
   */
  set(quantity, ids, values, mask) {
    within((frame) => {
      const [given, chosen] = [idsOf(frame, ids), this.#mask(frame, mask)];
      const at = frame.array("f64", "values", values);
      check(wasm().mimo_batch_set(this.pointer, integer("quantity", quantity), given, ids?.length ?? 0, chosen, mask ? this.worlds : 0, at, values.length));
    });
  }

  /**
   * What the motors of all infants do by themselves: actions for the next step, one world after the other.
   * @param {number} [which] kinds of Movement
   * @returns {Float32Array}
   */
  spontaneous(which = Movement.ALL) {
    return within((frame) => {
      const count = this.worlds * this.layout.actions.length;
      const at = frame.place(4 * Math.max(count, 1));
      check(wasm().mimo_batch_spontaneous(this.pointer, integer("which", which, 0), at, count));
      return frame.view("f32", at, count).slice();
    });
  }

  /** @param {ArrayLike<boolean | number>} [mask] @returns {Uint8Array} the states of all worlds; zeros outside the mask */
  saveStates(mask) {
    return within((frame) => {
      const size = frame.place(4);
      check(wasm().mimo_batch_state_size(this.pointer, size));
      const bytes = frame.numberAt("size", size) * this.worlds;
      const at = frame.place(bytes);
      frame.view("u8", at, bytes).fill(0);
      check(wasm().mimo_batch_state_save(this.pointer, this.#mask(frame, mask), mask ? this.worlds : 0, at, bytes));
      return frame.view("u8", at, bytes).slice();
    });
  }

  /**
   * @param {Uint8Array} states
   * @param {ArrayLike<boolean | number>} [mask]
   * @returns {import("./generated/types.js").LoadReport}
   */
  loadStates(states, mask) {
    return within((frame) => {
      const at = frame.array("u8", "states", states);
      const report = frame.empty("mimo_load_report");
      check(wasm().mimo_batch_state_load(this.pointer, this.#mask(frame, mask), mask ? this.worlds : 0, at, states.length, report));
      return frame.record("mimo_load_report", report);
    });
  }
}
