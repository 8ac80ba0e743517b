// Runs firmware on an emulated RP2040 with an ILI9341 on SPI0, listens to the bus, and compares what the panel shows with what the
// host drew. See run.sh.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { deflateSync } from "node:zlib";
import { GPIOPinState, RP2040 } from "rp2040js";

const FLASH = 0x10000000;
const RAM = 0x20000000;
const RAM_SIZE = 264 * 1024;
/** Behind the second stage of the boot loader. */
const VECTORS = FLASH + 0x100;
const COMMAND_PIN = 20;
/** What the stack is painted with. */
const PAINT = 0xa5;

/** An ILI9341, as far as mipidsi uses it: windows, and pixels into them. */
class Panel {
  pixels = new Uint8Array(2 * 320 * 320);
  landscape = false;
  columns = [0, 239];
  rows = [0, 319];
  bytes = 0;
  windows = 0;
  #command = 0;
  #arguments = [];
  #column = 0;
  #row = 0;
  #high;

  get width() {
    return this.landscape ? 320 : 240;
  }

  get height() {
    return this.landscape ? 240 : 320;
  }

  receive(byte, isCommand) {
    this.bytes += 1;
    if (isCommand) {
      this.#command = byte;
      this.#arguments = [];
      if (byte === 0x2c) {
        this.windows += 1;
        [this.#column] = this.columns;
        [this.#row] = this.rows;
        this.#high = undefined;
      }
      return;
    }
    switch (this.#command) {
      case 0x2a:
      case 0x2b:
        this.#arguments.push(byte);
        if (this.#arguments.length === 4) {
          const [a, b, c, d] = this.#arguments;
          const range = [a * 256 + b, c * 256 + d];
          const limit = this.#command === 0x2a ? this.width : this.height;
          if (range[0] > range[1] || range[1] >= limit) throw new Error(`the window ${range} is not on the panel`);
          if (this.#command === 0x2a) this.columns = range;
          else this.rows = range;
        }
        break;
      case 0x36:
        this.landscape = (byte & 0x20) !== 0;
        break;
      case 0x2c:
        if (this.#high === undefined) this.#high = byte;
        else {
          this.#pixel(this.#high, byte);
          this.#high = undefined;
        }
        break;
    }
  }

  #pixel(high, low) {
    if (this.#row > this.rows[1]) throw new Error("more pixels than the window has");
    const place = 2 * (this.#row * this.width + this.#column);
    this.pixels[place] = high;
    this.pixels[place + 1] = low;
    this.#column += 1;
    if (this.#column > this.columns[1]) {
      [this.#column] = this.columns;
      this.#row += 1;
    }
  }

  picture() {
    return this.pixels.slice(0, 2 * this.width * this.height);
  }
}

/** The loaded parts of an ELF file, by their place in flash; and what of the RAM is not free for the stack. */
function load(rp2040, file) {
  const elf = readFileSync(file);
  const [offset, size, count] = [elf.readUInt32LE(28), elf.readUInt16LE(42), elf.readUInt16LE(44)];
  let staticEnd = RAM;
  for (let index = 0; index < count; index += 1) {
    const at = offset + index * size;
    const [type, from, virtual, physical, length, memory] = [0, 4, 8, 12, 16, 20].map((field) => elf.readUInt32LE(at + field));
    if (type !== 1) continue;
    if (length > 0) {
      if (physical < FLASH) throw new Error(`a segment at ${physical.toString(16)} is not in flash`);
      rp2040.flash.set(elf.subarray(from, from + length), physical - FLASH);
    }
    if (virtual >= RAM && virtual < RAM + RAM_SIZE) staticEnd = Math.max(staticEnd, virtual + memory);
  }
  return staticEnd;
}

/** Runs to the end: a row for each stage. */
function run(file, expected, out) {
  const rp2040 = new RP2040();
  // A boot ROM of zeros: nothing is called in it. Loading it clears the flash.
  rp2040.loadBootrom(new Uint32Array(4096));
  const staticEnd = load(rp2040, file);
  rp2040.sram.fill(PAINT);
  rp2040.core.VTOR = VECTORS;
  rp2040.core.reset();
  const stackTop = rp2040.core.SP;

  const panel = new Panel();
  const command = rp2040.gpio[COMMAND_PIN];
  rp2040.spi[0].onTransmit = (byte) => {
    panel.receive(byte, command.value !== GPIOPinState.High);
    rp2040.spi[0].completeTransmit(0);
  };
  const stages = [];
  let stage;
  let line = "";
  let done = false;
  const say = (text) => {
    const [verb, way, name] = text.split(" ");
    if (verb === "begin") {
      stage = { way, name, bytes: panel.bytes, windows: panel.windows, cycles: rp2040.core.cycles };
    } else if (verb === "end") {
      stage.bytes = panel.bytes - stage.bytes;
      stage.windows = panel.windows - stage.windows;
      stage.cycles = rp2040.core.cycles - stage.cycles;
      compare(stage, panel, expected, out);
      stages.push(stage);
      console.error(`${stage.way} ${stage.name}: ${stage.bytes} bytes, ${stage.windows} windows, ${stage.cycles} cycles, ${stage.wrong} wrong`);
    } else if (verb === "done") {
      done = true;
    } else if (verb !== "skip") {
      throw new Error(`the firmware said: ${text}`);
    }
  };
  rp2040.uart[0].onByte = (byte) => {
    if (byte === 10) {
      say(line);
      line = "";
    } else line += String.fromCharCode(byte);
  };
  const NANOS = 8;
  let before = 0;
  const limit = Number(process.env.PICO_CYCLES ?? 4e9);
  while (!done) {
    if (rp2040.core.waiting) throw new Error("the firmware sleeps and nobody wakes it");
    const pc = rp2040.core.PC;
    if (pc < FLASH) throw new Error(`from ${before.toString(16)} to ${pc.toString(16)}, where there is no code`);
    before = pc;
    rp2040.clock.tick(rp2040.core.executeInstruction() * NANOS);
    if (rp2040.core.cycles > limit) throw new Error(`the firmware is not done after ${limit} cycles; its last line: ${line}`);
  }
  let deepest = staticEnd - RAM;
  while (rp2040.sram[deepest] === PAINT) deepest += 1;
  return { stages, picture: panel.picture(), staticBytes: staticEnd - RAM, stackBytes: stackTop - RAM - deepest };
}

function compare(stage, panel, expected, out) {
  const library = stage.way === "embedded-graphics" ? stage.way : "spanfill";
  const picture = panel.picture();
  stage.wrong = wrongPixels(picture, readFileSync(join(expected, `${library}-${stage.name}`)));
  if (out) writeFileSync(join(out, `${stage.way}-${stage.name}.png`), png(picture, panel.width, panel.height));
}

function wrongPixels(picture, wanted) {
  let wrong = Math.abs(wanted.length - picture.length) / 2;
  for (let place = 0; place < Math.min(wanted.length, picture.length); place += 2) {
    wrong += wanted[place] !== picture[place] || wanted[place + 1] !== picture[place + 1];
  }
  return wrong;
}

/** An RGB picture from RGB565. */
function png(picture, width, height) {
  const raw = Buffer.alloc(height * (1 + 3 * width));
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const value = picture[2 * (y * width + x)] * 256 + picture[2 * (y * width + x) + 1];
      const [r, g, b] = [value >> 11, (value >> 5) & 63, value & 31];
      raw.set([Math.round((r * 255) / 31), Math.round((g * 255) / 63), Math.round((b * 255) / 31)], y * (1 + 3 * width) + 1 + 3 * x);
    }
  }
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name, "latin1"), data]);
    const length = Buffer.alloc(4);
    length.writeUInt32BE(data.length);
    const check = Buffer.alloc(4);
    check.writeUInt32BE(crc32(body));
    return Buffer.concat([length, body, check]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width);
  header.writeUInt32BE(height, 4);
  header.set([8, 2], 8);
  const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
  return Buffer.concat([signature, chunk("IHDR", header), chunk("IDAT", deflateSync(raw)), chunk("IEND", Buffer.alloc(0))]);
}

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}

