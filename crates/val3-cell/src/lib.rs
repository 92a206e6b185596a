//! The cell around an arm: the file `cell.toml`, the poses of the described things, and their distances to the arm and
//! to carried bodies.
//!
//! Lengths are in mm, angles in degrees, times in seconds. The crate depends on arms, but neither on VAL 3 nor on the
//! file system: the caller reads meshes, and supplies the poses of a program's frames and tools.
//!
//! [`Cell`] is a checked file. A [`Scene`] combines it with an arm. [`Watch`] reports bodies that come too near to each
//! other, [`Minima`] records the smallest distances, and [`Profile`] computes the smallest distance in each cycle.
//! [`Handling`] moves parts with grippers and conveyors, and evaluates sensors. [`Contacts`] finds contacts without a
//! run.

mod allowed;
mod build;
mod carriers;
mod contacts;
mod conveyor;
mod error;
mod file;
mod gripper;
mod handling;
mod links;
mod measure;
mod mesh;
mod minima;
mod names;
mod observation;
mod pairs;
mod part;
mod poses;
mod profile;
mod reach;
mod scene;
mod sensor;
mod solids;
mod step;
mod surroundings;
#[cfg(test)]
mod testing;
mod track;
mod watch;

pub use self::build::{Cell, Thing};
pub use self::carriers::Carrier;
pub use self::contacts::{Contact, Contacts};
pub use self::conveyor::{Conveyor, Feed};
pub use self::error::CellError;
pub use self::file::{
    AllowedPair, BeamKeys, CellFile, ConveyorEnd, ConveyorEntry, FeedKeys, GripperEntry, HoldingState, ObjectEntry,
    PartEntry, SensorEntry, ShapeEntry, ShapeKeys, SignalLevel, SignalValues, WhenKey,
};
pub use self::gripper::{Gripper, GripperCommand, GripperControl, SignalWrite};
pub use self::handling::{CellOutputs, Handling, HandlingEvent, NearPart};
pub use self::links::{LinkCoordinates, LinkError, LinkFile, LinkHull, check_link_names, link_names};
pub use self::measure::Measured;
pub use self::mesh::{Mesh, MeshError};
pub use self::minima::{Minima, Minimum};
pub use self::part::{Part, PartHolder, PartPlace};
pub use self::profile::{Profile, Proximity};
pub use self::scene::Scene;
pub use self::sensor::{Sensor, SensorForm};
pub use self::solids::{Solid, SolidForm};
pub use self::step::Sight;
pub use self::surroundings::{ArmBase, DataKind, KnownSignal, SignalClass, Surroundings};
pub use self::watch::{Encounter, EncounterState, TOUCHING, Watch};
