//! What each shape costs a Cortex-M4, in instructions: spanfill, embedded-graphics 0.8, and the bare `fill_solid` calls
//! of the rectangles that spanfill sends, which is the least that any rasterizer on the same target could cost. And
//! what it costs spanfill with anti-aliased edges, blended in the target's memory, or over a background that is known.
//!
//! `examples/firmware/run.sh cycles` builds it and runs it in QEMU's `mps2-an386` under `-icount shift=0`, where every
//! instruction takes the same time: the counts are the same in each run, on any host. They are instructions, not
//! cycles: a division counts as much as an addition.
//!
//! Each library's primitives are built before the counting starts. All draw on the same target, see
//! `benches/scenes/frame.rs`, and the same shapes, see `benches/scenes/shapes.rs`.

#![no_std]
#![no_main]

mod instruction_counter;
#[path = "../../benches/scenes/mod.rs"]
mod scenes;

use core::{
    fmt::{self, Write as _},
    iter,
};

use cortex_m_semihosting::{
    debug,
    hio::{self, HostStream},
};
use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self as eg, PrimitiveStyle, Rectangle},
};
use panic_semihosting as _;
use spanfill::{
    AntiAlias, Blend, Circle, Cover, Fill, InPlace, Line, Over, Polygon, Triangle, Vertex,
    eg::{DrawOn as _, Style},
};

use instruction_counter::InstructionCounter;
use scenes::{
    CONCAVE_64, CONCAVE_RADIUS_PX, Frame, PixelPoint, RecordBlocks, STAR, STAR_RADIUS_PX, Scene, SubpixelPoint,
    circles, lines, triangles,
};

/// How many shapes are drawn between two readings of the timer. The costliest take 70 million instructions, a tenth of
/// what the timer can count; the cheapest are exact to an instruction.
const SHAPES: usize = 256;

/// The same for anti-aliased shapes, which take longer.
const ANTI_ALIASED_SHAPES: usize = 64;

/// The same for polygons, which take still longer.
const POLYGONS: usize = 16;

/// Room for the rectangles of so many shapes: 200 a shape, 3200 a polygon.
const BLOCKS: usize = SHAPES * 200;

const COLOUR: Rgb565 = Rgb565::CSS_ORANGE;

/// What the anti-aliased shapes are blended over when it is not read from the frame.
const BACKGROUND: Rgb565 = Rgb565::BLACK;

/// Anti-aliased polygons have a cell for each column: one pass does for all of them.

const STAR_VERTICES: [Vertex; STAR.len()] = vertices(STAR);
const STAR_POLYGON: Polygon<'static> = Polygon::new(&STAR_VERTICES);
const CONCAVE_64_VERTICES: [Vertex; CONCAVE_64.len()] = vertices(CONCAVE_64);
const CONCAVE_64_POLYGON: Polygon<'static> = Polygon::new(&CONCAVE_64_VERTICES);

const fn vertices<const N: usize>(outline: [SubpixelPoint; N]) -> [Vertex; N] {
    let mut vertices = [Vertex::from_bits(0, 0); N];
    let mut i = 0;
    while i < N {
        vertices[i] = Vertex::from_bits(outline[i][0], outline[i][1]);
        i += 1;
    }
    vertices
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    let mut bench = Bench {
        counter: InstructionCounter::new(core.SYST),
        frame: cortex_m::singleton!(: Frame = Frame::new()).expect("taken once"),
        blocks: cortex_m::singleton!(: [Rectangle; BLOCKS] = [Rectangle::zero(); BLOCKS]).expect("taken once"),
    };
    let rows = [
        bench.scene(Scene::Triangles(10)),
        bench.scene(Scene::Triangles(50)),
        bench.scene(Scene::Triangles(200)),
        bench.scene(Scene::Circles(5)),
        bench.scene(Scene::Circles(20)),
        bench.scene(Scene::Circles(100)),
        bench.scene(Scene::Lines(50)),
        bench.scene(Scene::Lines(200)),
        bench.thick_lines(50),
        bench.thick_lines(200),
        bench.star(),
        bench.concave_64(),
    ];

    let mut host = hio::hstdout().expect("the host takes text");
    print_table(&mut host, &rows).and_then(|()| print_csv(&mut host, &rows)).expect("the host takes text");
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}

/// Instructions a shape.
struct Cost {
    /// None for what it cannot draw.
    embedded_graphics: Option<u32>,
    spanfill: u32,
    bare_fill: u32,
    anti_aliased: u32,
    anti_aliased_over: u32,
}

struct Row {
    name: &'static str,
    /// What the size is of.
    size_name: &'static str,
    size_px: i32,
    cost: Cost,
}

struct Bench {
    counter: InstructionCounter,
    frame: &'static mut Frame,
    blocks: &'static mut [Rectangle],
}

