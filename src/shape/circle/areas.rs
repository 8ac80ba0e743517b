//! Anti-aliased circle.

use crate::{
    PixelRect,
    area::{PlacedAreaSink, Rounded, send_circle},
    coverage::CoverageSink,
    geometry::pixels_between,
    shape::{Circle, Cover},
    span::visible,
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
        Rounded::send(sink, |areas| self.areas(clip, areas))
    }
}

impl Circle {
    /// Sends the areas of the pixels in `clip`, before anything is rounded.
    pub(crate) fn areas(&self, clip: &PixelRect, sink: &mut dyn PlacedAreaSink) {
        let Some((rows, columns)) = visible(&Cover::touched(self), clip) else { return };
        let center = (self.center.x.to_bits(), self.center.y.to_bits());
        send_circle(center, self.radius.to_bits(), &rows, &columns, sink);
    }
}
