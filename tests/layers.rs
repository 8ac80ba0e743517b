//! The layer map in the crate's documentation is true: every module is on it, and none names one to its right.
//!
//! The map is the lines of `src/lib.rs` with a `·` in a `text` block of the crate's documentation. From left to right,
//! a module may use those before it; modules joined by a comma share a layer and do not know each other.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

/// What a module may know, by its name: lower layers are less.
type Layers = BTreeMap<String, usize>;

/// Reads the map from the documentation of `lib.rs`.
fn layer_map(lib: &str) -> Layers {
    let documentation = lib.lines().filter_map(|line| line.trim_start().strip_prefix("//!"));
    let mut in_block = false;
    let mut layers = Layers::new();
    let mut layer = 0;
    for line in documentation {
        if line.trim_start().starts_with("```") {
            in_block = !in_block && line.trim() == "```text";
        } else if in_block && line.contains('·') {
            // A comma keeps the next name in the layer; a dot, a space or a new line starts another.
            let mut joined = false;
            for word in line.replace(',', " , ").replace('·', " ").split_whitespace() {
                if word == "," {
                    joined = true;
                    continue;
                }
                if !joined {
                    layer += 1;
                }
                joined = false;
                assert!(layers.insert(word.to_owned(), layer).is_none(), "{word} is on the map twice");
            }
        }
    }
    assert!(!layers.is_empty(), "src/lib.rs has no layer map: a line with `·` in a `text` block of its documentation");
    layers
}

/// Every Rust file under a folder.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
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

/// The modules a file lies in, from the root of the crate: `shape`, `circle` for `shape/circle.rs`.
fn module_path(file: &Path, source: &Path) -> Vec<String> {
    let mut path: Vec<String> = file
        .strip_prefix(source)
        .unwrap()
        .with_extension("")
        .components()
        .map(|component| component.as_os_str().to_str().unwrap().to_owned())
        .collect();
    if path.last().is_some_and(|last| last == "mod") {
        path.pop();
    }
    path
}

