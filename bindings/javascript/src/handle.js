import { MimoError } from "./error.js";
import { Status } from "./generated/constants.js";

/** What was not closed is destroyed when nobody can reach it any more. @type {FinalizationRegistry<() => void>} */
const forgotten = new FinalizationRegistry((destroy) => destroy());

/** An object of the library. `close()` destroys it; so does `using`, and in the end the garbage collector. */
export class Handle {
  /** @type {number} */
  #pointer;
  /** @type {(() => void) | null} */
  #destroy;

  /**
   * @param {number} pointer
   * @param {(() => void) | null} destroy null: somebody else owns it
   */
  constructor(pointer, destroy) {
    this.#pointer = pointer;
    this.#destroy = destroy;
    if (destroy) forgotten.register(this, destroy, this);
  }

  /** @internal */
  get pointer() {
    if (this.#pointer === 0) throw new MimoError(Status.BAD_HANDLE, `this ${this.constructor.name} is closed`);
    return this.#pointer;
  }

  /** Destroys the object; a second call does nothing. */
  close() {
    if (this.#pointer === 0) return;
    this.#pointer = 0;
    forgotten.unregister(this);
    this.#destroy?.();
  }
}

// `using world = new World("reach")`, where the engine knows it.
if (Symbol.dispose) Object.defineProperty(Handle.prototype, Symbol.dispose, { value: Handle.prototype.close });