/** How many bytes fewer than embedded-graphics', in per cent. */
const FEWER = { "thick-lines-50": 35, "thick-lines-200": 35 };
const FRAME_BYTES = 2 * 320 * 240;
const RAM_LIMIT = 8 * 1024;

/** Programs that run on the simulator, too. */
const EXAMPLES = ["hello_lcd", "dashboard", "bands", "damage"];

const [firmware, expected, check, out] = process.argv.slice(2);
if (!check) {
  console.error("Usage: node run.mjs FOLDER_OF_FIRMWARE FOLDER_OF_EXPECTED check|show [FOLDER_FOR_PNG]");
  process.exit(2);
}
if (out) mkdirSync(out, { recursive: true });
const failures = [];
const must = (holds, what) => {
  if (!holds) failures.push(what);
};

const all = run(join(firmware, "bus"), expected, out);
console.log("| picture | by | bytes | windows | cycles | bytes beside embedded-graphics |\n|---|---|--:|--:|--:|--:|");
for (const stage of all.stages) {
  const { way, name, bytes, windows, cycles, wrong } = stage;
  must(wrong === 0, `${name} by ${way}: ${wrong} pixels differ from the host's`);
  const theirs = all.stages.find((other) => other.way === "embedded-graphics" && other.name === name);
  const share = theirs && theirs !== stage ? `${((100 * (bytes - theirs.bytes)) / theirs.bytes).toFixed(1)} %` : "";
  console.log(`| ${name} | ${way} | ${bytes} | ${windows} | ${cycles} | ${share} |`);
  if (way === "direct" && theirs && name !== "dashboard") {
    const most = theirs.bytes * (1 - (FEWER[name] ?? 0) / 100);
    must(bytes <= most, `${name} by ${way}: ${bytes} bytes, at most ${most}`);
  }
  if (name === "dashboard" && !["direct", "embedded-graphics"].includes(way)) {
    must(bytes <= FRAME_BYTES * 1.01, `${name} by ${way}: ${bytes} bytes for ${FRAME_BYTES} of pixels`);
  }
}
for (const way of ["embedded-graphics", "direct", "framebuffer", "bands", "dma", "async"]) {
  must(all.stages.some((stage) => stage.way === way && stage.name === "dashboard"), `no dashboard by ${way}`);
}
const moved = all.stages.find((stage) => stage.way === "damage");
must(moved && moved.bytes < FRAME_BYTES / 5, "a needle that moves costs a fifth of the frame or more");

const little = run(join(firmware, "small"), expected, undefined);
const total = little.staticBytes + little.stackBytes;
console.log(`\nA dashboard, anti-aliased, in ${total} bytes of RAM: ${little.staticBytes} static, ${little.stackBytes} of stack.`);
must(total < RAM_LIMIT, `${total} bytes of RAM, the limit is ${RAM_LIMIT}`);
must(little.stages.length >= 2, "the small firmware drew too little");
for (const { name, wrong } of little.stages) must(wrong === 0, `${name} in little RAM: ${wrong} pixels differ from the host's`);

for (const name of EXAMPLES) {
  const { picture } = run(join(firmware, name), expected, undefined);
  const wrong = wrongPixels(picture, readFileSync(join(expected, `${name}.rgb565`)));
  console.log(`${name}: ${wrong} pixels are not the simulator's`);
  must(wrong === 0, `${name}: ${wrong} pixels are not the simulator's`);
}

if (failures.length > 0) console.error(failures.join("\n"));
if (check === "check" && failures.length > 0) process.exit(1);
