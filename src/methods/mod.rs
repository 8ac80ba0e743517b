//! The methods that rasterization courses teach, each as it was published, to be drawn, timed and compared.

pub mod antialias;
pub mod attribute;
pub mod circle;
pub mod line;
pub mod number;
pub mod points;
pub mod polygon;
pub mod triangle;

/// A method of the literature, as it is charted: its name, its options, and who published it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Method {
    /// The usual name.
    pub name: &'static str,
    /// What can be chosen; `""` alone where nothing can.
    pub options: &'static [&'static str],
    /// Author, title, year.
    pub source: &'static str,
}

/// Methods that draw the same thing, and are charted together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Family {
    /// What they draw.
    pub name: &'static str,
    /// The methods.
    pub methods: &'static [Method],
}

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