impl Bench {
    fn scene(&mut self, scene: Scene) -> Row {
        let pixel = |[x, y]: PixelPoint| Point::new(x, y);
        let filled = PrimitiveStyle::with_fill(COLOUR);
        let cost = match scene {
            Scene::Triangles(box_px) => {
                let shapes = triangles(box_px).map(|vertices| vertices.map(pixel));
                let theirs = shapes.map(|[a, b, c]| eg::Triangle::new(a, b, c).into_styled(filled));
                let shapes = triangles(box_px).map(|vertices| vertices.map(pixel));
                let ours = shapes.map(|[a, b, c]| Triangle::new(a, b, c));
                self.compare(theirs, ours)
            }
            Scene::Circles(radius_px) => {
                let theirs = circles(radius_px).map(|[x, y]| {
                    let top_left = Point::new(x - radius_px, y - radius_px);
                    eg::Circle::new(top_left, 2 * radius_px.unsigned_abs()).into_styled(filled)
                });
                let ours = circles(radius_px).map(|[x, y]| Circle::new(Vertex::new(x, y), radius_px));
                self.compare(theirs, ours)
            }
            Scene::Lines(box_px) => {
                let thin = PrimitiveStyle::with_stroke(COLOUR, 1);
                let ends = lines(box_px).map(|ends| ends.map(pixel));
                let theirs = ends.map(|[start, end]| eg::Line::new(start, end).into_styled(thin));
                let ends = lines(box_px).map(|ends| ends.map(pixel));
                let ours = ends.map(|[start, end]| Line::new(start, end));
                self.compare(theirs, ours)
            }
            Scene::Stars(_) | Scene::Concave64(_) => unreachable!("a constant of each is measured"),
        };
        Row { name: scene.name(), size_name: scene.size_name(), size_px: scene.size_px(), cost }
    }

    /// Lines three pixels wide, by the styles of both.
    fn thick_lines(&mut self, box_px: i32) -> Row {
        let ends = lines(box_px).map(|ends| ends.map(|[x, y]| Point::new(x, y)));
        let shapes: [_; SHAPES] = take(ends.map(|[start, end]| eg::Line::new(start, end)));
        let theirs = shapes.map(|line| line.into_styled(PrimitiveStyle::with_stroke(COLOUR, 3)));
        let style = Style::with_stroke(COLOUR, 3);
        let ours = shapes.map(|line| line.into_styled(style));
        let blended = shapes.map(|line| line.into_styled(style.antialiased(InPlace)));
        let over = shapes.map(|line| line.into_styled(style.antialiased(Over(BACKGROUND))));
        let anti_aliased = blended.chunks(ANTI_ALIASED_SHAPES).map(|lines| {
            u64::from(self.counter.count(lines, |line| {
                let Ok(()) = line.draw_on(self.frame);
            }))
        });
        let anti_aliased = anti_aliased.sum::<u64>() / SHAPES as u64;
        let cost = Cost {
            embedded_graphics: Some(self.draw(&theirs)),
            spanfill: self.draw(&ours),
            bare_fill: self.fill_blocks_of(&ours),
            anti_aliased: anti_aliased as u32,
            anti_aliased_over: self.draw(&over),
        };
        Row { name: "line-3px", size_name: "box", size_px: box_px, cost }
    }

    fn star(&mut self) -> Row {
        let filled = STAR_POLYGON.with_capacity::<{ STAR_POLYGON.active_edges() }>();
        let covered = STAR_POLYGON.coverage_with::<{ STAR_POLYGON.coverage_edges() }>();
        let (filled, covered) = (filled.expect("it has what it needs"), covered.expect("it has what it needs"));
        let cost = self.polygon(|| filled.filled(COLOUR), || covered);
        Row { name: "star", size_name: "radius", size_px: STAR_RADIUS_PX, cost }
    }

    fn concave_64(&mut self) -> Row {
        let filled = CONCAVE_64_POLYGON.with_capacity::<{ CONCAVE_64_POLYGON.active_edges() }>();
        let covered = CONCAVE_64_POLYGON.coverage_with::<{ CONCAVE_64_POLYGON.coverage_edges() }>();
        let (filled, covered) = (filled.expect("it has what it needs"), covered.expect("it has what it needs"));
        let cost = self.polygon(|| filled.filled(COLOUR), || covered);
        Row { name: "concave-64", size_name: "radius", size_px: CONCAVE_RADIUS_PX, cost }
    }

    fn compare<S: Copy + Fill + Cover>(
        &mut self,
        theirs: impl Iterator<Item = impl Drawable<Color = Rgb565>>,
        ours: impl Iterator<Item = S>,
    ) -> Cost {
        let theirs: [_; SHAPES] = take(theirs);
        let ours: [S; SHAPES] = take(ours);
        Cost {
            embedded_graphics: Some(self.draw(&theirs)),
            ..self.ours(&ours.map(|shape| shape.filled(COLOUR)), &ours)
        }
    }

