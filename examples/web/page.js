// The page's controls. All pixels are drawn by the crate: see src/exports.rs for what it lends.

const WIDTH = 320;
const HEIGHT = 240;
const NUMBERS = ["pixels", "missing", "extra", "doubled", "ties", "off", "worst", "refused", "visited"];
/** By src/judge.rs: what a mark says. */
const VERDICTS = {
  2: { text: "missing: its centre is covered", colour: "#ff3b5c" },
  3: { text: "extra: its centre is not covered", colour: "#ff9f1a" },
  4: { text: "drawn more than once", colour: "#e056fd" },
  5: { text: "centre on the outline, given to the other side", colour: "#f6e58d" },
  6: { text: "coverage or colour not the nearest level", colour: "#4aa8ff" },
};

/** The crate, compiled to WebAssembly. */
class Crate {
  static async load(file) {
    const { instance } = await WebAssembly.instantiateStreaming(fetch(file), {});
    return new Crate(instance.exports);
  }

  constructor(exports) {
    this.exports = exports;
    const at = exports.catalogue();
    this.catalogue = JSON.parse(new TextDecoder().decode(this.#bytes(at, exports.catalogue_length())));
  }

  /** The memory moves when it grows: it is looked up each time. */
  #bytes(at, length) {
    return new Uint8Array(this.exports.memory.buffer, at, length);
  }

  show(canvas) {
    const bytes = new Uint8ClampedArray(this.#bytes(this.exports.canvas(), 4 * WIDTH * HEIGHT));
    canvas.getContext("2d", { willReadFrequently: true }).putImageData(new ImageData(bytes, WIDTH, HEIGHT), 0, 0);
  }

  #move(points) {
    this.exports.clear_points();
    for (const [x, y] of points) this.exports.push_point(x, y);
  }

  /** Undefined where the method is not one for such a subject. */
  draw(kind, points, place) {
    this.#move(points);
    if (!this.exports.draw(kind, ...place)) return undefined;
    const numbers = new Float64Array(this.exports.memory.buffer, this.exports.report(), NUMBERS.length);
    const report = Object.fromEntries(NUMBERS.map((name, index) => [name, numbers[index]]));
    report.wrong = report.missing + report.extra + report.doubled + report.off;
    const verdicts = this.#bytes(this.exports.verdicts(), WIDTH * HEIGHT).slice();
    const outline = [];
    const words = new Int32Array(this.exports.memory.buffer, this.exports.outline());
    for (let contour = 0, at = 1; contour < words[0]; contour += 1) {
      const end = at + 1 + 2 * words[at];
      outline.push(Array.from(words.subarray(at + 1, end), (subpixels) => subpixels / 256));
      at = end;
    }
    return { report, verdicts, outline };
  }

  /** Milliseconds of one drawing: the best of three runs that are long enough for the browser's clock. */
  time(kind, points, place) {
    this.#move(points);
    const run = (times) => {
      const started = performance.now();
      this.exports.time(kind, ...place, times);
      return performance.now() - started;
    };
    let times = 1;
    while (run(times) < 8 && times < 1 << 20) times *= 2;
    return Math.min(run(times), run(times), run(times)) / times;
  }
}

/** Pixels of a canvas, enlarged; over them the outline, the centres, and marks. */
class Loupe {
  constructor(loupe, picture, zoom, redrawn) {
    this.context = loupe.getContext("2d");
    this.picture = picture;
    this.zoom = zoom;
    this.middle = [WIDTH / 2, HEIGHT / 2];
    this.drawing = undefined;
    zoom.addEventListener("input", () => redrawn());
  }

  /** What of the picture is shown: left, top, and side, in pixels. */
  get window() {
    const side = 480 / this.zoom.value;
    return [Math.round(this.middle[0] - side / 2), Math.round(this.middle[1] - side / 2), side];
  }

