import { SceneCalls } from "./generated/scene_calls.js";
import { offsetOf } from "./structs.js";
import { check, Frame, integer, wasm, within } from "./memory.js";
import { withLog } from "./log.js";
import { writeTask } from "./task.js";

/**
 * @typedef {import("./generated/types.js").SceneConfig & {log?: import("./log.js").Log}} SceneOptions
 * @typedef {import("./generated/types.js").AgentConfig} AgentConfig
 */

/** A room, objects, infants and cameras, of which worlds are made. */
export class Scene extends SceneCalls {
  /**
   * A built-in scene by its name; or one by options: `xml` is an MJCF document. The module sees no files of the
   * system, so a `file` is not found.
   * @param {string | SceneOptions} [scene]
   */
  constructor(scene = {}) {
    const { log, ...options } = typeof scene === "string" ? { name: scene, log: undefined } : scene;
    const [pointer, forget] = within((frame) => {
      const config = frame.struct("mimo_scene_config", options);
      const at = frame.place(4);
      return withLog(log, config + offsetOf("mimo_scene_config", "log"), () => {
        check(wasm().mimo_scene_create(config, at));
        return frame.numberAt("size", at);
      });
    });
    super(pointer, () => {
      wasm().mimo_scene_destroy(pointer);
      forget();
    });
  }

  /**
   * The scene's defaults for its next infant.
   * @returns {AgentConfig}
   */
  defaultAgent() {
    return within((frame) => frame.record("mimo_agent_config", this.#agent(frame, {})));
  }

  /**
   * @param {Frame} frame
   * @param {AgentConfig} config
   */
  #agent(frame, config) {
    const size = frame.size("mimo_agent_config");
    const at = frame.place(size);
    check(wasm().mimo_scene_default_agent(this.pointer, at, size));
    return frame.struct("mimo_agent_config", config, at);
  }

  /**
   * Adds an infant: the scene's defaults, with these options.
   * @param {AgentConfig} [config]
   * @returns {number} its number, 0 for the first
   */
  addAgent(config = {}) {
    return within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_scene_add_agent(this.pointer, this.#agent(frame, config), at));
      return frame.numberAt("size", at);
    });
  }

  /**
   * Adds all infants that the scene names, or a single one: the scene's defaults, with these options.
   * @param {AgentConfig} [config]
   * @returns {number} how many were added
   */
  addAgents(config = {}) {
    return within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_scene_add_agents(this.pointer, this.#agent(frame, config), at));
      return frame.numberAt("size", at);
    });
  }

  /**
   * Adds a quantity of chosen elements to the observation.
   * @param {import("./generated/types.js").FieldConfig & {elements?: string[]}} config
   */
  addField({ elements = [], ...config }) {
    within((frame) => {
      const at = frame.struct("mimo_field_config", { ...config, elementCount: elements.length });
      if (elements.length > 0) frame.point("mimo_field_config", at, "elements", frame.texts("elements", elements));
      check(wasm().mimo_scene_add_field(this.pointer, at));
    });
  }

  /**
   * Sets the maturity of an agent's eyes and nerves; null: that of its age.
   * @param {number} agent
   * @param {import("./generated/types.js").Maturity | null} maturity
   */
  setMaturity(agent, maturity) {
    within((frame) => {
      const at = maturity === null ? 0 : frame.struct("mimo_maturity", maturity);
      check(wasm().mimo_scene_set_maturity(this.pointer, integer("agent", agent, 0), at));
    });
  }

  /**
   * Replaces the task by one of your own; null: none.
   * @param {import("./task.js").Task | null} task
   */
  setTask(task) {
    within((frame) => {
      check(wasm().mimo_scene_set_task(this.pointer, task === null ? 0 : writeTask(frame, task)));
    });
  }

  /**
   * The scene as one MJCF document, as MuJoCo will compile it.
   * @returns {string}
   */
  xml() {
    return within((frame) => {
      const length = frame.place(4);
      check(wasm().mimo_scene_xml(this.pointer, 0, 0, length));
      const capacity = frame.numberAt("size", length) + 1;
      const at = frame.place(capacity);
      check(wasm().mimo_scene_xml(this.pointer, at, capacity, length));
      return new TextDecoder().decode(frame.view("u8", at, capacity - 1).slice());
    });
  }
}

/**
 * The eyes and nerves of an age in months.
 * @param {number} age
 * @returns {import("./generated/types.js").Maturity}
 */
export function maturityAt(age) {
  return within((frame) => {
    const size = frame.size("mimo_maturity");
    const at = frame.place(size);
    check(wasm().mimo_maturity_at(age, at, size));
    return frame.record("mimo_maturity", at);
  });
}
