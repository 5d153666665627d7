/** What lies inside a page as text: bytes in base 64, some of them packed. */
import { wasm, within } from "../../bindings/javascript/src/memory.js";

/** The bytes that an element holds; afterwards it holds none. @param {HTMLElement} element */
export function bytesIn(element) {
  const letters = atob(element.textContent);
  element.textContent = "";
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/**
 * An answer with what an element holds, which is unpacked as it is read.
 * @param {HTMLElement} element
 * @param {string} type
 */
function unpackedIn(element, type) {
  if (typeof DecompressionStream !== "function") {
    throw new Error("this browser cannot unpack what the page holds; browsers of 2023 and later can");
  }
  const stream = new Blob([bytesIn(element)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream, { headers: { "content-type": type } });
}

/** @param {HTMLElement} element */
export const moduleIn = (element) => unpackedIn(element, "application/wasm");

/**
 * Lets the module's sin, exp and the like round as the machine that recorded does (src/rounding/rounding.h).
 * @param {HTMLElement} element
 */
export function roundAsIn(element) {
  const rows = bytesIn(element);
  within((frame) => wasm().mimo_round_as(frame.array("u8", "rounding", rows), rows.length / 32));
}

/** @param {HTMLElement} element */
export const textIn = (element) => unpackedIn(element, "text/plain").text();
