//! `userPageAlert`: shows a message above the user pages.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Shows a message above the user pages.
    ///
    /// - `sText`: the message.
    ///
    /// On CS9 controllers. See `userPageConfirm` for a question.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   userPageAlert("Tray is empty")
    /// ```
    "userPageAlert": Additions, since 8;
    modifier (string sText) = alert;
}

fn alert(call: &mut Call<'_>, text: Text) {
    call.ports.pop_up(&text, 1.0);
}
