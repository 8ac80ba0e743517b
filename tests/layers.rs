//! The layer map in the crate's documentation is true: every module is on it, and none names one to its right. Within a
//! folder, no modules use each other in a circle.
//!
//! The map is the lines of `src/lib.rs` with a `·` in a `text` block of the crate's documentation. From left to right,
//! a module may use those before it; modules joined by a comma share a layer and do not know each other.

mod source;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use source::{rust_files, shipped_code};

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

/// What a module uses against the map, one line each.
fn violations(layers: &Layers, root: &Room, path: &[String], text: &str) -> Vec<String> {
    let module = &path[0];
    let Some(layer) = layers.get(module) else { return vec![format!("{module} is not on the layer map")] };
    let mut found = Vec::new();
    for named in paths_from_root(&shipped_code(text), path) {
        let Some(name) = named.first() else { continue };
        let used = root.owners.get(name).unwrap_or(name);
        match layers.get(used) {
            Some(below) if below < layer || used == module => {}
            Some(_) => found.push(format!("{} uses {used}, which is not to the left of {module}", path.join("::"))),
            None => found.push(format!("{} names crate::{name}, of no module of the map", path.join("::"))),
        }
    }
    found.sort();
    found.dedup();
    found
}

#[test]
fn no_module_uses_one_to_its_right() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let lib = fs::read_to_string(source.join("lib.rs")).unwrap();
    let (layers, root) = (layer_map(&lib), Room::declared(&shipped_code(&lib)));
    let mut found = Vec::new();
    let mut seen = Vec::new();
    for file in rust_files(&source) {
        let path = module_path(&file, &source);
        if path == ["lib"] {
            continue;
        }
        found.extend(violations(&layers, &root, &path, &fs::read_to_string(&file).unwrap()));
        seen.push(path[0].clone());
    }
    found.extend(
        layers.keys().filter(|name| !seen.contains(name)).map(|name| format!("{name} is on the map, not in src")),
    );
    assert!(found.is_empty(), "\n{}\nthe map: {layers:?}", found.join("\n"));
}

/// A folder: what its `mod.rs` declares and re-exports, and what each of its modules uses of the others.
#[derive(Debug, Default)]
struct Room {
    children: BTreeSet<String>,
    /// The module that a name which `mod.rs` re-exports is from.
    owners: BTreeMap<String, String>,
    uses: BTreeMap<String, BTreeSet<String>>,
}

/// What `mod.rs` defines itself, as a module of its room.
const ITSELF: &str = "mod";

impl Room {
    fn declared(mod_code: &str) -> Self {
        let mut room = Self::default();
        for item in mod_code.split([';', '}']) {
            let words: Vec<&str> = item.split_whitespace().collect();
            if let [.., "mod", name] = words[..] {
                room.children.insert(name.to_owned());
            }
        }
        for (tree, is_public) in use_trees(mod_code) {
            for path in expanded(tree).into_iter().filter(|_| is_public) {
                if let [child, .., name] = &path[..] {
                    room.owners.insert(name.clone(), child.clone());
                }
            }
        }
        room.owners.retain(|_, child| room.children.contains(child));
        room
    }

    /// The module that a path from this room on leads to.
    fn module_of(&self, path: &[String]) -> String {
        let Some(first) = path.first() else { return ITSELF.to_owned() };
        if self.children.contains(first) {
            return first.clone();
        }
        self.owners.get(first).cloned().unwrap_or_else(|| ITSELF.to_owned())
    }

    /// A circle of modules that use each other, if there is one.
    fn circle(&self) -> Option<Vec<&str>> {
        fn search<'r>(room: &'r Room, done: &mut BTreeSet<&'r str>, way: &mut Vec<&'r str>) -> Option<Vec<&'r str>> {
            let last = *way.last()?;
            for next in room.uses.get(last).into_iter().flatten() {
                if let Some(start) = way.iter().position(|module| module == next) {
                    return Some(way[start..].to_vec());
                }
                if !done.contains(next.as_str()) {
                    way.push(next);
                    if let Some(circle) = search(room, done, way) {
                        return Some(circle);
                    }
                    way.pop();
                }
            }
            done.insert(last);
            None
        }
        let mut done = BTreeSet::new();
        self.uses.keys().find_map(|module| search(self, &mut done, &mut vec![module]))
    }
}

