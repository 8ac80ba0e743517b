//! The library's source as text.

use std::{
    fs,
    path::{Path, PathBuf},
};

/// Every Rust file under a folder.
pub(crate) fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The code without its comments and strings, and without the modules that only tests see.
pub(crate) fn shipped_code(text: &str) -> String {
    let mut code = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let skipped = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if first == '"' {
            let mut escaped = false;
            let end = rest[1..].find(|next| {
                let ends = next == '"' && !escaped;
                escaped = next == '\\' && !escaped;
                ends
            });
            end.map_or(rest.len(), |end| end + 2)
        } else {
            code.push(first);
            first.len_utf8()
        };
        rest = &rest[skipped..];
    }
    while let Some(start) = code.find("#[cfg(test)]") {
        // Up to the end of the item: a brace that closes, or a semicolon before any opens.
        let mut depth = 0;
        let end = code[start..].find(|next| {
            depth += i32::from(next == '{') - i32::from(next == '}');
            depth == 0 && (next == '}' || next == ';')
        });
        code.replace_range(start..end.map_or(code.len(), |end| start + end + 1), "");
    }
    code
}
