//! The page of a `screen` variable (4.2).

use super::{Call, ScreenRef};
use crate::fault::Result;
use crate::memory::Link;

impl ScreenRef {
    /// The number of its page. The page comes into being when the variable is first used.
    ///
    /// A copy of a structure with a screen shares the page from then on, as it shares links to inputs and outputs.
    ///
    /// # Errors
    /// 20 if the variable is gone.
    pub fn page(self, call: &mut Call<'_>) -> Result<u32> {
        if let Link::Port(page) = call.memory.link(self.0, 0)? {
            return Ok(page);
        }
        let page = call.ports.create_page(self.0);
        call.memory.set_link(self.0, 0, Link::Port(page))?;
        Ok(page)
    }
}
