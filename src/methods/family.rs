//! What a method is called, and what it is charted with.

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
