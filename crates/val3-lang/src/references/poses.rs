//! Poses of many values, for example of all values in a scene.

use rustc_hash::FxHashMap;
use val3_geometry::{IsometryMatrix3, Trsf};

use super::{ChainRoot, FLANGE, WORLD, frame_of, reference};
use crate::call::{FrameRef, PointRef, StoredValue, ToolRef};
use crate::fault::Result;
use crate::memory::{Memory, Place};

/// Poses of frames in `world` and of tools on `flange`. Each pose is computed from its father's cached pose, so the
/// time is proportional to the number of values, regardless of the chain lengths.
#[derive(Debug)]
pub struct Poses<'m> {
    memory: &'m Memory,
    known: FxHashMap<Place, Result<IsometryMatrix3<f64>>>,
}

impl<'m> Poses<'m> {
    /// Creates an empty cache; `memory` contains the values.
    #[must_use]
    pub fn new(memory: &'m Memory) -> Self {
        Self { memory, known: FxHashMap::default() }
    }

    /// Pose of a frame in `world`.
    ///
    /// # Errors
    /// The errors of [`of_frame`](super::of_frame).
    pub fn of_frame(&mut self, FrameRef(frame): FrameRef) -> Result<Trsf> {
        self.pose(frame, &WORLD).map(Trsf::from)
    }

    /// Pose of a tool on `flange`.
    ///
    /// # Errors
    /// The errors of [`of_tool`](super::of_tool).
    pub fn of_tool(&mut self, ToolRef(tool): ToolRef) -> Result<Trsf> {
        self.pose(tool, &FLANGE).map(Trsf::from)
    }

    /// Pose of a point in `world`.
    ///
    /// # Errors
    /// The errors of [`of_point`](super::of_point).
    pub fn of_point(&mut self, point: PointRef) -> Result<Trsf> {
        let inner = Trsf::read(self.memory, point.0)?;
        let FrameRef(frame) = frame_of(self.memory, point)?;
        Ok(Trsf::from(self.pose(frame, &WORLD)? * inner.isometry()))
    }

    /// Pose of a frame or tool whose chain ends at `root`.
    fn pose(&mut self, start: Place, root: &ChainRoot) -> Result<IsometryMatrix3<f64>> {
        let mut open = Vec::new();
        let mut at = start;
        let mut pose = loop {
            if at.store == root.store {
                break root.check(self.memory, at).map(|()| IsometryMatrix3::identity());
            }
            if let Some(known) = self.known.get(&at) {
                break *known;
            }
            // In a circular chain, this entry is found again.
            self.known.insert(at, Err(root.lacking));
            open.push(at);
            match reference(self.memory, at) {
                Ok(Some(next)) => at = next,
                Ok(None) => break Err(root.lacking),
                Err(fault) => break Err(fault),
            }
        };
        for place in open.into_iter().rev() {
            pose = pose.and_then(|outer| Ok(outer * Trsf::read(self.memory, place)?.isometry()));
            self.known.insert(place, pose);
        }
        pose
    }
}

#[cfg(test)]
mod tests {
    use val3_geometry::chain;

    use super::super::{of_frame, of_point, of_tool};
    use super::*;
    use crate::memory::LinkPlace;
    use crate::testing::Bench;

    #[test]
    fn poses_are_those_of_the_chains() {
        let globals = "frame fA; frame fB; frame fC; frame fRow[3]; point pA; point pNone; tool tA; tool tB";
        let mut bench = Bench::default().global(globals).with("fA", &[1.0, 2.0, 3.0, 10.0, 20.0, 30.0]);
        bench.set("fB", &[4.0, 5.0, 6.0, 40.0, 50.0, 60.0]);
        bench.set("tA", &[0.0, 0.0, 7.0, 0.0, 90.0, 0.0]);
        for line in [
            "link(fA,world)",
            "link(fB,fA)",
            "link(fC,fB)",
            "link(pA,fC)",
            "link(tA,flange)",
            "link(tB,tA)",
            "link(fRow[0],fRow[1])",
            "link(fRow[1],fRow[2])",
            "link(fRow[2],fRow[1])",
        ] {
            assert_eq!(bench.run(line), "", "{line}");
        }
        let memory = &bench.memory;
        let place = |name: &str| Place::first(bench.view(name).store);
        let mut poses = Poses::new(memory);
        let position = |way: Result<super::super::Chain>| way.map(|way| chain::position(&way, &[]));
        for name in ["fC", "fB", "fA", "world"] {
            let frame = FrameRef(place(name));
            assert!(is_near(poses.of_frame(frame), position(of_frame(memory, FrameRef(place(name))))), "{name}");
        }
        let row = memory.store(place("fRow").store).unwrap();
        for number in 0..3 {
            let frame = || FrameRef(row.place(place("fRow").store, number));
            assert!(poses.of_frame(frame()).is_err());
            assert_eq!(poses.of_frame(frame()).err(), of_frame(memory, frame()).err(), "{number}");
        }
        for name in ["pA", "pNone"] {
            let point = || PointRef(place(name));
            assert!(is_near(poses.of_point(point()), position(of_point(memory, point()))), "{name}");
        }
        for name in ["tB", "tA", "flange"] {
            let tool = || ToolRef(place(name));
            assert!(is_near(poses.of_tool(tool()), position(of_tool(memory, tool()))), "{name}");
        }
    }

    /// Without cached poses this would take hours, and recursion would overflow the stack.
    #[test]
    fn a_long_chain_is_followed_once() {
        const COUNT: u32 = 100_000;
        let mut bench = Bench::default().global(&format!("frame fRow[{COUNT}]"));
        bench.run("link(fRow[0],world)");
        let row = bench.view("fRow").store;
        let places: Vec<Place> = {
            let store = bench.memory.store(row).unwrap();
            (0..COUNT).map(|number| store.place(row, number)).collect()
        };
        for pair in places.windows(2) {
            bench.memory.set_link(pair[1], 0, LinkPlace::Data(pair[0])).unwrap();
        }
        bench.memory.set_num(places[0], 0, 1.0).unwrap();
        let mut poses = Poses::new(&bench.memory);
        for place in places.iter().rev() {
            assert_eq!(poses.of_frame(FrameRef(*place)).map(|pose| pose.x), Ok(1.0));
        }
        // Makes the chain circular.
        bench.memory.set_link(places[0], 0, LinkPlace::Data(places[99_999])).unwrap();
        let mut poses = Poses::new(&bench.memory);
        for place in places {
            assert!(poses.of_frame(FrameRef(place)).is_err());
        }
    }

    fn is_near(one: Result<Trsf>, other: Result<Trsf>) -> bool {
        match (one, other) {
            (Ok(one), Ok(other)) => one.distance(&other) < 1e-12 && (one.rz - other.rz).abs() < 1e-12,
            (one, other) => one == other,
        }
    }
}
