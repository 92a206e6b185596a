//! Distances of an arm from the things around it: `cargo bench --bench clearance`.
//!
//! A TX2-60L with a tool moves for 42 s between random joint positions at nominal speed, among 20 hulls and 5 surfaces of
//! 5,000 triangles. An iteration has 10,500 samples of 4 ms. Targets for a sample: 14 µs with a clearance of 0 mm, 20 µs
//! with 20 mm, 39 µs with 100 mm. They apply to the roomy cell, in which a sample needs 3 to 4 real distances: 14, 17 and
//! 28 µs were measured on one core. In the crowded cell, in which the arm often touches things, it needs 9 to 34: 64, 96
//! and 252 µs.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, reason = "a cell that cannot be built measures nothing")]

use std::sync::Arc;

use camino::Utf8Path;
use divan::Bencher;
use divan::counter::ItemsCount;
use val3_cell::{
    ArmBase, Cell, CellFile, DataKind, KnownSignal, Mesh, ObjectEntry, Profile, Scene, ShapeKeys, Sight, Surroundings,
    Watch,
};
use val3_geometry::degrees::{cos, sin};
use val3_kinematics::{Arm, Joints};

/// Seconds of a sample.
const CYCLE: f64 = 0.004;

/// Number of samples of an iteration: 42 s.
const SAMPLES: usize = 10_500;

/// Rows and columns of a surface: 5,000 triangles.
const ROWS: u32 = 50;

fn main() {
    divan::main();
}

/// Numbers from 0 to 1, the same in each run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(u32::MAX >> 1)
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.next()
    }
}

/// An application without data. Meshes with a name that begins with `h` are for hulls.
struct Application(Numbers);

impl Surroundings for Application {
    fn mesh(&mut self, path: &Utf8Path) -> Result<Mesh, String> {
        Ok(if path.as_str().starts_with('h') { hull(&mut self.0) } else { torus() })
    }

    fn carrier(&self, _: &str) -> Result<DataKind, Option<String>> {
        Err(None)
    }

    fn signal(&self, _: &str) -> Result<KnownSignal, Option<String>> {
        Err(None)
    }
}

/// About 30 points on an ellipsoid.
fn hull(numbers: &mut Numbers) -> Mesh {
    let points = (0..30).map(|_| {
        let (turn, height) = (numbers.between(0.0, 360.0), numbers.between(-1.0, 1.0));
        let radius = (1.0 - height * height).sqrt();
        [120.0 * radius * cos(turn), 80.0 * radius * sin(turn), 100.0 * height].into()
    });
    Mesh { points: points.collect(), triangles: (2..30).map(|last| [last - 2, last - 1, last]).collect() }
}

fn torus() -> Mesh {
    let angle = |index: u32| 360.0 * f64::from(index) / f64::from(ROWS);
    let place = |index: u32| {
        let (row, column) = (angle(index / ROWS), angle(index % ROWS));
        let radius = 150.0 + 50.0 * cos(column);
        [radius * cos(row), radius * sin(row), 50.0 * sin(column)].into()
    };
    let number = |row: u32, column: u32| (row % ROWS) * ROWS + column % ROWS;
    let cells = (0..ROWS).flat_map(|row| (0..ROWS).map(move |column| (row, column)));
    let triangles = cells.flat_map(|(row, column)| {
        let corners =
            [number(row, column), number(row + 1, column), number(row + 1, column + 1), number(row, column + 1)];
        let [a, b, c, d] = corners;
        [[a, b, c], [a, c, d]]
    });
    Mesh { points: (0..ROWS * ROWS).map(place).collect(), triangles: triangles.collect() }
}

/// Distances of the things from axis 1, in mm.
#[derive(Debug, Clone, Copy)]
enum Room {
    Roomy,
    Crowded,
}

impl Room {
    const fn distances(self) -> [f64; 2] {
        match self {
            Self::Roomy => [1000.0, 2000.0],
            Self::Crowded => [500.0, 1300.0],
        }
    }
}

