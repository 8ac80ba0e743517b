//! Attributes against their exact values: fractions of integers.

use std::fmt::Write as _;

use crate::{
    oracle::{
        Rng,
        rule::{At, centre, cross},
    },
    scenes::{self, SCENES, draw, index, name, picture},
    variants::{
        SCREEN, Variant,
        attribute::{ATTRIBUTES, Shaded, in_perspective, is_depth},
    },
};

/// Numerator and denominator, the latter positive inside.
type Fraction = (i128, i128);

/// The value at a pixel's centre of what is `values` at the vertices, with the weights `1 / w`.
pub(crate) fn exact(shape: &Shaded, values: [i32; 3], w: [i32; 3], x: i32, y: i32) -> Fraction {
    let [a, b, c] = shape.vertices.map(|[x, y]| At { x: x.into(), y: y.into() });
    let p = centre(x, y);
    let area = cross(a, b, c).signum();
    let e = [cross(b, c, p), cross(c, a, p), cross(a, b, p)].map(|e| e * area);
    let [w0, w1, w2] = w.map(i128::from);
    // e_i / w_i, times all three w.
    let f = [e[0] * w1 * w2, e[1] * w2 * w0, e[2] * w0 * w1];
    let sum = |values: [i128; 3]| f.iter().zip(values).map(|(f, value)| f * value).sum();
    (sum(values.map(i128::from)), sum([1; 3]))
}

/// How far a value is from its exact one.
pub(crate) fn error(value: i32, (numerator, denominator): Fraction) -> f64 {
    (i128::from(value) * denominator - numerator).abs() as f64 / denominator as f64
}

fn shape(vertices: [[i32; 2]; 3], rng: &mut Rng, in_perspective: bool) -> Shaded {
    let mut byte = || rng.int(0..=255) as i32;
    let attributes = [(); 3].map(|()| [(); 4].map(|()| byte()));
    let w = [(); 3].map(|()| if in_perspective { rng.int(1 << 15..=1 << 19) as i32 } else { 1 << 16 });
    Shaded { vertices, attributes, w, depth: [(); 3].map(|()| rng.int(0..=0xFFFF) as u16) }
}

fn stat(variant: &Variant<Shaded>, shapes: &[Shaded]) -> (u32, u32, f64) {
    let (mut pixels, mut wrong, mut worst) = (0, 0, 0.0_f64);
    for shape in shapes {
        let mut picture = picture();
        if draw(variant, shape, &SCREEN, &mut picture).is_err() {
            continue;
        }
        let w = if in_perspective(variant.method, variant.option) { shape.w } else { [1; 3] };
        for y in SCREEN.rows {
            for x in SCREEN.columns {
                let at = index(x, y);
                let truth = scenes::truth(&shape.vertices, x, y);
                if picture.count[at] == 0 || truth == scenes::Truth::Outside {
                    continue;
                }
                pixels += 1;
                let off = if is_depth(variant.method, variant.option) {
                    error(picture.depth[at].into(), exact(shape, shape.depth.map(i32::from), w, x, y))
                } else {
                    let channel = |channel: usize| {
                        let values = shape.attributes.map(|attributes| attributes[channel]);
                        error(picture.attributes[at][channel], exact(shape, values, w, x, y))
                    };
                    (0..4).map(channel).fold(0.0, f64::max)
                };
                wrong += u32::from(off > 0.5);
                worst = worst.max(off);
            }
        }
    }
    (pixels, wrong, worst)
}

/// How far off what is shipped may be: half a level, as all of them round.
///
/// In perspective, for a range of 255 levels in 1/256 and distances of 1:16: the range takes 16 bits of 30, so `1/w` has
/// 14, and its least is 1023. Half a unit of that is off by `e = 1/2046`: at the vertices it moves a value by
/// `255 e / (2 (1 - e))`, and once more, at the pixel, by `255 e`; then there are two units of 1/256.
fn shipped_bound(option: &str) -> f64 {
    let e = 1.0 / 2046.0;
    let divided = 0.5 + 255.0 * e / (2.0 * (1.0 - e)) + 255.0 * e + 2.0 / 256.0;
    match option {
        "gouraud" | "depth" => 0.5,
        "perspective, divided at each pixel" => divided,
        "perspective" => divided + 64.0 / 256.0,
        // One colour for all pixels.
        _ => 255.0,
    }
}

pub(crate) fn count(text: &mut String) {
    for scene in [0, 2, 3, 4] {
        let mut rng = Rng::new(0xA772, scene as u64);
        let shapes: Vec<_> =
            scenes::triangles(scene, 8).iter().map(|vertices| shape(*vertices, &mut rng, true)).collect();
        writeln!(text, "\nattributes, {}: {} triangles", SCENES[scene].0, shapes.len()).unwrap();
        writeln!(text, "pixels  not nearest  worst error").unwrap();
        for variant in ATTRIBUTES {
            let (pixels, wrong, worst) = stat(variant, &shapes);
            writeln!(text, "{pixels:6} {wrong:12} {worst:12.3}  {}", name(variant)).unwrap();
            let is_exact = variant.option.contains("f64") || variant.option == "f = e/w";
            // Half a level, and what doubles leave of it.
            assert!(!is_exact || worst < 0.5 + 1e-6, "{}: {worst}", name(variant));
            let bound = shipped_bound(variant.option);
            assert!(variant.method != "spanfill" || worst <= bound, "{}: {worst} of {bound}", name(variant));
        }
    }
}

/// "s/w from 4/1 to 6/3, 1/w from 1/1 to 1/3: the middle is 4.5", in 256ths; linear, it would be 5.
#[test]
fn the_notes_example_of_perspective() {
    let corner = |x: i32, y: i32| [256 * x + 128, 256 * y + 128];
    let shape = Shaded {
        vertices: [corner(10, 10), corner(30, 10), corner(10, 30)],
        attributes: [[4 * 256; 4], [6 * 256; 4], [4 * 256; 4]],
        w: [1, 3, 1].map(|w| w << 16),
        depth: [0; 3],
    };
    assert_eq!(
        exact(&shape, [4, 6, 4], shape.w, 20, 10),
        (9 * exact(&shape, [1; 3], shape.w, 20, 10).1 / 2, exact(&shape, [1; 3], shape.w, 20, 10).1)
    );
    let mut seen = 0;
    for variant in ATTRIBUTES.iter().filter(|variant| in_perspective(variant.method, variant.option)) {
        let mut picture = picture();
        draw(variant, &shape, &SCREEN, &mut picture).expect("nothing to refuse");
        let middle = picture.attributes[index(20, 10)];
        let expected = match variant.option {
            "affine" => 5 * 256..=5 * 256,
            // In the first piece, 10/16 of the way from 4 at column 10 to 36/7 at column 26, which is right there.
            "affine pieces of 16 px" => 1207..=1207,
            _ => 4 * 256 + 128..=4 * 256 + 128,
        };
        assert_eq!(picture.count[index(20, 10)], 1, "{}", name(variant));
        assert!(middle.iter().all(|value| expected.contains(value)), "{}: {middle:?}", name(variant));
        seen += 1;
    }
    assert_eq!(seen, 7);
}

/// The lecture's average is a third of the sum, to the nearest.
#[test]
fn the_average_is_rounded_to_the_nearest() {
    for sum in 0..=765_i32 {
        let parts = [sum / 3, (sum + 1) / 3, (sum + 2) / 3];
        let [average] = spanfill::methods::attribute::average::average([&[parts[0]], &[parts[1]], &[parts[2]]]);
        assert!((3 * average - sum).abs() <= 1, "{average} of {sum}");
    }
}
