/** Observations and results in the module's memory, as typed arrays that are made anew when the memory has grown. */
import { Block, buffer, data, Frame, view } from "./memory.js";
import { offsetOf, sizeOfStruct } from "./structs.js";

/** @typedef {import("./memory.js").NumberKind} NumberKind */

/** What a struct of results points to: the kind of the numbers, the member with the length, and how many. */
export class Results {
  /** @type {Record<string, any>} */
  #views = {};
  /** @type {ArrayBuffer | null} */
  #seen = null;

  /**
   * @param {string} struct
   * @param {Record<string, [NumberKind, number]>} arrays kind and length of each
   * @param {Record<string, number>} lengths members that have a length
   */
  constructor(struct, arrays, lengths) {
    const size = sizeOfStruct(struct).size;
    const total = Object.values(arrays).reduce((sum, [, length]) => sum + 8 * length, 0);
    this.block = new Block(size + 64 + total);
    this.pointer = this.block.pointer;
    this.arrays = /** @type {Record<string, [NumberKind, number, number]>} */ ({});
    data().setUint32(this.pointer, size, true);
    let at = Math.ceil((this.pointer + size) / 8) * 8;
    for (const [name, [kind, length]] of Object.entries(arrays)) {
      this.arrays[name] = [kind, length, at];
      if (length > 0) data().setUint32(this.pointer + offsetOf(struct, name), at, true);
      at += 8 * length;
    }
    this.struct = struct;
    this.point(lengths);
  }

  /** Writes lengths and addresses. @param {Record<string, number>} members */
  point(members) {
    for (const [name, value] of Object.entries(members)) {
      data().setUint32(this.pointer + offsetOf(this.struct, name), value, true);
    }
  }

  /** @param {string} name */
  get(name) {
    if (this.#seen !== buffer()) {
      this.#seen = buffer();
      for (const [one, [kind, length, at]] of Object.entries(this.arrays)) this.#views[one] = view(kind, at, length);
    }
    return this.#views[name];
  }

  free() {
    this.block.free();
  }
}

/** Actions in the module's memory. */
export class Actions {
  /** @type {Float32Array | null} */
  #view = null;

  /** @param {number} count */
  constructor(count) {
    this.count = count;
    this.block = new Block(Math.max(4 * count, 4));
  }

  /** @param {ArrayLike<number>} actions */
  write(actions) {
    if (actions?.length !== this.count) {
      throw new RangeError(`the action has ${actions?.length} numbers, expected ${this.count}`);
    }
    if (this.#view?.buffer !== buffer()) this.#view = view("f32", this.block.pointer, this.count);
    for (let i = 0; i < this.count; i++) {
      if (typeof actions[i] !== "number") throw new TypeError(`action ${i} is ${actions[i]}, expected a number`);
    }
    /** @type {Float32Array} */ (this.#view).set(actions);
    return this.block.pointer;
  }

  free() {
    this.block.free();
  }
}

/**
 * Pointers to growths, null for those that stay.
 * @param {Frame} frame
 * @param {(import("./generated/types.js").Growth | number | null)[]} ages months, or options of growth
 */
export function growths(frame, ages) {
  return frame.array("size", "ages", ages.map((age) => (age === null ? 0 : frame.struct("mimo_growth", typeof age === "number" ? { age } : age))));
}
