//! The chart: what each scene costs, in multiples of the floor.

use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, Pos, VPos},
};

use crate::{row::Rows, scenes::Scene, table::title, variant::Variant};

/// The chart's libraries, from top to bottom in each group, and their colours, which differ in lightness too.
const BARS: [(Variant, RGBColor); 3] = [
    (Variant::Spanfill, RGBColor(0x0b, 0x6e, 0x4f)),
    (Variant::TinySkia, RGBColor(0x6c, 0x9b, 0xd2)),
    (Variant::EmbeddedGraphics, RGBColor(0xe8, 0x9c, 0x31)),
];

const WIDTH: i32 = 900;
/// Where the bars start.
const LEFT: i32 = 230;
/// Room for the figure behind the longest bar.
const RIGHT: i32 = 70;
const TOP: i32 = 86;
const BOTTOM: i32 = 56;
const BAR: i32 = 15;
const GROUP_GAP: i32 = 13;

const INK: RGBColor = RGBColor(0x22, 0x26, 0x2b);
const PALE: RGBColor = RGBColor(0x6b, 0x72, 0x7b);
const GRID: RGBColor = RGBColor(0xdd, 0xe0, 0xe4);

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

/// The chart as SVG.
pub(crate) fn svg(rows: &Rows) -> Result<String, Box<dyn std::error::Error>> {
    let groups: Vec<(Scene, Vec<Bar>)> = rows.scenes().map(|scene| (scene, bars(rows, scene))).collect();
    let height = TOP + BOTTOM + groups.iter().map(|(_, bars)| group_height(bars)).sum::<i32>();
    let longest = groups.iter().flat_map(|(_, bars)| bars).map(|bar| bar.times).fold(2.0, f64::max);
    let shortest = groups.iter().flat_map(|(_, bars)| bars).map(|bar| bar.times).fold(1.0, f64::min);
    let scale = Scale { shortest, longest };
    let mut svg = String::new();
    {
        let canvas =
            SVGBackend::with_string(&mut svg, (WIDTH.unsigned_abs(), height.unsigned_abs())).into_drawing_area();
        canvas.fill(&WHITE)?;
        draw_head(&canvas)?;
        draw_grid(&canvas, scale, height - BOTTOM)?;
        let mut top = TOP;
        for (scene, bars) in &groups {
            draw_group(&canvas, scale, *scene, bars, top)?;
            top += group_height(bars);
        }
        canvas.present()?;
    }
    Ok(svg)
}

#[derive(Debug, Clone, Copy)]
struct Bar {
    variant: Variant,
    colour: RGBColor,
    /// Of the floor's cost.
    times: f64,
}

fn bars(rows: &Rows, scene: Scene) -> Vec<Bar> {
    let bar = |(variant, colour)| Some(Bar { variant, colour, times: rows.ratio(scene, variant, Variant::Floor)? });
    BARS.into_iter().filter_map(bar).collect()
}

fn group_height(bars: &[Bar]) -> i32 {
    BAR * i32::try_from(bars.len()).unwrap_or(0) + GROUP_GAP
}

/// Logarithmic, around once the floor's cost.
#[derive(Debug, Clone, Copy)]
struct Scale {
    /// At most 1.
    shortest: f64,
    longest: f64,
}

impl Scale {
    fn x(self, times: f64) -> i32 {
        let share = (times / self.shortest).ln() / (self.longest / self.shortest).ln();
        LEFT + (share * f64::from(WIDTH - RIGHT - LEFT)).round() as i32
    }
}

fn text(size: i32, colour: RGBColor, horizontal: HPos) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&colour).pos(Pos::new(horizontal, VPos::Center))
}

fn draw_head(canvas: &Canvas<'_>) -> Drawn {
    canvas.draw(&Text::new(
        "What a shape costs, in multiples of filling its pixels",
        (20, 26),
        text(21, INK, HPos::Left),
    ))?;
    let mut x = 20;
    for (variant, colour) in BARS {
        canvas.draw(&Rectangle::new([(x, 51), (x + 14, 65)], colour.filled()))?;
        canvas.draw(&Text::new(variant.name(), (x + 21, 58), text(15, INK, HPos::Left)))?;
        x += 21 + 9 * i32::try_from(variant.name().len()).unwrap_or(0) + 18;
    }
    Ok(())
}

fn draw_grid(canvas: &Canvas<'_>, scale: Scale, bottom: i32) -> Drawn {
    let marks = [0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0];
    for times in marks.into_iter().filter(|times| (scale.shortest..=scale.longest).contains(times)) {
        let x = scale.x(times);
        let colour = if times == 1.0 { INK } else { GRID };
        canvas.draw(&PathElement::new([(x, TOP - 6), (x, bottom)], colour))?;
        canvas.draw(&Text::new(format!("{times}x"), (x, bottom + 14), text(13, PALE, HPos::Center)))?;
    }
    let note = "logarithmic; 1x: the same rectangles, recorded, through slice::fill; lower is better";
    canvas.draw(&Text::new(note, (LEFT, bottom + 38), text(13, PALE, HPos::Left)))?;
    Ok(())
}

fn draw_group(canvas: &Canvas<'_>, scale: Scale, scene: Scene, bars: &[Bar], top: i32) -> Drawn {
    let middle = top + BAR * i32::try_from(bars.len()).unwrap_or(0) / 2;
    canvas.draw(&Text::new(title(scene), (LEFT - 12, middle), text(14, INK, HPos::Right)))?;
    for (bar, y) in bars.iter().zip((top..).step_by(BAR as usize)) {
        let end = scale.x(bar.times);
        let (left, right) = (end.min(scale.x(1.0)), end.max(scale.x(1.0)));
        canvas.draw(&Rectangle::new([(left, y), (right, y + BAR - 2)], bar.colour.filled()))?;
        let figure = format!("{:.*}x", if bar.times < 10.0 { 2 } else { 1 }, bar.times);
        let colour = if bar.variant == Variant::Spanfill { INK } else { PALE };
        canvas.draw(&Text::new(figure, (right + 6, y + (BAR - 2) / 2), text(12, colour, HPos::Left)))?;
    }
    Ok(())
}