/// What follows each `use`, and whether it is re-exported.
fn use_trees(code: &str) -> Vec<(&str, bool)> {
    let starts = code
        .match_indices("use ")
        .filter(|(index, _)| !code[..*index].ends_with(|last: char| last.is_alphanumeric() || last == '_'));
    starts
        .map(|(index, word)| {
            let tree = &code[index + word.len()..];
            let before = code[..index].trim_end();
            let is_public = before.ends_with("pub") || before.ends_with(')') && before.contains("pub(");
            (&tree[..tree.find(';').unwrap_or(tree.len())], is_public)
        })
        .collect()
}

/// The paths of a `use` tree, or of what follows a `::` anywhere: `a::{b, c::D}` is `a::b` and `a::c::D`.
fn expanded(tree: &str) -> Vec<Vec<String>> {
    let tree = tree.trim_start();
    if let Some(list) = tree.strip_prefix('{') {
        let (mut depth, mut start, mut paths) = (1, 0, Vec::new());
        for (index, next) in list.char_indices() {
            depth += i32::from(next == '{') - i32::from(next == '}');
            if depth == 0 || depth == 1 && next == ',' {
                paths.extend(expanded(&list[start..index]));
                start = index + 1;
            }
            if depth == 0 {
                break;
            }
        }
        return paths;
    }
    let name: String = tree.chars().take_while(|next| next.is_alphanumeric() || *next == '_').collect();
    let rest = &tree[name.len()..];
    match rest.trim_start().strip_prefix("::") {
        _ if name.is_empty() => Vec::new(),
        Some(rest) => {
            let mut paths = expanded(rest);
            if paths.is_empty() {
                paths.push(Vec::new());
            }
            paths.iter_mut().for_each(|path| path.insert(0, name.clone()));
            paths
        }
        None => vec![vec![name]],
    }
}

/// Every path that a file of the module `path` names, from the root of the crate.
fn paths_from_root(code: &str, path: &[String]) -> Vec<Vec<String>> {
    let trees = use_trees(code);
    let mut named: Vec<Vec<String>> = trees.iter().flat_map(|(tree, _)| expanded(tree)).collect();
    let mut rest = code.to_owned();
    for (tree, _) in trees {
        rest = rest.replace(tree, "");
    }
    for prefix in ["crate::", "super::"] {
        for (index, _) in rest.match_indices(prefix) {
            if !rest[..index].ends_with(|last: char| last.is_alphanumeric() || "_:".contains(last)) {
                named.extend(expanded(&rest[index..]));
            }
        }
    }
    let absolute = |named: Vec<String>| {
        let mut found = match named.first()?.as_str() {
            "crate" => Vec::new(),
            "super" | "self" => path.to_vec(),
            _ => return None,
        };
        for name in named {
            match name.as_str() {
                "crate" | "self" => {}
                "super" => _ = found.pop(),
                _ => found.push(name),
            }
        }
        Some(found)
    };
    named.into_iter().filter_map(absolute).collect()
}

/// What `mod.rs` uses of its own modules: what it names, but for what it declares and re-exports.
fn used_by_mod(code: &str, children: &BTreeSet<String>) -> BTreeSet<String> {
    let mut rest = code.to_owned();
    for (tree, is_public) in use_trees(code) {
        if is_public {
            rest = rest.replace(tree, "");
        }
    }
    let names = |child: &&String| {
        let path = format!("{child}::");
        let starts =
            |index: usize| !rest[..index].ends_with(|last: char| last.is_alphanumeric() || "_:".contains(last));
        rest.match_indices(&path).any(|(index, _)| starts(index))
    };
    children.iter().filter(names).cloned().collect()
}

/// The rooms by their paths; the root of the crate is one.
fn rooms(files: &[(Vec<String>, String)]) -> BTreeMap<Vec<String>, Room> {
    let code_of = |path: &[String]| files.iter().find(|(other, _)| other == path).map(|(_, text)| shipped_code(text));
    let mut rooms = BTreeMap::new();
    rooms.insert(Vec::new(), Room::declared(&code_of(&["lib".to_owned()]).unwrap_or_default()));
    for (path, _) in files {
        for length in 1..path.len() {
            let room = &path[..length];
            rooms.entry(room.to_vec()).or_insert_with(|| Room::declared(&code_of(room).unwrap_or_default()));
        }
    }
    for (path, text) in files {
        let code = shipped_code(text);
        for mut used in paths_from_root(&code, path) {
            // Through what the rooms on the way re-export.
            for length in 0..used.len() {
                let Some(room) = rooms.get(&used[..length]) else { break };
                let module = room.module_of(&used[length..]);
                if module != ITSELF && used[length] != module {
                    used.insert(length, module);
                }
            }
            let common = path.iter().zip(&used).take_while(|(a, b)| a == b).count();
            // A room by itself is only named in `pub(in crate::room)`.
            let Some(room) = rooms.get_mut(&path[..common]).filter(|_| common < used.len()) else { continue };
            let user = path.get(common).cloned().unwrap_or_else(|| ITSELF.to_owned());
            let module = room.module_of(&used[common..]);
            if user != module {
                room.uses.entry(user).or_default().insert(module);
            }
        }
        if let Some(room) = rooms.get_mut(path) {
            let used = used_by_mod(&code, &room.children);
            room.uses.entry(ITSELF.to_owned()).or_default().extend(used);
        }
    }
    rooms
}

