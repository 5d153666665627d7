import { Handle } from "./handle.js";
import { FieldType } from "./generated/constants.js";
import { buffer, check, integer, textAt, view, wasm, within } from "./memory.js";

const KINDS = /** @type {Record<number, [any, import("./memory.js").NumberKind]>} */ ({
  [FieldType.U8]: [Uint8Array, "u8"],
  [FieldType.I32]: [Int32Array, "i32"],
  [FieldType.F32]: [Float32Array, "f32"],
  [FieldType.F64]: [Float64Array, "f64"],
});

/**
 * One field of the observation: its name, type, shape, unit, bounds and time.
 * @typedef {import("./generated/types.js").Field & {shape: number[]}} Field
 * @typedef {Float32Array | Float64Array | Int32Array | Uint8Array} Values
 */

/** The observations, actions and reward terms of a world, or of each world of a batch. */
export class Layout extends Handle {
  /** @param {number} pointer */
  constructor(pointer) {
    super(pointer, null);
    const info = this.#record("mimo_layout_info", wasm().mimo_layout_describe);
    /** Bytes of an observation. */
    this.blockBytes = info.blockBytes;
    /** Number of agents. */
    this.agents = info.agents;
    /** Seconds of a step. */
    this.stepSeconds = info.stepSeconds;
    /** @type {import("./generated/types.js").Action[]} */
    this.actions = this.#records("mimo_action", info.actions, wasm().mimo_layout_action);
    /** The terms of rewards. @type {import("./generated/types.js").Term[]} */
    this.terms = this.#records("mimo_term", info.terms, wasm().mimo_layout_term);
    /** @type {Field[]} */
    this.fields = [];
    this.count = info.fields;
    this.renew();
  }

  /** Reads what another age changes: bounds, receptors and times. @internal */
  renew() {
    this.fields = Array.from({ length: this.count }, (_, index) => this.#field(index));
    this.actions = this.#records("mimo_action", this.actions.length, wasm().mimo_layout_action);
  }

  /** @param {number} index @returns {Field} */
  #field(index) {
    return within((frame) => {
      const at = frame.empty("mimo_field");
      check(wasm().mimo_layout_field(this.pointer, index, at));
      const { ndim, ...told } = frame.record("mimo_field", at);
      return { ...told, shape: [...view("size", frame.pointerIn("mimo_field", at, "shape"), ndim)] };
    });
  }

  /**
   * @param {string} struct
   * @param {Function} call
   * @param {number[]} given
   */
  #record(struct, call, ...given) {
    return within((frame) => {
      const at = frame.empty(struct);
      check(call(this.pointer, ...given, at));
      return frame.record(struct, at);
    });
  }

  /**
   * @param {string} struct
   * @param {number} count
   * @param {Function} call
   */
  #records(struct, count, call) {
    return Array.from({ length: count }, (_, index) => this.#record(struct, call, index));
  }

  /**
   * The index of a field by its name; an unknown one is refused, with a list of all.
   * @param {string} name
   * @returns {number}
   */
  find(name) {
    return within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_layout_find(this.pointer, frame.text("name", name), at));
      return frame.numberAt("size", at);
    });
  }

  /**
   * The name of an element: a joint, a body of the skin, ...
   * @param {string} field
   * @param {number} element
   * @returns {string}
   */
  label(field, element) {
    return within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_layout_label(this.pointer, this.find(field), integer("element", element, 0), at));
      return frame.textAt(at);
    });
  }

  /**
   * Delays of a field's elements, in seconds.
   * @param {string} field
   * @returns {Float64Array}
   */
  delays(field) {
    const index = this.find(field);
    const length = this.fields[index].shape.reduce((product, size) => product * size, 1);
    return this.#filled("f64", length, (at) => wasm().mimo_layout_delays(this.pointer, index, at, length));
  }

  /**
   * Unit vectors from an eye to the middle of each pixel of a picture, in the camera's frame.
   * @param {string} field
   * @returns {Float32Array}
   */
  directions(field) {
    const index = this.find(field);
    const { shape } = this.fields[index];
    const length = shape[0] * (shape[1] ?? 1) * 3;
    return this.#filled("f32", length, (at) => wasm().mimo_layout_directions(this.pointer, index, at, length));
  }

  /**
   * What is known of all receptors of a field of the skin, one after the other.
   * @param {string} field
   * @param {number} quantity one of Receptor
   * @returns {Float64Array}
   */
  receptors(field, quantity) {
    const index = this.find(field);
    integer("quantity", quantity);
    const length = within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_layout_receptor_width(this.pointer, index, quantity, at));
      return frame.numberAt("size", at);
    });
    return this.#filled("f64", length, (at) => wasm().mimo_layout_receptors(this.pointer, index, quantity, at, length));
  }

  /**
   * @param {"f32" | "f64"} kind
   * @param {number} length
   * @param {(at: number) => number} call
   */
  #filled(kind, length, call) {
    return within((frame) => {
      const at = frame.place(Math.max(length, 1) * 8);
      check(call(at));
      return view(kind, at, length).slice();
    });
  }

  /**
   * The fields of an observation in the module's memory, without copies, by their names.
   * @param {number} block where it lies
   * @returns {Readonly<Record<string, Values>>}
   */
  views(block) {
    /** @type {Record<string, Values>} */
    const found = {};
    for (const { name, dtype, offset, bytes } of this.fields) {
      const Kind = KINDS[/** @type {number} */ (dtype)][0];
      found[/** @type {string} */ (name)] = new Kind(buffer(), block + Number(offset), Number(bytes) / Kind.BYTES_PER_ELEMENT);
    }
    return Object.freeze(found);
  }
}

/**
 * The layout of a world or a batch.
 * @param {(at: number) => number} ask
 */
export function layoutOf(ask) {
  return within((frame) => {
    const at = frame.place(4);
    check(ask(at));
    return new Layout(frame.numberAt("size", at));
  });
}

/**
 * Names that the library lists: it gives null behind the last one.
 * @param {(index: number) => number} name
 * @returns {string[]}
 */
export function listed(name) {
  const found = [];
  for (let pointer = name(0); pointer !== 0; pointer = name(found.length)) found.push(textAt(pointer));
  return found;
}
