/** What the library itself knows: its version, and lists of names. */
import { listed } from "./layout.js";
import { check, integer, textAt, wasm, within } from "./memory.js";

/** The library's version. */
export const version = () => textAt(wasm().mimo_version());

/** The version of MuJoCo inside. */
export const mujocoVersion = () => textAt(wasm().mimo_mujoco_version());

/** The version of the interface with which the library was built. */
export const apiVersion = () => wasm().mimo_api_version();

/** The name of a status. @param {number} status */
export const statusName = (status) => textAt(wasm().mimo_status_name(integer("status", status)));

/** Whether the library has a name of the C interface: "mimo_env_step", "mimo_field.period". @param {string} name */
export const supports = (name) => within((frame) => wasm().mimo_supports(frame.text("name", name)) === 1);

/** The built-in scenes. */
export const scenes = () => listed(wasm().mimo_scene_name);

/** The rooms that scenes can have. */
export const rooms = () => listed(wasm().mimo_room_name);

/** The faces that infants can make. */
export const faces = () => listed(wasm().mimo_face_name);

/** The built-in tasks. */
export const tasks = () => listed(wasm().mimo_task_name);

/** The materials that things can be made of. */
export const materials = () => listed(wasm().mimo_material_name);

/** The parameters of all tasks: their names, what they are, and their bounds. */
export function parameters() {
  return within((frame) => {
    const at = frame.place(4);
    check(wasm().mimo_parameter_count(at));
    return Array.from({ length: frame.numberAt("size", at) }, (_, index) => {
      const one = frame.empty("mimo_parameter");
      check(wasm().mimo_parameter_describe(index, one));
      return /** @type {import("./generated/types.js").Parameter} */ (frame.record("mimo_parameter", one));
    });
  });
}
