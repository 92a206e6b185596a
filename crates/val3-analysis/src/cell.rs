//! The controller around the applications: arm, add-ons, inputs and outputs.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::add_on::AddOnTable;
use val3_lang::types::{Arm, BaseType};
use val3_lang::versions::Version;
use val3_syntax::arm_file::ArmFile;

/// The content of the files under `usr/configs` and `usr/app`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CellConfig {
    /// The kind of arm, from `arm.cfx`.
    pub arm: Option<Arm>,
    /// The version of VAL 3 of the controller, from `val3version.xml`.
    pub version: Option<Version>,
    /// The model of the arm and its limits, from `arm.cfx` and `cell.cfx`, in this order.
    pub arm_files: Vec<ArmFile>,
    /// The arm of the file that `arm` in `val3.toml` names, or the reason why it cannot be used.
    pub described_arm: Option<Result<Arc<val3_kinematics::Arm>, SmolStr>>,
    /// The instruction tables of the installed add-ons, for this arm.
    pub add_ons: Arc<Vec<AddOnTable>>,
    /// Files of the cell that exist but cannot be read, by path.
    pub unreadable_files: Vec<UnreadableCellFile>,
    /// Inputs and outputs of the devices whose configuration files are known; others are known to the controller
    /// alone.
    pub io: Io,
}

/// A file of a cell that exists but cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnreadableCellFile {
    /// Its path from `usr`, as spelt on the disk.
    pub path: SmolStr,
    /// The reason, as the system or the reader of tables words it.
    pub reason: SmolStr,
}

/// The inputs and outputs that configuration files name.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Io {
    /// The devices, by the first part of links: `BasicIO-1`.
    pub devices: FxHashMap<String, Device>,
    /// Links of signals by the names that the boards give them: `bOut7` is `BasicIO-1\%Q7`. In s5 and s6 they are the data
    /// of the library `io`.
    pub names: FxHashMap<SmolStr, SmolStr>,
    /// The signals of field buses whose links are bare GUIDs; `None` if the cell does not name all of them.
    pub tags: Option<Tags>,
}

/// Signals by their GUIDs in lower case, with the type of variable if it is known.
pub type Tags = FxHashMap<String, Option<BaseType>>;

/// The inputs and outputs of a device (`BasicIO-1`, `Socket`): name and type of variable.
pub type Device = FxHashMap<String, BaseType>;

/// The lower-case form of a GUID: `ce061c2d-63ef-4c60-9f0e-0d5c5e2b1a77`.
pub(crate) fn guid(text: &str) -> Option<String> {
    let groups: Vec<&str> = text.trim().split('-').collect();
    let lengths: Vec<usize> = groups.iter().map(|group| group.len()).collect();
    let is_hexadecimal = groups.iter().all(|group| group.bytes().all(|byte| byte.is_ascii_hexdigit()));
    (lengths == [8, 4, 4, 4, 12] && is_hexadecimal).then(|| text.trim().to_ascii_lowercase())
}