/// Things at random places in a room, and a tool.
fn cell(arm: &Arm, room: Room, clearance: f64) -> Cell {
    let [least, most] = room.distances();
    let mut numbers = Numbers(7);
    let mut thing = |name: String, is_hull: bool| {
        let (turn, distance) = (numbers.between(0.0, 360.0), numbers.between(least, most));
        let angles = [(); 3].map(|()| numbers.between(-180.0, 180.0));
        let lengths = [distance * cos(turn), distance * sin(turn), numbers.between(-400.0, 900.0)];
        let mesh = Some(format!("{name}.stl").into());
        let shape = ShapeKeys { mesh, hull: Some(is_hull), ..ShapeKeys::default() };
        ObjectEntry { name, at: lengths.into_iter().chain(angles).collect(), shape, ..ObjectEntry::default() }
    };
    let hulls: Vec<ObjectEntry> = (0..20).map(|index| thing(format!("hull{index}"), true)).collect();
    let surfaces = (0..5).map(|index| thing(format!("surface{index}"), false));
    let mut objects: Vec<ObjectEntry> = surfaces.chain(hulls).collect();
    let tool = ShapeKeys { mesh: Some("hand.stl".into()), ..ShapeKeys::default() };
    objects.push(ObjectEntry {
        name: "hand".to_owned(),
        carrier: Some("flange".to_owned()),
        at: vec![0.0, 0.0, 100.0],
        shape: tool,
        ..ObjectEntry::default()
    });
    let file = CellFile { clearance, objects, ..CellFile::default() };
    let base = ArmBase { axes: arm.axes(), height: arm.height() };
    Cell::build(&file, base, &mut Application(Numbers(1))).expect("a cell")
}

/// Joint positions of random moves in which the slowest axis has its nominal speed.
fn path(arm: &Arm) -> Vec<Joints> {
    let mut numbers = Numbers(3);
    let mut path = vec![Joints::default()];
    while path.len() < SAMPLES {
        let from = path.last().copied().unwrap_or_default();
        let mut to = Joints::default();
        for (joint, limits) in to.iter_mut().zip(arm.limits()) {
            *joint = numbers.between(limits.min, limits.max);
        }
        let times =
            (0..arm.axes()).filter_map(|axis| Some((to.get(axis)? - from.get(axis)?).abs() / arm.nominal_speed(axis)));
        let cycles = (times.fold(0.0, f64::max) / CYCLE).ceil().max(1.0);
        let at = |cycle: usize| {
            let fraction = cycle as f64 / cycles;
            let mut joints = from;
            joints.iter_mut().zip(to).for_each(|(joint, to)| *joint += (to - *joint) * fraction);
            joints
        };
        path.extend((1..=cycles as usize).map(at));
    }
    path.truncate(SAMPLES);
    path
}

fn scene(room: Room, clearance: f64) -> (Scene, Vec<Joints>, Arc<Arm>) {
    let arm = Arc::new(Arm::by_name("tx2-60l").expect("a shipped arm"));
    let scene = Scene::new(Arc::new(cell(&arm, room, clearance)), Arc::clone(&arm));
    (scene, path(&arm), arm)
}

/// Calls `see` for each sample of the path.
fn replay(path: &[Joints], arm: &Arc<Arm>, mut see: impl FnMut(&Sight<'_>)) {
    for (index, joints) in path.iter().enumerate() {
        let time = index as f64 * CYCLE;
        see(&Sight { arm, joints: *joints, placement: 0, places: Vec::new(), parts: Arc::default(), time });
    }
}

/// Samples of a watch with a clearance in mm.
fn watch(bencher: Bencher<'_, '_>, room: Room, clearance: f64) {
    let (scene, path, arm) = scene(room, clearance);
    let bencher = bencher.counter(ItemsCount::new(SAMPLES)).with_inputs(|| Watch::new(scene.clone()));
    bencher.bench_local_values(|mut watch| {
        let mut encounters = 0;
        replay(&path, &arm, |sight| encounters += watch.see(sight, &()).len());
        encounters
    });
}

#[divan::bench(args = [0.0, 20.0, 100.0], sample_count = 20, sample_size = 1)]
fn watch_in_a_roomy_cell(bencher: Bencher<'_, '_>, clearance: f64) {
    watch(bencher, Room::Roomy, clearance);
}

#[divan::bench(args = [0.0, 20.0, 100.0], sample_count = 20, sample_size = 1)]
fn watch_in_a_crowded_cell(bencher: Bencher<'_, '_>, clearance: f64) {
    watch(bencher, Room::Crowded, clearance);
}

#[divan::bench(args = [Room::Roomy, Room::Crowded], sample_count = 20, sample_size = 1)]
fn smallest_distance_of_each_sample(bencher: Bencher<'_, '_>, room: Room) {
    let (scene, path, arm) = scene(room, 0.0);
    let scene = Arc::new(scene);
    let bencher = bencher.counter(ItemsCount::new(SAMPLES)).with_inputs(|| Profile::new(Arc::clone(&scene)));
    bencher.bench_local_values(|mut profile| replay(&path, &arm, |sight| _ = profile.see(sight)));
}
