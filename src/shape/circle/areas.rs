//! Anti-aliased circle.

use crate::{
    PixelRect,
    area::{PlacedAreaSink, Rounded, send_circle},
    coverage::CoverageSink,
    geometry::pixels_between,
    shape::{Circle, Cover},
    span::clip_range,
};

impl Cover for Circle {
    #[inline]
    fn touched(&self) -> PixelRect {
        let radius = i64::from(self.radius.to_bits());
        if radius <= 0 {
            return PixelRect { rows: 0..0, columns: 0..0 };
        }
        let pixels = |center: i32| pixels_between(i64::from(center) - radius, i64::from(center) + radius);
        PixelRect { rows: pixels(self.center.y.to_bits()), columns: pixels(self.center.x.to_bits()) }
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let mut rounded = Rounded::new(sink);
        self.areas(clip, &mut rounded);
        rounded.result
    }
}

impl Circle {
    /// Sends the areas of the pixels in `clip`, before anything is rounded.
    pub(crate) fn areas(&self, clip: &PixelRect, sink: &mut dyn PlacedAreaSink) {
        let pixels = Cover::touched(self);
        let rows = clip_range(&pixels.rows, &clip.rows);
        let columns = clip_range(&pixels.columns, &clip.columns);
        if rows.is_empty() || columns.is_empty() {
            return;
        }
        let center = (self.center.x.to_bits(), self.center.y.to_bits());
        send_circle(center, self.radius.to_bits(), &rows, &columns, sink);
    }
}
