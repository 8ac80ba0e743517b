//! The methods of the literature for triangles: which of them are exact, how often the others are wrong, and that no
//! input makes one panic, run on or leave its clip.
//!
//! How often is in `tests/methods/triangle.txt`, counted on fixed triangles. `BLESS=1 cargo test --test
//! methods_triangle` counts again.

#[path = "methods/bad.rs"]
mod bad;
#[path = "methods/counts.rs"]
mod counts;
#[path = "methods/exact.rs"]
mod exact;
mod oracle;
#[path = "methods/scenes.rs"]
mod scenes;
#[path = "methods/shaded.rs"]
mod shaded;
#[path = "methods/suspicions.rs"]
mod suspicions;
#[path = "../examples/methods/variants/mod.rs"]
mod variants;

use spanfill::methods::{FAMILIES, Method};
use variants::Variant;

/// The pairs of method and option of a family.
fn published(family: &str) -> Vec<(&'static str, &'static str)> {
    let family = FAMILIES.iter().find(|found| found.name == family).expect("a family of that name");
    let pairs = |method: &'static Method| method.options.iter().map(move |option| (method.name, *option));
    family.methods.iter().flat_map(pairs).collect()
}

fn check_list<S: ?Sized>(family: &str, list: &[Variant<S>], shipped: &[&str]) {
    assert!(list.iter().all(|variant| variant.family == family));
    let drawn: Vec<_> = list.iter().map(|variant| (variant.method, variant.option)).collect();
    assert_eq!(drawn, published(family));
    let last: Vec<_> = shipped.iter().map(|option| ("spanfill", *option)).collect();
    assert!(drawn.ends_with(&last), "{family} ends with {:?}", drawn.last());
}

#[test]
fn every_option_of_every_method_is_a_variant() {
    check_list("triangle: inside test", variants::triangle::INSIDE, &["shipped"]);
    check_list("triangle: traversal", variants::triangle::TRAVERSAL, &["shipped"]);
    check_list("shared edges", variants::triangle::SHARED, &["shipped"]);
    let shipped = ["flat", "gouraud", "perspective", "perspective, divided at each pixel", "depth"];
    check_list("attributes", variants::attribute::ATTRIBUTES, &shipped);
}
