//! `libSave` (6.7).

use val3_bytecode::{DataDef, Image};
use val3_lang::memory::{Memory, StoreId};

use super::Devices;

impl Devices {
    pub(super) fn save_library(
        &mut self,
        _: &Image,
        _: &Memory,
        _: &[(&DataDef, StoreId)],
        _: &str,
        _: Option<&str>,
    ) -> u16 {
        30
    }
}
