/** The module of WebAssembly: its memory, and how arguments get there. */
import { MimoError } from "./error.js";
import { ABI_VERSION, Status } from "./generated/constants.js";
import { filesOf, instantiate } from "./loader.js";
import { offsetOf, readStruct, sizeOfStruct, writeStruct } from "./structs.js";

/** @typedef {"u8" | "i32" | "u32" | "u64" | "f32" | "f64" | "size"} NumberKind */

const ARRAYS = {
  u8: Uint8Array,
  i32: Int32Array,
  u32: Uint32Array,
  u64: BigUint64Array,
  f32: Float32Array,
  f64: Float64Array,
  size: Uint32Array,
};
/** @type {Record<string, [number, number]>} */
const RANGES = { u8: [0, 255], i32: [-(2 ** 31), 2 ** 31 - 1], u32: [0, 2 ** 32 - 1], size: [0, 2 ** 32 - 1] };
const SCRATCH = 1 << 16;
const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** @type {any} */
let module = null;
let scratch = { base: 0, top: 0 };
/** @type {Promise<void> | null} */
let loading = null;

/**
 * Loads the module, once: a second call waits for the first. Without SIMD, without the file and with a module of another
 * version it is refused with a sentence.
 * @param {import("./loader.js").Source} [source] by default mimo.wasm of the package
 * @returns {Promise<void>}
 */
export function load(source) {
  loading ??= loadOnce(source).catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}

/** @param {import("./loader.js").Source} [source] */
async function loadOnce(source) {
  const made = await instantiate(source);
  const abi = made.mimo_abi_version();
  if (abi !== ABI_VERSION) {
    throw new MimoError(Status.UNSUPPORTED, `mimo.wasm has ABI version ${abi}, expected ${ABI_VERSION}`);
  }
  use(made);
}

/**
 * Takes a module that is there already.
 * @param {any} made
 */
export function use(made) {
  module = made;
  const base = made.malloc(SCRATCH);
  scratch = { base, top: base };
}

/** The module; refuses where load() has not ended. */
export function wasm() {
  if (module === null) throw new MimoError(Status.UNSUPPORTED, "the module is not loaded; call `await load()` first");
  return module;
}

/** The files that the module sees. */
export const files = () => filesOf(wasm());

/** The memory as it is now: it is another one after it has grown. */
export function buffer() {
  return /** @type {ArrayBuffer} */ (wasm().memory.buffer);
}

/** @type {DataView | null} */
let seen = null;

export function data() {
  const now = buffer();
  if (seen?.buffer !== now) seen = new DataView(now);
  return seen;
}

/**
 * Numbers in the module's memory, without a copy. They are valid until the memory grows.
 * @param {NumberKind} kind
 * @param {number} pointer
 * @param {number} length
 * @returns {any}
 */
export function view(kind, pointer, length) {
  return new ARRAYS[kind](buffer(), pointer, length);
}

/** The class of arrays of a kind. @param {NumberKind} kind @returns {any} */
export const numbers = (kind) => ARRAYS[kind];

/** @param {NumberKind} kind */
export function bytesOf(kind) {
  return ARRAYS[kind].BYTES_PER_ELEMENT;
}

/** @param {number} pointer */
export function textAt(pointer) {
  if (pointer === 0) return "";
  const bytes = new Uint8Array(buffer());
  return decoder.decode(bytes.slice(pointer, bytes.indexOf(0, pointer)));
}

/** Memory that stays until it is freed. */
export class Block {
  /** @param {number} bytes */
  constructor(bytes) {
    this.bytes = bytes;
    // Fields lie at multiples of 64 bytes.
    this.whole = wasm().malloc(bytes + 64);
    if (this.whole === 0) throw new MimoError(Status.OUT_OF_MEMORY, `no memory for ${bytes} bytes`);
    this.pointer = Math.ceil(this.whole / 64) * 64;
    new Uint8Array(buffer(), this.pointer, bytes).fill(0);
  }

  free() {
    if (this.whole !== 0) wasm().free(this.whole);
    this.whole = 0;
  }
}

/**
 * Throws the error of a call.
 * @param {number} status
 */
export function check(status) {
  if (status === Status.OK) return;
  const cause = thrown;
  thrown = undefined;
  throw new MimoError(status, textAt(wasm().mimo_last_error()), cause === undefined ? undefined : { cause });
}

/** @type {unknown} */
let thrown;

/**
 * Calls a function that belongs to the program from within the library: what it throws becomes the cause of the error.
 * @param {() => void} call
 */
export function guarded(call) {
  try {
    call();
    return Status.OK;
  } catch (error) {
    thrown = error;
    const status = error instanceof MimoError ? error.status : Status.TASK;
    return within((frame) => wasm().mimo_fail(status, frame.text("message", String(error instanceof Error ? error.message : error))));
  }
}

/**
 * @param {string} name
 * @param {unknown} value
 * @param {number} low
 * @param {number} high
 */
export function integer(name, value, low = -(2 ** 31), high = 2 ** 32 - 1) {
  if (typeof value !== "number" || !Number.isInteger(value) || value < low || value > high) {
    throw new TypeError(`${name} is ${shown(value)}, expected a whole number from ${low} to ${high}`);
  }
  return value;
}

/**
 * @param {string} name
 * @param {unknown} value
 */
export function number(name, value) {
  if (typeof value !== "number") throw new TypeError(`${name} is ${shown(value)}, expected a number`);
  return value;
}

/** @param {unknown} value */
export function shown(value) {
  return typeof value === "bigint" ? `${value}n` : typeof value === "function" ? "a function" : (JSON.stringify(value) ?? String(value));
}

/** Memory for the length of a call: what a call takes and gives. */
export class Frame {
  /** @type {number[]} */
  more = [];

