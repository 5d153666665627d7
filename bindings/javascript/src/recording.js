import { MimoError } from "./error.js";
import { Status } from "./generated/constants.js";
import { Handle } from "./handle.js";
import { Block, buffer, check, files, integer, numbers, shown, wasm, within } from "./memory.js";
import { World } from "./world.js";

/**
 * @typedef {import("./generated/types.js").RecorderConfig} RecorderOptions
 * @typedef {import("./generated/types.js").RecordingInfo} RecordingInfo
 * @typedef {import("./generated/types.js").ReplayReport} ReplayReport
 */

/** A name that no other file has. @param {string} name */
function freshName(name) {
  let fresh = name;
  for (let i = 2; files().has(fresh); i++) fresh = `${name} (${i})`;
  return fresh;
}

/** What is done with a world, as the bytes of a file that all other languages read. */
export class Recorder extends Handle {
  #file;

  /**
   * Records every step of a world from now on.
   * @param {World} world
   * @param {RecorderOptions} [options]
   */
  constructor(world, options = {}) {
    const file = freshName("/recording.h5"); // as the library completes a name
    const pointer = within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_recorder_open(world.pointer, frame.text("file", file), frame.struct("mimo_recorder_config", options), at));
      return frame.numberAt("size", at);
    });
    super(pointer, () => {
      wasm().mimo_recorder_close(pointer);
      files().remove(file);
    });
    this.#file = file;
  }

  /** The file as it is so far. @returns {Uint8Array} */
  flush() {
    check(wasm().mimo_recorder_flush(this.pointer));
    return /** @type {Uint8Array} */ (files().bytes(this.#file));
  }

  /** Ends the recording. @returns {Uint8Array} the file */
  finish() {
    const { pointer } = this;
    check(wasm().mimo_recorder_close(pointer));
    const bytes = files().bytes(this.#file);
    this.close();
    if (bytes === undefined) throw new MimoError(Status.FILE, "the recording has no file");
    return bytes;
  }
}

/** A recording that is played again, and read. */
export class Recording extends Handle {
  /**
   * @param {Uint8Array} bytes the file, of whichever language
   * @param {string} [name] by which messages call it
   */
  constructor(bytes, name = "recording.h5") {
    if (!(bytes instanceof Uint8Array)) throw new TypeError("bytes are no Uint8Array");
    const file = freshName(name);
    files().put(file, bytes);
    let pointer = 0;
    try {
      pointer = within((frame) => {
        const at = frame.place(4);
        check(wasm().mimo_recording_open(frame.text("file", file), 0, at));
        return frame.numberAt("size", at);
      });
    } finally {
      if (pointer === 0) files().remove(file);
    }
    super(pointer, () => {
      wasm().mimo_recording_close(pointer);
      files().remove(file);
    });
  }

  /** What the recording holds. @returns {RecordingInfo} */
  get info() {
    return this.#described("mimo_recording_info", wasm().mimo_recording_describe);
  }

  /** What the replay has shown so far. @returns {ReplayReport} */
  get report() {
    return this.#described("mimo_replay_report", wasm().mimo_recording_report);
  }

  /**
   * @param {string} struct
   * @param {Function} describe
   */
  #described(struct, describe) {
    return within((frame) => {
      const at = frame.empty(struct);
      check(describe(this.pointer, at));
      return frame.record(struct, at);
    });
  }

  /**
   * The recorded world, made anew.
   * @param {{senses?: import("./generated/types.js").AgentConfig, config?: import("./generated/types.js").EnvConfig}} [options]
   * senses other than the recorded ones, each may be AS_RECORDED; and the renderer and its settings
   */
  world({ senses, config } = {}) {
    return within((frame) => {
      const at = frame.place(4);
      const chosen = config === undefined ? 0 : frame.struct("mimo_env_config", config);
      const sensed = senses === undefined ? 0 : frame.struct("mimo_agent_config", senses);
      check(wasm().mimo_recording_env(this.pointer, chosen, sensed, at));
      return new World(frame.numberAt("size", at));
    });
  }

  /**
   * Begins a replay from the last kept state that is not later than a step.
   * @param {World} world
   * @param {number} [step]
   * @param {number} [how] of Replay
   * @returns {number} the step that comes next
   */
  seek(world, step = 0, how = 0) {
    return within((frame) => {
      const at = frame.place(4);
      check(wasm().mimo_recording_seek(this.pointer, world.pointer, integer("step", step, 0), integer("how", how, 0), at));
      world.layout.renew();
      return frame.numberAt("size", at);
    });
  }

  /**
   * Plays the next step; the observation is in the world's.
   * @param {World} world
   * @returns {import("./world.js").Step | null} null at the end
   */
  step(world) {
    const { pointer, bytes } = world.block_;
    const status = wasm().mimo_recording_step(this.pointer, world.pointer, pointer, bytes, world.results_.pointer);
    if (status === Status.END) return null;
    check(status);
    return world.results;
  }

  /** How many rows a dataset has, and how many bytes each. @param {string} dataset */
  size(dataset) {
    return within((frame) => {
      const rows = frame.place(4);
      const rowBytes = frame.place(4);
      check(wasm().mimo_recording_size(this.pointer, frame.text("dataset", dataset), rows, rowBytes));
      return { rows: frame.numberAt("size", rows), rowBytes: frame.numberAt("size", rowBytes) };
    });
  }

  /**
   * Rows of a dataset, as numbers of the type that they have in the file.
   * @param {string} dataset
   * @param {import("./memory.js").NumberKind} kind
   * @param {number} [first]
   * @param {number} [rows] all by default
   */
  read(dataset, kind, first = 0, rows = this.size(dataset).rows - first) {
    const Numbers = numbers(kind);
    if (Numbers === undefined) throw new TypeError(`kind is ${shown(kind)}, expected u8, i32, u32, u64, f32, f64 or size`);
    const bytes = integer("rows", rows, 0) * this.size(dataset).rowBytes;
    const block = new Block(bytes);
    try {
      within((frame) =>
        check(wasm().mimo_recording_read(this.pointer, frame.text("dataset", dataset), integer("first", first, 0), rows, block.pointer, bytes)),
      );
      return new Numbers(buffer().slice(block.pointer, block.pointer + bytes));
    } finally {
      block.free();
    }
  }
}
