//! User page of a `screen` variable (4.2).

use super::{Call, ScreenRef};
use crate::fault::Result;
use crate::memory::LinkPlace;

/// Memory of a page, in bytes.
const PAGE_BYTES: u64 = 16 << 10;

impl ScreenRef {
    /// Number of the page, which is created when the variable is first used.
    ///
    /// A later copy of a structure with a screen shares the page, as it shares links to inputs and outputs.
    ///
    /// # Errors
    /// 20 if the variable does not exist, 40 without memory for a new page.
    pub fn page(self, call: &mut Call<'_>) -> Result<u32> {
        if let LinkPlace::Port(page) = call.memory.link(self.0, 0)? {
            return Ok(page);
        }
        call.memory.stores.room.take(PAGE_BYTES)?;
        let page = call.ports.create_page(self.0);
        call.memory.set_link(self.0, 0, LinkPlace::Port(page))?;
        Ok(page)
    }
}
