//! From the root down to what is as small as a pixel.

use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb565};

use crate::{
    PixelRect,
    attribute::{DepthBuffer, DepthTest},
    span::Span,
    splat::{BrokenModel, CONE_SINES, Model, Node, Sphere, View, normal},
    target::PixelRows,
};

/// A node as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Splat {
    /// Its middle, in 1/256 px.
    pub x: i32,
    /// Its middle, in 1/256 px.
    pub y: i32,
    /// The diameter of its sphere, in 1/256 px.
    pub size: u32,
    /// `65536 (1 - near / z)`: 0 at the near plane.
    pub depth: u16,
    /// Its direction, of length 16384, in the model's own axes.
    pub normal: [i32; 3],
    /// Its colour.
    pub colour: Rgb565,
}

/// Receives splats, in no particular order.
pub trait SplatSink {
    /// Takes one.
    fn splat(&mut self, splat: &Splat);
}

/// How far down a model is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Refinement {
    /// Nodes whose diameter is at most that many 1/256 px are drawn, and nothing below them. 0 draws every leaf.
    pub threshold: u32,
    /// No more splats are drawn.
    pub budget: u32,
}

/// Where to go after a node.
enum Next {
    /// To its children, if it has any.
    Below,
    /// Past it, and all that is below it.
    Beside,
    /// Nowhere.
    End,
}

/// Levels below the root.
const LEVELS: usize = 24;
/// Siblings that wait while one is looked into.
const STACK: usize = 3 * LEVELS + 4;

/// A node that is still to be looked at.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    sphere: Sphere,
    node: Node,
    /// The group of its children.
    group: usize,
    level: u8,
    /// It is known to be inside of the screen; to be turned towards the eye.
    inside: bool,
    facing: bool,
}

impl Model<'_> {
    /// Draws the model as a view sees it: every node of it that is small enough, or has no children.
    ///
    /// Subtrees that lie beside the screen, before the near plane or turned away are left out.
    ///
    /// Returns how many splats there were.
    ///
    /// # Errors
    ///
    /// What is broken in the model, as soon as it is met.
    ///
    /// # Cost
    ///
    /// A division a node, twelve multiplications for where it is seen, 7 KB of stack at most. Tables of 33 KB.
    pub fn draw(
        &self,
        view: &View,
        screen: &PixelRect,
        refinement: Refinement,
        sink: &mut impl SplatSink,
    ) -> Result<u32, BrokenModel> {
        let screen = Screen::new(view, screen);
        let mut drawn = 0;
        self.descend(|Waiting { sphere, node, inside, facing, .. }| {
            let Some(seen) = screen.look(sphere, node, inside, facing) else { return Next::Beside };
            if node.children > 0 && (seen.size > refinement.threshold || seen.z == 0) {
                return Next::Below;
            }
            if drawn == refinement.budget {
                return Next::End;
            }
            if let Some(splat) = seen.splat(&screen, node) {
                sink.splat(&splat);
                drawn += 1;
            }
            Next::Beside
        })?;
        Ok(drawn)
    }

    /// Looks at every node.
    ///
    /// # Errors
    ///
    /// The first thing that is broken; nodes that nothing leads to, too.
    pub fn check(&self) -> Result<(), BrokenModel> {
        match self.descend(|_| Next::Below)? {
            0 => Ok(()),
            missing => Err(BrokenModel::TooFewNodes { missing }),
        }
    }

    /// From the root down, depth first.
    ///
    /// It ends, whatever the bytes are: a tree has no more nodes than its header says, and no more are looked at. Returns how
    /// many more there could be.
    #[inline(always)]
    fn descend(&self, mut look: impl FnMut(&mut Waiting) -> Next) -> Result<u32, BrokenModel> {
        let mut stack = heapless::Vec::<Waiting, STACK>::new();
        let (sphere, node, group) = (self.root, self.root_node, self.root_group);
        let _ = stack.push(Waiting { sphere, node, group, level: 0, inside: false, facing: false });
        let mut left = self.nodes();
        while let Some(mut waiting) = stack.pop() {
            left = left.checked_sub(1).ok_or(BrokenModel::TooManyNodes)?;
            match look(&mut waiting) {
                Next::Below => {}
                Next::Beside => continue,
                Next::End => break,
            }
            let Waiting { sphere, node, group, level, inside, facing } = waiting;
            if node.children == 0 {
                continue;
            }
            if usize::from(level) == LEVELS {
                return Err(BrokenModel::TooDeep);
            }
            let mut below = if node.grandchildren { self.groups_below(group, node.children)? } else { 0 };
            for index in 0..node.children {
                let offset = Self::sibling(group, index);
                let child = self.node(offset)?;
                let sphere = sphere.child(child.sphere).ok_or(BrokenModel::Code { offset })?;
                let group = below;
                if child.children > 0 {
                    if !node.grandchildren {
                        return Err(BrokenModel::Code { offset });
                    }
                    below = below.saturating_add(child.group_bytes());
                }
                let mut next = Waiting { sphere, node: child, group, level: level + 1, inside, facing };
                if child.children > 0 {
                    stack.push(next).map_err(|_| BrokenModel::TooDeep)?;
                    continue;
                }
                // Nothing is below a leaf: it need not wait.
                left = left.checked_sub(1).ok_or(BrokenModel::TooManyNodes)?;
                if matches!(look(&mut next), Next::End) {
                    return Ok(left);
                }
            }
        }
        Ok(left)
    }

    /// The least threshold by which no more than `budget` splats are drawn, to an 8th of a pixel, from 0 to 64 px; and how
    /// many then are.
    ///
    /// # Errors
    ///
    /// What is broken in the model.
    ///
    /// # Cost
    ///
    /// Nine times that of going down the model, without drawing.
    pub fn threshold_for(&self, view: &View, screen: &PixelRect, budget: u32) -> Result<(u32, u32), BrokenModel> {
        struct Nothing;
        impl SplatSink for Nothing {
            fn splat(&mut self, _: &Splat) {}
        }
        let count = |threshold| {
            let budget = budget.saturating_add(1);
            self.draw(view, screen, Refinement { threshold, budget }, &mut Nothing)
        };
        let (mut low, mut high) = (0_u32, 64 * 8);
        while low < high {
            let middle = (low + high) / 2;
            if count(middle * 32)? > budget { low = middle + 1 } else { high = middle }
        }
        Ok((high * 32, count(high * 32)?.min(budget)))
    }
}

