//! Where the tests of the methods draw: pictures, looked at through a window.

mod pictures;

use spanfill::PixelRect;

use crate::variants::{Picture, Variant, WIDTH};

/// What a variant drew in a window.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Drawn {
    pub(crate) window: PixelRect,
    /// Row by row, how often each pixel came.
    pub(crate) counts: Vec<u16>,
    /// What it last came with.
    pub(crate) coverage: Vec<u8>,
    pub(crate) visited: u64,
}

impl Drawn {
    /// Draws, clipped to a window of the screen; panics if anything comes that lies outside of it.
    ///
    /// None if the variant cannot draw such a shape; then nothing came.
    pub(crate) fn new<S: ?Sized>(variant: &Variant<S>, shape: &S, window: &PixelRect) -> Option<Self> {
        let mut picture = pictures::picture();
        let outcome = (variant.check)(shape, window, &mut picture);
        let at = |row: i32| {
            let index = |column: i32| (row * WIDTH + column) as usize;
            index(window.columns.start)..index(window.columns.end)
        };
        let (mut counts, mut coverage) = (Vec::new(), Vec::new());
        for row in window.rows.clone() {
            counts.extend_from_slice(&picture.count[at(row)]);
            coverage.extend_from_slice(&picture.coverage[at(row)]);
            picture.count[at(row)].fill(0);
            picture.coverage[at(row)].fill(0);
        }
        let name = format!("{}, {}", variant.method, variant.option);
        let is_outside = picture.outside > 0 || picture.count.iter().any(|count| *count > 0);
        let visited = picture.visited;
        (picture.visited, picture.outside) = (0, 0);
        if is_outside {
            *picture = Picture::new();
            panic!("{name}: drew outside of {window:?}");
        }
        if outcome.is_err() {
            assert!(counts.iter().all(|count| *count == 0) && visited == 0, "{name}: refused, but drew");
            return None;
        }
        Some(Self { window: window.clone(), counts, coverage, visited })
    }

    pub(crate) fn pixels(&self) -> impl Iterator<Item = (i32, i32)> {
        let columns = self.window.columns.clone();
        self.window.rows.clone().flat_map(move |row| columns.clone().map(move |column| (column, row)))
    }
}

/// The list of variants is the list of methods and options, and the crate's own at its end.
pub(crate) fn assert_complete<S: ?Sized>(family: &str, variants: &[Variant<S>]) {
    let methods = spanfill::methods::FAMILIES.iter().find(|there| there.name == family).unwrap().methods;
    let expected: Vec<_> =
        methods.iter().flat_map(|method| method.options.iter().map(|option| (method.name, *option))).collect();
    let listed: Vec<_> = variants.iter().map(|variant| (variant.method, variant.option)).collect();
    assert!(variants.iter().all(|variant| variant.family == family));
    let own = listed.iter().position(|(method, _)| *method == "spanfill").expect("the crate's own");
    assert_eq!(listed[..own], expected);
    assert!(own < listed.len() && listed[own..].iter().all(|(method, _)| *method == "spanfill"));
    assert!(methods.iter().all(|method| !method.source.is_empty()));
}
