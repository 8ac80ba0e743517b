//! The `render` example, as a program that is run: what it draws, what it says, and how it fails.
//!
//! Its modules' own tests run here too: cargo does not run those of an example.

#[path = "../examples/render/main.rs"]
#[allow(dead_code, reason = "the program is started below; here only its modules' tests are of use")]
mod render;

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output},
    sync::{
        LazyLock,
        atomic::{AtomicUsize, Ordering},
    },
    time::SystemTime,
};

use embedded_graphics::pixelcolor::{Gray4, Gray8, Rgb565, Rgb888, RgbColor};
use image::RgbImage;

/// The example's executable. `cargo test` has built it; `cargo test --test render` has not, or not lately.
static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
    // target/<profile>/deps/render-<hash>
    let this = std::env::current_exe().expect("the path of this test");
    let profile = this.ancestors().nth(2).expect("a folder for the profile");
    let program = profile.join("examples").join(format!("render{}", std::env::consts::EXE_SUFFIX));

    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let sources =
        ["src", "examples/render", "examples/assets/world.svg"].map(|path| last_change_in(&package.join(path)));
    let built = fs::metadata(&program).and_then(|metadata| metadata.modified());
    if built.is_ok_and(|built| sources.iter().all(|&source| source <= built)) {
        return program;
    }
    let name = profile.file_name().and_then(|name| name.to_str()).expect("a profile's name");
    let mut cargo = Command::new(env!("CARGO"));
    // As `cargo test` does: `cargo build` would build every dependency again, in another profile.
    cargo.args(["test", "--quiet", "--no-run"]).current_dir(package);
    if name != "debug" {
        cargo.args(["--profile", name]);
    }
    let status = cargo.arg("--target-dir").arg(profile.parent().expect("a folder for what is built")).status();
    assert!(status.expect("cargo runs").success(), "the example does not build");
    program
});

fn last_change_in(path: &Path) -> SystemTime {
    let metadata = fs::metadata(path).expect("a part of this package");
    let changed = metadata.modified().expect("a file system with times");
    if !metadata.is_dir() {
        return changed;
    }
    let entries = fs::read_dir(path).expect("a folder of this package");
    let changes = entries.map(|entry| last_change_in(&entry.expect("an entry of a folder of this package").path()));
    changes.fold(changed, SystemTime::max)
}