/// A view onto the pixels of a screen.
struct Screen<'v> {
    view: &'v View,
    /// In 1/256 px, from the middle.
    columns: (i64, i64),
    rows: (i64, i64),
    /// `near / focal`, in `2^-16`.
    nearness: i64,
}

/// A node as it is seen.
struct Seen {
    x: i64,
    y: i64,
    z: i64,
    /// `focal / z`, in `2^-20`.
    scale: i64,
    size: u32,
}

const SCALE_BITS: u32 = 20;

impl<'v> Screen<'v> {
    fn new(view: &'v View, screen: &PixelRect) -> Self {
        let [x, y] = view.middle.map(i64::from);
        let side = |range: &core::ops::Range<i32>, middle: i64| {
            (i64::from(range.start) * 256 - middle, i64::from(range.end) * 256 - middle)
        };
        let nearness = (i64::from(view.near) << 16) / i64::from(view.focal.max(1));
        Self { view, columns: side(&screen.columns, x), rows: side(&screen.rows, y), nearness }
    }

    /// None for what is not seen at all. Its `z` is 0 where it lies on both sides of the near plane.
    #[inline(always)]
    fn look(&self, sphere: &Sphere, node: &Node, inside: &mut bool, facing: &mut bool) -> Option<Seen> {
        let view = self.view;
        let ([cx, cy, cz], [ex, ey, ez]) = (sphere.centre.map(i64::from), view.eye.map(i64::from));
        let radius = i64::from(sphere.radius);
        let offset = [cx - ex, cy - ey, cz - ez];
        if !*facing && let Some(normal) = normal(node.normal) {
            // By squares: offsets have 28 bits, and so has their length.
            let [nx, ny, nz] = normal.map(i64::from);
            let away = (offset[0] * nx + offset[1] * ny + offset[2] * nz) >> 14;
            let sine = CONE_SINES.get(usize::from(node.cone)).copied().unwrap_or(16);
            if sine < 16 {
                let square = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
                let reach = (square >> 8) * i64::from(sine * sine);
                if away > radius && (away - radius) * (away - radius) > reach {
                    return None;
                }
                *facing = -away > radius && (away + radius) * (away + radius) > reach;
            }
        }
        let [x, y, z] = view.seen(offset);
        let near = i64::from(view.near);
        if z + radius < near {
            return None;
        }
        if z - radius < near {
            return Some(Seen {
                x,
                y,
                z: if z < near { 0 } else { z },
                scale: self.scale(z.max(near)),
                size: u32::MAX,
            });
        }
        let scale = self.scale(z);
        let on_screen = |length: i64| (length * scale) >> SCALE_BITS;
        let size = u32::try_from(on_screen(2 * radius)).unwrap_or(u32::MAX);
        if !*inside {
            // A sphere is seen a little larger off the middle: all of its box counts.
            let reach = i64::from(size) + 256;
            let (right, down) = (on_screen(x), on_screen(y));
            let (columns, rows) = (self.columns, self.rows);
            if right + reach < columns.0 || right - reach > columns.1 || down + reach < rows.0 || down - reach > rows.1
            {
                return None;
            }
            *inside = right - reach > columns.0
                && right + reach < columns.1
                && down - reach > rows.0
                && down + reach < rows.1;
        }
        Some(Seen { x, y, z, scale, size })
    }

