//! Maps of the world, from TopoJSON: as wide as the picture, a degree as long in both directions.

use std::{fs, path::Path};

use kurbo::BezPath;
use serde_json::Value;

use crate::{HEIGHT, Outcome, WIDTH, outline::Shape};

/// All land as one shape.
pub(crate) fn coast(file: &Path) -> Outcome<Vec<Shape>> {
    let map = Map::read(file)?;
    Ok(map.shape(&map.topology["objects"]["land"], [0x6b, 0x8e, 0x4e]).into_iter().collect())
}

/// A shape for each country.
pub(crate) fn countries(file: &Path) -> Outcome<Vec<Shape>> {
    const COLOURS: [[u8; 3]; 5] =
        [[0x8d, 0xd3, 0xc7], [0xff, 0xff, 0xb3], [0xbe, 0xba, 0xda], [0xfb, 0x80, 0x72], [0x80, 0xb1, 0xd3]];
    let map = Map::read(file)?;
    let countries = map.topology["objects"]["countries"]["geometries"].as_array().ok_or("no countries")?;
    Ok(countries.iter().zip(COLOURS.into_iter().cycle()).filter_map(|(country, rgb)| map.shape(country, rgb)).collect())
}

struct Map {
    topology: Value,
    /// In degrees.
    arcs: Vec<Vec<[f64; 2]>>,
}

impl Map {
    fn read(file: &Path) -> Outcome<Self> {
        let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
        let topology: Value = serde_json::from_str(&text)?;
        let arcs = arcs(&topology).ok_or("no TopoJSON with quantized arcs")?;
        Ok(Self { topology, arcs })
    }

    fn shape(&self, geometry: &Value, rgb: [u8; 3]) -> Option<Shape> {
        let mut path = BezPath::new();
        for ring in rings(geometry) {
            let ring = unrolled(ring.iter().flat_map(|&index| arc(&self.arcs, index)));
            add_ring(&mut path, &ring, 0.0);
            // What lies beyond the map's one edge is seen at the other.
            if ring.iter().any(|[longitude, _]| *longitude > 180.0) {
                add_ring(&mut path, &ring, -360.0);
            }
            if ring.iter().any(|[longitude, _]| *longitude < -180.0) {
                add_ring(&mut path, &ring, 360.0);
            }
        }
        Shape::new(rgb, true, &path)
    }
}

fn add_ring(path: &mut BezPath, ring: &[[f64; 2]], to_the_east: f64) {
    let mut points = ring.iter().map(|[longitude, latitude]| pixels([longitude + to_the_east, *latitude]));
    let Some(first) = points.next() else { return };
    path.move_to(first);
    points.for_each(|point| path.line_to(point));
    path.close_path();
}

/// Without jumps from one edge of the map to the other; what goes around the world is closed below the South Pole.
fn unrolled(ring: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut turns = 0.0;
    let mut last = None;
    let step = |[longitude, latitude]: [f64; 2]| {
        let jump: f64 = last.map_or(0.0, |last| longitude - last);
        turns -= if jump.abs() > 180.0 { jump.signum() } else { 0.0 };
        last = Some(longitude);
        [longitude + 360.0 * turns, latitude]
    };
    let mut ring: Vec<[f64; 2]> = ring.map(step).collect();
    if let (&[first, _], &[end, _]) = (&ring[0], &ring[ring.len() - 1])
        && (end - first).abs() > 180.0
    {
        ring.extend([[end, -90.0], [first, -90.0]]);
    }
    ring
}

fn pixels([longitude, latitude]: [f64; 2]) -> (f64, f64) {
    let scale = WIDTH / 360.0;
    (WIDTH / 2.0 + longitude * scale, HEIGHT / 2.0 - latitude * scale)
}

fn arcs(topology: &Value) -> Option<Vec<Vec<[f64; 2]>>> {
    let pair = |value: &Value| Some([value.get(0)?.as_f64()?, value.get(1)?.as_f64()?]);
    let transform = topology.get("transform")?;
    let (scale, translate) = (pair(transform.get("scale")?)?, pair(transform.get("translate")?)?);
    let arc = |arc: &Value| {
        let [mut x, mut y] = [0.0, 0.0];
        let steps = arc.as_array()?.iter().map(pair);
        let points = steps.map(|step| {
            let [dx, dy] = step?;
            (x, y) = (x + dx, y + dy);
            Some([x * scale[0] + translate[0], y * scale[1] + translate[1]])
        });
        points.collect::<Option<Vec<_>>>()
    };
    topology.get("arcs")?.as_array()?.iter().map(arc).collect()
}

/// The arc, or, of ~index, the arc reversed; without its last point, which is the next one's first.
fn arc(arcs: &[Vec<[f64; 2]>], index: i64) -> Vec<[f64; 2]> {
    let mut points = arcs[index.max(!index) as usize].clone();
    if index < 0 {
        points.reverse();
    }
    points.pop();
    points
}

/// The rings of all polygons of a geometry, as the indices of their arcs.
fn rings(geometry: &Value) -> Vec<Vec<i64>> {
    let members = geometry["geometries"].as_array().into_iter().flatten().flat_map(rings);
    let mut found: Vec<Vec<i64>> = members.collect();
    collect_rings(&geometry["arcs"], &mut found);
    found
}

fn collect_rings(value: &Value, found: &mut Vec<Vec<i64>>) {
    let Some(list) = value.as_array() else { return };
    if list.iter().all(Value::is_i64) {
        found.push(list.iter().filter_map(Value::as_i64).collect());
    } else {
        list.iter().for_each(|inner| collect_rings(inner, found));
    }
}
