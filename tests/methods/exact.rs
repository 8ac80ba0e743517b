//! The methods that are exact: equal to the rule, pixel by pixel.

use crate::{
    oracle::{Rng, rect},
    scenes::{Corners, SCENES, Truth, draw, index, name, picture, triangles, truth},
    variants::{
        SCREEN, Variant,
        triangle::{INSIDE, TRAVERSAL},
    },
};

/// The same pixels as the crate's rule.
const EXACT: &[(&str, &str)] = &[
    ("spanfill", "shipped"),
    ("every pixel", ""),
    ("bounding box", ""),
    ("backtrack", ""),
    ("edge walking", "exact remainder, half open"),
    ("Warnock", "whole screen"),
    ("Warnock", "bounding box"),
    ("micropolygons", "middles exact"),
    ("8 x 8 blocks", ""),
];

/// The same, and those on the outline.
const CLOSED: &[(&str, &str)] = &[
    ("edge functions, snapped", "F = 8, 64 bits"),
    ("edge functions, snapped", "F = 12, 64 bits"),
    ("edge functions, snapped", "F = 16, 64 bits"),
    ("edge walking", "exact remainder, ceiling and floor"),
    ("edge equations", "f64"),
    ("edge equations", "F = 16, 64 bits"),
    ("given by", "three vertices"),
    ("bounding box", "centres"),
    ("bounding box", "(int) min to (int) (max + 1)"),
    ("samples", "centres"),
];

fn listed(list: &[(&str, &str)]) -> Vec<&'static Variant<Corners>> {
    let all = INSIDE.iter().chain(TRAVERSAL);
    let found: Vec<_> = all.filter(|variant| list.contains(&(variant.method, variant.option))).collect();
    assert!(found.len() >= list.len());
    found
}

/// Compares within a clip; `closed` says whether the whole outline is expected.
fn check(variant: &Variant<Corners>, closed: bool, v: &Corners, clip: &spanfill::PixelRect) {
    let mut picture = picture();
    draw(variant, v, clip, &mut picture).expect("nothing to refuse");
    for y in clip.rows.clone() {
        for x in clip.columns.clone() {
            let expected = match truth(v, x, y) {
                Truth::Outside => 0,
                Truth::Inside | Truth::TieInside => 1,
                Truth::TieOutside => closed.into(),
            };
            assert_eq!(picture.count[index(x, y)], expected, "{} at ({x}, {y}) of {v:?} in {clip:?}", name(variant));
        }
    }
}

fn check_all(v: &Corners, clip: &spanfill::PixelRect) {
    for (list, closed) in [(EXACT, false), (CLOSED, true)] {
        listed(list).iter().for_each(|variant| check(variant, closed, v, clip));
    }
}

#[test]
fn exact_methods_are_exact() {
    for scene in 0..SCENES.len() {
        for (number, v) in triangles(scene, 12).iter().enumerate() {
            let mut rng = Rng::new(1, number as u64);
            let (x, y) = (rng.int(0..=250) as i32, rng.int(0..=180) as i32);
            let clip = rect(x..x + rng.int(1..=60) as i32, y..y + rng.int(1..=50) as i32);
            check_all(v, &clip);
            if number == 0 {
                check_all(v, &SCREEN);
            }
        }
    }
}

/// Triangles between 64 points, among them centres of pixels, middles of their sides and corners.
#[test]
fn exact_methods_are_exact_on_a_grid() {
    let clip = rect(1..6, 1..6);
    let points: Vec<[i32; 2]> = (0..64).map(|point| [256 + 192 * (point % 8), 256 + 128 * (point / 8)]).collect();
    let variants = [(listed(EXACT), false), (listed(CLOSED), true)];
    let mut picture = picture();
    for triangle in 0..64_usize.pow(3) {
        let v = [points[triangle % 64], points[triangle / 64 % 64], points[triangle / 4096]];
        // All for a part, then one in seven.
        if triangle > 12_000 && triangle % 7 != 0 {
            continue;
        }
        let [[x0, y0], [x1, y1], [x2, y2]] = v;
        let is_degenerate = (x1 - x0) * (y2 - y0) == (x2 - x0) * (y1 - y0);
        let mut expected = [[Truth::Outside; 5]; 5];
        for (y, row) in (1..6).zip(&mut expected) {
            for (x, pixel) in (1..6).zip(row) {
                *pixel = truth(&v, x, y);
            }
        }
        for (variants, closed) in &variants {
            for variant in variants {
                draw(variant, &v, &clip, &mut picture).expect("nothing to refuse");
                // Closed spans have the pixels that lie on a triangle without an area, too.
                if is_degenerate && variant.option == "exact remainder, ceiling and floor" {
                    continue;
                }
                let same = (1..6).zip(&expected).all(|(y, row)| {
                    row.iter().zip(&picture.count[index(1, y)..index(6, y)]).all(|(truth, count)| match truth {
                        Truth::Outside => *count == 0,
                        Truth::Inside | Truth::TieInside => *count == 1,
                        Truth::TieOutside => *count == u16::from(*closed),
                    })
                });
                assert!(same, "{} of {v:?}", name(variant));
            }
        }
    }
}
