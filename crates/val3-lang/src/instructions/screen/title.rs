//! `title` (4.3): sets the title of a user page.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;
use crate::values::Text;

instruction! {
    /// Sets the title of a user page.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `sText`: the title. The cursor does not move.
    ///
    /// ## Example
    /// ```val3
    ///   title("Palletiser")
    /// ```
    "title": Screen "4.3";
    modifier (string sText) = title;
    modifier (screen scPage, string sText) = title_on;
}

fn title(call: &mut Call<'_>, text: Text) {
    call.ports.set_title(DEFAULT_PAGE, &text);
}

fn title_on(call: &mut Call<'_>, screen: ScreenRef, text: Text) -> Result<()> {
    let page = screen.page(call)?;
    call.ports.set_title(page, &text);
    Ok(())
}
