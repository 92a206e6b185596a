//! Poses of many values in mm, for example of all values in a scene.

use rustc_hash::FxHashMap;
use val3_geometry::{IsometryMatrix3, Trsf};

use super::{ChainRoot, FLANGE, WORLD, frame_of, reference, scaled};
use crate::call::{FrameRef, PointRef, StoredValue, ToolRef};
use crate::fault::Result;
use crate::memory::{Memory, Place};
use crate::types::LengthUnit;

/// Poses of frames in `world` and of tools on `flange`, in mm. Each pose is computed from its father's cached pose, so the
/// time is proportional to the number of values, regardless of the chain lengths.
#[derive(Debug)]
pub struct Poses<'m> {
    memory: &'m Memory,
    unit: LengthUnit,
    /// Poses in the length unit.
    known: FxHashMap<Place, Result<IsometryMatrix3<f64>>>,
}

impl<'m> Poses<'m> {
    /// Creates an empty cache; `memory` contains the values, and `unit` is the length unit of their application.
    #[must_use]
    pub fn new(memory: &'m Memory, unit: LengthUnit) -> Self {
        Self { memory, unit, known: FxHashMap::default() }
    }

    /// Pose of a frame in `world`.
    ///
    /// # Errors
    /// The errors of [`of_frame`](super::of_frame).
    pub fn of_frame(&mut self, FrameRef(frame): FrameRef) -> Result<IsometryMatrix3<f64>> {
        self.pose(frame, &WORLD).map(|pose| scaled(pose, self.unit))
    }

    /// Pose of a tool on `flange`.
    ///
    /// # Errors
    /// The errors of [`of_tool`](super::of_tool).
    pub fn of_tool(&mut self, ToolRef(tool): ToolRef) -> Result<IsometryMatrix3<f64>> {
        self.pose(tool, &FLANGE).map(|pose| scaled(pose, self.unit))
    }

    /// Pose of a point in `world`.
    ///
    /// # Errors
    /// The errors of [`of_point`](super::of_point).
    pub fn of_point(&mut self, point: PointRef) -> Result<IsometryMatrix3<f64>> {
        let inner = Trsf::read(self.memory, point.0)?;
        let FrameRef(frame) = frame_of(self.memory, point)?;
        Ok(scaled(self.pose(frame, &WORLD)? * inner.isometry(), self.unit))
    }

    /// Pose of a frame or tool whose chain ends at `root`, in the length unit.
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
    use super::super::{in_millimetres, of_frame, of_point, of_tool};
    use super::*;
    use crate::memory::LinkPlace;
    use crate::testing::Bench;

    #[test]
    fn poses_are_those_of_the_chains_in_mm() {
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
        for unit in [LengthUnit::Millimetre, LengthUnit::Inch] {
            let mut poses = Poses::new(memory, unit);
            let position = |way: Result<super::super::Chain>| way.map(|way| in_millimetres(&way, unit));
            for name in ["fC", "fB", "fA", "world"] {
                let frame = FrameRef(place(name));
                let expected = position(of_frame(memory, FrameRef(place(name))));
                assert!(is_near(poses.of_frame(frame), expected), "{name}");
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
        let mut poses = Poses::new(&bench.memory, LengthUnit::Millimetre);
        for place in places.iter().rev() {
            assert_eq!(poses.of_frame(FrameRef(*place)).map(|pose| pose.translation.x), Ok(1.0));
        }
        // Makes the chain circular.
        bench.memory.set_link(places[0], 0, LinkPlace::Data(places[99_999])).unwrap();
        let mut poses = Poses::new(&bench.memory, LengthUnit::Millimetre);
        for place in places {
            assert!(poses.of_frame(FrameRef(place)).is_err());
        }
    }

    fn is_near(one: Result<IsometryMatrix3<f64>>, other: Result<IsometryMatrix3<f64>>) -> bool {
        match (one, other) {
            (Ok(one), Ok(other)) => (one.to_homogeneous() - other.to_homogeneous()).norm() < 1e-12,
            (one, other) => one == other,
        }
    }
}
