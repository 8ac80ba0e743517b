// Serves the page: `node serve.mjs SITE PORT`. With `node serve.mjs SITE 0 EXPECTED CHROMIUM`, opens it in that browser, headless,
// works its controls, and compares each canvas with the file of that name in EXPECTED: the exit status is 0 if every one was shown
// and is equal. Shown is every subject by the last method of each family; check.mjs compares the others.

import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [site, port, expected, chromium] = process.argv.slice(2);
const TYPES = { html: "text/html", js: "text/javascript", wasm: "application/wasm" };
/** What a browser that saves a picture waits for: see page.js. */
const HOLD_MS = 5_000;
const TIMEOUT_MS = 300_000;

/** By subject and family, the last of them; the dashboards by themselves. */
const group = (name) => (name.startsWith("dashboard") ? name : name.split("-").slice(0, 2).join("-"));
const wanted = new Set(new Map((expected ? readdirSync(expected) : []).map((name) => [group(name), name])).values());
const equal = new Set();
const failures = [];
let finish = () => {};

function compare(name, drawn) {
  if (!wanted.has(name)) return failures.push(`${name} is not expected`);
  const right = readFileSync(join(expected, name));
  let wrong = Math.abs(right.length - drawn.length) / 4;
  for (let at = 0; at < Math.min(right.length, drawn.length); at += 4) {
    wrong += right.readUInt32LE(at) !== drawn.readUInt32LE(at);
  }
  if (wrong > 0) failures.push(`${name}: ${wrong} pixels differ from the host's`);
  else equal.add(name);
}

const server = createServer(async (request, response) => {
  const path = new URL(request.url, "http://localhost").pathname.slice(1) || "index.html";
  const answer = (status, type, body) => response.writeHead(status, { "content-type": type }).end(body);
  if (request.method === "POST" && expected) {
    const parts = [];
    for await (const part of request) parts.push(part);
    const body = Buffer.concat(parts);
    if (path === "done") finish(body.toString());
    else compare(path.replace("drawn/", ""), body);
    return answer(200, "text/plain", "");
  }
  if (path === "expected") return answer(200, "application/json", JSON.stringify([...wanted]));
  if (path === "held") return setTimeout(() => answer(404, "text/plain", ""), HOLD_MS);
  // Only what `run.sh build` put there.
  if (!readdirSync(site).includes(path)) return answer(404, "text/plain", "There is no such file.");
  answer(200, TYPES[path.split(".").pop()] ?? "text/plain", readFileSync(join(site, path)));
});

server.listen(Number(port), "127.0.0.1", async () => {
  const address = `http://127.0.0.1:${server.address().port}/`;
  if (!expected) return console.log(`The page is at ${address}`);
  const profile = mkdtempSync(join(tmpdir(), "spanfill-web-"));
  const flags =
    "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking " +
    "--disable-component-update --disable-sync --disable-dev-shm-usage";
  const browser = spawn(chromium, [...flags.split(" "), `--user-data-dir=${profile}`, `${address}?test`], {
    stdio: ["ignore", "ignore", "pipe"],
  });
  let complaints = "";
  browser.stderr.on("data", (text) => (complaints = (complaints + text).slice(-2_000)));
  const said = await new Promise((resolve) => {
    finish = resolve;
    browser.on("error", (error) => resolve(`the browser did not start: ${error}`));
    browser.on("exit", (code) => resolve(`the browser ended by itself, with ${code}`));
    setTimeout(() => resolve(`the page was not done after ${TIMEOUT_MS / 1000} s`), TIMEOUT_MS).unref();
  });
  browser.removeAllListeners("exit");
  // One that did not start, or has ended, says nothing more.
  const ended = new Promise((resolve) => browser.on("exit", resolve));
  if (browser.kill()) await ended;
  rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  server.close();
  server.closeAllConnections();
  if (said) failures.push(said);
  for (const name of wanted) {
    if (!equal.has(name) && !failures.some((failure) => failure.startsWith(`${name}:`))) failures.push(`${name} was not shown`);
  }
  for (const failure of failures.slice(0, 20)) console.error(failure);
  const isGood = failures.length === 0 && wanted.size > 0;
  if (!isGood) console.error(`The browser's last words:\n${complaints}`);
  console.log(`${equal.size} of ${wanted.size} canvases equal the host's, pixel for pixel: ${isGood ? "passed" : "FAILED"}`);
  process.exitCode = isGood ? 0 : 1;
});
