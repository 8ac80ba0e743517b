//! How much code there is: lines that are neither blank nor comment nor test, of the rooms that are to stay small.
//!
//! `cargo test --test source_size -- --nocapture` prints them.

mod source;

use std::{fmt::Write as _, fs, path::Path};

use source::{rust_files, shipped_code};

/// Rooms that are counted together, how many lines they are to have at most, and how many they may have until then.
struct Bar {
    rooms: &'static [&'static str],
    wanted: usize,
    allowed: usize,
}

const BARS: [Bar; 2] = [
    Bar { rooms: &["area", "coverage", "shape"], wanted: 3500, allowed: 5386 },
    Bar { rooms: &["eg"], wanted: 1000, allowed: 1854 },
];

/// Of the code that is shipped.
fn lines(code: &str) -> usize {
    code.lines().filter(|line| !line.trim().is_empty()).count()
}

#[test]
fn the_rooms_that_are_to_stay_small_do() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut table = String::from("| lines of code in | are | at most |\n|---|--:|--:|\n");
    let mut too_many = Vec::new();
    for Bar { rooms, wanted, allowed } in BARS {
        let mut all = 0;
        for room in rooms {
            let files = rust_files(&source.join(room));
            assert!(!files.is_empty(), "src/{room} has no files");
            let count: usize = files.iter().map(|file| lines(&shipped_code(&fs::read_to_string(file).unwrap()))).sum();
            if rooms.len() > 1 {
                writeln!(table, "| {room} | {count} | |").unwrap();
            }
            all += count;
        }
        let name = rooms.join(", ");
        writeln!(table, "| {name} | {all} | {wanted} |").unwrap();
        if all > allowed {
            too_many.push(format!("{name}: {all} lines, where {allowed} are allowed and {wanted} are wanted"));
        }
    }
    println!("{table}");
    assert!(too_many.is_empty(), "\n{}\n\n{table}", too_many.join("\n"));
}

#[test]
fn blank_lines_comments_and_tests_are_not_counted() {
    let text = "//! Doc.\n\nuse a::b;\n\n/// Doc.\nfn f() {\n    // why\n    g(); // here\n}\n\n/* a\nb */\n\
                #[cfg(test)]\nmod tests {\n    fn h() {}\n}\nconst S: &str = \"// not\";\n";
    assert_eq!(lines(&shipped_code(text)), 5);
}
