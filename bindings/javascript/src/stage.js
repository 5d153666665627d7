import { Handle } from "./handle.js";
import { withLog } from "./log.js";
import { check, integer, wasm, within } from "./memory.js";
import { offsetOf } from "./structs.js";

/**
 * @typedef {import("./generated/types.js").StageConfig & {log?: import("./log.js").Log}} StageParts
 * @typedef {import("./generated/types.js").StagePoses} StagePoses
 *
 * Where a picture is taken from, and what it shows. `position` has 3 numbers; `rotation` has 9, from the camera's frame (x
 * right, y up, z backward) to the world's.
 * @typedef {Omit<import("./generated/types.js").StageView, "rgbBytes" | "rgbStride" | "depthCount" | "depthStride" |
 *   "segmentationCount" | "segmentationStride"> & {
 *   position: ArrayLike<number>, rotation: ArrayLike<number>, rgba?: boolean, depth?: boolean, segmentation?: boolean
 * }} StageView
 *
 * @typedef {object} StagePicture
 * @property {number} width
 * @property {number} height
 * @property {Uint8ClampedArray} [rgba] as of ImageData, the top row first
 * @property {Float32Array} [depth] metres along the camera's axis
 * @property {Int32Array} [segmentation] two for each pixel: id and type of the object, -1 -1 where nothing is
 */

/**
 * Shapes, lights and textures from plain arrays, moved by poses and drawn with rays, without a simulation. Parts are objects
 * of arrays: `geoms: { forms, sizes, colors }`, `sites`, `meshes`, `fields`, `textures`, `materials`, `surfaces`, `tendons`,
 * `lights` and `air`. An array has the numbers of its elements one after the other.
 */
export class Stage extends Handle {
  /** @param {StageParts} [parts] */
  constructor({ log, ...parts } = {}) {
    const [pointer, forget] = within((frame) => {
      const config = frame.struct("mimo_stage_config", parts);
      const at = frame.place(4);
      return withLog(log, config + offsetOf("mimo_stage_config", "log"), () => {
        check(wasm().mimo_stage_create(config, at));
        return frame.numberAt("size", at);
      });
    });
    super(pointer, () => {
      wasm().mimo_stage_destroy(pointer);
      forget();
    });
  }

  /**
   * Replaces the parts that are given, all at once; the others stay.
   * @param {Omit<StageParts, "log" | "threads">} parts
   */
  update(parts) {
    within((frame) => check(wasm().mimo_stage_update(this.pointer, frame.struct("mimo_stage_config", parts))));
  }

  /**
   * Draws one picture of one pose.
   * @overload
   * @param {StagePoses | StagePoses[]} poses
   * @param {StageView} views
   * @returns {StagePicture}
   */
  /**
   * Draws many pictures, each of the pose whose number is the view's `pose`.
   * @overload
   * @param {StagePoses | StagePoses[]} poses
   * @param {StageView[]} views
   * @returns {StagePicture[]}
   */
  /**
   * @param {StagePoses | StagePoses[]} poses
   * @param {StageView | StageView[]} views
   */
  draw(poses, views) {
    const several = Array.isArray(poses) ? poses : [poses];
    const shown = Array.isArray(views) ? views : [views];
    return within((frame) => {
      const canvases = shown.map((view) => new Canvas(frame, view));
      const placed = several.map((one) => frame.struct("mimo_stage_poses", one));
      const [from, into] = [frame.array("size", "poses", placed), frame.array("size", "views", canvases.map(({ at }) => at))];
      check(wasm().mimo_stage_draw(this.pointer, from, placed.length, into, canvases.length));
      const pictures = canvases.map((canvas) => canvas.picture());
      return Array.isArray(views) ? pictures : pictures[0];
    });
  }
}

/** A view in the module's memory, and the picture that goes there. */
class Canvas {
  #frame;
  /** @type {Record<string, number>} */
  #places = {};

  /**
   * @param {import("./memory.js").Frame} frame
   * @param {StageView} view
   */
  constructor(frame, { position, rotation, rgba = true, depth = false, segmentation = false, ...options }) {
    this.#frame = frame;
    this.at = frame.struct("mimo_stage_view", options);
    const size = frame.record("mimo_stage_view", this.at);
    this.width = integer("width", size.width, 1, 16384);
    this.height = integer("height", size.height, 1, 16384);
    const camera = [
      ["position", frame.array("f64", "position", position, 3)],
      ["rotation", frame.array("f64", "rotation", rotation, 9)],
    ];
    for (const [member, pointer] of /** @type {[string, number][]} */ (camera)) frame.point("mimo_stage_view", this.at, member, pointer);
    if (rgba) this.#buffer("rgb", "rgbBytes", 3, 1);
    if (depth) this.#buffer("depth", "depthCount", 1, 4);
    if (segmentation) this.#buffer("segmentation", "segmentationCount", 2, 4);
  }

  /**
   * @param {string} name
   * @param {string} length
   * @param {number} width numbers of a pixel
   * @param {number} bytes of a number
   */
  #buffer(name, length, width, bytes) {
    const count = width * this.width * this.height;
    this.#places[name] = this.#frame.place(count * bytes);
    this.#frame.struct("mimo_stage_view", { [name]: this.#places[name], [length]: count }, this.at);
  }

  /** @returns {StagePicture} */
  picture() {
    const { rgb, depth, segmentation } = this.#places;
    const pixels = this.width * this.height;
    return {
      width: this.width,
      height: this.height,
      ...(rgb !== undefined && { rgba: opaque(this.#frame.view("u8", rgb, 3 * pixels)) }),
      ...(depth !== undefined && { depth: this.#frame.view("f32", depth, pixels).slice() }),
      ...(segmentation !== undefined && { segmentation: this.#frame.view("i32", segmentation, 2 * pixels).slice() }),
    };
  }
}

/**
 * Colours with the opacity that ImageData has.
 * @param {Uint8Array} rgb
 */
function opaque(rgb) {
  const rgba = new Uint8ClampedArray((rgb.length / 3) * 4).fill(255);
  for (let from = 0, to = 0; from < rgb.length; from += 3, to += 4) rgba.set(rgb.subarray(from, from + 3), to);
  return rgba;
}
