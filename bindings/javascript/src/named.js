import { WorldCalls } from "./generated/world_calls.js";
import { Kind, Movement, Quantity } from "./generated/constants.js";
import { Block, check, integer, wasm, within } from "./memory.js";
import { setWorldAt } from "./task.js";

/**
 * @typedef {import("./generated/types.js").PictureConfig} PictureConfig
 *
 * @typedef {object} Picture
 * @property {number} width
 * @property {number} height
 * @property {Uint8ClampedArray} [rgba] four bytes a pixel, as ImageData takes them
 * @property {Float32Array} [depth] metres along the camera's axis
 * @property {Int32Array} [segmentation] geom ids, -1 is background
 *
 * @typedef {object} Mesh
 * @property {Float32Array} positions three for each vertex
 * @property {Float32Array} normals three for each vertex
 * @property {Float32Array} texcoords two for each vertex
 * @property {Uint32Array} indices three for each triangle
 */

/** A world that somebody else steps: its things by name, its pictures, its shapes. */
export class Named extends WorldCalls {
  /** @type {Map<string, number>} */
  #ids = new Map();

  /**
   * The id of a thing by its name, which is looked up once.
   * @param {number} kind one of Kind
   * @param {string} name
   */
  id(kind, name) {
    const key = `${kind} ${name}`;
    let id = this.#ids.get(key);
    if (id === undefined) this.#ids.set(key, (id = this.find(kind, name)));
    return id;
  }

  /**
   * The names of all things of a kind, in the order of their ids.
   * @param {number} kind one of Kind
   * @returns {string[]}
   */
  names(kind) {
    return Array.from({ length: this.count(kind) }, (_, id) => this.name(kind, id));
  }

  /**
   * How many numbers `get` returns.
   * @param {number} quantity one of Quantity
   * @param {ArrayLike<number> | null} [ids] null: all
   * @returns {number}
   */
  width(quantity, ids = null) {
    return within((frame) => this.#width(frame, quantity, idsOf(frame, ids), ids?.length ?? 0));
  }

  /**
   * @param {import("./memory.js").Frame} frame
   * @param {number} quantity
   * @param {number} ids
   * @param {number} count
   */
  #width(frame, quantity, ids, count) {
    const at = frame.place(4);
    check(wasm().mimo_env_width(this.pointer, integer("quantity", quantity), ids, count, at));
    return frame.numberAt("size", at);
  }

  /**
   * Reads a quantity of things, one after the other.
   * @param {number} quantity one of Quantity, which may have NOW
   * @param {ArrayLike<number> | null} [ids] null: all
   * @returns {Float64Array}
   */
  get(quantity, ids = null) {
    return this.#get("f64", wasm().mimo_env_get, quantity, ids);
  }

  /**
   * The same in single precision.
   * @param {number} quantity
   * @param {ArrayLike<number> | null} [ids]
   * @returns {Float32Array}
   */
  getFloat(quantity, ids = null) {
    return this.#get("f32", wasm().mimo_env_get_float, quantity, ids);
  }

