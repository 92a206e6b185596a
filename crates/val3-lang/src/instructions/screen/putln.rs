//! `putln` (4.3): writes text or a number on a user page and goes to the next line.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;
use crate::values::Text;
use crate::values::number_text::shown;

instruction! {
    /// Writes text or a number on a user page and goes to the next line.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `sText`: the text.
    /// - `nValue`: the number, shown with up to 3 decimals.
    ///
    /// A full line continues in the next one, and a full page scrolls up.
    ///
    /// ## Example
    /// ```val3
    /// num nDone = 12
    ///   putln("parts")
    ///   putln(nDone)
    /// ```
    "putln": Screen "4.3";
    modifier (string sText) = putln_text;
    modifier (screen scPage, string sText) = putln_text_on;
    modifier (num nValue) = putln_number;
    modifier (screen scPage, num nValue) = putln_number_on;
}

fn putln_text(call: &mut Call<'_>, text: Text) {
    call.ports.put(DEFAULT_PAGE, &text, true);
}

fn putln_text_on(call: &mut Call<'_>, screen: ScreenRef, text: Text) -> Result<()> {
    let page = screen.page(call)?;
    call.ports.put(page, &text, true);
    Ok(())
}

fn putln_number(call: &mut Call<'_>, value: f64) {
    putln_text(call, shown(value));
}

fn putln_number_on(call: &mut Call<'_>, screen: ScreenRef, value: f64) -> Result<()> {
    putln_text_on(call, screen, shown(value))
}
