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

/** What is no picture: the table, the magnifier, and vertices that follow the pointer. */
function controls({ demonstration, shapes }) {
  const cells = [...demonstration.root.querySelectorAll("tbody td")].map((cell) => cell.textContent);
  must(/\d (ms|µs)$/.test(cells[1]) && Number(cells[4].replace(",", "")) >= 0, `no time or wrong pixels: ${cells}`);
  must(demonstration.root.querySelectorAll("tbody tr").length === 2, "spanfill is not beside the method");
  const before = String(shown(shapes.picture));
  const magnified = () => String(shown(shapes.root.querySelector(".loupe")));
  const enlarged = magnified();
  const box = shapes.overlay.getBoundingClientRect();
  const at = ([x, y]) => ({ clientX: box.left + x / 128, clientY: box.top + y / 128, pointerId: 1 });
  const to = [20_000, 30_000];
  // No pointer is down that could be captured.
  shapes.overlay.setPointerCapture = () => {};
  shapes.overlay.dispatchEvent(new PointerEvent("pointerdown", at(shapes.points[0])));
  shapes.overlay.dispatchEvent(new PointerEvent("pointermove", at(to)));
  shapes.overlay.dispatchEvent(new PointerEvent("pointerup", at(to)));
  must(Math.hypot(shapes.points[0][0] - to[0], shapes.points[0][1] - to[1]) < 256, `dragged to ${shapes.points[0]}`);
  must(String(shown(shapes.picture)) !== before, "a vertex was dragged and the picture is the same");
  must(magnified() !== enlarged, "a vertex was dragged and the magnifier shows the same");
  shapes.points = [];
  shapes.choose(shapes.kind);
  must(String(shown(shapes.picture)) === before, "the vertex is back and the picture is another");
}

export async function test(crate, benches) {
  try {
    controls(benches);
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