    /// A focal length has 20 bits, `z` is at least 1.
    #[inline(always)]
    fn scale(&self, z: i64) -> i64 {
        let focal = u64::from(self.view.focal.unsigned_abs()) << SCALE_BITS;
        let z = z.max(1).unsigned_abs();
        let scale = match (u32::try_from(focal), u32::try_from(z)) {
            (Ok(focal), Ok(z)) => u64::from(focal / z.max(1)),
            _ => focal / z.max(1),
        };
        scale.cast_signed()
    }
}

impl Seen {
    /// None before the near plane.
    #[inline(always)]
    fn splat(&self, screen: &Screen<'_>, node: &Node) -> Option<Splat> {
        if self.z == 0 {
            return None;
        }
        let view = screen.view;
        let on_screen = |length: i64, middle: i32| {
            let at = ((length * self.scale) >> SCALE_BITS) + i64::from(middle);
            i32::try_from(at).unwrap_or(if at > 0 { i32::MAX } else { i32::MIN })
        };
        // 65536 at most, as `z` is at least `near`.
        let depth = 65535 - ((screen.nearness * self.scale) >> SCALE_BITS).min(65535);
        Some(Splat {
            x: on_screen(self.x, view.middle[0]),
            y: on_screen(self.y, view.middle[1]),
            size: self.size,
            depth: u16::try_from(depth).unwrap_or(0),
            normal: normal(node.normal)?,
            colour: node.colour,
        })
    }
}

/// Draws splats as squares, the nearer ones in front.
///
/// A square has the size of its sphere, rounded to whole pixels, at least one.
#[derive(Debug)]
pub struct Squares<'t, 'b, D, F> {
    target: &'t mut D,
    depths: &'t mut DepthBuffer<'b>,
    shade: F,
    clip: PixelRect,
}

impl<'t, 'b, D: PixelRows, F: Fn(&Splat) -> D::Color> Squares<'t, 'b, D, F> {
    /// On a target, by a buffer, in colours that `shade` makes of a splat's colour and direction.
    pub fn new(target: &'t mut D, depths: &'t mut DepthBuffer<'b>, shade: F) -> Self {
        let clip = depths.cut(target.bounding_box());
        Self { target, depths, shade, clip }
    }
}

impl<D: PixelRows, F: Fn(&Splat) -> D::Color> SplatSink for Squares<'_, '_, D, F> {
    #[inline(always)]
    fn splat(&mut self, splat: &Splat) {
        let (x, y) = (splat.x >> 8, splat.y >> 8);
        if splat.size < 384 {
            if self.depths.test(x, y, splat.depth, DepthTest::LESS)
                && let Some([pixel, ..]) = self.target.row_from(Point::new(x, y))
            {
                *pixel = (self.shade)(splat);
            }
            return;
        }
        self.square(splat);
    }
}

impl<D: PixelRows, F: Fn(&Splat) -> D::Color> Squares<'_, '_, D, F> {
    #[inline(never)]
    fn square(&mut self, splat: &Splat) {
        let size = i32::try_from(splat.size.saturating_add(128) >> 8).unwrap_or(i32::MAX);
        let first = |middle: i32| (middle.saturating_sub(size.saturating_mul(128)).saturating_add(128)) >> 8;
        let cut = |start: i32, range: &core::ops::Range<i32>| {
            start.max(range.start)..start.saturating_add(size).min(range.end)
        };
        let (rows, columns) = (cut(first(splat.y), &self.clip.rows), cut(first(splat.x), &self.clip.columns));
        if columns.is_empty() {
            return;
        }
        let colour = (self.shade)(splat);
        for row in rows {
            let span = Span { row, columns: columns.clone() };
            let kept = self.depths.row_mut(&span);
            let pixels = self.target.row_from(Point::new(columns.start, row)).unwrap_or_default();
            for (pixel, kept) in pixels.iter_mut().zip(kept) {
                if DepthTest::LESS.passes(splat.depth, kept) {
                    *pixel = colour;
                }
            }
        }
    }
}
