//! Circles around whole pixels, `[x, y, r]`.

use spanfill::{
    Circle, Shape, Vertex,
    methods::circle::{
        functions::{Functions, Rounding},
        midpoint::{self, Decision},
        ngon,
        octant::Style,
        parametric, second_differences, symmetry4, symmetry8,
    },
};

use crate::variants;
use crate::variants::line::{Fragments, drawn};

/// The crate's circle that ends with the pixels of the outline of radius r: of radius r + 1/2.
pub fn shipped([x, y, r]: [i32; 3]) -> Circle {
    Circle::from_bits(Vertex::pixel(x, y), r.saturating_mul(256).saturating_add(128))
}

variants! {
    CIRCLES: [i32; 3];
    "circle", "4-way symmetry", "truncated, outline" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Libm, Rounding::Truncated, Style::Outline, clip, sink));
    "circle", "4-way symmetry", "truncated, filled" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Libm, Rounding::Truncated, Style::Filled, clip, sink));
    "circle", "4-way symmetry", "nearest, outline" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Libm, Rounding::Nearest, Style::Outline, clip, sink));
    "circle", "4-way symmetry", "nearest, filled" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Libm, Rounding::Nearest, Style::Filled, clip, sink));
    "circle", "4-way symmetry", "micromath, truncated, outline" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Micromath, Rounding::Truncated, Style::Outline, clip, sink));
    "circle", "4-way symmetry", "micromath, truncated, filled" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Micromath, Rounding::Truncated, Style::Filled, clip, sink));
    "circle", "4-way symmetry", "micromath, nearest, outline" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Micromath, Rounding::Nearest, Style::Outline, clip, sink));
    "circle", "4-way symmetry", "micromath, nearest, filled" => |circle, clip, sink|
        drawn(symmetry4::circle(*circle, Functions::Micromath, Rounding::Nearest, Style::Filled, clip, sink));
    "circle", "8-way symmetry", "truncated, outline" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Libm, Rounding::Truncated, Style::Outline, clip, sink));
    "circle", "8-way symmetry", "truncated, filled" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Libm, Rounding::Truncated, Style::Filled, clip, sink));
    "circle", "8-way symmetry", "nearest, outline" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Libm, Rounding::Nearest, Style::Outline, clip, sink));
    "circle", "8-way symmetry", "nearest, filled" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Libm, Rounding::Nearest, Style::Filled, clip, sink));
    "circle", "8-way symmetry", "micromath, truncated, outline" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Micromath, Rounding::Truncated, Style::Outline, clip, sink));
    "circle", "8-way symmetry", "micromath, truncated, filled" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Micromath, Rounding::Truncated, Style::Filled, clip, sink));
    "circle", "8-way symmetry", "micromath, nearest, outline" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Micromath, Rounding::Nearest, Style::Outline, clip, sink));
    "circle", "8-way symmetry", "micromath, nearest, filled" => |circle, clip, sink|
        drawn(symmetry8::circle(*circle, Functions::Micromath, Rounding::Nearest, Style::Filled, clip, sink));
    "circle", "parametric", "libm, outline" => |circle, clip, sink|
        drawn(parametric::circle(*circle, Functions::Libm, Style::Outline, clip, sink));
    "circle", "parametric", "libm, filled" => |circle, clip, sink|
        drawn(parametric::circle(*circle, Functions::Libm, Style::Filled, clip, sink));
    "circle", "parametric", "micromath, outline" => |circle, clip, sink|
        drawn(parametric::circle(*circle, Functions::Micromath, Style::Outline, clip, sink));
    "circle", "parametric", "micromath, filled" => |circle, clip, sink|
        drawn(parametric::circle(*circle, Functions::Micromath, Style::Filled, clip, sink));
    "circle", "midpoint", "5/4 - r, outline" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::Derived, Style::Outline, clip, sink));
    "circle", "midpoint", "5/4 - r, filled" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::Derived, Style::Filled, clip, sink));
    "circle", "midpoint", "5 / 4 - r in integers, outline" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::Printed, Style::Outline, clip, sink));
    "circle", "midpoint", "5 / 4 - r in integers, filled" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::Printed, Style::Filled, clip, sink));
    "circle", "midpoint", "1 - r, outline" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::Integer, Style::Outline, clip, sink));
    "circle", "midpoint", "1 - r, filled" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::Integer, Style::Filled, clip, sink));
    "circle", "midpoint", "without + 5, outline" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::WithoutFive, Style::Outline, clip, sink));
    "circle", "midpoint", "without + 5, filled" => |circle, clip, sink|
        drawn(midpoint::circle(*circle, Decision::WithoutFive, Style::Filled, clip, sink));
    "circle", "second differences", "outline" => |circle, clip, sink|
        drawn(second_differences::circle(*circle, Style::Outline, clip, sink));
    "circle", "second differences", "filled" => |circle, clip, sink|
        drawn(second_differences::circle(*circle, Style::Filled, clip, sink));
    "circle", "n-gon", "n = 8, outline" => |circle, clip, sink|
        drawn(ngon::circle::<8, _>(*circle, Style::Outline, clip, sink));
    "circle", "n-gon", "n = 16, outline" => |circle, clip, sink|
        drawn(ngon::circle::<16, _>(*circle, Style::Outline, clip, sink));
    "circle", "n-gon", "n = 32, outline" => |circle, clip, sink|
        drawn(ngon::circle::<32, _>(*circle, Style::Outline, clip, sink));
    "circle", "n-gon", "n = 64, outline" => |circle, clip, sink|
        drawn(ngon::circle::<64, _>(*circle, Style::Outline, clip, sink));
    "circle", "n-gon", "n = 128, outline" => |circle, clip, sink|
        drawn(ngon::circle::<128, _>(*circle, Style::Outline, clip, sink));
    "circle", "n-gon", "n = 8, filled" => |circle, clip, sink|
        drawn(ngon::circle::<8, _>(*circle, Style::Filled, clip, sink));
    "circle", "n-gon", "n = 16, filled" => |circle, clip, sink|
        drawn(ngon::circle::<16, _>(*circle, Style::Filled, clip, sink));
    "circle", "n-gon", "n = 32, filled" => |circle, clip, sink|
        drawn(ngon::circle::<32, _>(*circle, Style::Filled, clip, sink));
    "circle", "n-gon", "n = 64, filled" => |circle, clip, sink|
        drawn(ngon::circle::<64, _>(*circle, Style::Filled, clip, sink));
    "circle", "n-gon", "n = 128, filled" => |circle, clip, sink|
        drawn(ngon::circle::<128, _>(*circle, Style::Filled, clip, sink));
    "circle", "spanfill", "filled" => |circle, clip, sink|
        drawn(shipped(*circle).spans(clip, &mut Fragments(sink)));
}
