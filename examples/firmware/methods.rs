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
#[allow(unreachable_pub, reason = "it is a library in itself")]
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
use variants::{Frame, SCREEN, Variant, attribute::Shaded, polygon::Outline};

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
        let counts = [("typical", 2), ("on pixels", 2), ("small", MOST), ("slivers", 2), ("large", 1), ("self-intersecting", 2)];
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
            let mut instructions = 0_u64;
            for index in 0..shapes {
                let shape = [shape(index)];
                let frame = &mut *self.frame;
                instructions += u64::from(self.counter.count(&shape, |shape| {
                    // What a method cannot draw costs what finding that out costs.
                    let _ = (variant.time)(shape.borrow(), &SCREEN, frame);
                }));
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
        instructions: u64,
    ) -> fmt::Result {
        // Names may have commas, and have no quotation marks.
        writeln!(self.host, "{CORE},\"{family}\",\"{method}\",\"{option}\",{scene},{shapes},{instructions}")
    }
}
