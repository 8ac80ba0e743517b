//! Time a frame against the size of primitives.

use plotters::prelude::*;

use crate::surface::Measured;

const COLOURS: [RGBColor; 3] = [RGBColor(0x2f, 0x6f, 0xb0), RGBColor(0xc0, 0x5a, 0x12), RGBColor(0x0b, 0x6e, 0x4f)];

pub(crate) fn svg(lines: &[(&str, Vec<Measured>); 3]) -> Result<String, Box<dyn std::error::Error>> {
    let all = || lines.iter().flat_map(|(_, line)| line);
    let bounds = |of: fn(&Measured) -> f64| {
        all().map(of).fold((f64::INFINITY, 0_f64), |(low, high), value| (low.min(value), high.max(value)))
    };
    // One size for all: that of the triangles between the same points.
    let [(_, triangles), ..] = lines;
    let sizes = || triangles.iter().map(|m| m.pixels_each);
    let (small, large) = sizes().fold((f64::INFINITY, 0_f64), |(low, high), size| (low.min(size), high.max(size)));
    let (fast, slow) = bounds(|m| m.ms);
    let mut svg = String::new();
    {
        let canvas = SVGBackend::with_string(&mut svg, (900, 520)).into_drawing_area();
        canvas.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&canvas)
            .caption("One surface on 640 x 480: triangles against splats", ("sans-serif", 20))
            .margin(16)
            .x_label_area_size(48)
            .y_label_area_size(64)
            // Smaller to the right: more of them.
            .build_cartesian_2d((large * 1.2..small / 1.2).log_scale(), (fast / 1.3..slow * 1.3).log_scale())?;
        chart
            .configure_mesh()
            .x_desc("pixels of the picture for each triangle between the surface's points (log)")
            .y_desc("ms a frame (log)")
            .light_line_style(RGBColor(0xf1, 0xf2, 0xf4))
            .bold_line_style(RGBColor(0xe2, 0xe5, 0xe8))
            .x_label_formatter(&|value| format!("{value}"))
            .draw()?;
        for ((name, line), colour) in lines.iter().zip(COLOURS) {
            let points: Vec<(f64, f64)> = sizes().zip(line.iter().map(|m| m.ms)).collect();
            chart
                .draw_series([PathElement::new(points.clone(), colour.stroke_width(2))])?
                .label(*name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
            chart.draw_series(points.iter().map(|point| Circle::new(*point, 4, colour.filled())))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE)
            .border_style(RGBColor(0xe2, 0xe5, 0xe8))
            .draw()?;
        canvas.present()?;
    }
    Ok(svg)
}
