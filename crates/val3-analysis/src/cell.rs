//! The cell around the applications: arm, add-ons, inputs and outputs.

use std::sync::Arc;

use camino::Utf8PathBuf;
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::add_on::AddOnTable;
use val3_lang::types::{Arm, BaseType};
use val3_lang::versions::Version;
use val3_syntax::arm_file::ArmFile;

/// Content of the configuration files under `usr/configs` and `usr/app`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CellConfig {
    /// Kind of arm, from `arm.cfx`.
    pub arm: Option<Arm>,
    /// VAL 3 version of the controller, from `val3version.xml`.
    pub version: Option<Version>,
    /// Model and limits of the arm, from `arm.cfx` and `cell.cfx`, in this order.
    pub arm_files: Vec<ArmFile>,
    /// Arm from the file that `arm` in `val3.toml` names, or the reason why it cannot be used.
    pub described_arm: Option<Result<Arc<val3_kinematics::Arm>, SmolStr>>,
    /// Instruction tables of the installed add-ons for this arm.
    pub add_ons: Arc<Vec<AddOnTable>>,
    /// Files of the cell that exist but cannot be read.
    pub unreadable_files: Vec<UnreadableCellFile>,
    /// Inputs and outputs of the devices with supported configuration files. The links of other devices cannot be
    /// checked.
    pub io: CellIo,
}

/// A file of a cell that exists but cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnreadableCellFile {
    /// Path below `usr`, as spelt on the disk.
    pub path: SmolStr,
    /// Error message of the system or of the table reader.
    pub reason: SmolStr,
}

/// Inputs and outputs in configuration files.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CellIo {
    /// Devices by the first part of their links, for example `BasicIO-1`.
    pub devices: FxHashMap<String, Device>,
    /// Links of signals by the names in the board configuration: `bOut7` is `BasicIO-1\%Q7`. In s5 and s6 these names
    /// are the data of the library `io`.
    pub names: FxHashMap<SmolStr, SmolStr>,
    /// Signals of field buses with bare GUIDs as links; `None` if the cell does not list all of them.
    pub tags: Option<Tags>,
    /// File of the Modbus server, `applicom/Modbus/modbus.xml`; `None` if it does not exist or cannot be read.
    pub modbus: Option<CellText>,
}

/// Text of a file of a cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CellText {
    /// Absolute path, as spelt on the disk.
    pub path: Utf8PathBuf,
    /// Content.
    pub text: Arc<str>,
}

/// Signals by GUID in lower case, with the type of variable if known.
pub type Tags = FxHashMap<String, Option<BaseType>>;

/// Inputs and outputs of a device (`BasicIO-1`, `Socket`): variable types by signal name.
pub type Device = FxHashMap<String, BaseType>;

/// Returns a GUID in lower case, for example `ce061c2d-63ef-4c60-9f0e-0d5c5e2b1a77`; `None` if the text is no GUID.
pub(crate) fn guid(text: &str) -> Option<String> {
    let groups: Vec<&str> = text.trim().split('-').collect();
    let lengths: Vec<usize> = groups.iter().map(|group| group.len()).collect();
    let is_hexadecimal = groups.iter().all(|group| group.bytes().all(|byte| byte.is_ascii_hexdigit()));
    (lengths == [8, 4, 4, 4, 12] && is_hexadecimal).then(|| text.trim().to_ascii_lowercase())
}
