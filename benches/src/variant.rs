//! Who draws.

use std::{fmt, str::FromStr};

/// A way to draw a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Variant {
    /// The library that all this is about.
    Spanfill,
    /// embedded-graphics' styled primitives, on the same frame.
    EmbeddedGraphics,
    /// tiny-skia without anti-aliasing: the path is built, then filled (a line: stroked as a hairline).
    TinySkia,
    /// The same with the paths built beforehand: only what filling them takes.
    TinySkiaKeptPath,
    /// The rectangles that spanfill sends, recorded, and sent again by themselves.
    Floor,
}

impl Variant {
    /// In the order of the tables.
    pub(crate) const ALL: [Self; 5] =
        [Self::Spanfill, Self::EmbeddedGraphics, Self::TinySkia, Self::TinySkiaKeptPath, Self::Floor];

    /// Its name in tables, CSV rows and on the command line.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Spanfill => "spanfill",
            Self::EmbeddedGraphics => "embedded-graphics",
            Self::TinySkia => "tiny-skia",
            Self::TinySkiaKeptPath => "tiny-skia-kept-path",
            Self::Floor => "floor",
        }
    }
}

impl fmt::Display for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Variant {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Self::ALL
            .into_iter()
            .find(|variant| variant.name() == name)
            .ok_or_else(|| format!("no variant is called that; there are {}", Self::ALL.map(Self::name).join(", ")))
    }
}
