//! `distances/arms.json`: 24 positions of three arms with the exact distances between their links, a tool and four
//! things. Two libraries, coal 3.0.3 and python-fcl 0.7.0, agree with them within 1e-5 mm.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

use serde_json::{Map, Value};
use val3_collision::{Nearness, PlacedShape, Shape, nearest};
use val3_geometry::{IsometryMatrix3, Trsf, Vector3};
use val3_kinematics::{Arm, Joints};

/// Greatest difference to the reference, in mm.
const TOLERANCE: f64 = 1e-3;

/// A shape of a case at its place in world.
type Body = (Shape, IsometryMatrix3<f64>);

fn numbers<const N: usize>(of: &Value) -> [f64; N] {
    let mut numbers = of.as_array().unwrap().iter().map(|number| number.as_f64().unwrap());
    std::array::from_fn(|_| numbers.next().unwrap_or_default())
}

fn shape(of: &Value) -> Shape {
    let radius = || of["radius"].as_f64().unwrap();
    let points = || of["points"].as_array().unwrap().iter().map(|point| numbers(point).into()).collect::<Vec<_>>();
    let triangle = |of: &Value| numbers::<3>(of).map(|number| number as u32);
    match of["shape"].as_str().unwrap() {
        "box" => Shape::cuboid(&numbers(&of["size"]).into()),
        "capsule" => Shape::capsule(numbers(&of["from"]).into(), numbers(&of["to"]).into(), radius()),
        "hull" => Shape::hull(&points()),
        "mesh" => {
            let triangles: Vec<_> = of["triangles"].as_array().unwrap().iter().map(triangle).collect();
            Shape::surface(&points(), &triangles)
        }
        other => panic!("{other}"),
    }
    .unwrap()
}

fn pose(of: &Value) -> IsometryMatrix3<f64> {
    let [x, y, z, rx, ry, rz] = numbers(&of["pose"]);
    Trsf::new([x, y, z], [rx, ry, rz]).isometry()
}

/// Returns the body of this name: a part of the arm, the tool at the flange, or a thing.
fn body(name: &str, case: &Value, things: &Value) -> Body {
    let arm = Arm::by_name(case["arm"].as_str().unwrap()).unwrap();
    let joints: Joints = numbers(&case["joints"]);
    let part = if name == "base" { Some(0) } else { name.strip_prefix("link").and_then(|number| number.parse().ok()) };
    match part {
        Some(part) => (shape(&case["shapes"][name]), arm.parts(&joints)[part]),
        None if name == "tool" => (shape(&case["tool"]), arm.flange(&joints) * pose(&case["tool"])),
        None => (shape(&things[name]), pose(&things[name])),
    }
}

/// Returns the differences above the tolerance.
fn differences(case: &Value, things: &Value, expected: &Map<String, Value>) -> Vec<String> {
    let mut found = Vec::new();
    for (pair, distance) in expected {
        let (first, second) = pair.split_once(' ').unwrap();
        let [a, b] = [first, second].map(|name| body(name, case, things));
        let computed = between(&a, &b);
        let distance = distance.as_f64().unwrap();
        if (computed - distance).abs() > TOLERANCE {
            found.push(format!("{} {pair}: {computed} instead of {distance}", case["name"]));
        }
    }
    found
}

fn between(a: &Body, b: &Body) -> f64 {
    let [a, b] = [a, b].map(|(shape, pose)| PlacedShape { shape, pose });
    match nearest(a, b, 1e4) {
        Nearness::Apart(closest) => closest.distance,
        Nearness::Overlap(_) => 0.0,
        Nearness::Beyond => f64::INFINITY,
    }
}

#[test]
fn distances_of_arms_are_those_of_other_libraries() {
    let cases: Vec<Value> = serde_json::from_str(include_str!("distances/arms.json")).unwrap();
    assert_eq!(cases.len(), 24);
    let mut wrong = Vec::new();
    let mut things = &Value::Null;
    let mut count = 0;
    for case in &cases {
        // A case without things of its own has those of the cases before.
        things = if case["things"].is_object() { &case["things"] } else { things };
        for expected in [&case["distances"], &case["self"]].map(|list| list.as_object().unwrap()) {
            count += expected.len();
            wrong.extend(differences(case, things, expected));
        }
    }
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(count > 900, "{count}");
}

/// The shipped shapes are the measured ones up to rounding; short capsules are inclined a little differently.
#[test]
fn shipped_shapes_are_near_the_measured_ones() {
    let cases: Vec<Value> = serde_json::from_str(include_str!("distances/arms.json")).unwrap();
    for case in cases.iter().filter(|case| case["shapes"].is_object()) {
        let arm = Arm::by_name(case["arm"].as_str().unwrap()).unwrap();
        for (part, capsules) in arm.shapes().iter().enumerate() {
            let name = if part == 0 { "base".to_owned() } else { format!("link{part}") };
            let measured = &case["shapes"][&name];
            let [capsule] = capsules[..] else { panic!("{name}") };
            for (own, key) in [(capsule.from, "from"), (capsule.to, "to")] {
                let difference = own - Vector3::from(numbers::<3>(&measured[key]));
                assert!(difference.amax() < 3.5, "{} {name} {key}: {difference}", arm.name());
            }
            assert!(capsule.radius >= measured["radius"].as_f64().unwrap() - 0.5, "{} {name}", arm.name());
        }
    }
}