  draw(hasMarks) {
    const { context, drawing } = this;
    const zoom = Number(this.zoom.value);
    const [left, top, side] = this.window;
    this.zoom.parentElement.querySelector("output").textContent = `${zoom} x`;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.imageSmoothingEnabled = false;
    context.fillStyle = "#0e1116";
    context.fillRect(0, 0, 480, 480);
    context.drawImage(this.picture, left, top, side, side, 0, 0, 480, 480);
    if (zoom >= 8) {
      context.strokeStyle = "#ffffff1c";
      context.lineWidth = 1;
      context.beginPath();
      for (let at = 0; at <= side; at += 1) {
        context.moveTo(at * zoom + 0.5, 0);
        context.lineTo(at * zoom + 0.5, 480);
        context.moveTo(0, at * zoom + 0.5);
        context.lineTo(480, at * zoom + 0.5);
      }
      context.stroke();
    }
    if (!drawing) return;
    for (let row = 0; row < side; row += 1) {
      for (let column = 0; column < side; column += 1) {
        const [x, y] = [left + column, top + row];
        if (x < 0 || x >= WIDTH || y < 0 || y >= HEIGHT) continue;
        const mark = hasMarks && VERDICTS[drawing.verdicts[y * WIDTH + x]];
        if (mark) {
          context.strokeStyle = mark.colour;
          context.lineWidth = Math.max(1.5, zoom / 8);
          const inset = context.lineWidth;
          context.strokeRect(column * zoom + inset, row * zoom + inset, zoom - 2 * inset, zoom - 2 * inset);
        }
        if (zoom >= 12) {
          context.fillStyle = "#ffffff90";
          context.fillRect((column + 0.5) * zoom - 1, (row + 0.5) * zoom - 1, 2, 2);
        }
      }
    }
    context.setTransform(zoom, 0, 0, zoom, -left * zoom, -top * zoom);
    context.lineJoin = "round";
    for (const [width, colour] of [[4, "#000000b0"], [1.8, "#7ef9ff"]]) {
      context.lineWidth = width / zoom;
      context.strokeStyle = colour;
      context.beginPath();
      for (const points of drawing.outline) {
        for (let at = 0; at < points.length; at += 2) context[at ? "lineTo" : "moveTo"](points[at], points[at + 1]);
      }
      context.stroke();
    }
  }
}

/** Where the pointer is, in pixels of the picture. */
function pixelAt(event, element) {
  const box = element.getBoundingClientRect();
  return [((event.clientX - box.left) * WIDTH) / box.width, ((event.clientY - box.top) * HEIGHT) / box.height];
}

/** A picture by a method: what both the demonstration and the magnifier are. */
class Bench {
  /** `accepts` says of an option whether it is on offer. */
  constructor(root, crate, accepts) {
    this.root = root;
    this.crate = crate;
    this.accepts = accepts;
    root.append(document.getElementById("bench").content.cloneNode(true));
    this.picture = root.querySelector(".picture");
    this.overlay = root.querySelector(".overlay");
    this.method = root.querySelector(".method");
    this.marks = root.querySelector(".marks");
    this.loupe = new Loupe(root.querySelector(".loupe"), this.picture, root.querySelector(".zoom"), () => this.decorate());
    this.kind = 0;
    this.points = [];
    /** Whether the method is timed and held against spanfill. */
    this.isMeasured = true;
    for (const { text, colour } of Object.values(VERDICTS)) {
      const item = document.createElement("span");
      const box = document.createElement("i");
      box.style.background = colour;
      item.append(box, text);
      root.querySelector(".legend").append(item);
    }
    this.method.addEventListener("change", () => this.draw());
    this.marks.addEventListener("change", () => this.decorate());
    this.overlay.addEventListener("pointerdown", (event) => this.#grab(event));
    this.overlay.addEventListener("pointermove", (event) => this.#pointed(event));
    this.overlay.addEventListener("pointerup", () => this.#release());
  }

  /** Another subject: its vertices where they are by default, and the methods that can draw it. */
  choose(kind, preferred) {
    if (kind !== this.kind || this.points.length === 0) {
      this.points = this.crate.catalogue.kinds[kind].points.map((point) => [...point]);
    }
    this.kind = kind;
    const before = this.method.value;
    this.method.replaceChildren();
    this.crate.catalogue.families.forEach((family, familyAt) => {
      const group = document.createElement("optgroup");
      group.label = family.name;
      family.methods.forEach((method, methodAt) => {
        method.options.forEach((option, optionAt) => {
          if (!option.draws.includes(kind) || !this.accepts(family, method, option)) return;
          const text = option.name ? `${method.name} · ${option.name}` : method.name;
          group.append(new Option(text, `${familyAt}-${methodAt}-${optionAt}`));
        });
      });
      if (group.children.length > 0) this.method.append(group);
    });
    const has = (value) => [...this.method.options].some((option) => option.value === value);
    const named = [...this.method.options].find((option) => option.text === preferred);
    if (has(before)) this.method.value = before;
    else if (named) this.method.value = named.value;
    this.draw();
  }

  get place() {
    return this.method.value.split("-").map(Number);
  }

  /** The shipped way in the same family. */
  get shipped() {
    const [familyAt] = this.place;
    const { methods } = this.crate.catalogue.families[familyAt];
    const methodAt = methods.findIndex((method) => method.name === "spanfill");
    const isSuited = (option) => option.draws.includes(this.kind) && this.accepts(undefined, undefined, option);
    const options = methods[methodAt]?.options ?? [];
    // Of several the last one is exact.
    const optionAt = options.findLastIndex(isSuited);
    return optionAt < 0 ? undefined : [familyAt, methodAt, optionAt];
  }

  draw() {
    const rows = [];
    const { kind, points, crate, shipped } = this;
    if (this.isMeasured && shipped && String(shipped) !== String(this.place)) {
      rows.push(["spanfill", crate.draw(kind, points, shipped).report, crate.time(kind, points, shipped)]);
    }
    const time = this.isMeasured ? crate.time(kind, points, this.place) : undefined;
    const drawing = crate.draw(kind, points, this.place);
    if (!drawing) throw new Error(`${this.method.value} cannot draw ${kind}`);
    crate.show(this.picture);
    this.loupe.drawing = drawing;
    rows.unshift([this.method.selectedOptions[0].text, drawing.report, time]);
    this.root.querySelector("tbody").replaceChildren(...rows.map((row) => this.#row(...row)));
    const [family, method] = this.place;
    this.root.querySelector(".source").textContent = `Source: ${crate.catalogue.families[family].methods[method].source}`;
    this.decorate();
  }

  #row(name, report, time) {
    const row = document.createElement("tr");
    const put = (text, look) => {
      const cell = row.insertCell();
      cell.textContent = text;
      if (look) cell.className = look;
    };
    const count = (number) => number.toLocaleString("en");
    put(name + (report.refused ? ` (could not draw ${report.refused})` : ""));
    put(time === undefined ? "" : time >= 1 ? `${time.toFixed(2)} ms` : `${(1000 * time).toFixed(1)} µs`);
    put(time === undefined ? "" : `${((1e6 * time) / Math.max(1, report.pixels)).toFixed(1)} ns`);
    put(count(report.pixels));
    put(count(report.wrong), report.wrong ? "bad" : "good");
    put(count(report.missing));
    put(count(report.extra));
    put(count(report.doubled));
    put(count(report.ties));
    put(report.worst.toFixed(2));
    return row;
  }

  /** The magnifier, and what lies over the picture. */
  decorate() {
    const context = this.overlay.getContext("2d");
    context.clearRect(0, 0, 640, 480);
    if (this.marks.checked) {
      this.loupe.drawing.verdicts.forEach((verdict, at) => {
        if (verdict < 2) return;
        context.fillStyle = VERDICTS[verdict].colour;
        context.fillRect(2 * (at % WIDTH), 2 * Math.floor(at / WIDTH), 2, 2);
      });
    }
    const [left, top, side] = this.loupe.window;
    context.strokeStyle = "#ffffffb0";
    context.lineWidth = 1;
    context.strokeRect(2 * left + 0.5, 2 * top + 0.5, 2 * side, 2 * side);
    for (const [x, y] of this.points) {
      context.beginPath();
      context.arc(x / 128, y / 128, 7, 0, 2 * Math.PI);
      context.fillStyle = "#7ef9ff50";
      context.fill();
      context.strokeStyle = "#7ef9ff";
      context.stroke();
    }
    this.loupe.draw(this.marks.checked);
  }

  #grab(event) {
    const [x, y] = pixelAt(event, this.overlay);
    const near = (point) => Math.hypot(point[0] / 256 - x, point[1] / 256 - y) < 6;
    this.grabbed = this.points.findIndex(near);
    if (this.grabbed >= 0) this.overlay.setPointerCapture(event.pointerId);
    else if (this.points.length === 0) this.draw();
  }

  #pointed(event) {
    const [x, y] = pixelAt(event, this.overlay);
    this.loupe.middle = [x, y];
    if (this.grabbed >= 0) {
      this.points[this.grabbed] = [Math.round(256 * x), Math.round(256 * y)];
      const { isMeasured } = this;
      this.isMeasured = false;
      this.draw();
      this.isMeasured = isMeasured;
    } else this.decorate();
  }

  #release() {
    if (this.grabbed >= 0) this.draw();
    this.grabbed = -1;
  }
}

function demonstrate(crate) {
  const root = document.getElementById("demonstration");
  let shade = "flat";
  const bench = new Bench(root, crate, (family) => !family || (family.name === "attributes") === (shade === "smooth"));
  const buttons = [...root.querySelectorAll("[data-kind]")];
  const press = (button) => {
    for (const other of buttons) other.setAttribute("aria-pressed", other === button);
    shade = button.dataset.shade;
    bench.choose(Number(button.dataset.kind), shade === "smooth" ? undefined : "as printed · FlatTri, Java");
  };
  for (const button of buttons) button.addEventListener("click", () => press(button));
  // The rim, where methods differ.
  bench.loupe.middle = [92, 51];
  press(buttons[0]);
  return bench;
}

function magnify(crate) {
  const root = document.getElementById("shapes");
  const kind = root.querySelector(".kind");
  const antialiased = root.querySelector(".antialiased");
  const accepts = (_family, _method, option) => option.antialiased === antialiased.checked;
  const bench = new Bench(root, crate, accepts);
  crate.catalogue.kinds.forEach(({ name }, at) => at >= 2 && kind.append(new Option(name, at)));
  const choose = () => {
    const options = crate.catalogue.families.flatMap(({ methods }) => methods.flatMap((method) => method.options));
    const canBe = options.some((option) => option.antialiased && option.draws.includes(Number(kind.value)));
    antialiased.disabled = !canBe;
    antialiased.parentElement.title = canBe ? "" : "The literature's methods of anti-aliasing draw straight edges, one shape at a time.";
    if (!canBe) antialiased.checked = false;
    bench.choose(Number(kind.value), antialiased.checked ? "n x n samples · n = 4" : undefined);
  };
  kind.addEventListener("change", choose);
  antialiased.addEventListener("change", choose);
  bench.loupe.middle = [84, 42];
  choose();
  return bench;
}

function showDashboard(crate) {
  const root = document.getElementById("dashboard");
  const [picture, value, library] = [".picture", ".value", ".library"].map((name) => root.querySelector(name));
  const loupe = new Loupe(root.querySelector(".loupe"), picture, root.querySelector(".zoom"), () => loupe.draw());
  loupe.middle = [125, 84];
  const draw = () => {
    root.querySelector("output").textContent = value.value;
    const started = performance.now();
    crate.exports.draw_dashboard(Number(value.value), library.value === "spanfill" ? 0 : 1);
    const spent = performance.now() - started;
    crate.show(picture);
    root.querySelector(".spent").textContent = `Drawn in ${spent.toFixed(1)} ms.`;
    loupe.draw();
  };
  value.addEventListener("input", draw);
  library.addEventListener("change", draw);
  picture.addEventListener("pointermove", (event) => {
    loupe.middle = pixelAt(event, picture);
    loupe.draw();
  });
  draw();
}

const asked = new URLSearchParams(location.search);
// A browser that is only to save a picture waits for what is being loaded: the server takes its time over this.
if (asked.has("screenshot")) document.body.append(Object.assign(new Image(), { src: "held" }));
const crate = await Crate.load("spanfill_web.wasm");
const benches = { demonstration: demonstrate(crate), shapes: magnify(crate) };
showDashboard(crate);
if (asked.has("test")) {
  const { test } = await import("./test.js");
  await test(crate, benches);
}