/// The code without its comments and strings, and without the modules that only tests see.
fn shipped_code(text: &str) -> String {
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

/// The names in `text`, which follows a `::`, that stand first in a path: one, or those of a braced list.
fn first_names(text: &str) -> Vec<String> {
    let name = |text: &str| {
        let text = text.trim_start();
        text.chars().take_while(|next| next.is_alphanumeric() || *next == '_').collect::<String>()
    };
    let text = text.trim_start();
    let Some(list) = text.strip_prefix('{') else { return vec![name(text)] };
    let mut names = vec![name(list)];
    let mut depth = 1;
    for (index, next) in list.char_indices() {
        depth += i32::from(next == '{') - i32::from(next == '}');
        if depth == 0 {
            break;
        }
        if depth == 1 && next == ',' {
            names.push(name(&list[index + 1..]));
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

/// Everything that a file of the module `path` names directly under the root of the crate.
fn names_at_root(code: &str, path: &[String]) -> Vec<String> {
    // `super::` leads to the root from a top-level module, `super::super::` from one within.
    let prefixes = ["crate::".to_owned(), "super::".repeat(path.len())];
    let mut names = Vec::new();
    for prefix in &prefixes {
        for (index, _) in code.match_indices(prefix.as_str()) {
            let before = &code[..index];
            let longer_path =
                before.ends_with("::") || before.ends_with(|last: char| last.is_alphanumeric() || last == '_');
            let rest = &code[index + prefix.len()..];
            if !longer_path && !rest.starts_with("super::") {
                names.extend(first_names(rest));
            }
        }
    }
    names
}

/// The modules that `lib.rs` re-exports names from, by name.
fn re_exports(lib_code: &str) -> BTreeMap<String, String> {
    let mut owners = BTreeMap::new();
    for (index, _) in lib_code.match_indices("pub use ") {
        let path = &lib_code[index + "pub use ".len()..];
        let Some((module, rest)) = path.split_once("::") else { continue };
        for name in first_names(rest) {
            owners.insert(name, module.to_owned());
        }
    }
    owners
}

/// What a module uses against the map, one line each.
fn violations(layers: &Layers, owners: &BTreeMap<String, String>, path: &[String], text: &str) -> Vec<String> {
    let module = &path[0];
    let Some(layer) = layers.get(module) else { return vec![format!("{module} is not on the layer map")] };
    let mut found = Vec::new();
    for name in names_at_root(&shipped_code(text), path) {
        let used = owners.get(&name).unwrap_or(&name);
        match layers.get(used) {
            Some(below) if below < layer || used == module => {}
            Some(_) => found.push(format!("{} uses {used}, which is not to the left of {module}", path.join("::"))),
            None => found.push(format!("{} names crate::{name}, of no module of the map", path.join("::"))),
        }
    }
    found
}

#[test]
fn no_module_uses_one_to_its_right() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let lib = fs::read_to_string(source.join("lib.rs")).unwrap();
    let (layers, owners) = (layer_map(&lib), re_exports(&shipped_code(&lib)));
    let mut found = Vec::new();
    let mut seen = Vec::new();
    for file in rust_files(&source) {
        let path = module_path(&file, &source);
        if path == ["lib"] {
            continue;
        }
        found.extend(violations(&layers, &owners, &path, &fs::read_to_string(&file).unwrap()));
        seen.push(path[0].clone());
    }
    found.extend(
        layers.keys().filter(|name| !seen.contains(name)).map(|name| format!("{name} is on the map, not in src")),
    );
    assert!(found.is_empty(), "\n{}\nthe map: {layers:?}", found.join("\n"));
}

mod the_reader {
    use super::*;

    const LIB: &str = "//! Layers:\n//! ```text\n//! Shape -> Span\n//! base · low, other · high   top\n//! ```\npub use base::{A, B as C};\n";

    fn found(path: &[&str], text: &str) -> usize {
        let path: Vec<String> = path.iter().map(|name| (*name).to_owned()).collect();
        violations(&layer_map(LIB), &re_exports(LIB), &path, text).len()
    }

    #[test]
    fn reads_the_map() {
        let layers = layer_map(LIB);
        let expected = [("base", 1), ("low", 2), ("other", 2), ("high", 3), ("top", 4)];
        assert_eq!(layers, expected.map(|(name, layer)| (name.to_owned(), layer)).into_iter().collect());
    }

    #[test]
    fn allows_what_stands_to_the_left() {
        assert_eq!(found(&["high"], "use crate::{base::{X, Y}, low, other::Z};"), 0);
        assert_eq!(found(&["low", "part"], "use super::super::base; fn f() { crate::A::new(); super::g(); }"), 0);
        assert_eq!(found(&["high", "part"], "use crate::high::Other;"), 0);
    }

    #[test]
    fn finds_what_points_to_the_right() {
        assert_eq!(found(&["low"], "use crate::high::X;"), 1);
        assert_eq!(found(&["low"], "use crate::{\n    base::X,\n    top::{Y, Z},\n};"), 1);
        assert_eq!(found(&["low"], "use crate::other::X;"), 1);
        assert_eq!(found(&["low"], "fn f() { super::high::g() }"), 1);
        assert_eq!(found(&["low", "part"], "fn f() { super::super::high::g() }"), 1);
        assert_eq!(found(&["low"], "use crate::Unknown;"), 1);
        assert_eq!(found(&["unknown"], ""), 1);
    }

    #[test]
    fn leaves_comments_strings_and_tests_alone() {
        let text = "/// See crate::top.\nconst S: &str = \"crate::top\";\n#[cfg(test)]\nmod tests { use crate::top::X; fn f() {} }\n";
        assert_eq!(found(&["low"], text), 0);
        assert_eq!(found(&["low"], &format!("{text}use crate::top::X;")), 1);
    }
}