  /**
   * @param {"f32" | "f64"} kind
   * @param {Function} call
   * @param {number} quantity
   * @param {ArrayLike<number> | null} ids
   */
  #get(kind, call, quantity, ids) {
    return within((frame) => {
      const [given, count] = [idsOf(frame, ids), ids?.length ?? 0];
      const width = this.#width(frame, quantity, given, count);
      const at = frame.place(8 * Math.max(width, 1));
      check(call(this.pointer, quantity, given, count, at, width));
      return frame.view(kind, at, width).slice();
    });
  }

  /**
   * Writes a quantity of things.
   * @param {number} quantity one of Quantity
   * @param {ArrayLike<number> | null} ids null: all
   * @param {ArrayLike<number>} values
   */
  set(quantity, ids, values) {
    within((frame) => {
      const given = idsOf(frame, ids);
      const at = frame.array("f64", "values", values);
      check(wasm().mimo_env_set(this.pointer, integer("quantity", quantity), given, ids?.length ?? 0, at, values.length));
    });
  }

  /**
   * Numbers from 0 to 1 from the world's random stream.
   * @param {number} count
   * @returns {Float64Array}
   */
  random(count) {
    return within((frame) => {
      const at = frame.place(8 * Math.max(integer("count", count, 0), 1));
      check(wasm().mimo_env_random(this.pointer, at, count));
      return frame.view("f64", at, count).slice();
    });
  }

  /**
   * What the motors of an infant do by themselves at this moment: its actions for the next step.
   * @param {number} count how many actions it has
   * @param {number} [which] kinds of Movement
   * @param {number} [agent]
   * @returns {Float32Array}
   */
  spontaneous(count, which = Movement.ALL, agent = 0) {
    return within((frame) => {
      const at = frame.place(4 * Math.max(integer("count", count, 0), 1));
      check(wasm().mimo_env_spontaneous(this.pointer, integer("agent", agent, 0), integer("which", which, 0), at, count));
      return frame.view("f32", at, count).slice();
    });
  }

  /**
   * The poses of all bodies, geoms, sites or cameras: three numbers of position and four of a quaternion each.
   * @param {number} kind one of Kind
   * @param {number} axes one of Axes
   * @param {Float32Array} [into] keeps them; its length is seven times count(kind)
   * @returns {Float32Array}
   */
  poses(kind, axes, into = new Float32Array(7 * this.count(kind))) {
    return within((frame) => {
      const at = frame.place(Math.max(into.byteLength, 4));
      check(wasm().mimo_env_poses(this.pointer, integer("kind", kind), integer("axes", axes), at, into.length));
      into.set(frame.view("f32", at, into.length));
      return into;
    });
  }

  /**
   * A geom as triangles in its own frame.
   * @param {number} geom
   * @param {{axes?: number, segments?: number, plane?: number}} [options]
   * @returns {Mesh}
   */
  mesh(geom, options = {}) {
    return within((frame) => {
      integer("geom", geom);
      const at = frame.struct("mimo_mesh", options);
      check(wasm().mimo_env_mesh(this.pointer, geom, at));
      const { vertexCount, indexCount } = frame.record("mimo_mesh", at);
      const places = { positions: frame.place(12 * vertexCount), normals: frame.place(12 * vertexCount), texcoords: frame.place(8 * vertexCount), indices: frame.place(4 * indexCount) };
      const full = frame.struct("mimo_mesh", { ...options, ...places, vertexCapacity: vertexCount, indexCapacity: indexCount });
      check(wasm().mimo_env_mesh(this.pointer, geom, full));
      return {
        positions: frame.view("f32", places.positions, 3 * vertexCount).slice(),
        normals: frame.view("f32", places.normals, 3 * vertexCount).slice(),
        texcoords: frame.view("f32", places.texcoords, 2 * vertexCount).slice(),
        indices: frame.view("u32", places.indices, indexCount).slice(),
      };
    });
  }

  /**
   * A texture's pixels, red, green, blue and 255 each.
   * @param {number} texture
   * @returns {{type: number, width: number, height: number, pixels: Uint8ClampedArray}}
   */
  texture(texture) {
    return within((frame) => {
      integer("texture", texture, 0);
      const at = frame.empty("mimo_texture");
      check(wasm().mimo_env_texture(this.pointer, texture, at));
      const { type, width, height } = frame.record("mimo_texture", at);
      const bytes = 4 * width * height;
      const pixels = frame.place(bytes);
      check(wasm().mimo_env_texture(this.pointer, texture, frame.struct("mimo_texture", { pixels, pixelBytes: bytes })));
      return { type, width, height, pixels: new Uint8ClampedArray(frame.view("u8", pixels, bytes).slice().buffer) };
    });
  }

  /**
   * Draws the world as a camera sees it.
   * @param {PictureConfig} [config] by default the free camera
   * @param {{rgba?: boolean, depth?: boolean, segmentation?: boolean}} [parts] by default only colours
   * @returns {Picture}
   */
  render(config = {}, { rgba = true, depth = false, segmentation = false } = {}) {
    return within((frame) => {
      const settings = frame.struct("mimo_picture_config", { ...config, format: (config.format ?? 0) | 1 });
      const { width, height } = frame.record("mimo_picture_config", settings);
      const count = width * height;
      /** @type {Record<string, number>} */
      const places = {};
      if (rgba) Object.assign(places, { rgb: frame.place(4 * count), rgbBytes: 4 * count });
      if (depth) Object.assign(places, { depth: frame.place(4 * count), depthCount: count });
      if (segmentation) Object.assign(places, { segmentation: frame.place(4 * count), segmentationCount: count });
      check(wasm().mimo_env_render(this.pointer, settings, frame.struct("mimo_picture", places)));
      return {
        width,
        height,
        ...(rgba && { rgba: new Uint8ClampedArray(frame.view("u8", places.rgb, 4 * count).slice().buffer) }),
        ...(depth && { depth: frame.view("f32", places.depth, count).slice() }),
        ...(segmentation && { segmentation: frame.view("i32", places.segmentation, count).slice() }),
      };
    });
  }

  /**
   * Where points of the world appear in the picture that `render` draws: right, down, and depth for each.
   * @param {PictureConfig} config
   * @param {ArrayLike<number>} points three numbers each
   * @returns {Float64Array}
   */
  project(config, points) {
    return within((frame) => {
      if (points.length % 3 !== 0) throw new RangeError(`points has ${points.length} numbers, expected three for each point`);
      const settings = frame.struct("mimo_picture_config", config);
      const at = frame.array("f64", "points", points);
      const pixels = frame.place(8 * Math.max(points.length, 1));
      check(wasm().mimo_env_project(this.pointer, settings, at, points.length / 3, pixels));
      return frame.view("f64", pixels, points.length).slice();
    });
  }

  /**
   * The joint angles with which an agent looks at a point, without moving anything.
   * @param {number} agent
   * @param {ArrayLike<number>} point
   * @param {number} how one of Look
   * @returns {{joints: number[], angles: number[], errors: number[]}}
   */
  lookAngles(agent, point, how) {
    return within((frame) => {
      const at = frame.array("f64", "point", point, 3);
      const count = frame.place(4);
      const call = (/** @type {number} */ joints, /** @type {number} */ angles, /** @type {number} */ capacity, /** @type {number} */ errors) =>
        check(wasm().mimo_env_look_angles(this.pointer, integer("agent", agent, 0), at, integer("how", how), joints, angles, capacity, count, errors));
      call(0, 0, 0, 0);
      const capacity = frame.numberAt("size", count);
      const [joints, angles, errors] = [frame.place(4 * capacity), frame.place(8 * capacity), frame.place(16)];
      call(joints, angles, capacity, errors);
      return {
        joints: [...frame.view("i32", joints, capacity)],
        angles: [...frame.view("f64", angles, capacity)],
        errors: [...frame.view("f64", errors, 2)],
      };
    });
  }

  /**
   * Moves one step along a known movement.
   * @param {ArrayLike<number>} positions frameSkip() times the positions of all joints
   * @param {Block | null} block receives the observation
   * @param {number} forces how many forces to return: frameSkip() times the degrees of freedom
   * @returns {Float64Array}
   * @protected
   */
  followInto(positions, block, forces) {
    return within((frame) => {
      const at = frame.place(8 * Math.max(forces, 1));
      const movement = frame.struct("mimo_movement", {
        ...{ positions: frame.array("f64", "positions", positions), positionCount: positions.length },
        ...(forces > 0 && { forces: at, forceCount: forces }),
      });
      check(wasm().mimo_env_follow(this.pointer, movement, block?.pointer ?? 0, block?.bytes ?? 0));
      return frame.view("f64", at, forces).slice();
    });
  }

  /** The world's state as bytes. @returns {Uint8Array} */
  saveState() {
    return within((frame) => {
      const size = frame.place(4);
      check(wasm().mimo_env_state_size(this.pointer, size));
      const bytes = frame.numberAt("size", size);
      const at = frame.place(bytes);
      check(wasm().mimo_env_state_save(this.pointer, at, bytes));
      return frame.view("u8", at, bytes).slice();
    });
  }

  /**
   * Loads a state.
   * @param {Uint8Array} state
   * @returns {import("./generated/types.js").LoadReport} the memories that started fresh
   */
  loadState(state) {
    return within((frame) => {
      const at = frame.array("u8", "state", state);
      const report = frame.empty("mimo_load_report");
      check(wasm().mimo_env_state_load(this.pointer, at, state.length, report));
      return frame.record("mimo_load_report", report);
    });
  }

  /**
   * Gives the agent a face by its name; see faces().
   * @param {string} name
   * @param {number} [agent]
   */
  setFace(name, agent = 0) {
    this.set(Quantity.AGENT_FACE, [integer("agent", agent, 0)], [this.find(Kind.FACE, name)]);
  }
}

/**
 * @param {import("./memory.js").Frame} frame
 * @param {ArrayLike<number> | null} ids
 */
export function idsOf(frame, ids) {
  return ids === null || ids.length === 0 ? 0 : frame.array("i32", "ids", ids);
}

/** @type {Map<number, Named>} worlds that tasks see */
const lent = new Map();
setWorldAt((pointer) => {
  let world = lent.get(pointer);
  if (!world) lent.set(pointer, (world = new Named(pointer, null)));
  return world;
});

/** A world is destroyed: another one may get its address. @param {number} pointer */
export function forget(pointer) {
  lent.delete(pointer);
}
