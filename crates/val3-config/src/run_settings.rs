//! The controller that applications run on.

use std::collections::BTreeMap;

use camino::Utf8PathBuf;
use schemars::JsonSchema;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};

use crate::add_on_stand_in::{self, AddOnStandIn};
use crate::{DefaultRun, LinkShapeFile};

/// The controller that `val3 run` executes applications on: the table `[run]`. Arguments of the command
/// take precedence.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct RunSettings {
    /// The connections of serial lines and sockets, by link: `{ 'Socket\host' = "server:2000" }`.
    pub lines: BTreeMap<String, String>,
    /// Whether sockets can connect to other machines and accept connections from them. If not, every address means
    /// this machine.
    pub network: bool,
    /// The time that a line of code needs on the controller, in microseconds; the default is 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    pub line_cost: Option<f64>,
    /// The monitor speed at the start, 0 to 100 per cent; the default is 100.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u8", range(max = 100))]
    pub monitor_speed: Option<u8>,
    /// The joint position of the arm at the start, in degrees (a stroke in mm); the default is 0 for each axis.
    #[serde(skip_serializing_if = "Vec::is_empty", deserialize_with = "start")]
    pub start: Vec<f64>,
    /// Whether the arm has power at the start, as if an operator had switched it on.
    pub power: bool,
    /// The user profile that is active at the start; the default is `default`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub profile: Option<String>,
    /// User profiles that programs can choose, in addition to `default`.
    pub profiles: BTreeMap<String, Profile>,
    /// The units of analog inputs and outputs, which viewers show, by link: `{ 'Rio\%IF0' = "bar" }`.
    pub units: BTreeMap<String, String>,
    /// Files with the shapes of the arm's base and links, which viewers show, and whose hulls are compared with the things
    /// around the arm. Paths are relative to the folder of this file:
    /// `{ base = "arm/base.stl", link1 = "arm/link1.glb" }`. An STL file is in mm with z up, a GLB file in m with y up,
    /// both in the frame that the link has in the chain of the arm. A table states other coordinates:
    /// `{ file = "link1.stl", unit = "m", frame = "zero", origin = [0, 0, 375] }`.
    pub shapes: BTreeMap<String, LinkShapeFile>,
    /// The file with the things around the arm, relative to the folder of this file; `cell.toml` next to this file by
    /// default, and `none` for an empty room.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub cell: Option<Utf8PathBuf>,
    /// Licences that differ from the licences of a usual controller: `{ alter = "demo", compliance = "missing" }`.
    pub licences: BTreeMap<String, Licence>,
    /// Values that instructions of add-ons return, and programs that are called in place of them, because a simulated
    /// controller does not have the add-ons: `{ '$isReady' = true, '$velJoint' = { program = "standIns/velJoint.pgx" } }`.
    /// A program has the parameters of the instruction. If that returns a value, a last parameter by reference receives
    /// it. An instruction with a value as stand-in that the line does not use does nothing.
    #[serde(deserialize_with = "add_on_stand_in::read")]
    #[schemars(with = "BTreeMap<String, AddOnStandIn>")]
    pub add_ons: BTreeMap<String, AddOnStandIn>,
    /// The run for a folder without a named application.
    pub default: DefaultRun,
}

/// Reads a joint position with six axes, or four axes for a SCARA arm.
fn start<'de, D: Deserializer<'de>>(input: D) -> Result<Vec<f64>, D::Error> {
    let start = Vec::<f64>::deserialize(input)?;
    if [4, 6].contains(&start.len()) {
        return Ok(start);
    }
    Err(D::Error::custom(format!("`start` has 6 numbers, for a SCARA arm 4, and this list has {}", start.len())))
}

/// A user profile.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
#[schemars(inline)]
pub struct Profile {
    /// Its password.
    pub password: String,
    /// Whether the operator controls the monitor speed. Programs then cannot increase it.
    pub controls_speed: bool,
}

/// The state of a licence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum Licence {
    /// It is installed.
    Enabled,
    /// It can be used for a limited time.
    Demo,
    /// It is not installed, or it has expired.
    Missing,
}
