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

    /// spanfill without anti-aliasing, among those that have it: the quickest and the least accurate.
    Aliased,
    /// Exact coverage, blended over what the frame shows.
    AntiAliased,
    /// Exact coverage, blended over a background that is known.
    AntiAliasedOver,
    /// Exact coverage, into a mask, as [`Variant::Zeno`] and [`Variant::AbGlyph`] have it.
    Mask,
    /// The spans and runs that spanfill sends, recorded, and blended again by themselves.
    BlendFloor,
    /// Coverage by 4 x 4 samples of each pixel in place of its area, blended as [`Variant::AntiAliased`] is.
    Samples4,
    /// By 4 x 4 samples, those nearer to the pixel's centre counting for more.
    SamplesWeighted,
    /// By 16 x 16 samples.
    Samples16,
    /// tiny-skia with anti-aliasing.
    TinySkiaAntiAliased,
    /// vello_cpu, hundreds of shapes in each picture that it renders: its best.
    Vello,
    /// The same by the instructions that every processor of the target has, which is what spanfill is compiled for.
    VelloBaseline,
    /// vello_cpu, each shape rendered by itself onto what the picture shows.
    VelloAlone,
    /// zeno, into a mask.
    Zeno,
    /// ab_glyph_rasterizer, into a mask.
    AbGlyph,
}

impl Variant {
    /// Those that set pixels or leave them, in the order of the tables.
    pub(crate) const ALIASED: [Self; 5] =
        [Self::Spanfill, Self::EmbeddedGraphics, Self::TinySkia, Self::TinySkiaKeptPath, Self::Floor];

    /// Those that are held to the exact area, in the order of the tables.
    pub(crate) const ANTI_ALIASED: [Self; 14] = [
        Self::Aliased,
        Self::AntiAliased,
        Self::AntiAliasedOver,
        Self::Mask,
        Self::BlendFloor,
        Self::Samples4,
        Self::SamplesWeighted,
        Self::Samples16,
        Self::TinySkiaAntiAliased,
        Self::Vello,
        Self::VelloBaseline,
        Self::VelloAlone,
        Self::Zeno,
        Self::AbGlyph,
    ];

    fn all() -> impl Iterator<Item = Self> {
        Self::ALIASED.into_iter().chain(Self::ANTI_ALIASED)
    }

    /// Their names.
    pub(crate) fn list(variants: &[Self]) -> String {
        variants.iter().map(|variant| variant.name()).collect::<Vec<_>>().join(", ")
    }

    /// Its name in tables, CSV rows and on the command line.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Spanfill => "spanfill",
            Self::EmbeddedGraphics => "embedded-graphics",
            Self::TinySkia => "tiny-skia",
            Self::TinySkiaKeptPath => "tiny-skia-kept-path",
            Self::Floor => "floor",
            Self::Aliased => "spanfill-aliased",
            Self::AntiAliased => "spanfill-aa",
            Self::AntiAliasedOver => "spanfill-aa-over",
            Self::Mask => "spanfill-mask",
            Self::BlendFloor => "blend-floor",
            Self::Samples4 => "spanfill-4x4",
            Self::SamplesWeighted => "spanfill-weighted",
            Self::Samples16 => "spanfill-16x16",
            Self::TinySkiaAntiAliased => "tiny-skia-aa",
            Self::Vello => "vello-cpu",
            Self::VelloBaseline => "vello-cpu-baseline",
            Self::VelloAlone => "vello-cpu-alone",
            Self::Zeno => "zeno-mask",
            Self::AbGlyph => "ab-glyph-mask",
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
        let named = Self::all().find(|variant| variant.name() == name);
        named.ok_or_else(|| {
            let all: Vec<Self> = Self::all().collect();
            format!("no variant is called that; there are {}", Self::list(&all))
        })
    }
}
