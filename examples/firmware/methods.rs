//! What a pixel by each method of `spanfill::methods` costs a Cortex-M4, in instructions.
//!
//! `examples/firmware/run.sh methods` builds it with and without the float unit and runs it in QEMU's `mps2-an386` under
//! `-icount shift=0`, as `cycles`. It draws the first shapes of the scenes that the host's chart draws, on the same
//! frame; the rows that it prints are the chart's.

#![no_std]
#![no_main]

mod instruction_counter;
#[path = "../../benches/scenes/random.rs"]
mod random;
#[path = "../methods/scenes.rs"]
mod scenes;
#[path = "../methods/variants/mod.rs"]
mod variants;

use core::{
    borrow::Borrow,
    fmt::{self, Write as _},
};

use cortex_m_semihosting::{
    debug,
    hio::{self, HostStream},
};
use panic_semihosting as _;

use instruction_counter::InstructionCounter;
use scenes::{MOST_VERTICES, Point};
use spanfill::Vertex;
use variants::{Frame, SCREEN, Variant, antialias, attribute::Shaded, polygon::Outline};

/// With hardware for floats of 32 bits, or without.
const CORE: &str = if cfg!(target_abi = "eabihf") { "hard" } else { "soft" };

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    let mut bench = Bench {
        counter: InstructionCounter::new(core.SYST),
        frame: cortex_m::singleton!(: Frame = Frame::new()).expect("taken once"),
        host: hio::hstdout().expect("the host takes text"),
    };
    bench.run().expect("the host takes text");
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}

/// The texture of the chart's first scene of checks.
static CHECKS: [u8; 64 * 64] = {
    let mut texels = [0; 64 * 64];
    let mut at = 0;
    while at < texels.len() {
        texels[at] = if (at % 64 + at / 64) % 2 == 0 { 255 } else { 0 };
        at += 1;
    }
    texels
};

fn vertex([x, y]: Point) -> Vertex {
    Vertex::from_bits(x, y)
}

struct Bench {
    counter: InstructionCounter,
    frame: &'static mut Frame,
    host: HostStream,
}

impl Bench {
    fn run(&mut self) -> fmt::Result {
        writeln!(self.host, "core,family,method,option,scene,shapes,instructions")?;
        for (scene, shapes) in [("typical", 4), ("on pixels", 4), ("small", 8), ("slivers", 4), ("large", 1)] {
            let triangle = |index| scenes::triangle(scene, index);
            self.scene(variants::triangle::INSIDE, scene, shapes, triangle)?;
            self.scene(variants::triangle::TRAVERSAL, scene, shapes, triangle)?;
            self.scene(variants::attribute::ATTRIBUTES, scene, shapes, |index| {
                let (attributes, w, depth) = scenes::varying(scene, index);
                Shaded { vertices: triangle(index), attributes, w, depth }
            })?;
        }
        for (scene, _) in scenes::MESHES {
            self.scene(variants::triangle::SHARED, scene, 1, |index| scenes::mesh(scene, index))?;
        }
        for (scene, shapes) in [("typical", 4), ("short", 8), ("long", 2), ("nearly level", 4)] {
            self.scene(variants::line::LINES, scene, shapes, |index| scenes::line(scene, index))?;
        }
        for (scene, shapes) in [("typical", 3), ("small", 6), ("large", 1)] {
            self.scene(variants::circle::CIRCLES, scene, shapes, |index| scenes::circle(scene, index))?;
        }
        for (scene, square) in scenes::SPECKS {
            const TRIANGLES: usize = 2 * scenes::SPECKS_ACROSS * scenes::SPECKS_ACROSS;
            let mesh = |_| -> [[Vertex; 3]; TRIANGLES] {
                core::array::from_fn(|index| scenes::speck(square, index).map(vertex))
            };
            self.scene(variants::points::POINTS, scene, 1, mesh)?;
        }
        for (name, scene, shapes) in
            [("triangles", "typical", 2), ("small triangles", "small", 4), ("slivers", "slivers", 2)]
        {
            let shape = |index| antialias::Scene::Triangle(scenes::triangle(scene, index).map(vertex));
            self.scene(antialias::ANTIALIAS, name, shapes, shape)?;
        }
        for (name, scene, shapes) in [("lines", "typical", 2), ("short lines", "short", 4)] {
            let shape = |index| antialias::Scene::Line(scenes::line(scene, index).map(|[x, y]| Vertex::pixel(x, y)));
            self.scene(antialias::ANTIALIAS, name, shapes, shape)?;
        }
        self.scene(antialias::ANTIALIAS, "checks", 1, |_| antialias::Scene::Texture {
            texels: &CHECKS,
            size: [64, 64],
            corner: [40, 40],
            pixels: [20, 20],
        })?;
        self.polygons()
    }

