//! Chains of fathers from points, frames and tools to `world` and `flange` (9.4 to 9.6).
//!
//! The last element of a chain has no father if the chain is circular, or if its father no longer exists because an
//! array has shrunk or a library was unloaded.

mod poses;

use smallvec::SmallVec;
use val3_geometry::{IsometryMatrix3, Trsf, chain};

use crate::call::{FrameRef, PointRef, StoredValue, ToolRef};
use crate::fault::{Fault, Result};
use crate::memory::{LinkPlace, Memory, Place, StoreId};
use crate::runtime_errors::{
    FLANGE_CHANGED, FRAME_WITHOUT_REFERENCE, POINT_WITHOUT_REFERENCE, TOOL_WITHOUT_REFERENCE, WORLD_CHANGED,
};
use crate::types::LengthUnit;

pub use poses::Poses;

/// Transformations from the inside out, as [`val3_geometry::chain`] requires.
///
/// Short chains are stored inline: with a `Vec`, `distance` of two points takes 1.4 times as long.
pub type Chain = SmallVec<[Trsf; 4]>;

/// Resolves a chain in this length unit to a pose in mm.
#[must_use]
pub fn in_millimetres(chain: &[Trsf], unit: LengthUnit) -> IsometryMatrix3<f64> {
    scaled(chain::resolve(chain), unit)
}

/// Converts a pose from this length unit to mm.
fn scaled(mut pose: IsometryMatrix3<f64>, unit: LengthUnit) -> IsometryMatrix3<f64> {
    pose.translation.vector *= unit.millimetres();
    pose
}

/// Root of frame or tool chains.
struct ChainRoot {
    store: StoreId,
    changed: Fault,
    lacking: Fault,
}

impl ChainRoot {
    /// Checks that the root has not been moved.
    fn check(&self, memory: &Memory, at: Place) -> Result<()> {
        if Trsf::read(memory, at)? == Trsf::IDENTITY { Ok(()) } else { Err(self.changed) }
    }
}

const WORLD: ChainRoot =
    ChainRoot { store: Memory::WORLD, changed: Fault(WORLD_CHANGED), lacking: Fault(FRAME_WITHOUT_REFERENCE) };

const FLANGE: ChainRoot =
    ChainRoot { store: Memory::FLANGE, changed: Fault(FLANGE_CHANGED), lacking: Fault(TOOL_WITHOUT_REFERENCE) };

/// Chain from a frame to `world`.
///
/// # Errors
/// 161 if `world` was changed, 163 if a frame in the chain has no father.
pub fn of_frame(memory: &Memory, FrameRef(frame): FrameRef) -> Result<Chain> {
    follow(memory, Chain::new(), frame, &WORLD)
}

/// Chain from a tool to `flange`.
///
/// # Errors
/// 160 if `flange` was changed, 164 if a tool in the chain has no father.
pub fn of_tool(memory: &Memory, ToolRef(tool): ToolRef) -> Result<Chain> {
    follow(memory, Chain::new(), tool, &FLANGE)
}

/// Chain from a point to `world`.
///
/// # Errors
/// 161 if `world` was changed, 162 if the point has no father, 163 if a frame in the chain has none.
pub fn of_point(memory: &Memory, point: PointRef) -> Result<Chain> {
    let inner = Chain::from_iter([Trsf::read(memory, point.0)?]);
    let FrameRef(frame) = frame_of(memory, point)?;
    follow(memory, inner, frame, &WORLD)
}

/// Father frame of a point.
///
/// # Errors
/// 162 if it has none.
pub fn frame_of(memory: &Memory, PointRef(point): PointRef) -> Result<FrameRef> {
    let frame = reference(memory, point)?;
    frame.map(FrameRef).ok_or(Fault(POINT_WITHOUT_REFERENCE))
}

/// Father of a frame, a tool or a point; `None` if it has no father or the father does not exist.
///
/// # Errors
/// 20 if the value itself does not exist, 82 if it must not refer to its father.
pub fn reference(memory: &Memory, at: Place) -> Result<Option<Place>> {
    match memory.link(at, 0)? {
        LinkPlace::Data(reference) if memory.link(reference, 0).is_ok() => {
            memory.check_reference(at, reference)?;
            Ok(Some(reference))
        }
        LinkPlace::Data(_) | LinkPlace::None | LinkPlace::Port(_) => Ok(None),
    }
}

/// Appends the transformations from `start` to `root`.
fn follow(memory: &Memory, mut chain: Chain, start: Place, root: &ChainRoot) -> Result<Chain> {
    let mut way = SmallVec::<[Place; 4]>::new();
    let mut at = start;
    // Detects loops by Brent's algorithm: the checkpoint moves forward at doubling distances until it is inside a loop
    // that is shorter than the distance.
    let mut checkpoint = None;
    while at.store != root.store {
        if checkpoint == Some(at) {
            return Err(root.lacking);
        }
        if way.len().is_power_of_two() {
            checkpoint = Some(at);
        }
        way.push(at);
        at = reference(memory, at)?.ok_or(root.lacking)?;
    }
    root.check(memory, at)?;
    for place in way {
        chain.push(Trsf::read(memory, place)?);
    }
    Ok(chain)
}

#[cfg(test)]
mod tests {
    use super::{Chain, FrameRef, Place, of_frame};
    use crate::fault::Fault;
    use crate::testing::Bench;

    fn frame(bench: &Bench, name: &str) -> FrameRef {
        FrameRef(Place::first(bench.view(name).store))
    }

    #[test]
    fn a_chain_leads_from_the_inside_out() {
        let mut bench = Bench::default().global("frame fCell; frame fTable").with("fCell", &[1.0]);
        bench.set("fTable", &[2.0]);
        bench.run("link(fTable,fCell)");
        bench.run("link(fCell,world)");
        let chain = of_frame(&bench.memory, frame(&bench, "fTable")).unwrap();
        assert_eq!(chain.iter().map(|trsf| trsf.x).collect::<Vec<_>>(), [2.0, 1.0]);
        assert_eq!(of_frame(&bench.memory, frame(&bench, "world")), Ok(Chain::new()));
    }

    #[test]
    fn a_circle_is_an_error() {
        let mut bench = Bench::default().global("frame fA; frame fB; frame fC");
        for line in ["link(fA,fB)", "link(fB,fC)", "link(fC,fB)"] {
            assert_eq!(bench.run(line), "");
        }
        assert_eq!(of_frame(&bench.memory, frame(&bench, "fA")), Err(Fault(163)));
        bench.run("link(fC,fC)");
        assert_eq!(of_frame(&bench.memory, frame(&bench, "fA")), Err(Fault(163)));
        bench.run("link(fC,world)");
        assert_eq!(of_frame(&bench.memory, frame(&bench, "fA")).map(|chain| chain.len()), Ok(3));
    }

    #[test]
    fn a_lost_reference_is_an_error() {
        let mut bench = Bench::default().global("frame fA; frame fB; frame fRow[2]");
        bench.run("link(fA,fRow[1])");
        bench.run("link(fRow[1],fB)");
        bench.run("link(fB,world)");
        assert!(of_frame(&bench.memory, frame(&bench, "fA")).is_ok());
        let removed = bench.view("fB").store;
        bench.memory.remove(removed);
        assert_eq!(of_frame(&bench.memory, frame(&bench, "fA")), Err(Fault(163)));
        bench.run("delete(fRow[1])");
        assert_eq!(of_frame(&bench.memory, frame(&bench, "fA")), Err(Fault(163)));
    }
}
