/** The module that tests run on: MIMO_WASM, else the package's, else the build's; without one they are skipped. */
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { load } from "../src/index.js";

const places = [process.env.MIMO_WASM, at("../mimo.wasm"), at("../../../build-web/lib/mimo.wasm")];
const found = places.find((place) => place && existsSync(place));

function at(path) {
  return fileURLToPath(new URL(path, import.meta.url));
}

/** Options of tests that need the module. */
export const needed = found ? {} : { skip: "there is no mimo.wasm; ./dev build --web makes it" };
export const wasmPath = found;

if (found) await load(new URL(`file://${found}`));
