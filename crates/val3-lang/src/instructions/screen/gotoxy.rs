//! `gotoxy` (4.3): moves the cursor of a user page.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;

instruction! {
    /// Moves the cursor of a user page.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `nX`: column, 0 to 39 (modulo 40).
    /// - `nY`: line, 0 to 13 (modulo 14); (0,0) is the upper left corner.
    ///
    /// ## Example
    /// ```val3
    /// num nDone
    ///   gotoxy(0,2)
    ///   put("parts: ")
    ///   put(nDone)
    /// ```
    "gotoxy": Screen "4.3";
    modifier (num nX, num nY) = gotoxy;
    modifier (screen scPage, num nX, num nY) = gotoxy_on;
}

fn gotoxy(call: &mut Call<'_>, x: f64, y: f64) {
    call.ports.go_to(DEFAULT_PAGE, x, y);
}

fn gotoxy_on(call: &mut Call<'_>, screen: ScreenRef, x: f64, y: f64) -> Result<()> {
    let page = screen.page(call)?;
    call.ports.go_to(page, x, y);
    Ok(())
}