  /** @param {number} bytes */
  place(bytes) {
    const at = Math.ceil(scratch.top / 8) * 8;
    if (at + bytes > scratch.base + SCRATCH) {
      const block = wasm().malloc(bytes);
      if (block === 0) throw new MimoError(Status.OUT_OF_MEMORY, `no memory for ${bytes} bytes`);
      this.more.push(block);
      return block;
    }
    scratch.top = at + bytes;
    return at;
  }

  free() {
    for (const block of this.more) wasm().free(block);
  }

  /**
   * @param {string} name
   * @param {unknown} value
   */
  text(name, value) {
    if (typeof value !== "string") throw new TypeError(`${name} is ${shown(value)}, expected a string`);
    if (value.includes("\0")) throw new TypeError(`${name} has a character 0, which no name has`);
    const bytes = encoder.encode(value);
    const at = this.place(bytes.length + 1);
    const memory = new Uint8Array(buffer(), at, bytes.length + 1);
    memory.set(bytes);
    memory[bytes.length] = 0;
    return at;
  }

  /**
   * @param {string} name
   * @param {unknown} value
   */
  textOrNull(name, value) {
    return value === undefined || value === null ? 0 : this.text(name, value);
  }

  /**
   * @param {string} name
   * @param {readonly string[]} values
   */
  texts(name, values) {
    const pointers = values.map((value, index) => this.text(`${name}[${index}]`, value));
    return this.array("size", name, pointers);
  }

  /**
   * Numbers in memory.
   * @param {NumberKind} kind
   * @param {string} name
   * @param {ArrayLike<number | bigint | boolean>} values
   * @param {number} [length] that they must have
   */
  array(kind, name, values, length) {
    if (values === null || typeof values !== "object" || typeof values.length !== "number") {
      throw new TypeError(`${name} is ${shown(values)}, expected an array of numbers`);
    }
    if (length !== undefined && values.length !== length) {
      throw new RangeError(`${name} has ${values.length} numbers, expected ${length}`);
    }
    const at = this.place(Math.max(values.length, 1) * bytesOf(kind));
    fill(view(kind, at, values.length), kind, name, values);
    return at;
  }

  /**
   * Fills a struct with the library's defaults and with options.
   * @param {string} struct
   * @param {object} [options]
   * @param {number} [at] where it has defaults already
   */
  struct(struct, options, at = this.empty(struct)) {
    writeStruct(this, struct, at, options ?? {});
    return at;
  }

  /**
   * A struct with the library's defaults.
   * @param {string} struct
   */
  empty(struct) {
    const { size, init } = sizeOfStruct(struct);
    const at = this.place(size);
    if (init) {
      check(wasm()[init](at, size));
    } else {
      new Uint8Array(buffer(), at, size).fill(0);
      data().setUint32(at, size, true);
    }
    return at;
  }

  /**
   * Writes an address into a member.
   * @param {string} struct
   * @param {number} at
   * @param {string} member
   * @param {number} pointer
   */
  point(struct, at, member, pointer) {
    data().setUint32(at + offsetOf(struct, member), pointer, true);
  }

  /**
   * The address in a member.
   * @param {string} struct
   * @param {number} at
   * @param {string} member
   */
  pointerIn(struct, at, member) {
    return data().getUint32(at + offsetOf(struct, member), true);
  }

  /** @param {string} struct */
  size(struct) {
    return sizeOfStruct(struct).size;
  }

  /**
   * @param {string} struct
   * @param {number} at
   * @returns {any}
   */
  record(struct, at) {
    return readStruct(struct, at);
  }

  /**
   * @param {NumberKind} kind
   * @param {number} at
   */
  numberAt(kind, at) {
    return Number(view(kind, at, 1)[0]);
  }

  /**
   * @param {NumberKind} kind
   * @param {number} at
   * @param {number} length
   */
  view(kind, at, length) {
    return view(kind, at, length);
  }

  /**
   * The text whose address lies there.
   * @param {number} at
   */
  textAt(at) {
    return textAt(data().getUint32(at, true));
  }
}

/**
 * Writes numbers, each of which has to be one.
 * @param {any} to
 * @param {NumberKind} kind
 * @param {string} name
 * @param {ArrayLike<number | bigint | boolean>} values
 */
export function fill(to, kind, name, values) {
  const real = kind === "f32" || kind === "f64";
  if (ArrayBuffer.isView(values) && (real ? !(values instanceof BigUint64Array) : values.constructor === ARRAYS[kind])) {
    to.set(values);
    return;
  }
  const [low, high] = RANGES[kind] ?? [];
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (kind === "u64") {
      to[i] = whole64(`${name}[${i}]`, value);
    } else if (real) {
      to[i] = number(`${name}[${i}]`, value);
    } else {
      to[i] = integer(`${name}[${i}]`, typeof value === "boolean" ? Number(value) : value, low, high);
    }
  }
}

/**
 * @param {string} name
 * @param {unknown} value
 */
export function whole64(name, value) {
  const fits = typeof value === "bigint" ? value >= 0n && value < 1n << 64n : Number.isSafeInteger(value) && Number(value) >= 0;
  if (!fits) throw new TypeError(`${name} is ${shown(value)}, expected a whole number from 0 to 2^64 - 1, as BigInt from 2^53 on`);
  return BigInt(/** @type {number | bigint} */ (value));
}

/**
 * Runs a function with memory of its own.
 * @template T
 * @param {(frame: Frame) => T} use
 * @returns {T}
 */
export function within(use) {
  wasm();
  const { top } = scratch;
  const frame = new Frame();
  try {
    return use(frame);
  } finally {
    frame.free();
    scratch.top = top;
  }
}
