//! `put` (4.3): writes text or a number on a user page and stays on the line.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;
use crate::values::Text;
use crate::values::number_text::shown;

instruction! {
    /// Writes text or a number on a user page and stays on the line.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `sText`: the text.
    /// - `nValue`: the number, shown with up to 3 decimals.
    ///
    /// Writing starts at the cursor, which moves past the last character. A full line continues in the next one, and
    /// a full page scrolls up.
    ///
    /// ## Example
    /// ```val3
    /// num nDone = 12
    ///   put("parts: ")
    ///   put(nDone)
    ///   putln("")
    /// ```
    "put": Screen "4.3";
    modifier (string sText) = put_text;
    modifier (screen scPage, string sText) = put_text_on;
    modifier (num nValue) = put_number;
    modifier (screen scPage, num nValue) = put_number_on;
}

fn put_text(call: &mut Call<'_>, text: Text) {
    call.ports.put(DEFAULT_PAGE, &text, false);
}

fn put_text_on(call: &mut Call<'_>, screen: ScreenRef, text: Text) -> Result<()> {
    let page = screen.page(call)?;
    call.ports.put(page, &text, false);
    Ok(())
}

fn put_number(call: &mut Call<'_>, value: f64) {
    put_text(call, shown(value));
}

fn put_number_on(call: &mut Call<'_>, screen: ScreenRef, value: f64) -> Result<()> {
    put_text_on(call, screen, shown(value))
}
