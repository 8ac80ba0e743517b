// Works the page's controls as a person would, and hands what each canvas shows to the server, which knows what it must show.
// `run.sh test` opens the page with `?test`.

const shown = (canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;

async function hand(name, body) {
  const answer = await fetch(`/drawn/${name}`, { method: "POST", body });
  if (!answer.ok) throw new Error(`${name}: the server answered ${answer.status}`);
}

function set(control, value, event) {
  if (control.type === "checkbox") control.checked = value;
  else control.value = value;
  if (control.type !== "checkbox" && control.value !== String(value)) throw new Error(`there is no ${value} to choose`);
  control.dispatchEvent(new Event(event));
}

function must(holds, what) {
  if (!holds) throw new Error(what);
}

async function dashboards(names) {
  const root = document.getElementById("dashboard");
  for (const name of names) {
    const [, library, value] = /^dashboard-(.*)-(\d+)$/.exec(name);
    set(root.querySelector(".library"), library, "change");
    set(root.querySelector(".value"), value, "input");
    await hand(name, shown(root.querySelector(".picture")));
  }
}

async function methods(names, crate, { demonstration, shapes }) {
  for (const name of names) {
    const [kind, ...place] = name.split("-").map(Number);
    const [family, method, option] = place;
    const of = crate.catalogue.families[family];
    const bench = kind < 2 ? demonstration : shapes;
    if (kind < 2) {
      const shade = of.name === "attributes" ? "smooth" : "flat";
      bench.root.querySelector(`[data-kind="${kind}"][data-shade="${shade}"]`).click();
    } else {
      set(bench.root.querySelector(".kind"), kind, "change");
      set(bench.root.querySelector(".antialiased"), of.methods[method].options[option].antialiased, "change");
    }
    set(bench.method, place.join("-"), "change");
    await hand(name, shown(bench.picture));
  }
}

const colourAt = ({ data, width }, x, y) => Array.from(data.subarray(4 * (Math.floor(y) * width + Math.floor(x))).subarray(0, 3));
const image = (canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
const row = (bench, index) => [...bench.root.querySelectorAll("tbody tr")[index].cells].map((cell) => cell.textContent);
const number = (text) => Number(text.replaceAll(",", ""));

/** A pointer on the picture, in 1/256 pixel. */
function point(bench, event, [x, y]) {
  const box = bench.overlay.getBoundingClientRect();
  const at = { clientX: box.left + x / 128, clientY: box.top + y / 128, pointerId: 1 };
  bench.overlay.dispatchEvent(new PointerEvent(event, at));
}

/** Each button draws its scene by any method, with its time and its wrong pixels; a click draws it again. */
function clicks(bench) {
  for (const button of bench.root.querySelectorAll("[data-kind]")) {
    button.click();
    must(button.getAttribute("aria-pressed") === "true", "a button does not show that it was pressed");
    must(bench.kind === Number(button.dataset.kind), "a button draws another scene");
    const families = new Set([...bench.method.options].map((option) => option.parentElement.label));
    must(families.has("attributes") === (button.dataset.shade === "smooth"), `${button.textContent} by ${[...families]}`);
    for (const at of [0, bench.method.options.length - 1]) {
      set(bench.method, bench.method.options[at].value, "change");
      const [name, time, each, pixels, wrong] = row(bench, 0);
      must(name.startsWith(bench.method.selectedOptions[0].text), `the table says ${name}`);
      must(/^[\d.]+ (ms|µs)$/.test(time) && Number.parseFloat(time) > 0 && /ns$/.test(each), `the time is ${time}, ${each}`);
      const bad = bench.loupe.drawing.verdicts.filter((verdict) => [2, 3, 4, 6].includes(verdict)).length;
      must(number(pixels) > 0 && number(wrong) === bad, `${wrong} wrong pixels in the table, ${bad} marked`);
      must(bench.root.querySelector(".source").textContent.length > 10, "a method has no source");
    }
    const before = String(shown(bench.picture));
    bench.picture.getContext("2d").clearRect(0, 0, 320, 240);
    point(bench, "pointerdown", [40_000, 30_000]);
    point(bench, "pointerup", [40_000, 30_000]);
    must(String(shown(bench.picture)) === before, "a click does not draw the scene again");
  }
}

/** A method that is not spanfill's stands beside it, and the marks are there when they are asked for. */
function marks(bench) {
  bench.root.querySelector('[data-kind="1"][data-shade="flat"]').click();
  const printed = [...bench.method.options].find((option) => option.text.startsWith("as printed"));
  set(bench.method, printed.value, "change");
  must(row(bench, 1)[0] === "spanfill" && number(row(bench, 1)[4]) === 0, `beside the method: ${row(bench, 1)}`);
  must(number(row(bench, 0)[4]) > 0, "the method as printed has no wrong pixels");
  const on = String(shown(bench.overlay));
  set(bench.marks, false, "change");
  must(String(shown(bench.overlay)) !== on, "marks do not go away");
  set(bench.marks, true, "change");
  must(String(shown(bench.overlay)) === on, "marks do not come back");
}

/** How far from a line between two points. */
function distance([x, y], [ax, ay, bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - along * dx, y - ay - along * dy);
}

/** Pixels are shown enlarged, and the true outline lies over them where it is. */
function magnifier(bench) {
  set(bench.root.querySelector(".kind"), 7, "change");
  set(bench.marks, false, "change");
  for (const [zoom, to] of [[8, [40_000, 12_000]], [24, [43_000, 10_000]], [40, [40_960, 4_000]]]) {
    const control = bench.root.querySelector(".zoom");
    point(bench, "pointermove", to);
    set(control, zoom, "input");
    must(control.parentElement.querySelector("output").textContent === `${zoom} x`, "the zoom is not told");
    const [left, top, side] = bench.loupe.window;
    must(side === 480 / zoom, `${side} pixels are shown, enlarged ${zoom} times`);
    must(Math.abs(left + side / 2 - to[0] / 256) <= 1 && Math.abs(top + side / 2 - to[1] / 256) <= 1, "another place is shown");
    const [picture, loupe] = [image(bench.picture), image(bench.root.querySelector(".loupe"))];
    const lines = bench.loupe.drawing.outline.flatMap((points) =>
      Array.from({ length: points.length / 2 - 1 }, (_, at) => points.slice(2 * at, 2 * at + 4)));
    let pixels = 0;
    for (let row = 0; row < side; row += 1) {
      for (let column = 0; column < side; column += 1) {
        const at = [left + column + 0.3, top + row + 0.7];
        if (at[1] < 0 || lines.some((line) => distance(at, line) < 3.5 / zoom)) continue;
        const [wanted, drawn] = [colourAt(picture, ...at), colourAt(loupe, (at[0] - left) * zoom, (at[1] - top) * zoom)];
        must(String(wanted) === String(drawn), `pixel ${at} is ${wanted}, enlarged ${drawn}`);
        pixels += 1;
      }
    }
    must(pixels > side, "there is hardly a pixel under the magnifier");
    let seen = 0;
    for (const [ax, ay, bx, by] of lines) {
      for (let step = 0; step <= 1000; step += 1) {
        const [x, y] = [ax + ((bx - ax) * step) / 1000 - left, ay + ((by - ay) * step) / 1000 - top];
        if (x < 0.1 || y < 0.1 || x > side - 0.1 || y > side - 0.1) continue;
        const [r, g, b] = colourAt(loupe, x * zoom, y * zoom);
        must(r < 210 && g > 180 && b > 180, `the outline is ${[r, g, b]} at ${[x + left, y + top]}`);
        seen += 1;
      }
    }
    must(seen > 10, "no outline lies over the pixels");
  }
  set(bench.marks, true, "change");
}

/** Every shape is on offer, smooth where a method of the literature can be. */
function shapesAndSmoothing(bench, { kinds }) {
  const kind = bench.root.querySelector(".kind");
  const smooth = bench.root.querySelector(".antialiased");
  must(kind.options.length === kinds.length - 2, "a shape is missing");
  let smoothed = 0;
  for (const { value } of [...kind.options]) {
    set(kind, value, "change");
    const rough = String(shown(bench.picture));
    if (smooth.disabled) continue;
    set(smooth, true, "change");
    must(String(shown(bench.picture)) !== rough, `${kinds[value].name} looks the same, smooth and not`);
    set(smooth, false, "change");
    smoothed += 1;
  }
  must(smoothed >= 4, `${smoothed} shapes can be smoothed`);
}

/** Vertices follow the pointer. */
function dragging(bench) {
  set(bench.root.querySelector(".kind"), 2, "change");
  point(bench, "pointermove", bench.points[0]);
  const before = String(shown(bench.picture));
  const magnified = () => String(shown(bench.root.querySelector(".loupe")));
  const enlarged = magnified();
  const to = [20_000, 30_000];
  // No pointer is down that could be captured.
  bench.overlay.setPointerCapture = () => {};
  point(bench, "pointerdown", bench.points[0]);
  point(bench, "pointermove", to);
  point(bench, "pointerup", to);
  must(Math.hypot(bench.points[0][0] - to[0], bench.points[0][1] - to[1]) < 256, `dragged to ${bench.points[0]}`);
  must(String(shown(bench.picture)) !== before, "a vertex was dragged and the picture is the same");
  must(magnified() !== enlarged, "a vertex was dragged and the magnifier shows the same");
  bench.points = [];
  bench.choose(bench.kind);
  must(String(shown(bench.picture)) === before, "the vertex is back and the picture is another");
}

export async function test(crate, benches) {
  try {
    const { demonstration, shapes } = benches;
    clicks(demonstration);
    marks(demonstration);
    shapesAndSmoothing(shapes, crate.catalogue);
    dragging(shapes);
    magnifier(shapes);
    const names = await (await fetch("/expected")).json();
    for (const bench of Object.values(benches)) bench.isMeasured = false;
    const isDashboard = (name) => name.startsWith("dashboard");
    await dashboards(names.filter(isDashboard));
    await methods(names.filter((name) => !isDashboard(name)), crate, benches);
    await fetch("/done", { method: "POST", body: "" });
  } catch (error) {
    await fetch("/done", { method: "POST", body: `${error}\n${error.stack}` });
  }
}