    /// Methods of polygons want outlines that last.
    fn polygons(&mut self) -> fmt::Result {
        const MOST: usize = 8;
        type Contour = [Point; MOST_VERTICES];
        const NONE: &[Point] = &[];
        let contours = cortex_m::singleton!(: [Contour; 6 * MOST] = [[[0; 2]; MOST_VERTICES]; 6 * MOST]);
        let slices = cortex_m::singleton!(: [&'static [Point]; 6 * MOST] = [NONE; 6 * MOST]);
        let (Some(contours), Some(slices)) = (contours, slices) else { return Err(fmt::Error) };
        let counts =
            [("typical", 2), ("on pixels", 2), ("small", MOST), ("slivers", 2), ("large", 1), ("self-intersecting", 2)];
        let shapes = || counts.iter().flat_map(|&(scene, shapes)| (0..shapes).map(move |index| (scene, index)));
        for ((contour, slice), (scene, index)) in contours.into_iter().zip(slices.iter_mut()).zip(shapes()) {
            let vertices = scenes::polygon(scene, index, contour);
            *slice = &contour[..vertices];
        }
        let mut slices: &'static [&'static [Point]] = slices;
        for (scene, shapes) in counts {
            let (these, rest) = slices.split_at(shapes);
            slices = rest;
            self.scene(variants::polygon::POLYGONS, scene, shapes, |index| Outline {
                contours: core::slice::from_ref(&these[index]),
                even_odd: index % 2 == 1,
            })?;
        }
        Ok(())
    }

    /// Counts every variant on the first shapes of a scene.
    fn scene<S: Borrow<V>, V: ?Sized>(
        &mut self,
        variants: &'static [Variant<V>],
        scene: &str,
        shapes: usize,
        shape: impl Fn(usize) -> S,
    ) -> fmt::Result {
        for variant in variants {
            let mut instructions = Some(0_u64);
            for index in 0..shapes {
                let shape = [shape(index)];
                let frame = &mut *self.frame;
                let count = self.counter.try_count(&shape, |shape| {
                    // What a method cannot draw costs what finding that out costs.
                    let _ = (variant.time)(shape.borrow(), &SCREEN, frame);
                });
                instructions = instructions.zip(count).map(|(sum, count)| sum + u64::from(count));
                if instructions.is_none() {
                    break;
                }
            }
            self.row(variant.family, variant.method, variant.option, scene, shapes, instructions)?;
        }
        Ok(())
    }

    fn row(
        &mut self,
        family: &str,
        method: &str,
        option: &str,
        scene: &str,
        shapes: usize,
        instructions: Option<u64>,
    ) -> fmt::Result {
        // Names may have commas, and have no quotation marks.
        write!(self.host, "{CORE},\"{family}\",\"{method}\",\"{option}\",{scene},{shapes},")?;
        // What took longer than the timer can count has no number.
        match instructions {
            Some(instructions) => writeln!(self.host, "{instructions}"),
            None => writeln!(self.host),
        }
    }
}
