import { MimoError } from "./error.js";
import { Status } from "./generated/constants.js";
import { layoutOf } from "./layout.js";
import { withLog } from "./log.js";
import { Block, buffer, check, integer, view, wasm, within } from "./memory.js";
import { forget, Named } from "./named.js";
import { Actions, growths, Results } from "./observed.js";
import { Scene } from "./scene.js";
import { offsetOf } from "./structs.js";

/**
 * @typedef {import("./generated/types.js").EnvConfig & {log?: import("./log.js").Log}} WorldOptions
 * @typedef {import("./generated/types.js").Growth} Growth
 * @typedef {number | Growth | null} Age months, or options of growth; null: as it is
 *
 * What a step gave, one for each agent; the arrays lie in the module's memory and the next step overwrites them.
 * @typedef {object} Step
 * @property {Float64Array} reward
 * @property {Uint8Array} terminated 1 where the episode ended by success or failure
 * @property {Uint8Array} truncated 1 where the episode was cut off
 * @property {Int32Array} outcome of Outcome
 * @property {Float64Array} terms the terms of the rewards, in the order of layout.terms
 */

/** A world: physics, infants, senses and task. It owns one block of memory, into which each step writes all observations. */
export class World extends Named {
  #block;
  #results;
  #actions;
  /** @type {Readonly<Record<string, import("./layout.js").Values>> | null} */
  #views = null;
  /** @type {ArrayBuffer | null} */
  #seen = null;

  /**
   * @param {string | Scene | number} scene a built-in scene with all its infants, by name; or a scene
   * @param {WorldOptions} [options]
   */
  constructor(scene, options = {}) {
    const [pointer, forgetLog] = typeof scene === "number" ? [scene, () => {}] : made(scene, options);
    const parts = /** @type {{free(): void}[]} */ ([]);
    super(pointer, () => {
      wasm().mimo_env_destroy(pointer);
      forget(pointer);
      forgetLog();
      for (const part of parts) part.free();
    });
    /** The fields, actions and terms of this world. */
    this.layout = layoutOf((at) => wasm().mimo_env_layout(pointer, at));
    const { agents, terms, actions, blockBytes } = this.layout;
    this.#block = new Block(blockBytes);
    this.#actions = new Actions(actions.length);
    this.#results = new Results("mimo_env_results", arraysOf(agents, terms.length), { agentCount: agents, termCount: terms.length });
    parts.push(this.#block, this.#actions, this.#results);
    /** @type {Step} */
    this.results = stepOf(this.#results);
  }

  /** @internal */
  get block_() {
    return this.#block;
  }

  /** @internal */
  get results_() {
    return this.#results;
  }

  /** All observations as bytes in the module's memory, without a copy. @returns {Uint8Array} */
  get block() {
    return view("u8", this.#block.pointer, this.#block.bytes);
  }

  /**
   * The observation by fields: "proprioception/position", "touch/force", ... The arrays lie in the module's memory and
   * change with each step. After the memory has grown they are other arrays: ask for `world.observation` anew.
   */
  get observation() {
    if (this.#views === null || this.#seen !== buffer()) {
      this.#seen = buffer();
      this.#views = this.layout.views(this.#block.pointer);
    }
    return this.#views;
  }

  /**
   * Starts an episode. A growth gives the infants another age: one for all, or a list with one for each.
   * @param {{seed?: number | bigint, age?: Age | Age[]}} [options]
   * @returns {Readonly<Record<string, import("./layout.js").Values>>} the observation
   */
  reset({ seed, age } = {}) {
    within((frame) => {
      const ages = age === undefined ? [] : Array.isArray(age) ? age : [age];
      const config = frame.struct("mimo_reset_config", { seed, growthCount: ages.length });
      if (ages.length > 0) frame.point("mimo_reset_config", config, "growth", growths(frame, ages));
      check(wasm().mimo_env_reset(this.pointer, config, this.#block.pointer, this.#block.bytes));
    });
    if (age !== undefined) this.layout.renew();
    return this.observation;
  }

  /**
   * Steps.
   * @param {ArrayLike<number>} action one number for each of layout.actions
   * @returns {Step} what came of it; the observation is in `observation`
   */
  step(action) {
    const at = this.#actions.write(action);
    check(wasm().mimo_env_step(this.pointer, at, this.#actions.count, this.#block.pointer, this.#block.bytes, this.#results.pointer));
    return this.results;
  }

  /** Senses anew without a step. */
  observe() {
    check(wasm().mimo_env_observe(this.pointer, this.#block.pointer, this.#block.bytes));
    return this.observation;
  }

  /**
   * Moves one step along a known movement, and senses as if the infant had moved so.
   * @param {ArrayLike<number>} positions frameSkip() times the positions of all joints
   * @param {number} [forces] how many forces to return: frameSkip() times the degrees of freedom
   */
  follow(positions, forces = 0) {
    return super.followInto(positions, this.#block, integer("forces", forces, 0));
  }

  /** Another world in the same state. */
  clone() {
    return within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_env_clone(this.pointer, at));
      return new World(frame.numberAt("size", at));
    });
  }
}

/**
 * @param {string | Scene} scene
 * @param {WorldOptions} options
 * @returns {[number, () => void]}
 */
function made(scene, { log, ...options }) {
  return within((frame) => {
    const at = frame.place(4);
    if (typeof scene === "string" && log === undefined && Object.keys(options).length === 0) {
      check(wasm().mimo_env_make(frame.text("scene", scene), at));
      return [frame.numberAt("size", at), () => {}];
    }
    const own = typeof scene === "string" ? new Scene(scene) : scene;
    if (!(own instanceof Scene)) throw new MimoError(Status.INVALID_ARGUMENT, "scene is no Scene and no name of one");
    try {
      if (own !== scene) own.addAgents();
      const config = frame.struct("mimo_env_config", options);
      return withLog(log, config + offsetOf("mimo_env_config", "log"), () => {
        check(wasm().mimo_env_create(own.pointer, config, at));
        return frame.numberAt("size", at);
      });
    } finally {
      if (own !== scene) own.close();
    }
  });
}

/**
 * The arrays of results.
 * @param {number} agents
 * @param {number} terms
 * @returns {Record<string, [import("./memory.js").NumberKind, number]>}
 */
export function arraysOf(agents, terms) {
  return {
    reward: ["f64", agents],
    terms: ["f64", terms],
    outcome: ["i32", agents],
    terminated: ["u8", agents],
    truncated: ["u8", agents],
  };
}

/**
 * Results by their names, each time where they lie now.
 * @param {Results} results
 * @returns {any}
 */
export function stepOf(results) {
  const step = {};
  for (const name of Object.keys(results.arrays)) {
    Object.defineProperty(step, name, { enumerable: true, get: () => results.get(name) });
  }
  return Object.freeze(step);
}
