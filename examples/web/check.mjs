// Draws every picture of EXPECTED by the WebAssembly that the page loads, and compares its canvas with the host's, without a
// browser: `node check.mjs SITE EXPECTED`. The exit status is 0 if every picture is equal.

import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const [site, expected] = process.argv.slice(2);
const BYTES = 4 * 320 * 240;

const { instance } = await WebAssembly.instantiate(readFileSync(join(site, "spanfill_web.wasm")), {});
const { exports } = instance;

/** False where the crate does not draw what the name says. */
function draw(name) {
  const dashboard = /^dashboard-(.*)-(\d+)$/.exec(name);
  if (!dashboard) return exports.draw(...name.split("-").map(Number)) === 1;
  exports.draw_dashboard(Number(dashboard[2]), dashboard[1] === "spanfill" ? 0 : 1);
  return true;
}

const names = readdirSync(expected);
const failures = [];
for (const name of names) {
  const right = readFileSync(join(expected, name));
  if (!draw(name)) failures.push(`${name}: the page does not draw it`);
  // The memory moves when it grows: it is looked up each time.
  else if (!right.equals(new Uint8Array(exports.memory.buffer, exports.canvas(), BYTES))) failures.push(`${name}: another picture`);
}
for (const failure of failures.slice(0, 20)) console.error(failure);
const isGood = failures.length === 0 && names.length > 0;
console.log(`${names.length - failures.length} of ${names.length} pictures equal the host's, pixel for pixel: ${isGood ? "passed" : "FAILED"}`);
process.exitCode = isGood ? 0 : 1;
