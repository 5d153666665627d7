/**
 * Instantiates mimo.wasm: the few functions of an operating system that it asks for, and nothing else. It sees no files
 * but those in memory, and no network.
 */
import { MimoError } from "./error.js";
import { Files } from "./files.js";
import { Status } from "./generated/constants.js";

// As Emscripten's C library and WASI number "there is no such function".
const NO_SUCH_CALL = -52;
const NO_SUCH_FILE_CALL = 52;

/** A function that adds two vectors of 16 bytes: what an engine without SIMD does not know. */
const SIMD = Uint8Array.of(
  ...[0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11],
);

/**
 * Where mimo.wasm is: its address, its bytes, an answer that has them, or itself compiled.
 * @typedef {string | URL | ArrayBuffer | Uint8Array | Response | WebAssembly.Module} Source
 */

/**
 * @param {Source} [source] by default the file of the package
 * @returns {Promise<any>} what the module exports
 */
export async function instantiate(source = new URL("../mimo.wasm", import.meta.url)) {
  if (typeof WebAssembly !== "object" || !WebAssembly.validate(SIMD)) {
    throw new MimoError(Status.UNSUPPORTED, "this browser has no WebAssembly with SIMD; browsers of 2023 and later have it");
  }
  const module = source instanceof WebAssembly.Module ? source : await compile(/** @type {any} */ (source));
  const system = new System();
  const imports = new Proxy(system.calls, { get: (calls, name) => calls[/** @type {string} */ (name)] ?? lacking(String(name)) });
  let instance;
  try {
    instance = await WebAssembly.instantiate(module, { env: imports, wasi_snapshot_preview1: imports });
  } catch (error) {
    throw refused(error);
  }
  const exports = /** @type {any} */ (instance.exports);
  system.memory = exports.memory;
  systems.set(exports, system);
  if (typeof exports.mimo_abi_version !== "function") throw new MimoError(Status.FILE, "the module is not mimo.wasm");
  exports._initialize();
  return exports;
}

/** @param {string | URL | ArrayBuffer | Uint8Array | Response} source */
async function compile(source) {
  const given = typeof source === "string" || source instanceof URL ? await fetched(source) : source;
  try {
    if (!(given instanceof Response)) return await WebAssembly.compile(/** @type {BufferSource} */ (given));
    // An engine compiles it as it comes, but takes it only by this type, which not all servers know.
    const isNamed = given.headers.get("content-type") === "application/wasm";
    return await (isNamed ? WebAssembly.compileStreaming(given) : WebAssembly.compile(await given.arrayBuffer()));
  } catch (error) {
    throw refused(error);
  }
}

/** @param {unknown} error */
function refused(error) {
  const { message } = /** @type {Error} */ (error);
  return new MimoError(Status.FILE, `mimo.wasm cannot be used here: ${message}`, { cause: error });
}

/** @param {string | URL} address */
async function fetched(address) {
  const base = globalThis.document?.baseURI ?? globalThis.location?.href ?? import.meta.url;
  const url = new URL(address, base);
  try {
    if (url.protocol === "file:" && /** @type {any} */ (globalThis).process?.versions?.node) {
      // @ts-ignore: types of Node are not installed
      return await (await import("node:fs/promises")).readFile(url);
    }
    const answer = await fetch(url);
    if (answer.ok) return answer;
    throw new Error(`the server answers ${answer.status}`);
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    throw new MimoError(Status.NOT_FOUND, `mimo.wasm cannot be read from ${url}: ${message}`, { cause: error });
  }
}

/** @param {string} name */
function lacking(name) {
  return () => (name.startsWith("fd_") ? NO_SUCH_FILE_CALL : NO_SUCH_CALL);
}

/** @type {WeakMap<object, System>} */
const systems = new WeakMap();

/** The files that an instance of the module sees. @param {object} exports */
export const filesOf = (exports) => /** @type {System} */ (systems.get(exports)).files;

/** What the module asks of an operating system. */
class System {
  /** @type {WebAssembly.Memory | null} */
  memory = null;
  #high = 0;

  get #buffer() {
    return /** @type {WebAssembly.Memory} */ (this.memory).buffer;
  }

  files = new Files(() => this.#buffer);

  /** @type {Record<string, Function>} */
  calls = {
    ...this.files.calls,
    getTempRet0: () => this.#high,
    setTempRet0: (/** @type {number} */ value) => {
      this.#high = value;
    },
    emscripten_notify_memory_growth: () => {},
    __call_sighandler: () => {},
    getentropy: (/** @type {number} */ at, /** @type {number} */ count) => {
      crypto.getRandomValues(new Uint8Array(this.#buffer, at, count));
      return 0;
    },
    clock_time_get: (/** @type {number} */ clock, /** @type {bigint} */ _, /** @type {number} */ at) => {
      const now = clock === 0 ? Date.now() : performance.now();
      new DataView(this.#buffer).setBigUint64(at, BigInt(Math.round(now * 1e6)), true);
      return 0;
    },
    environ_sizes_get: (/** @type {number} */ count, /** @type {number} */ bytes) => {
      new DataView(this.#buffer).setUint32(count, 0, true);
      new DataView(this.#buffer).setUint32(bytes, 0, true);
      return 0;
    },
    environ_get: () => 0,
    proc_exit: (/** @type {number} */ status) => {
      throw new MimoError(Status.INTERNAL, `the module ended with status ${status}`);
    },
  };
}

/**
 * Gives the module a function of JavaScript, as a number that C calls: a module of its own makes it one with this type.
 * @param {any} exports
 * @param {Function} call
 * @param {number} parameters how many numbers of 32 bits it takes
 * @param {boolean} returns whether it returns one
 * @returns {number}
 */
export function addFunction(exports, call, parameters, returns) {
  const type = [0x60, parameters, ...Array(parameters).fill(0x7f), ...(returns ? [1, 0x7f] : [0])];
  const bytes = Uint8Array.of(
    ...[0, 97, 115, 109, 1, 0, 0, 0], // a module of version 1
    ...[1, type.length + 1, 1, ...type], // one type
    ...[2, 7, 1, 1, 101, 1, 102, 0, 0], // imports "e" "f", a function of that type
    ...[7, 5, 1, 1, 102, 0, 0], // exports it as "f"
  );
  const made = new WebAssembly.Instance(new WebAssembly.Module(bytes), { e: { f: call } });
  const table = exports.__indirect_function_table;
  const index = table.grow(1);
  table.set(index, made.exports.f);
  return index;
}
