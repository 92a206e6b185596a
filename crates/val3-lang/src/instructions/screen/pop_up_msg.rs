//! `popUpMsg` (4.3): shows a message in a window above the pendant's content.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Shows a message in a window above the pendant's content.
    ///
    /// - `sText`: the message. It stays until the operator confirms it; the program does not wait.
    /// - `nLevel`: (s8) its kind, a number.
    ///
    /// ## Example
    /// ```val3
    /// dio diGuard
    ///   if diGuard==false
    ///     popUpMsg("Close the guard")
    ///   endIf
    /// ```
    "popUpMsg": Screen "4.3";
    modifier (string sText) = pop_up;
    modifier (string sText, num nLevel) since 8 = pop_up_of;
}

fn pop_up(call: &mut Call<'_>, text: Text) {
    call.ports.pop_up(&text, 1.0);
}

fn pop_up_of(call: &mut Call<'_>, text: Text, level: f64) {
    call.ports.pop_up(&text, level);
}