/// Circles that are still to be dissolved: the room, and who should not use whom in it.
const NOT_YET: [(&str, &str, &str); 3] =
    [("area", "sweep", "fill"), ("path", "arc", "element"), ("shape::polygon", "waiting", "active")];

#[test]
fn no_modules_of_a_folder_use_each_other_in_a_circle() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = rust_files(&source).into_iter();
    let files: Vec<_> = files.map(|file| (module_path(&file, &source), fs::read_to_string(&file).unwrap())).collect();
    let mut rooms = rooms(&files);
    for (path, user, used) in NOT_YET {
        let room: Vec<String> = path.split("::").map(str::to_owned).collect();
        let uses = rooms.get_mut(&room).and_then(|room| room.uses.get_mut(user));
        let is_there = uses.is_some_and(|uses| uses.remove(used));
        assert!(is_there, "{path}::{user} no longer uses {used}: take it off the list");
    }
    assert!(rooms.len() > 10 && rooms.values().filter(|room| room.uses.len() > 3).count() > 10, "{rooms:?}");
    let circles: Vec<String> = rooms
        .iter()
        // The root is what the map is about.
        .filter(|(path, _)| !path.is_empty())
        .filter_map(|(path, room)| Some(format!("{}: {}", path.join("::"), room.circle()?.join(" -> "))))
        .collect();
    assert!(circles.is_empty(), "\n{}", circles.join("\n"));
}

mod the_reader {
    use super::*;

    const LIB: &str = "//! Layers:\n//! ```text\n//! Shape -> Span\n//! base · low, other · high   top\n//! ```\nmod base;\npub use base::{A, B as C};\n";

    fn found(path: &[&str], text: &str) -> usize {
        let path: Vec<String> = path.iter().map(|name| (*name).to_owned()).collect();
        violations(&layer_map(LIB), &Room::declared(LIB), &path, text).len()
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

    fn circle_of(files: &[(&str, &str)]) -> Option<String> {
        let path = |name: &str| name.split('/').map(str::to_owned).collect();
        let files: Vec<_> = files.iter().map(|(name, text)| (path(name), (*text).to_owned())).collect();
        rooms(&files).values().find_map(|room| Some(room.circle()?.join(" ")))
    }

    const ROOM: &str = "mod a; mod b; mod c; pub use a::A; pub(crate) use b::{B, make as build}; pub trait Own {}";

    #[test]
    fn finds_circles_in_a_folder() {
        let lib = ("lib", "mod high; pub use high::{A, B};");
        let found =
            |a: &str, b: &str, c: &str| circle_of(&[lib, ("high", ROOM), ("high/a", a), ("high/b", b), ("high/c", c)]);
        assert_eq!(found("", "use super::a;", "use crate::{high::{a::X, b}};"), None);
        assert_eq!(
            found("use crate::high::c::X;", "use super::A;", "use crate::{low, high::{B, Own}};").unwrap(),
            "a c b"
        );
        assert_eq!(found("fn f() { crate::B::new() }", "use crate::high::A;", "").unwrap(), "a b");
        assert_eq!(found("// crate::high::b", "use super::{Own, a::X};", ""), None);
    }

    #[test]
    fn finds_circles_through_folders_and_their_mod_file() {
        let lib = ("lib", "mod high;");
        let deep = ("high/a/deep", "use super::super::c::X;");
        let found =
            |room: &str, c: &str| circle_of(&[lib, ("high", room), ("high/a", "mod deep;"), deep, ("high/c", c)]);
        assert_eq!(found(ROOM, ""), None);
        assert_eq!(found(ROOM, "use crate::high::a::deep;").unwrap(), "a c");
        assert_eq!(found(ROOM, "use super::Own;"), None);
        assert_eq!(found(&format!("{ROOM} fn f() {{ c::g() }}"), "use super::Own;").unwrap(), "c mod");
    }
}
