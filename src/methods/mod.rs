//! The methods that rasterization courses teach, each as it was published, to be drawn, timed and compared.

pub mod antialias;
pub mod attribute;
pub mod circle;
mod family;
pub mod line;
pub mod number;
pub mod points;
pub mod polygon;
pub mod triangle;

pub use family::{Family, Method};

/// Every method there is.
pub const FAMILIES: &[Family] = &[
    Family { name: "triangle: inside test", methods: triangle::INSIDE },
    Family { name: "triangle: traversal", methods: triangle::TRAVERSAL },
    Family { name: "shared edges", methods: triangle::SHARED },
    Family { name: "attributes", methods: attribute::METHODS },
    Family { name: "line", methods: line::METHODS },
    Family { name: "circle", methods: circle::METHODS },
    Family { name: "polygon", methods: polygon::METHODS },
    Family { name: "anti-aliasing", methods: antialias::METHODS },
    Family { name: "points", methods: points::METHODS },
];
