//! The controller around the applications: arm, add-ons, inputs and outputs.

use std::sync::Arc;

use rustc_hash::FxHashSet;
use val3_lang::add_on::AddOnTable;
use val3_lang::types::Arm;

/// What the files under `usr/configs` and `usr/app` say.
#[derive(Debug, Clone, Default)]
pub struct CellConfig {
    /// The kind of arm, from `arm.cfx`.
    pub arm: Option<Arm>,
    /// The instruction tables of the installed add-ons, for this arm.
    pub add_ons: Arc<Vec<AddOnTable>>,
    /// Names of the serial lines and sockets in `sio.cfx`; `None` where the cell has no such file.
    pub channels: Option<FxHashSet<String>>,
}