/// A folder of its own for one test, removed with it.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let name = format!("render-{}-{}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(&path).expect("a new folder");
        Self(path)
    }

    /// A folder with a drawing in it, `in.svg`.
    fn with_drawing(attributes: &str, content: &str) -> Self {
        let folder = Self::new();
        folder.write("in.svg", &format!(r#"<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{content}</svg>"#));
        folder
    }

    fn write(&self, name: &str, content: &str) {
        fs::write(self.0.join(name), content).expect("a new file");
    }

    fn run(&self, arguments: &[&str]) -> Output {
        Command::new(&*PROGRAM).args(arguments).current_dir(&self.0).output().expect("the example runs")
    }

    /// Runs the program, which must succeed, and gives its picture and its two outputs.
    fn picture(&self, arguments: &[&str], name: &str) -> (RgbImage, String, String) {
        let output = self.run(arguments);
        let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
        assert!(output.status.success(), "{arguments:?}: {stderr}");
        let picture = image::open(self.0.join(name)).expect("a PNG file");
        (picture.into_rgb8(), stdout, stderr)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the folder is there");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8")).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // Left behind, it is in cargo's own folder for such files.
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The picture as text: the first letter of each pixel's colour, `.` for the white background.
fn pattern(picture: &RgbImage) -> Vec<String> {
    let letter = |pixel: &image::Rgb<u8>| match pixel.0 {
        [255, 255, 255] => '.',
        [255, 0, 0] => 'r',
        [0, 0, 255] => 'b',
        [0, 128, 0] => 'g',
        [0, 0, 0] => 'k',
        _ => '?',
    };
    picture.rows().map(|row| row.map(letter).collect()).collect()
}

/// Draws in exact colours.
fn pattern_of(attributes: &str, content: &str) -> Vec<String> {
    let folder = Folder::with_drawing(attributes, content);
    let (picture, _, stderr) = folder.picture(&["in.svg", "--color", "rgb888"], "render.png");
    assert_eq!(stderr, "");
    pattern(&picture)
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

#[test]
fn the_bundled_map_is_drawn_without_arguments() {
    let folder = Folder::new();
    let (picture, stdout, stderr) = folder.picture(&[], "render.png");
    assert_eq!(picture.dimensions(), (800, 424));
    assert_eq!(stderr, "");
    assert_eq!(folder.names(), ["render.png"], "nothing else is left");

    let places = [
        ("page", (20, 20), 0x16293f),
        ("Atlantic", (330, 190), 0xa8d1e7),
        ("Caspian Sea", (502, 138), 0xa8d1e7),
        ("Antarctica", (400, 400), 0xf6f8f8),
        ("Antarctica, near the seam", (760 - 120, 410), 0xf6f8f8),
        ("around Cairo", (465, 138), 0xffffff),
        ("Cairo", (465, 136), 0xc0282d),
        ("north point of the compass rose", (45, 356), 0xe0533d),
    ];
    for (name, (x, y), expected) in places {
        let [_, red, green, blue] = u32::to_be_bytes(expected);
        let expected = Rgb888::from(Rgb565::from(Rgb888::new(red, green, blue)));
        let image::Rgb([red, green, blue]) = *picture.get_pixel(x, y);
        assert_eq!(Rgb888::new(red, green, blue), expected, "{name}");
    }

    let summary = first_line(&stdout);
    assert!(summary.contains("800x424 pixels, rgb565"), "{summary}");
    for kind in ["triangles", "polygons", "vertices", "circles", "lines"] {
        assert!(summary.contains(kind) && !summary.contains(&format!(" 0 {kind}")), "{kind} in {summary}");
    }
    assert!(stdout.contains(" ms, saved as render.png"), "{stdout}");
}

#[test]
fn whole_pixels_are_filled_exactly() {
    let content = r##"<rect x="1" y="1" width="3" height="2" fill="red"/>
        <polygon points="5,0 9,0 5,4" fill="blue"/>
        <path d="M1 4H6V8H1ZM2 5V7H4V5Z" fill="green"/>
        <path d="M7 4H11V8H7ZM8 5H10V7H8Z" fill="black" fill-rule="evenodd"/>"##;
    let expected = [
        ".....bbb...", // The last pixel's centre is on the triangle's long side, which is a right one.
        ".rrr.bb....",
        ".rrr.b.....",
        "...........",
        ".ggggg.kkkk",
        ".g..gg.k..k",
        ".g..gg.k..k",
        ".ggggg.kkkk",
    ];
    assert_eq!(pattern_of(r#"width="11" height="8""#, content), expected);
}

#[test]
fn shapes_go_through_the_primitive_of_their_kind() {
    let cases = [
        (r#"<polygon points="1,1 8,1 1,8"/>"#, "1 triangles, 0 polygons (0 contours, 0 vertices), 0 circles, 0 lines"),
        (r#"<path d="M1 1L8 1L1 8L1 1Z"/>"#, "1 triangles, 0 polygons (0 contours, 0 vertices), 0 circles, 0 lines"),
        (r#"<circle cx="4" cy="4" r="3"/>"#, "0 triangles, 0 polygons (0 contours, 0 vertices), 1 circles, 0 lines"),
        (
            r#"<line x2="9" y2="9" stroke="red"/>"#,
            "0 triangles, 0 polygons (0 contours, 0 vertices), 0 circles, 1 lines",
        ),
        (
            r#"<line x2="9" y2="9" stroke="red" stroke-width="2"/>"#,
            "0 triangles, 1 polygons (1 contours, 4 vertices), 0 circles, 0 lines",
        ),
        (
            r#"<rect width="3" height="3"/><path d="M1 1h3v3zM5 5h3v3z"/>"#,
            "0 triangles, 2 polygons (3 contours, 10 vertices), 0 circles, 0 lines",
        ),
        (
            r#"<g transform="rotate(30) scale(2)"><circle cx="4" cy="4" r="3"/></g>"#,
            "0 triangles, 0 polygons (0 contours, 0 vertices), 1 circles, 0 lines",
        ),
    ];
    for (content, expected) in cases {
        let folder = Folder::with_drawing(r#"width="9" height="9""#, content);
        let (_, stdout, stderr) = folder.picture(&["in.svg"], "render.png");
        assert_eq!(stderr, "", "{content}");
        assert!(first_line(&stdout).ends_with(expected), "{content}: {stdout}");
    }
    let squeezed = r#"<g transform="scale(1 .5)"><circle cx="4" cy="4" r="3"/></g>"#;
    let folder = Folder::with_drawing(r#"width="9" height="9""#, squeezed);
    let (_, stdout, _) = folder.picture(&["in.svg"], "render.png");
    assert!(first_line(&stdout).contains("0 triangles, 1 polygons (1 contours"), "{stdout}");
}

#[test]
fn circles_and_hairlines_have_the_crates_pixels() {
    let content = r#"<circle cx="3.5" cy="3.5" r="2.5" fill="red"/>
        <line x1="6.5" y1="0.5" x2="9.5" y2="6.5" stroke="blue" stroke-width=".25"/>"#;
    let expected = [
        "......b...", // Centres at the distance of the radius are outside.
        "..rrr.b...",
        ".rrrrr.b..",
        ".rrrrr.b..",
        ".rrrrr..b.",
        "..rrr...b.",
        ".........b",
    ];
    let drawn = pattern_of(r#"width="10" height="7""#, content);
    // A line that passes exactly between two pixels may take either; the crate's own tests say which.
    let rows = [0, 2, 4, 6];
    assert_eq!(rows.map(|row| &drawn[row][6..]), rows.map(|row| &expected[row][6..]));
    assert_eq!(drawn.iter().map(|row| &row[..6]).collect::<Vec<_>>(), expected.map(|row| &row[..6]));
}

#[test]
fn strokes_are_outlined() {
    let content = r#"<rect x="2" y="2" width="5" height="3" fill="red" stroke="blue" stroke-width="2"/>"#;
    let expected = [".........", ".bbbbbbb.", ".bbbbbbb.", ".bbrrrbb.", ".bbbbbbb.", ".bbbbbbb.", "........."];
    assert_eq!(pattern_of(r#"width="9" height="7""#, content), expected);
    let stroke_first = content.replace("<rect", r#"<rect paint-order="stroke""#);
    let row = ".brrrrrb.";
    assert_eq!(pattern_of(r#"width="9" height="7""#, &stroke_first)[2..5], [row, row, row]);
}

#[test]
fn a_view_box_and_a_size_scale_the_drawing() {
    let attributes = r#"width="4" height="2" viewBox="10 10 8 4""#;
    let content =
        r#"<rect x="10" y="10" width="4" height="2" fill="red"/><rect x="-99" width="999" height="10" fill="blue"/>"#;
    assert_eq!(pattern_of(attributes, content), ["rr..", "...."]);

    let folder = Folder::with_drawing(attributes, content);
    let size = ["in.svg", "--color=rgb888", "--size=8x6"];
    // What is outside of the view box stays outside, though the display has room for it.
    let expected = ["........", "rrrr....", "rrrr....", "........", "........", "........"];
    let (picture, _, _) = folder.picture(&size, "render.png");
    assert_eq!(pattern(&picture), expected);

    let options = ["--background", "#0000ff", "--scale", "3"];
    let (picture, _, _) = folder.picture(&[&size[..], &options].concat(), "render.png");
    assert_eq!(picture.dimensions(), (24, 18));
    let places = [((0, 2), 'b'), ((0, 3), 'r'), ((11, 8), 'r'), ((12, 8), 'b'), ((11, 9), 'b')];
    for ((x, y), expected) in places {
        assert_eq!(pattern(&picture)[y].chars().nth(x), Some(expected), "{x} {y}");
    }
}

#[test]
fn nested_drawings_are_clipped() {
    let content = r#"<svg x="1" y="1" width="3" height="2"><rect width="99" height="99" fill="red"/></svg>"#;
    assert_eq!(pattern_of(r#"width="5" height="4""#, content), [".....", ".rrr.", ".rrr.", "....."]);
}

#[test]
fn every_colour_type_draws() {
    let folder = Folder::with_drawing(r#"width="2" height="1""#, r##"<rect width="1" height="1" fill="#4080c0"/>"##);
    let color = Rgb888::new(0x40, 0x80, 0xc0);
    let rgb565 = Rgb888::from(Rgb565::from(color));
    let gray4 = Rgb888::from(Gray4::from(color));
    let gray8 = Rgb888::from(Gray8::from(color));
    let cases = [("rgb565", rgb565), ("rgb888", color), ("gray8", gray8), ("gray4", gray4), ("binary", Rgb888::BLACK)];
    for (name, expected) in cases {
        let (picture, stdout, _) = folder.picture(&["in.svg", "out.png", "--color", name], "out.png");
        let [left, right] = [0, 1].map(|x| picture.get_pixel(x, 0).0);
        assert_eq!(left, [expected.r(), expected.g(), expected.b()], "{name}");
        assert_eq!(right, [255, 255, 255], "{name}");
        assert!(stdout.contains(name), "{stdout}");
    }
    assert_eq!(folder.names(), ["in.svg", "out.png"]);
}

#[test]
fn what_is_not_drawn_is_named_once() {
    let content = r#"<defs>
            <linearGradient id="a"><stop stop-color="red"/><stop offset="1" stop-color="blue"/></linearGradient>
            <pattern id="p" width="2" height="2" patternUnits="userSpaceOnUse"><rect width="1" height="1"/></pattern>
            <clipPath id="c"><circle cx="5" cy="5" r="4"/></clipPath>
            <mask id="m"><rect width="9" height="9" fill="white"/></mask>
            <filter id="f"><feGaussianBlur stdDeviation="1"/></filter>
        </defs>
        <rect width="1" height="1" fill="url(#a)"/><rect width="2" height="1" y="1" stroke="url(#a)" stroke-width="2"/>
        <rect width="9" height="9" fill="url(#p)"/>
        <g opacity=".5"><rect width="2" height="2"/><rect width="2" height="2"/></g>
        <rect width="2" height="2" clip-path="url(#c)"/><rect width="2" height="2" mask="url(#m)"/>
        <rect width="2" height="2" filter="url(#f)"/><rect width="2" height="2" style="mix-blend-mode:multiply"/>
        <text x="1" y="5">letters</text><text x="1" y="8">more</text><image href="nowhere.png" width="2" height="2"/>"#;
    let folder = Folder::with_drawing(r#"width="9" height="9""#, content);
    let (_, _, stderr) = folder.picture(&["in.svg"], "render.png");
    let kinds = ["opacity", "patterns", "clip paths", "masks", "filters", "blend modes", "text", "images"];
    assert_eq!(stderr.lines().count(), kinds.len(), "{stderr}");
    for kind in kinds {
        let named = stderr.lines().filter(|line| line.starts_with(&format!("render: not drawn yet: {kind}"))).count();
        assert_eq!(named, 1, "{kind} in {stderr}");
    }
}

/// What resvg makes of the same file, on white.
fn by_resvg(folder: &Folder, width: u32, height: u32) -> RgbImage {
    let text = fs::read_to_string(folder.0.join("in.svg")).expect("the drawing");
    let tree = resvg::usvg::Tree::from_str(&text, &resvg::usvg::Options::default()).expect("a drawing");
    let mut pixmap = resvg::tiny_skia::Pixmap::new(width, height).expect("a picture");
    pixmap.fill(resvg::tiny_skia::Color::WHITE);
    resvg::render(&tree, resvg::tiny_skia::Transform::identity(), &mut pixmap.as_mut());
    RgbImage::from_fn(width, height, |x, y| {
        let pixel = pixmap.pixel(x, y).expect("a pixel").demultiply();
        image::Rgb([pixel.red(), pixel.green(), pixel.blue()])
    })
}

/// Whole pixels, so that nothing but the colours differs.
#[test]
fn gradients_are_those_of_resvg() {
    let stops = r##"<stop stop-color="#ff0000"/><stop offset=".3" stop-color="#ffff00"/>
        <stop offset=".3" stop-color="#0000ff"/><stop offset="1" stop-color="#00ff80"/>"##;
    let fading = r##"<stop stop-color="#ff0000"/><stop offset="1" stop-color="#0000ff" stop-opacity="0"/>"##;
    let one = r##"<stop offset=".5" stop-color="#123456"/>"##;
    // Attributes of the gradient, its stops, attributes of a rectangle, and the share of pixels in 1/1000 at jumps of
    // colour that may be any.
    let drawings = [
        ("linearGradient", "", stops, "", 20),
        ("linearGradient", r#"x2="0" y2="1""#, stops, "", 20),
        ("linearGradient", r#"x1=".2" y1=".1" x2=".9" y2=".8""#, stops, "", 20),
        ("linearGradient", r#"x1=".4" x2=".6" y2=".1" spreadMethod="reflect""#, fading, "", 0),
        ("linearGradient", r#"x1=".4" x2=".6" y2=".1" spreadMethod="repeat""#, fading, "", 60),
        ("linearGradient", r#"x1="5" y1="9" x2="40" y2="20" gradientUnits="userSpaceOnUse""#, stops, "", 20),
        ("linearGradient", r#"gradientTransform="rotate(30) skewX(20)""#, stops, r#"opacity=".5""#, 20),
        ("linearGradient", "", fading, r#"fill-opacity=".7" transform="translate(20 -10) rotate(0)""#, 0),
        ("linearGradient", "", one, "", 0),
        ("radialGradient", "", stops, "", 20),
        ("radialGradient", r#"cx=".3" cy=".6" r=".2" spreadMethod="reflect""#, fading, "", 0),
        ("radialGradient", r#"cx="30" cy="20" r="25" gradientUnits="userSpaceOnUse""#, stops, "", 20),
        ("radialGradient", r#"fx=".3" fy=".4""#, stops, "", 20),
        ("radialGradient", r#"fx=".3" fy=".4" fr=".1""#, stops, "", 20),
        ("radialGradient", r#"r=".3" fx=".6" fy=".6" spreadMethod="repeat""#, fading, "", 60),
        ("radialGradient", r#"gradientTransform="translate(.1 .2) rotate(20) scale(.9 .4)""#, stops, "", 20),
    ];
    for (element, attributes, stops, rectangle, at_jumps) in drawings {
        let content = format!(
            r##"<{element} id="g" {attributes}>{stops}</{element}>
            <rect width="64" height="40" x="8" y="4" fill="url(#g)" {rectangle}/>"##
        );
        let folder = Folder::with_drawing(r#"width="80" height="48""#, &content);
        let (picture, _, stderr) = folder.picture(&["in.svg", "--color", "rgb888", "--aa", "exact"], "render.png");
        assert_eq!(stderr, "");
        let expected = by_resvg(&folder, 80, 48);
        let mut differences: Vec<u8> = picture
            .pixels()
            .zip(expected.pixels())
            .map(|(a, b)| a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0))
            .collect();
        differences.sort_unstable();
        let worst = differences[differences.len() - 1 - differences.len() * at_jumps / 1000];
        eprintln!("{element} {attributes}: {worst} {:?}", differences.iter().filter(|d| **d > 3).count());
        assert!(worst <= 3, "{worst} in {content}");
    }
}

#[test]
fn nothing_is_seen_of_what_is_hidden_or_transparent() {
    let content = r#"<g opacity="0"><rect width="2" height="2"/></g><rect width="2" height="2" fill-opacity="0"/>
        <rect width="2" height="2" visibility="hidden"/><rect width="2" height="2" display="none"/>"#;
    assert_eq!(pattern_of(r#"width="2" height="2""#, content), ["..", ".."]);
}

const MODES: [&str; 5] = ["none", "exact", "4", "16", "weighted"];

/// How much of each pixel is covered, in 255ths: what is black on white, in a display of 24 bits.
fn coverage_of(attributes: &str, content: &str, aa: &str) -> Vec<Vec<u8>> {
    let folder = Folder::with_drawing(attributes, content);
    let (picture, _, stderr) = folder.picture(&["in.svg", "--color", "rgb888", "--aa", aa], "render.png");
    assert_eq!(stderr, "");
    picture.rows().map(|row| row.map(|pixel| 255 - pixel.0[0]).collect()).collect()
}

#[test]
fn without_anti_aliasing_every_pixel_of_the_map_is_as_ever() {
    let folder = Folder::new();
    let (picture, stdout, _) = folder.picture(&["--aa", "none"], "render.png");
    let shown = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/world.png");
    assert!(picture == image::open(shown).expect("the picture in the README").into_rgb8());
    assert!(first_line(&stdout).contains("pixels, rgb565: "), "{stdout}");
}

/// Land, sea and page are the same; along the edges of the map, and only there, colours are mixed.
#[test]
fn every_mode_draws_the_map() {
    let folder = Folder::new();
    let (hard, _, _) = folder.picture(&[], "render.png");
    let inside = [(20, 20), (330, 190), (502, 138), (400, 400), (465, 136), (45, 356)];
    for aa in &MODES[1..] {
        let (soft, stdout, stderr) = folder.picture(&["--aa", aa], "render.png");
        assert_eq!(stderr, "", "{aa}");
        assert!(first_line(&stdout).contains(if *aa == "exact" { "exact areas" } else { "samples" }), "{stdout}");
        for (x, y) in inside {
            assert_eq!(soft.get_pixel(x, y), hard.get_pixel(x, y), "{aa}: {x} {y}");
        }
        let distance = |a: &image::Rgb<u8>, b: &image::Rgb<u8>| {
            a.0.iter().zip(b.0).map(|(a, b)| u32::from(a.abs_diff(b))).max().unwrap_or(0)
        };
        let changed = soft.pixels().zip(hard.pixels()).filter(|(a, b)| distance(a, b) > 8).count();
        let all = soft.pixels().len();
        // Borders, coasts and the graticule.
        assert!((all / 50..all / 8).contains(&changed), "{aa}: {changed} of {all}");
    }
}

#[test]
fn coverage_is_the_area_or_the_share_of_samples() {
    // From 1/4 to 2 1/2 across, from 1/2 to 1 3/4 down.
    let content = r#"<rect x=".25" y=".5" width="2.25" height="1.25"/>"#;
    let drawn = |aa| coverage_of(r#"width="4" height="3""#, content, aa);
    // 3/4, 1 and 1/2 of a pixel's width times 1/2 and 3/4 of its height, and 0.
    let areas = [[96, 128, 64, 0], [143, 191, 96, 0], [0; 4]];
    assert_eq!(drawn("exact"), areas);
    // All sides lie between samples.
    assert_eq!(drawn("4"), areas);
    assert_eq!(drawn("16"), areas);
    // Of the weights 1 2 2 1, 2 3 3 2, 2 3 3 2, 1 2 2 1: 13, 16, 8 of 32 above, and 20 + .. below.
    assert_eq!(drawn("weighted"), [[104, 128, 64, 0], [167, 207, 104, 0], [0; 4]]);
    // Of columns 1, 2 and 3 the last centre is on the right side, and of rows 1 and 2 the first on the upper one.
    assert_eq!(drawn("none"), [[255, 255, 0, 0], [255, 255, 0, 0], [0; 4]]);
}

#[test]
fn triangles_circles_and_lines_cover_their_areas() {
    // Half a square, a steep edge, and an even one.
    let halves = coverage_of(r#"width="3" height="3""#, r#"<polygon points="0,0 3,0 0,3"/>"#, "exact");
    assert_eq!(halves, [[255, 255, 128], [255, 128, 0], [128, 0, 0]]);
    let slope = coverage_of(r#"width="4" height="1""#, r#"<polygon points="0,1 4,1 4,0"/>"#, "exact");
    assert_eq!(slope, [[32, 96, 159, 223]]);

    let sum = |content: &str, aa| -> f64 {
        let rows = coverage_of(r#"width="40" height="40""#, content, aa);
        rows.concat().iter().map(|&coverage| f64::from(coverage) / 255.0).sum()
    };
    // Mitred corners have as much outside of the path as they lack inside.
    let perimeter = 36f64.hypot(7.0) + 27f64.hypot(26.0) + 9f64.hypot(33.0);
    let shapes = [
        (r#"<circle cx="19.3" cy="20.6" r="15.4"/>"#, std::f64::consts::PI * 15.4 * 15.4),
        (r#"<line x1="3.2" y1="5.1" x2="33.2" y2="28.6" stroke="black"/>"#, 30f64.hypot(23.5)),
        (r#"<line x1="3.2" y1="5.1" x2="33.2" y2="28.6" stroke="black" stroke-width=".25"/>"#, 30f64.hypot(23.5) / 4.0),
        (r#"<path d="M2 2L38 9L11 35Z" fill="none" stroke="black" stroke-width=".5"/>"#, 0.5 * perimeter),
    ];
    for (content, area) in shapes {
        for aa in ["exact", "16"] {
            let drawn = sum(content, aa);
            assert!((drawn - area).abs() < 0.02 * area, "{aa}: {drawn}, not {area}: {content}");
        }
    }
}

/// Random shapes of all kinds: many samples are near the area, fewer are farther away.
#[test]
fn samples_come_close_to_areas() {
    let mut state = 7_u64;
    let mut random = |most: u64| {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (((state >> 33) * most * 8) >> 31) as f64 / 8.0
    };
    let mut errors = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..12 {
        let mut content = String::new();
        let points: Vec<String> = (0..7).map(|_| format!("{},{}", random(60), random(60))).collect();
        content += &format!(r#"<polygon fill-rule="evenodd" points="{}"/>"#, points.join(" "));
        content += &format!(r#"<polygon points="{} {}"/>"#, points[0], points[1..3].join(" "));
        content += &format!(r#"<circle cx="{}" cy="{}" r="{}"/>"#, random(60), random(60), random(9));
        let [x1, y1, x2, y2] = [60; 4].map(&mut random);
        content += &format!(r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="black"/>"#);
        let drawn = |aa| coverage_of(r#"width="60" height="60""#, &content, aa).concat();
        let exact = drawn("exact");
        for (errors, aa) in errors.iter_mut().zip(["16", "4", "weighted"]) {
            let pairs = drawn(aa).into_iter().zip(&exact);
            errors.extend(pairs.filter(|(_, exact)| (1..255).contains(*exact)).map(|(a, b)| a.abs_diff(*b)));
        }
    }
    for errors in &mut errors {
        errors.sort_unstable();
    }
    let [sixteen, four, weighted] = errors.map(|errors| {
        let of_100 = |share| errors[errors.len() * share / 100];
        assert!(errors.len() > 3000, "{} pixels of an edge", errors.len());
        (of_100(50), of_100(95), errors[errors.len() - 1])
    });
    assert!(sixteen.0 <= 1 && sixteen.1 <= 4 && sixteen.2 <= 24, "{sixteen:?}");
    assert!((2..=10).contains(&four.0) && (8..=40).contains(&four.1), "{four:?}");
    assert!((2..=14).contains(&weighted.0) && weighted.1 <= 50, "{weighted:?}");
}

#[test]
fn opacity_lets_through_what_is_below() {
    let content = r#"<rect width="2" height="1" fill-opacity=".5"/>
        <g opacity=".5"><rect x="1" width="2" height="1"/></g>
        <line x1="3" y1=".5" x2="5" y2=".5" stroke="black" stroke-opacity=".2"/>
        <circle cx="7" cy=".5" r="9" opacity=".4" fill-opacity=".5" clip-path="url(#c)"/>
        <clipPath id="c"><rect x="6" width="1" height="1"/></clipPath>"#;
    for aa in MODES {
        let drawn = coverage_of(r#"width="8" height="1""#, content, aa);
        // Half of the half that shows through is 63.5 of 127; mixed from 127 it is 64 less.
        let [first, twice, second, line, _, _, circle, nothing] = *drawn[0].as_slice() else { panic!("eight pixels") };
        assert_eq!([first, twice, second, line, circle, nothing], [128, 192, 128, 51, 51, 0], "{aa}");
    }
}

#[test]
fn blended_shapes_stay_in_their_clip() {
    let content = r#"<svg x="1" y="1" width="3" height="2"><circle cx="1.5" cy="1" r="1.7"/></svg>"#;
    for aa in MODES {
        let drawn = coverage_of(r#"width="5" height="4""#, content, aa);
        let inside = |x: usize, y: usize| (1..4).contains(&x) && (1..3).contains(&y);
        for (y, row) in drawn.iter().enumerate() {
            for (x, &coverage) in row.iter().enumerate() {
                assert_eq!(coverage > 0, inside(x, y), "{aa}: {x} {y}");
            }
        }
    }
}

#[test]
fn every_colour_type_is_blended() {
    let content = r#"<rect x=".5" width="1" height="1"/>"#;
    let folder = Folder::with_drawing(r#"width="2" height="1""#, content);
    // Half of 31 and 63 steps, of 255 and of 15, as they are shown; of two steps the farther one.
    let half = Rgb888::from(Rgb565::new(15, 31, 15));
    let gray4 = Rgb888::from(Gray4::new(7));
    let expected = [
        ("rgb565", half),
        ("rgb888", Rgb888::new(127, 127, 127)),
        ("gray8", Rgb888::new(127, 127, 127)),
        ("gray4", gray4),
        ("binary", Rgb888::BLACK),
    ];
    for (name, expected) in expected {
        let (picture, _, _) = folder.picture(&["in.svg", "--aa", "exact", "--color", name], "render.png");
        for x in [0, 1] {
            assert_eq!(picture.get_pixel(x, 0).0, [expected.r(), expected.g(), expected.b()], "{name} {x}");
        }
    }
}

#[test]
fn a_crop_is_that_part_of_the_display_magnified() {
    let folder = Folder::new();
    for aa in ["none", "exact"] {
        let (whole, _, _) = folder.picture(&["--aa", aa], "render.png");
        let detail = ["--aa", aa, "--crop", "440,120,32,20", "--scale", "3"];
        let (detail, stdout, _) = folder.picture(&detail, "render.png");
        assert!(stdout.contains("800x424"), "{stdout}");
        assert_eq!(detail.dimensions(), (96, 60));
        for (x, y, pixel) in detail.enumerate_pixels() {
            assert_eq!(pixel, whole.get_pixel(440 + x / 3, 120 + y / 3), "{aa}: {x} {y}");
        }
    }
}

/// The pictures in `docs` are what the program draws today, but for a step of a channel.
#[test]
fn the_magnified_edges_are_those_of_today() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let drawing = package.join("examples/assets/edges.svg");
    let folder = Folder::new();
    for aa in MODES {
        let shown = package.join(format!("docs/edges-{aa}.png"));
        let drawing = drawing.to_str().expect("UTF-8");
        let (picture, _, stderr) = folder.picture(&[drawing, "out.png", "--scale", "8", "--aa", aa], "out.png");
        assert_eq!(stderr, "");
        let shown = image::open(&shown).expect("a picture of docs").into_rgb8();
        assert_eq!(shown.dimensions(), picture.dimensions());
        let step = if aa == "exact" { 9 } else { 0 };
        for ((x, y, a), b) in picture.enumerate_pixels().zip(shown.pixels()) {
            let near = a.0.iter().zip(b.0).all(|(a, b)| a.abs_diff(b) <= step);
            assert!(near, "{aa}: {x} {y} is {a:?}, not {b:?}: draw it anew with --scale 8 --aa {aa}");
        }
    }
}

#[test]
fn failures_are_one_line_and_leave_no_picture() {
    let folder = Folder::with_drawing(r#"width="4" height="4""#, r#"<rect width="2" height="2"/>"#);
    folder.write("broken.svg", r#"<svg xmlns="http://www.w3.org/2000/svg" width="4" height="4"><rect"#);
    folder.write("other.svg", "<html/>");
    folder.write("empty.svg", "");
    folder.write("flat.svg", r#"<svg xmlns="http://www.w3.org/2000/svg" width="4" height="0"/>"#);
    folder.write("huge.svg", r#"<svg xmlns="http://www.w3.org/2000/svg" width="1e9" height="1e9"/>"#);
    fs::write(folder.0.join("binary.svg"), [0x1f, 0x8b, 0xff, 0x00]).expect("a new file");
    fs::create_dir(folder.0.join("folder.png")).expect("a new folder");
    let before = folder.names();

    let cases: &[(&[&str], &str)] = &[
        (&["missing.svg"], "missing.svg: "),
        (&["."], ".: "),
        (&["broken.svg"], "broken.svg: not an SVG file"),
        (&["other.svg"], "other.svg: not an SVG file"),
        (&["empty.svg"], "empty.svg: not an SVG file"),
        (&["binary.svg"], "binary.svg: not an SVG file"),
        (&["flat.svg"], "flat.svg: "),
        (&["huge.svg"], "huge.svg: "),
        (&["in.svg", "--size", "0x4"], "0x4"),
        (&["in.svg", "--size", "4x0"], "4x0"),
        (&["in.svg", "--size", "4"], "'4'"),
        (&["in.svg", "--size", "999999x999999"], "too large"),
        (&["in.svg", "--size", "8000x8000", "--scale", "2"], "too large"),
        (&["in.svg", "--scale", "0"], "'0'"),
        (&["in.svg", "--color", "cmyk"], "'cmyk'"),
        (&["in.svg", "--background", "red"], "#rrggbb"),
        (&["in.svg", "--aa", "5"], "'5'"),
        (&["in.svg", "--crop", "1,2,3"], "X,Y,WIDTH,HEIGHT"),
        (&["in.svg", "--crop", "3,0,2,4"], "not on the display"),
        (&["in.svg", "--no-such-option"], "--no-such-option"),
        (&["in.svg", "a.png", "b.png"], "b.png"),
        (&["in.svg", "no/such/folder/out.png"], "no/such/folder/out.png: "),
        (&["in.svg", "folder.png"], "folder.png: "),
    ];
    for &(arguments, expected) in cases {
        let output = folder.run(arguments);
        let stderr = String::from_utf8(output.stderr).expect("UTF-8");
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {stderr}");
        assert_eq!(stderr.lines().count(), 1, "{arguments:?}: {stderr}");
        assert!(stderr.starts_with("render: ") && stderr.contains(expected), "{arguments:?}: {stderr}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
        assert_eq!(folder.names(), before, "{arguments:?}");
    }
}

#[test]
fn a_failure_leaves_an_older_picture_alone() {
    let folder = Folder::new();
    folder.write("out.png", "older");
    folder.write("in.svg", "<svg");
    assert_eq!(folder.run(&["in.svg", "out.png"]).status.code(), Some(1));
    assert_eq!(fs::read(folder.0.join("out.png")).expect("still there"), b"older");
    assert_eq!(folder.names(), ["in.svg", "out.png"]);
}

#[test]
fn help_is_no_failure() {
    let output = Folder::new().run(&["--help"]);
    let help = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(output.status.success());
    for word in [
        "IN.svg",
        "OUT.png",
        "--size",
        "--color",
        "gray4",
        "--background",
        "--scale",
        "--aa",
        "exact",
        "weighted",
        "--crop",
    ] {
        assert!(help.contains(word), "{word} in {help}");
    }
}
