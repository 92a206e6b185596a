//! `cls` (4.3): clears a user page and moves its cursor to the upper left corner.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;

instruction! {
    /// Clears a user page and moves its cursor to the upper left corner.
    ///
    /// - `scPage`: the page; without it, the default page.
    ///
    /// ## Example
    /// ```val3
    ///   cls()
    ///   putln("ready")
    /// ```
    "cls": Screen "4.3";
    modifier () = cls;
    modifier (screen scPage) = cls_on;
}

fn cls(call: &mut Call<'_>) {
    call.ports.clear(DEFAULT_PAGE);
}

fn cls_on(call: &mut Call<'_>, screen: ScreenRef) -> Result<()> {
    let page = screen.page(call)?;
    call.ports.clear(page);
    Ok(())
}
