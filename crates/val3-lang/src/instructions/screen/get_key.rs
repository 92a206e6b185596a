//! `getKey` (4.3): reads the last key that was pressed, without waiting.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;

instruction! {
    /// Reads the last key that was pressed, without waiting.
    ///
    /// - `scPage`: the page; without it, the default page. Only the displayed page receives keys.
    /// - Result: the code of the last key since the previous call (`get` lists codes); -1 if none was pressed.
    ///
    /// Call it once without using the result to discard an earlier key.
    ///
    /// ## Example
    /// ```val3
    ///   getKey()
    ///   while getKey()==-1
    ///     gotoxy(0,0)
    ///     put(toString(".1",clock()))
    ///     delay(0.1)
    ///   endWhile
    /// ```
    "getKey": Screen "4.3";
    modifier () -> num = key;
    modifier (screen scPage) -> num = key_on;
}

fn key(call: &mut Call<'_>) -> f64 {
    last(call, DEFAULT_PAGE)
}

fn key_on(call: &mut Call<'_>, screen: ScreenRef) -> Result<f64> {
    let page = screen.page(call)?;
    Ok(last(call, page))
}

fn last(call: &mut Call<'_>, page: u32) -> f64 {
    call.ports.take_key(page).map_or(-1.0, f64::from)
}
