//! From a scene to a PNG file, through a simulated display.

use std::{
    path::Path,
    time::{Duration, Instant},
};

use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use embedded_graphics_simulator::{OutputSettings, OutputSettingsBuilder, SimulatorDisplay};
use spanfill::Mix;

use super::{
    cli::{Args, ColorDepth},
    paint::{Scratch, Window, paint},
    scene::Scene,
};

/// Draws the scene, writes what a part of the display shows to `png`, and says how long the drawing took.
pub(crate) fn render(
    scene: &Scene,
    args: &Args,
    part: &Rectangle,
    png: &Path,
) -> Result<Duration, Box<dyn std::error::Error>> {
    let settings = OutputSettingsBuilder::new().scale(args.scale.get()).build();
    match args.color {
        ColorDepth::Rgb565 => in_colour::<Rgb565>(scene, args, part, &settings, png),
        ColorDepth::Rgb888 => in_colour::<Rgb888>(scene, args, part, &settings, png),
        ColorDepth::Gray8 => in_grey::<Gray8>(scene, args, part, &settings, png),
        ColorDepth::Gray4 => in_grey::<Gray4>(scene, args, part, &settings, png),
        ColorDepth::Binary => in_grey::<BinaryColor>(scene, args, part, &settings, png),
    }
}

fn in_colour<C: Mix + From<Rgb888> + Into<Rgb888>>(
    scene: &Scene,
    args: &Args,
    part: &Rectangle,
    settings: &OutputSettings,
    png: &Path,
) -> Result<Duration, Box<dyn std::error::Error>> {
    let (display, taken) = drawn::<C>(scene, args)?;
    cropped(display, part)?.to_rgb_output_image(settings).save_png(png)?;
    Ok(taken)
}

fn in_grey<C: Mix + From<Rgb888> + Into<Rgb888>>(
    scene: &Scene,
    args: &Args,
    part: &Rectangle,
    settings: &OutputSettings,
    png: &Path,
) -> Result<Duration, Box<dyn std::error::Error>> {
    let (display, taken) = drawn::<C>(scene, args)?;
    cropped(display, part)?.to_grayscale_output_image(settings).save_png(png)?;
    Ok(taken)
}

/// A display with the scene on it. The conversions of embedded-graphics go to the nearest colour, through luma for
/// greys.
fn drawn<C: Mix + From<Rgb888>>(
    scene: &Scene,
    args: &Args,
) -> Result<(SimulatorDisplay<C>, Duration), Box<dyn std::error::Error>> {
    let mut display = SimulatorDisplay::with_default_color(scene.size, args.background.into());
    let mut scratch = Scratch::default();
    let start = Instant::now();
    for item in &scene.items {
        let part = display.bounding_box().intersection(&item.clip);
        let mut window = Window { display: &mut display, part };
        paint(item, args.aa, &mut window, &mut scratch)?;
    }
    let taken = start.elapsed();
    Ok((display, taken))
}

fn cropped<C: PixelColor>(
    display: SimulatorDisplay<C>,
    part: &Rectangle,
) -> Result<SimulatorDisplay<C>, Box<dyn std::error::Error>> {
    if *part == display.bounding_box() {
        return Ok(display);
    }
    let first = display.get_pixel(part.top_left);
    let mut detail = SimulatorDisplay::with_default_color(part.size, first);
    detail.fill_contiguous(&Rectangle::new(Point::zero(), part.size), part.points().map(|p| display.get_pixel(p)))?;
    Ok(detail)
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
