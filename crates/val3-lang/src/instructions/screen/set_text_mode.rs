//! `setTextMode` (4.3): sets the display mode of text that is written later.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;

instruction! {
    /// Sets the display mode of text that is written later.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `nMode`: 0 dark on light, 1 light on dark, 2 and 3 the same, flashing. Text that is already shown does not
    ///   change.
    /// - Error 70: another mode.
    ///
    /// ## Example
    /// ```val3
    ///   setTextMode(2)
    ///   putln("guard open")
    ///   setTextMode(0)
    /// ```
    "setTextMode": Screen "4.3", errors [70];
    modifier (num nMode) = set_text_mode;
    modifier (screen scPage, num nMode) = set_text_mode_on;
}

fn set_text_mode(call: &mut Call<'_>, mode: f64) -> Result<()> {
    call.ports.set_text_mode(DEFAULT_PAGE, mode)
}

fn set_text_mode_on(call: &mut Call<'_>, screen: ScreenRef, mode: f64) -> Result<()> {
    let page = screen.page(call)?;
    call.ports.set_text_mode(page, mode)
}
