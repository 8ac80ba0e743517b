//! From a scene to a PNG file, through a simulated display.

use std::{
    path::Path,
    time::{Duration, Instant},
};

use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888},
    prelude::*,
};
use embedded_graphics_simulator::{OutputSettings, OutputSettingsBuilder, SimulatorDisplay};
use spanfill::{ActiveEdge, Circle, Fill, Line, Polygon, Triangle, Vertex};

use super::{
    cli::ColorDepth,
    scene::{Outline, Scene},
};

/// Draws the scene, writes what the display shows to `png`, and says how long the drawing took.
pub(crate) fn render(
    scene: &Scene,
    depth: ColorDepth,
    background: Rgb888,
    scale: u32,
    png: &Path,
) -> Result<Duration, Box<dyn std::error::Error>> {
    let settings = OutputSettingsBuilder::new().scale(scale).build();
    match depth {
        ColorDepth::Rgb565 => in_colour::<Rgb565>(scene, background, &settings, png),
        ColorDepth::Rgb888 => in_colour::<Rgb888>(scene, background, &settings, png),
        ColorDepth::Gray8 => in_grey::<Gray8>(scene, background, &settings, png),
        ColorDepth::Gray4 => in_grey::<Gray4>(scene, background, &settings, png),
        ColorDepth::Binary => in_grey::<BinaryColor>(scene, background, &settings, png),
    }
}

fn in_colour<C: PixelColor + From<Rgb888> + Into<Rgb888>>(
    scene: &Scene,
    background: Rgb888,
    settings: &OutputSettings,
    png: &Path,
) -> Result<Duration, Box<dyn std::error::Error>> {
    let (display, taken) = drawn::<C>(scene, background)?;
    display.to_rgb_output_image(settings).save_png(png)?;
    Ok(taken)
}

fn in_grey<C: PixelColor + From<Rgb888> + Into<Rgb888>>(
    scene: &Scene,
    background: Rgb888,
    settings: &OutputSettings,
    png: &Path,
) -> Result<Duration, Box<dyn std::error::Error>> {
    let (display, taken) = drawn::<C>(scene, background)?;
    display.to_grayscale_output_image(settings).save_png(png)?;
    Ok(taken)
}

/// A display with the scene on it. The conversions of embedded-graphics go to the nearest colour, through luma for
/// greys.
fn drawn<C: PixelColor + From<Rgb888>>(
    scene: &Scene,
    background: Rgb888,
) -> Result<(SimulatorDisplay<C>, Duration), Box<dyn std::error::Error>> {
    let mut display = SimulatorDisplay::with_default_color(scene.size, background.into());
    let mut scratch = Vec::new();
    let start = Instant::now();
    for item in &scene.items {
        let mut target = display.clipped(&item.clip);
        let colour = C::from(item.colour);
        match &item.outline {
            Outline::Triangle([a, b, c]) => Triangle::new(*a, *b, *c).filled(colour).draw(&mut target)?,
            Outline::Line([start, end]) => Line::new(*start, *end).filled(colour).draw(&mut target)?,
            Outline::Circle { center, radius } => Circle::new(*center, *radius).filled(colour).draw(&mut target)?,
            Outline::Polygon { contours, rule } => {
                let contours: Vec<&[Vertex]> = contours.iter().map(Vec::as_slice).collect();
                let polygon = Polygon::with_contours(&contours).fill_rule(*rule);
                // Not the exact number, which takes a pass over the vertices for each of their turns.
                let needed = polygon.active_edges_at_most();
                if scratch.len() < needed {
                    scratch.resize(needed, ActiveEdge::EMPTY);
                }
                polygon.in_scratch(&mut scratch)?.filled(colour).draw(&mut target)?;
            }
        }
    }
    let taken = start.elapsed();
    Ok((display, taken))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The nearest of the levels 0..=max to a value of 0..=255.
    fn nearest(value: u8, max: u32) -> u32 {
        (u32::from(value) * max * 2 + 255) / 510
    }

    #[test]
    fn colours_go_to_the_nearest_that_the_display_has() {
        for value in 0..=255 {
            let color = Rgb888::new(value, value, value);
            let rgb565 = Rgb565::from(color);
            let channels = [rgb565.r(), rgb565.g(), rgb565.b()].map(u32::from);
            assert_eq!(channels, [31, 63, 31].map(|max| nearest(value, max)), "{value}");
            assert_eq!(Gray8::from(color).luma(), value);
            assert_eq!(u32::from(Gray4::from(color).luma()), nearest(value, 15), "{value}");
            assert_eq!(BinaryColor::from(color).is_on(), value >= 128, "{value}");
        }
    }

    #[test]
    fn greys_weigh_the_channels_by_their_luma() {
        assert_eq!(Gray8::from(Rgb888::RED), Gray8::new(77));
        assert_eq!(Gray8::from(Rgb888::GREEN), Gray8::new(149));
        assert_eq!(Gray8::from(Rgb888::BLUE), Gray8::new(29));
    }
}
