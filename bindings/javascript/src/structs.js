/** Structs of C in the module's memory, written from options and read as objects, by generated/structs.js. */
import { structs } from "./generated/structs.js";
import { data, fill, integer, number, shown, textAt, view, whole64 } from "./memory.js";

/** Members that programs do not see: addresses, and lengths that follow from arrays. */
const HIDDEN = ["pointer", "length"];

/**
 * @typedef {object} Layout
 * @property {number} size bytes
 * @property {string} init the function that fills it with defaults; "" if it has none
 * @property {Record<string, any[]>} members
 * @property {Record<string, string>} [implied] switches that are on where a member is given
 */

/** @param {string} struct */
export function sizeOfStruct(struct) {
  return structs[struct];
}

/**
 * Writes options into a struct; what is undefined stays as it is. A name that the struct lacks is an error.
 * @param {import("./memory.js").Frame} frame
 * @param {string} struct
 * @param {number} at
 * @param {object} options
 */
export function writeStruct(frame, struct, at, options) {
  const { members, implied = {} } = structs[struct];
  if (typeof options !== "object" || Array.isArray(options)) {
    throw new TypeError(`options are ${shown(options)}, expected an object`);
  }
  /** @type {Lengths} */
  const lengths = {};
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined) continue;
    if (!Object.hasOwn(members, name) || members[name][0] === "length" || Object.values(implied).includes(name)) {
      const known = Object.keys(members).filter((one) => !Object.values(implied).includes(one) && !HIDDEN.includes(members[one][0]));
      throw new TypeError(`there is no option ${name}; there are ${known.join(", ")}`);
    }
    if (members[name].length === 4) writeArray(frame, at, name, members, value, lengths);
    else writeMember(frame, at, name, members[name], value);
    if (implied[name]) writeMember(frame, at, implied[name], members[implied[name]], true);
  }
}

/**
 * Writes numbers of an array, its address and its length, which several arrays share.
 * @typedef {Record<string, [string, number]>} Lengths the first array of each length, and how many elements it has
 * @param {import("./memory.js").Frame} frame
 * @param {number} at
 * @param {string} name
 * @param {Record<string, any[]>} members
 * @param {any} value null: none
 * @param {Lengths} lengths
 */
function writeArray(frame, at, name, members, value, lengths) {
  if (value === null) return;
  const [kind, offset, width, length] = members[name];
  const pointer = frame.array(kind, name, value);
  if (value.length % width !== 0) throw new RangeError(`${name} has ${value.length} numbers, expected a multiple of ${width}`);
  const count = value.length / width;
  const [first, expected] = (lengths[length] ??= [name, count]);
  if (count !== expected) throw new RangeError(`${name} has ${count} elements, expected ${expected}, as ${first}`);
  data().setUint32(at + offset, pointer, true);
  data().setUint32(at + members[length][1], count, true);
}

/**
 * @param {import("./memory.js").Frame} frame
 * @param {number} at
 * @param {string} name
 * @param {any[]} member
 * @param {any} value
 */
function writeMember(frame, at, name, [kind, offset, length], value) {
  const place = at + offset;
  if (length) {
    fill(view(kind, place, length), kind, name, checkedLength(name, value, length));
  } else if (kind === "text") {
    data().setUint32(place, frame.textOrNull(name, value), true);
  } else if (kind === "switch") {
    if (typeof value !== "boolean") throw new TypeError(`${name} is ${shown(value)}, expected true or false`);
    data().setUint32(place, Number(value), true);
  } else if (kind === "u64") {
    data().setBigUint64(place, whole64(name, value), true);
  } else if (kind === "f32") {
    data().setFloat32(place, number(name, value), true);
  } else if (kind === "f64") {
    data().setFloat64(place, number(name, value), true);
  } else if (kind === "i32") {
    data().setInt32(place, integer(name, value, -(2 ** 31), 2 ** 31 - 1), true);
  } else if (kind === "flags") {
    data().setUint32(place, integer(name, value) >>> 0, true);
  } else if (kind in structs) {
    data().setUint32(place, value === null ? 0 : frame.struct(kind, value), true);
  } else {
    data().setUint32(place, integer(name, value, 0), true);
  }
}

/**
 * @param {string} name
 * @param {any} value
 * @param {number} length
 */
function checkedLength(name, value, length) {
  if (value === null || typeof value !== "object" || value.length !== length) {
    throw new TypeError(`${name} is ${shown(value)}, expected ${length} numbers`);
  }
  return value;
}

/**
 * Reads a struct as an object: text as strings, arrays as arrays. Other pointers are left out.
 * @param {string} struct
 * @param {number} at
 */
export function readStruct(struct, at) {
  /** @type {Record<string, unknown>} */
  const record = {};
  for (const [name, member] of Object.entries(structs[struct].members)) {
    const value = readMember(at, member);
    if (value !== undefined) record[name] = value;
  }
  return record;
}

/**
 * @param {number} at
 * @param {any[]} member
 */
function readMember(at, [kind, offset, length, shared]) {
  const place = at + offset;
  if (HIDDEN.includes(kind) || shared) return undefined;
  if (kind === "text") return textAt(data().getUint32(place, true));
  if (kind === "switch") return data().getUint32(place, true) !== 0;
  if (kind === "flags") return data().getUint32(place, true);
  if (kind in structs) {
    const pointer = data().getUint32(place, true);
    return pointer === 0 ? undefined : readStruct(kind, pointer);
  }
  const values = view(kind, place, length ?? 1);
  return length ? [...values] : Number(values[0]);
}

/**
 * Where a member lies in its struct.
 * @param {string} struct
 * @param {string} member
 * @returns {number}
 */
export function offsetOf(struct, member) {
  return structs[struct].members[member][1];
}
