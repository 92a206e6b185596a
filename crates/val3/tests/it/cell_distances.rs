//! Distances of `val3 run` with a `cell.toml`, compared with the figures of other programs:
//!
//! - `pairs.json` of val3-collision: 36 pairs of shapes, of which link 1 carries the first.
//! - `arms.jsonl`: 24 joint positions of three arms with a tool and four things. Closed forms; coal 3.0.3 agrees to 1e-6 mm.
//! - `scenes.jsonl`: random things in frames, tools and things, by coal 3.0.3; `scenes.py` writes the file.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use serde_json::Value;

use crate::support::Folder;

/// Greatest difference to the reference, in mm.
const TOLERANCE: f64 = 1e-3;

/// Smallest distances of a run, by the names of both things.
type Distances = BTreeMap<(String, String), f64>;

/// Runs an application that ends immediately, with the things of `cell.toml` around the arm.
fn distances(folder: &Folder, arm: &str, start: &Value) -> Distances {
    folder.write("val3.toml", &format!("arm = \"{arm}\"\n[run]\nstart = {start}\n"));
    let run = folder.val3(&["run", "--events", "events.jsonl"]);
    assert!(run.code <= 1 && !run.stderr.contains("cannot"), "{}", run.stderr);
    let events = folder.read("events.jsonl");
    let events = events.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    let ends = events.filter(|event| event["kind"] == "clearance" && event["state"] == "clear");
    let name = |of: &Value| of.as_str().unwrap().to_owned();
    ends.map(|event| ((name(&event["a"]), name(&event["b"])), event["distance"].as_f64().unwrap())).collect()
}

#[track_caller]
fn assert_distance(found: &Distances, a: &str, b: &str, expected: f64, case: &str) {
    let get = |a: &str, b: &str| found.get(&(a.to_owned(), b.to_owned())).copied();
    let distance = get(a, b).or_else(|| get(b, a)).unwrap_or_else(|| panic!("{case}: no {a} - {b} in {found:?}"));
    assert!((distance - expected).abs() < TOLERANCE, "{case}: {a} - {b}: {distance} instead of {expected}");
}

/// The text form of an STL file. The corners of a hull become a strip of triangles.
fn stl(mesh: &Value) -> String {
    let points = mesh["points"].as_array().unwrap();
    let triangles: Vec<[usize; 3]> = match mesh.get("triangles") {
        Some(triangles) => serde_json::from_value(triangles.clone()).unwrap(),
        None => (2..points.len()).map(|last| [last - 2, last - 1, last]).collect(),
    };
    let mut text = "solid mesh\n".to_owned();
    for point in triangles.iter().flatten().map(|corner| &points[*corner]) {
        writeln!(text, "vertex {} {} {}", point[0], point[1], point[2]).unwrap();
    }
    text + "endsolid mesh\n"
}

fn write_meshes(folder: &Folder, meshes: &Value) {
    for (name, mesh) in meshes.as_object().unwrap() {
        folder.write(name, &stl(mesh));
    }
}

fn lines(text: &str) -> impl Iterator<Item = Value> {
    text.lines().map(|line| serde_json::from_str(line).unwrap())
}

/// An object of `cell.toml` with the shape and pose of `pairs.json`.
fn object(name: &str, carrier: &str, of: &Value, folder: &Folder) -> String {
    let shape = match of["shape"].as_str().unwrap() {
        "box" => format!("box = {}", of["size"]),
        "sphere" => format!("sphere = {{ radius = {} }}", of["radius"]),
        "cylinder" => format!("cylinder = {{ radius = {}, length = {} }}", of["radius"], of["length"]),
        "capsule" => format!("capsule = {{ from = {}, to = {}, radius = {} }}", of["from"], of["to"], of["radius"]),
        form => {
            folder.write(&format!("{name}.stl"), &stl(of));
            format!("mesh = \"{name}.stl\"\nhull = {}", form == "hull")
        }
    };
    format!("[[object]]\nname = \"{name}\"\nin = \"{carrier}\"\nat = {}\n{shape}\n", of["pose"])
}

