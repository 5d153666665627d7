import { Status } from "./generated/constants.js";

/** The names of the status codes, by their numbers. @type {Map<number, string>} */
const names = new Map(Object.entries(Status).map(([name, status]) => [status, name]));

/** A call that the library refused: its status, and the library's message. */
export class MimoError extends Error {
  /**
   * @param {number} status one of Status
   * @param {string} message
   * @param {{cause?: unknown}} [options]
   */
  constructor(status, message, options) {
    super(message, options);
    this.name = "MimoError";
    /** One of Status. */
    this.status = status;
    /** The name of the status: "NOT_FOUND". */
    this.code = names.get(status) ?? String(status);
  }
}
