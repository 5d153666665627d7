/** Files in memory: all that the module can open. They have names and no folders. */

// Errors, kinds and choices as Emscripten's C library numbers them.
const NO_SUCH_FILE = 44;
const EXISTS = 20;
const NOT_OPEN = 8;
const INVALID = 28;
const PLAIN_FILE = 0o100644;
const FOLDER = 0o040755;
const CREATE = 0o100;
const MUST_BE_NEW = 0o200;
const CUT = 0o1000;
const APPEND = 0o2000;
const FIRST_NUMBER = 16; // beyond the standard streams

/** A file, whose bytes lie at the beginning of a larger array. */
class File {
  bytes = new Uint8Array(0);
  size = 0;
  inode;

  /** @param {number} inode */
  constructor(inode) {
    this.inode = inode;
  }

  /** @param {number} size */
  resize(size) {
    if (size > this.bytes.length) {
      const larger = new Uint8Array(Math.max(size, 2 * this.bytes.length, 1 << 16));
      larger.set(this.bytes.subarray(0, this.size));
      this.bytes = larger;
    }
    if (size < this.size) this.bytes.fill(0, size, this.size);
    this.size = size;
  }
}

/** The files of a module, and the calls by which it uses them. */
export class Files {
  /** @type {Map<string, File>} */
  #files = new Map();
  /** @type {Map<number, {file: File, at: number, append: boolean}>} */
  #open = new Map();
  #next = FIRST_NUMBER;
  #inodes = 1;
  #memory;

  /** @param {() => ArrayBufferLike} memory the module's */
  constructor(memory) {
    this.#memory = memory;
  }

  /**
   * Makes a file of these bytes.
   * @param {string} name
   * @param {Uint8Array} bytes
   */
  put(name, bytes) {
    const file = new File(this.#inodes++);
    file.resize(bytes.length);
    file.bytes.set(bytes);
    this.#files.set(name, file);
  }

  /** @param {string} name */
  has(name) {
    return this.#files.has(name);
  }

  /** The bytes of a file. @param {string} name */
  bytes(name) {
    const file = this.#files.get(name);
    return file?.bytes.slice(0, file.size);
  }

  /** @param {string} name */
  remove(name) {
    this.#files.delete(name);
  }

  #view() {
    return new DataView(this.#memory());
  }

  /** @param {number} pointer */
  #name(pointer) {
    const bytes = new Uint8Array(this.#memory());
    return new TextDecoder().decode(bytes.slice(pointer, bytes.indexOf(0, pointer)));
  }

  /** @param {number} at @param {File | undefined} file undefined: the one folder */
  #describe(at, file) {
    const view = this.#view();
    new Uint8Array(this.#memory(), at, 88).fill(0);
    view.setUint32(at + 8, file?.inode ?? 0, true);
    view.setUint32(at + 12, file ? PLAIN_FILE : FOLDER, true);
    view.setUint32(at + 16, 1, true);
    view.setBigInt64(at + 40, BigInt(file?.size ?? 0), true);
    view.setUint32(at + 48, 4096, true);
    view.setBigInt64(at + 80, BigInt(file?.inode ?? 0), true);
    return 0;
  }

  /** @param {number} path @param {number} at */
  #describeNamed(path, at) {
    const name = this.#name(path);
    const file = this.#files.get(name);
    return file || name === "/" ? this.#describe(at, file) : -NO_SUCH_FILE;
  }

