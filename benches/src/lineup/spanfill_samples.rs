//! spanfill with anti-aliasing by samples in place of areas. Lines have none.

use spanfill::{Circle, Polygon, Samples, Triangle, Vertex};

use crate::{
    drawing::Drawing,
    lineup::{
        point, some,
        spanfill_aa::{
            CircleFigure, CoverVisitor, Figure, FigureVisitor, IntoMask, OutlineFigure, OverFrame, Scratch,
            TriangleFigure,
        },
    },
    scenes::{Scene, circles, concave_polygons, stars, triangles},
};

/// Blended over what the frame shows.
pub(super) fn drawing(scene: Scene, samples: Samples) -> Option<Box<dyn Drawing>> {
    with_figures(scene, samples, OverFrame)
}

/// The coverage alone.
pub(super) fn mask(scene: Scene, samples: Samples) -> Option<Box<dyn Drawing>> {
    with_figures(scene, samples, IntoMask)
}

fn with_figures(scene: Scene, samples: Samples, visitor: impl FigureVisitor) -> Option<Box<dyn Drawing>> {
    Some(match scene {
        Scene::Triangles(box_px) => {
            let figures = triangles(box_px).map(|vertices| Sampled(TriangleFigure(vertices), samples));
            visitor.visit(some(scene, figures))
        }
        Scene::Circles(radius_px) => {
            let figures = circles(radius_px).map(|centre| Sampled(CircleFigure { centre, radius_px }, samples));
            visitor.visit(some(scene, figures))
        }
        Scene::Lines(_) => return None,
        Scene::Stars(radius_px) => {
            let figures = stars(radius_px).map(|outline| Sampled(OutlineFigure(outline), samples));
            visitor.visit(some(scene, figures))
        }
        Scene::Concave64(radius_px) => {
            let figures = concave_polygons(radius_px).map(|outline| Sampled(OutlineFigure(outline), samples));
            visitor.visit(some(scene, figures))
        }
    })
}

struct Sampled<F>(F, Samples);

impl Figure for Sampled<TriangleFigure> {
    #[inline]
    fn cover<V: CoverVisitor>(&self, scratch: &mut Scratch, visitor: V) {
        let Self(TriangleFigure(vertices), samples) = self;
        let [a, b, c] = vertices.map(point);
        let triangle = Triangle::new(a, b, c).supersampled_in(*samples, &mut scratch.sample_cells);
        visitor.visit(triangle.expect("there are cells"));
    }
}

impl Figure for Sampled<CircleFigure> {
    #[inline]
    fn cover<V: CoverVisitor>(&self, scratch: &mut Scratch, visitor: V) {
        let Self(CircleFigure { centre: [x, y], radius_px }, samples) = self;
        let circle = Circle::new(Vertex::new(*x, *y), *radius_px).supersampled_in(*samples, &mut scratch.sample_cells);
        visitor.visit(circle.expect("there are cells"));
    }
}

impl<const N: usize> Figure for Sampled<OutlineFigure<N>> {
    #[inline]
    fn cover<V: CoverVisitor>(&self, scratch: &mut Scratch, visitor: V) {
        let Self(OutlineFigure(outline), samples) = self;
        let outline = outline.map(|[x, y]| Vertex::from_bits(x, y));
        let Scratch { sample_edges, sample_cells, .. } = scratch;
        let polygon = Polygon::new(&outline).supersampled_in(*samples, sample_edges, sample_cells);
        visitor.visit(polygon.expect("there is enough for any outline here"));
    }
}