#[test]
fn pairs_of_shapes_have_the_distances_of_other_programs() {
    let cases: Vec<Value> =
        serde_json::from_str(include_str!("../../../val3-collision/tests/suite/pairs.json")).unwrap();
    for case in &cases {
        let folder = Folder::with("cls()");
        // With all joints at zero, the frame of link 1 is `world`.
        let [a, b] =
            [("a", "link1"), ("b", "world")].map(|(name, carrier)| object(name, carrier, &case[name], &folder));
        folder.write("cell.toml", &format!("clearance = 5000\n{a}{b}"));
        let found = distances(&folder, "tx2-60l", &serde_json::json!([0, 0, 0, 0, 0, 0]));
        let depth = case.get("depth").map(|depth| -depth.as_f64().unwrap());
        let expected = depth.unwrap_or_else(|| case["distance"].as_f64().unwrap());
        assert_distance(&found, "a", "b", expected, case["name"].as_str().unwrap());
    }
    assert_eq!(cases.len(), 36);
}

/// The file of a built-in arm with other capsules.
fn arm_file(name: &str, shapes: &str) -> String {
    let path = format!("{}/../val3-kinematics/arms/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let (head, _) = text.split_once("[shapes]").unwrap();
    format!("{head}[shapes]\n{shapes}")
}

/// Overlapping pairs of arm parts, without pairs that are never compared.
fn overlaps(case: &Value, axes: usize) -> BTreeSet<(String, String)> {
    let number = |name: &str| match name {
        "base" => 0,
        "tool" => axes + 1,
        link => link.strip_prefix("link").unwrap().parse().unwrap(),
    };
    let pairs = case["overlaps"].as_array().unwrap().iter().map(|pair| pair.as_str().unwrap().split_once(' ').unwrap());
    let compared = pairs.filter(|(a, b)| {
        let (a, b) = (number(a), number(b));
        b - a >= if b > axes { 4 } else { 3 } && ![(2, 5), (2, 6)].contains(&(a, b))
    });
    compared.map(|(a, b)| (a.to_owned(), b.to_owned())).collect()
}

#[test]
fn arms_in_24_positions_have_the_distances_of_other_programs() {
    let folder = Folder::with("cls()");
    let (mut axes, mut compared) = (6, 0);
    for case in lines(include_str!("cell_distances/arms.jsonl")) {
        if let Some(arm) = case.get("arm").and_then(Value::as_str) {
            folder.write("arm.toml", &arm_file(arm, case["shapes"].as_str().unwrap()));
            folder.write("cell.toml", case["cell"].as_str().unwrap());
            write_meshes(&folder, &case["meshes"]);
            continue;
        }
        let name = case["name"].as_str().unwrap();
        axes = case["start"].as_array().map_or(axes, Vec::len);
        let found = distances(&folder, "arm.toml", &case["start"]);
        for (pair, expected) in case["distances"].as_object().unwrap() {
            let (a, b) = pair.split_once(' ').unwrap();
            match expected.as_f64().unwrap() {
                0.0 => assert!(
                    found.iter().any(|((one, other), depth)| (one.as_str(), other.as_str()) == (a, b) && *depth <= 0.0)
                ),
                expected => assert_distance(&found, a, b, expected, name),
            }
            compared += 1;
        }
        let is_arm = |name: &str| name == "base" || name == "tool" || name.starts_with("link");
        let own: BTreeSet<_> = found.into_keys().filter(|(a, b)| is_arm(a) && is_arm(b)).collect();
        assert_eq!(own, overlaps(&case, axes), "{name}");
    }
    assert_eq!(compared, 16 * 7 * 4 + 8 * 5 * 4);
}

#[test]
fn random_cells_have_the_distances_of_coal() {
    let mut compared = 0;
    for case in lines(include_str!("cell_distances/scenes.jsonl")) {
        let name = case["name"].as_str().unwrap();
        let head = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database \
                    xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
                    xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n";
        let data = case["data"].as_str().unwrap();
        let folder = Folder::with("cls()");
        folder.write("usrapp/main/main.dtx", &format!("{head}{data}  </Datas>\n</Database>\n"));
        folder.write("cell.toml", case["cell"].as_str().unwrap());
        write_meshes(&folder, &case["meshes"]);
        let found = distances(&folder, case["arm"].as_str().unwrap(), &case["start"]);
        for (pair, expected) in case["distances"].as_object().unwrap() {
            let (a, b) = pair.split_once(' ').unwrap();
            assert_distance(&found, a, b, expected.as_f64().unwrap(), name);
            compared += 1;
        }
    }
    assert_eq!(compared, 56);
}