  /**
   * Reads or writes pieces of memory one after the other.
   * @param {number} number @param {number} parts @param {number} count @param {number} done where their sum goes
   * @param {(open: {file: File, at: number, append: boolean}, piece: Uint8Array) => number} move
   */
  #move(number, parts, count, done, move) {
    const open = this.#open.get(number);
    const view = this.#view();
    let total = 0;
    for (let i = 0; i < count; i++) {
      const [from, length] = [view.getUint32(parts + 8 * i, true), view.getUint32(parts + 8 * i + 4, true)];
      // What the C library complains of before it ends the program goes nowhere.
      total += open ? move(open, new Uint8Array(this.#memory(), from, length)) : number < FIRST_NUMBER ? length : 0;
    }
    view.setUint32(done, total, true);
    return open || number < FIRST_NUMBER ? 0 : NOT_OPEN;
  }

  /** @type {Record<string, Function>} */
  calls = {
    __syscall_openat: (/** @type {number} */ _, /** @type {number} */ path, /** @type {number} */ how) => {
      const name = this.#name(path);
      let file = this.#files.get(name);
      if (file && how & CREATE && how & MUST_BE_NEW) return -EXISTS;
      if (!file && !(how & CREATE)) return -NO_SUCH_FILE;
      if (!file) this.#files.set(name, (file = new File(this.#inodes++)));
      if (how & CUT) file.resize(0);
      this.#open.set(this.#next, { file, at: 0, append: (how & APPEND) !== 0 });
      return this.#next++;
    },
    fd_close: (/** @type {number} */ number) => (this.#open.delete(number) ? 0 : NOT_OPEN),
    fd_read: (/** @type {number} */ number, /** @type {number} */ parts, /** @type {number} */ count, /** @type {number} */ done) =>
      this.#move(number, parts, count, done, (open, piece) => {
        const length = Math.max(0, Math.min(piece.length, open.file.size - open.at));
        piece.set(open.file.bytes.subarray(open.at, open.at + length));
        open.at += length;
        return length;
      }),
    fd_write: (/** @type {number} */ number, /** @type {number} */ parts, /** @type {number} */ count, /** @type {number} */ done) =>
      this.#move(number, parts, count, done, (open, piece) => {
        if (open.append) open.at = open.file.size;
        if (open.at + piece.length > open.file.size) open.file.resize(open.at + piece.length);
        open.file.bytes.set(piece, open.at);
        open.at += piece.length;
        return piece.length;
      }),
    fd_seek: (/** @type {number} */ number, /** @type {bigint} */ offset, /** @type {number} */ from, /** @type {number} */ result) => {
      const open = this.#open.get(number);
      if (!open) return NOT_OPEN;
      const place = Number(offset) + [0, open.at, open.file.size][from];
      if (!(place >= 0)) return INVALID;
      open.at = place;
      this.#view().setBigInt64(result, BigInt(place), true);
      return 0;
    },
    __syscall_ftruncate64: (/** @type {number} */ number, /** @type {number} */ low, /** @type {number} */ high) => {
      const open = this.#open.get(number);
      open?.file.resize((low >>> 0) + 2 ** 32 * high);
      return open ? 0 : -NOT_OPEN;
    },
    __syscall_fstat64: (/** @type {number} */ number, /** @type {number} */ at) => {
      const open = this.#open.get(number);
      return open ? this.#describe(at, open.file) : -NOT_OPEN;
    },
    __syscall_stat64: (/** @type {number} */ path, /** @type {number} */ at) => this.#describeNamed(path, at),
    __syscall_lstat64: (/** @type {number} */ path, /** @type {number} */ at) => this.#describeNamed(path, at),
    __syscall_fstatat64: (/** @type {number} */ _, /** @type {number} */ path, /** @type {number} */ at) => this.#describeNamed(path, at),
    __syscall_readlink: () => -INVALID, // no file is a link
    __syscall_getcwd: (/** @type {number} */ at) => {
      this.#view().setUint16(at, "/".charCodeAt(0), true);
      return at;
    },
    __syscall_unlink: (/** @type {number} */ path) => (this.#files.delete(this.#name(path)) ? 0 : -NO_SUCH_FILE),
    __syscall_rename: (/** @type {number} */ before, /** @type {number} */ after) => {
      const file = this.#files.get(this.#name(before));
      if (!file) return -NO_SUCH_FILE;
      this.#files.delete(this.#name(before));
      this.#files.set(this.#name(after), file);
      return 0;
    },
  };
}
