//! What a figure belongs to: processor, compiler, flags, versions.

use std::{
    fmt, fs,
    path::{Path, PathBuf},
};

/// The target that this program was built for.
pub(crate) const TARGET: &str = env!("BENCH_TARGET");

const LOCK: &str = include_str!("../Cargo.lock");
const MANIFEST: &str = include_str!("../Cargo.toml");

const LIBRARIES: [&str; 6] = ["spanfill", "embedded-graphics", "tiny-skia", "vello_cpu", "zeno", "ab_glyph_rasterizer"];

/// The environment of this run.
#[derive(Debug)]
pub(crate) struct Environment {
    processor: String,
    date: String,
}

impl Environment {
    pub(crate) fn new() -> Self {
        Self { processor: processor(), date: time::OffsetDateTime::now_utc().date().to_string() }
    }

    /// The file for the rows of today, in UTC.
    pub(crate) fn record(&self, suffix: &str) -> PathBuf {
        let file = format!("{}{suffix}.csv", self.date);
        Path::new(env!("CARGO_MANIFEST_DIR")).join("record").join(TARGET).join(file)
    }
}

/// As a Markdown list.
impl fmt::Display for Environment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let flags = match env!("BENCH_RUSTFLAGS") {
            "" => "none",
            flags => flags,
        };
        writeln!(f, "- date: {}", self.date)?;
        writeln!(f, "- processor: {}", self.processor)?;
        writeln!(f, "- target: {TARGET}")?;
        writeln!(f, "- compiler: {}", env!("BENCH_RUSTC"))?;
        writeln!(f, "- release profile: {}; RUSTFLAGS: {flags}", release_profile())?;
        write!(f, "- versions: ")?;
        for (index, package) in LIBRARIES.into_iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            write!(f, "{separator}{package} {}", locked_version(package).unwrap_or("of unknown version"))?;
        }
        writeln!(f)
    }
}

fn processor() -> String {
    let model = fs::read_to_string("/proc/cpuinfo").ok().and_then(|info| {
        let line = info.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    model.unwrap_or_else(|| format!("unknown ({})", std::env::consts::ARCH))
}

fn release_profile() -> String {
    let section = MANIFEST.lines().skip_while(|line| *line != "[profile.release]").skip(1);
    let settings = section.take_while(|line| !line.starts_with('[')).filter(|line| line.contains('='));
    settings.map(str::trim).collect::<Vec<_>>().join(", ")
}

fn locked_version(package: &str) -> Option<&'static str> {
    let name = format!("name = \"{package}\"");
    let mut lines = LOCK.lines().skip_while(|line| *line != name).skip(1);
    lines.next()?.strip_prefix("version = \"")?.strip_suffix('"')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_and_profile_are_found_where_they_are_written() {
        assert_eq!(locked_version("embedded-graphics"), Some("0.8.2"));
        assert_eq!(locked_version("no-such-package"), None);
        assert!(LIBRARIES.into_iter().all(|library| locked_version(library).is_some()));
        assert_eq!(release_profile(), "debug = 1");
    }
}