    /// Draws one polygon time and again.
    fn polygon<D: Drawable<Color = Rgb565>, S: Copy + Cover>(
        &mut self,
        filled: impl Fn() -> D,
        covered: impl Fn() -> S,
    ) -> Cost {
        let filled: [_; POLYGONS] = take(iter::repeat_with(filled));
        let covered: [_; POLYGONS] = take(iter::repeat_with(covered));
        self.ours(&filled, &covered)
    }

    fn ours<S: Copy + Cover>(&mut self, filled: &[impl Drawable<Color = Rgb565>], covered: &[S]) -> Cost {
        Cost {
            embedded_graphics: None,
            spanfill: self.draw(filled),
            bare_fill: self.fill_blocks_of(filled),
            anti_aliased: self.draw_anti_aliased(covered, InPlace),
            anti_aliased_over: self.draw_anti_aliased(covered, Over(BACKGROUND)),
        }
    }

    /// Draws the shapes: the instructions that it takes, a shape.
    fn draw(&mut self, shapes: &[impl Drawable<Color = Rgb565>]) -> u32 {
        let instructions = self.counter.count(shapes, |shape| {
            let Ok(_) = shape.draw(self.frame);
        });
        instructions / shapes.len() as u32
    }

    /// Draws the shapes with anti-aliased edges: the instructions that it takes, a shape.
    fn draw_anti_aliased<S, B>(&mut self, shapes: &[S], blend: B) -> u32
    where
        S: Copy + Cover,
        B: Copy + Blend<Frame>,
    {
        let counts = shapes.chunks(ANTI_ALIASED_SHAPES).map(|shapes| {
            let instructions = self.counter.count(shapes, |shape| {
                let Ok(()) = shape.antialiased(COLOUR, blend).draw_on(self.frame);
            });
            u64::from(instructions)
        });
        (counts.sum::<u64>() / shapes.len() as u64) as u32
    }

    /// Fills the rectangles that the shapes send, shape by shape: the instructions that it takes, a shape.
    fn fill_blocks_of(&mut self, shapes: &[impl Drawable<Color = Rgb565>]) -> u32 {
        let mut recorder = RecordBlocks::new(self.blocks);
        for shape in shapes {
            assert!(shape.draw(&mut recorder).is_ok(), "the shapes have more than {BLOCKS} rectangles");
        }
        let blocks = recorder.into_blocks();
        let instructions = self.counter.count(blocks, |block| {
            let Ok(()) = self.frame.fill_solid(block, COLOUR);
        });
        instructions / shapes.len() as u32
    }
}

fn print_table(host: &mut HostStream, rows: &[Row]) -> fmt::Result {
    writeln!(
        host,
        "| shape | embedded-graphics | spanfill | bare `fill_solid` | embedded-graphics / spanfill | spanfill / bare \
         | anti-aliased | anti-aliased, `Over` | anti-aliased / aliased |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|"
    )?;
    for Row { name, size_name, size_px, cost } in rows {
        write!(host, "| {name}, {size_name} {size_px} px | ")?;
        if let Some(instructions) = cost.embedded_graphics {
            write!(host, "{instructions}")?;
        }
        write!(host, " | {} | {} | ", cost.spanfill, cost.bare_fill)?;
        if let Some(instructions) = cost.embedded_graphics {
            write_ratio(host, instructions, cost.spanfill)?;
        }
        write!(host, " | ")?;
        write_ratio(host, cost.spanfill, cost.bare_fill)?;
        write!(host, " | {} | {} | ", cost.anti_aliased, cost.anti_aliased_over)?;
        write_ratio(host, cost.anti_aliased, cost.spanfill)?;
        writeln!(host, " |")?;
    }
    Ok(())
}

/// Two decimals, rounded to the nearest.
fn write_ratio(host: &mut HostStream, numerator: u32, denominator: u32) -> fmt::Result {
    let hundredths = (u64::from(numerator) * 100 + u64::from(denominator / 2)) / u64::from(denominator.max(1));
    write!(host, "{}.{:02}", hundredths / 100, hundredths % 100)
}

/// After an empty line. `px` is the size that belongs to the scene's name, see [`Scene::size_px`].
fn print_csv(host: &mut HostStream, rows: &[Row]) -> fmt::Result {
    writeln!(host, "\nscene,variant,target,px,instructions")?;
    for Row { name, size_px, cost, .. } in rows {
        let mut row =
            |variant: &str, instructions: u32| writeln!(host, "{name},{variant},cortex-m4,{size_px},{instructions}");
        if let Some(instructions) = cost.embedded_graphics {
            row("embedded-graphics", instructions)?;
        }
        row("spanfill", cost.spanfill)?;
        row("bare-fill-solid", cost.bare_fill)?;
        row("spanfill-aa", cost.anti_aliased)?;
        row("spanfill-aa-over", cost.anti_aliased_over)?;
    }
    Ok(())
}

fn take<T, const N: usize>(mut shapes: impl Iterator<Item = T>) -> [T; N] {
    core::array::from_fn(|_| shapes.next().expect("the scenes are endless"))
}
