//! `isKeyPressed` (4.3): returns whether a key is held down.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;

instruction! {
    /// Returns whether a key is held down.
    ///
    /// - `scPage`: the page; without it, the default page. Keys are read only while it is shown; the keys 1, 2 and 3
    ///   (codes 281 to 283) are always read.
    /// - `nCode`: the code of the key (`get` lists codes).
    /// - Result: `true` while it is held down.
    ///
    /// ## Example
    /// ```val3
    /// dio doValve
    ///   doValve=isKeyPressed(281)
    /// ```
    "isKeyPressed": Screen "4.3";
    function (num nCode) -> bool = is_pressed;
    function (screen scPage, num nCode) -> bool = is_pressed_on;
}

fn is_pressed(call: &mut Call<'_>, code: f64) -> bool {
    call.ports.is_key_pressed(DEFAULT_PAGE, code)
}

fn is_pressed_on(call: &mut Call<'_>, screen: ScreenRef, code: f64) -> Result<bool> {
    let page = screen.page(call)?;
    Ok(call.ports.is_key_pressed(page, code))
}
