//! What a pixel of a triangle costs a Cortex-M4, in instructions: in one colour, with colours that vary, with a
//! texture, with and without a depth buffer; and what setting one up costs.
//!
//! `examples/firmware/run.sh attributes` builds it and runs it as `cycles`. Each row draws the same triangles into the
//! rows of the same frame. The set-up is what a triangle of one pixel costs more than the same triangle in one colour,
//! which takes the same walk over its edges; neither is known to the compiler.

#![no_std]
#![no_main]

mod instruction_counter;
#[path = "../../benches/scenes/mod.rs"]
mod scenes;

use core::{convert::Infallible, fmt::Write as _, hint::black_box};

use cortex_m_semihosting::{debug, hio};
use embedded_graphics::{image::GetPixel, pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use panic_semihosting as _;
use spanfill::{
    Affine, Attributes, DepthBuffer, DepthTest, Fill, Filter, Gouraud, Perspective, PixelRect, Shape, Span, SpanSink,
    Texture, Triangle, Vertex, Wrap,
};

use instruction_counter::InstructionCounter;
use scenes::{FRAME_HEIGHT, FRAME_WIDTH, Frame, PixelPoint, Random, triangles};

const SHAPES: usize = 64;

const TEXTURE_SIDE: usize = 64;

/// A texture of 64 x 64 texels in memory, as a firmware's own would be.
struct Board([[Rgb565; TEXTURE_SIDE]; TEXTURE_SIDE]);

impl OriginDimensions for &Board {
    fn size(&self) -> Size {
        Size::new_equal(TEXTURE_SIDE as u32)
    }
}

impl GetPixel for &Board {
    type Color = Rgb565;

    #[inline(always)]
    fn pixel(&self, point: Point) -> Option<Rgb565> {
        self.0.as_flattened().get((point.y as usize) * TEXTURE_SIDE + point.x as usize).copied()
    }
}

static BOARD: Board = Board(board());

const fn board() -> [[Rgb565; TEXTURE_SIDE]; TEXTURE_SIDE] {
    let mut board = [[Rgb565::BLACK; TEXTURE_SIDE]; TEXTURE_SIDE];
    let mut y = 0;
    while y < TEXTURE_SIDE {
        let mut x = 0;
        while x < TEXTURE_SIDE {
            board[y][x] = Rgb565::new((x / 2) as u8, y as u8, ((x ^ y) / 2) as u8);
            x += 1;
        }
        y += 1;
    }
    board
}

/// A triangle of a scene with everything that any row needs.
#[derive(Clone, Copy)]
struct Scene {
    triangle: Triangle,
    colours: [Rgb565; 3],
    texels: [[i32; 2]; 3],
    distances: [i32; 3],
    depths: [u16; 3],
}

/// Counts what a triangle covers.
struct Count {
    pixels: u32,
    rows: u32,
}

impl SpanSink for Count {
    type Error = Infallible;

    fn span(&mut self, span: Span) -> Result<(), Infallible> {
        self.pixels += span.columns.len() as u32;
        self.rows += 1;
        Ok(())
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    let mut counter = InstructionCounter::new(core.SYST);
    let frame = cortex_m::singleton!(: Frame = Frame::new()).expect("taken once");
    let memory = cortex_m::singleton!(
        : [u16; (FRAME_WIDTH * FRAME_HEIGHT) as usize] = [0; (FRAME_WIDTH * FRAME_HEIGHT) as usize]
    )
    .expect("taken once");
    let area = Rectangle::new(Point::zero(), Size::new(FRAME_WIDTH as u32, FRAME_HEIGHT as u32));
    let mut depths = DepthBuffer::new(area, FRAME_WIDTH as usize, memory).expect("it is large enough");
    let texture = Texture::new(&BOARD, Wrap::Repeat, Filter::Nearest).expect("it has texels");
    let bilinear = Texture::new(&BOARD, Wrap::Repeat, Filter::Bilinear).expect("it has texels");
    let texel = move |at: [i32; 2]| texture.texel(at).unwrap_or(Rgb565::BLACK);
    let mixed = move |at: [i32; 2]| bilinear.sample(at).unwrap_or(Rgb565::BLACK);
    let colour = |channels: [i32; 3]| Rgb565::new(channels[0] as u8, channels[1] as u8, channels[2] as u8);

    let mut host = hio::hstdout().expect("the host takes text");
    let mut csv = heapless::String::<4096>::new();
    writeln!(host, "| triangle | drawn | instructions | a pixel | of which set-up |\n|---|---|--:|--:|--:|")
        .expect("text");
    // The last ones are larger than the screen, and have areas beyond 32 bits.
    for (box_px, times) in [(10, 1), (50, 1), (200, 1), (200, 8)] {
        let scenes = scenes(box_px).map(|scene| larger(scene, times));
        let box_px = box_px * times;
        let mut all = Count { pixels: 0, rows: 0 };
        for scene in &scenes {
            let clip = PixelRect::from(frame.bounding_box());
            let Ok(()) = scene.triangle.spans(&clip, &mut all);
        }
        let mut row = |name: &str, total: u32, setup: Option<u32>| {
            let pixels = all.pixels;
            let hundredths = (u64::from(total) * 100 / u64::from(pixels)) as u32;
            let each = total / SHAPES as u32;
            let setup_text: heapless::String<12> =
                setup.map_or(heapless::String::new(), |setup| heapless::format!("{setup}").unwrap_or_default());
            writeln!(
                host,
                "| {box_px} px | {name} | {each} | {}.{:02} | {setup_text} |",
                hundredths / 100,
                hundredths % 100
            )
            .expect("text");
            writeln!(csv, "triangles,\"{name}\",cortex-m4,{box_px},{each},{hundredths},{setup_text}").expect("room");
        };
        macro_rules! cost {
            ($name:literal, $draw:expr) => {{
                #[allow(unused_mut)]
                let mut draw = $draw;
                let total = counter.count(&scenes, |scene| draw(scene, frame));
                let start = counter.count(&scenes, |scene| draw(black_box(&thin(scene)), frame));
                let none = counter.count(&scenes, |scene| {
                    let Ok(()) = black_box(&thin(scene)).triangle.filled(Rgb565::RED).draw(frame);
                });
                // One of a pixel has a small area.
                row($name, total, (times == 1).then_some(start.saturating_sub(none) / SHAPES as u32));
            }};
        }
        depths.clear(u16::MAX);
        cost!("flat", |scene: &Scene, frame: &mut Frame| {
            let Ok(()) = scene.triangle.filled(scene.colours[0]).draw(frame);
        });
        cost!("flat, depth", |scene: &Scene, frame: &mut Frame| {
            let colour = scene.colours[0];
            let flat = Affine::new(scene.triangle, [[], [], []]).shaded(|[]| colour);
            flat.depth_tested(scene.depths, DepthTest::LESS).draw_on(frame, &mut depths);
        });
        cost!("Gouraud, exact", |scene: &Scene, frame: &mut Frame| {
            let Ok(()) = Gouraud::new(scene.triangle, scene.colours).draw_on(frame);
        });
        cost!("Gouraud, packed", |scene: &Scene, frame: &mut Frame| {
            let Ok(()) = Gouraud::packed(scene.triangle, scene.colours).draw_on(frame);
        });
        depths.clear(u16::MAX);
        cost!("Gouraud, exact, depth", |scene: &Scene, frame: &mut Frame| {
            let shaded = Gouraud::new(scene.triangle, scene.colours).affine().shaded(colour);
            shaded.depth_tested(scene.depths, DepthTest::LESS).draw_on(frame, &mut depths);
        });
        cost!("affine texture", |scene: &Scene, frame: &mut Frame| {
            Affine::new(scene.triangle, scene.texels).shaded(texel).draw_on(frame);
        });
        depths.clear(u16::MAX);
        cost!("affine texture, depth", |scene: &Scene, frame: &mut Frame| {
            let shaded = Affine::new(scene.triangle, scene.texels).shaded(texel);
            shaded.depth_tested(scene.depths, DepthTest::LESS).draw_on(frame, &mut depths);
        });
        cost!("perspective texture", |scene: &Scene, frame: &mut Frame| {
            let seen = Perspective::new(scene.triangle, scene.texels, scene.distances).expect("in front");
            seen.shaded(texel).draw_on(frame);
        });
        cost!("perspective texture, every pixel divided", |scene: &Scene, frame: &mut Frame| {
            let seen = Perspective::new(scene.triangle, scene.texels, scene.distances).expect("in front");
            seen.tolerance(0).shaded(texel).draw_on(frame);
        });
        depths.clear(u16::MAX);
        cost!("perspective texture, depth", |scene: &Scene, frame: &mut Frame| {
            let seen = Perspective::new(scene.triangle, scene.texels, scene.distances).expect("in front");
            seen.shaded(texel).depth_tested(scene.depths, DepthTest::LESS).draw_on(frame, &mut depths);
        });
        cost!("perspective texture, bilinear", |scene: &Scene, frame: &mut Frame| {
            let seen = Perspective::new(scene.triangle, scene.texels, scene.distances).expect("in front");
            seen.shaded(mixed).draw_on(frame);
        });
    }
    write!(host, "\nscene,variant,target,px,instructions,hundredths_a_pixel,setup\n{csv}").expect("text");
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}

/// The same, scaled about the middle of the frame.
fn larger(scene: Scene, times: i32) -> Scene {
    let middle = [FRAME_WIDTH, FRAME_HEIGHT].map(|side| side as i32 * 128);
    let vertices = scene.triangle.vertices.map(|vertex| {
        let [x, y] = [(vertex.x, middle[0]), (vertex.y, middle[1])]
            .map(|(part, middle)| (part.to_bits() - middle) * times + middle);
        Vertex::from_bits(x, y)
    });
    Scene { triangle: Triangle::from_vertices(vertices), ..scene }
}

/// The same around a single pixel's centre, where a triangle is hardly more than its set-up.
fn thin(scene: &Scene) -> Scene {
    let [a, ..] = scene.triangle.vertices;
    let (x, y) = (a.x.to_bits(), a.y.to_bits());
    let corner = |dx: i32, dy: i32| Vertex::from_bits(x.clamp(512, 70_000) + dx, y.clamp(512, 50_000) + dy);
    let triangle = Triangle::from_vertices([corner(-120, -120), corner(130, -100), corner(-110, 130)]);
    Scene { triangle, ..*scene }
}

fn scenes(box_px: i32) -> [Scene; SHAPES] {
    let mut random = Random::new(0xA77);
    let mut triangles = triangles(box_px);
    core::array::from_fn(|_| {
        let [a, b, c] = triangles.next().expect("endless").map(|[x, y]: PixelPoint| Point::new(x, y));
        Scene {
            triangle: Triangle::new(a, b, c),
            colours: [(); 3]
                .map(|()| Rgb565::new(random.below(32) as u8, random.below(64) as u8, random.below(32) as u8)),
            texels: [(); 3].map(|()| [random.below(64 * 256), random.below(64 * 256)]),
            distances: [(); 3].map(|()| 1000 + random.below(3000)),
            depths: [(); 3].map(|()| random.below(65536) as u16),
        }
    })
}
