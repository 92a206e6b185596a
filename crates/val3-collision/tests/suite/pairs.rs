//! `pairs.json`: 36 pairs of shapes with their exact distances. Two libraries, coal 3.0.3 and python-fcl 0.7.0, agree
//! with them within 1e-6 and 6e-4 mm.

use serde_json::Value;
use val3_collision::{Nearness, PlacedShape, Shape, nearest};
use val3_geometry::{IsometryMatrix3, Trsf, Vector3};

/// Greatest difference to the reference, in mm.
const TOLERANCE: f64 = 1e-3;

fn number(of: &Value, key: &str) -> f64 {
    of[key].as_f64().unwrap_or_else(|| panic!("no {key} in {of}"))
}

fn numbers<const N: usize>(of: &Value) -> [f64; N] {
    let numbers: Vec<f64> = of.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect();
    numbers.try_into().unwrap()
}

fn points(of: &Value) -> Vec<Vector3<f64>> {
    of["points"].as_array().unwrap().iter().map(|point| numbers(point).into()).collect()
}

fn shape(of: &Value) -> Shape {
    let shape = match of["shape"].as_str().unwrap() {
        "box" => Shape::cuboid(&numbers(&of["size"]).into()),
        "sphere" => Shape::sphere(number(of, "radius")),
        "capsule" => Shape::capsule(numbers(&of["from"]).into(), numbers(&of["to"]).into(), number(of, "radius")),
        "cylinder" => Shape::cylinder(number(of, "radius"), number(of, "length")),
        "hull" => Shape::hull(&points(of)),
        "mesh" => {
            let triangle = |of: &Value| numbers::<3>(of).map(|number| number as u32);
            let triangles: Vec<[u32; 3]> = of["triangles"].as_array().unwrap().iter().map(triangle).collect();
            Shape::surface(&points(of), &triangles)
        }
        other => panic!("{other}"),
    };
    shape.unwrap()
}

fn pose(of: &Value) -> IsometryMatrix3<f64> {
    let [x, y, z, rx, ry, rz] = numbers(&of["pose"]);
    Trsf::new([x, y, z], [rx, ry, rz]).isometry()
}

#[test]
fn distances_and_depths_are_those_of_other_libraries() {
    let cases: Vec<Value> = serde_json::from_str(include_str!("pairs.json")).unwrap();
    assert_eq!(cases.len(), 36);
    for case in &cases {
        let [a, b] = ["a", "b"].map(|key| (shape(&case[key]), pose(&case[key])));
        let [a, b] = [&a, &b].map(|(shape, pose)| PlacedShape { shape, pose });
        let distance = number(case, "distance");
        for (first, second) in [(a, b), (b, a)] {
            match nearest(first, second, distance + 1.0) {
                Nearness::Apart(closest) => {
                    assert!((closest.distance - distance).abs() < TOLERANCE, "{closest:?} {case}")
                }
                Nearness::Overlap(overlap) => {
                    let depth = case.get("depth").map(|depth| depth.as_f64().unwrap());
                    assert_eq!(overlap.depth.is_some(), depth.is_some(), "{}", case["name"]);
                    let difference = overlap.depth.unwrap_or_default() - depth.unwrap_or_default();
                    assert!(difference.abs() < TOLERANCE, "{overlap:?} {}", case["name"]);
                }
                Nearness::Beyond => panic!("beyond: {}", case["name"]),
            }
        }
        if distance > 1.0 {
            assert_eq!(nearest(a, b, distance - 1.0), Nearness::Beyond, "{}", case["name"]);
        }
    }
}
