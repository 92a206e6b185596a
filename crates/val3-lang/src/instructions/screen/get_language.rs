//! `getLanguage` (4.3): returns the language of the controller.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the language of the controller.
    ///
    /// - Result: its name, such as `"english"`, `"francais"`, `"deutsch"`, `"italiano"`, `"espanol"`, `"chinese"`.
    ///
    /// ## Example
    /// ```val3
    /// string sMessage
    ///   switch getLanguage()
    ///     case "deutsch"
    ///       sMessage="Achtung!"
    ///     break
    ///     default
    ///       sMessage="Warning!"
    ///     break
    ///   endSwitch
    ///   putln(sMessage)
    /// ```
    "getLanguage": Screen "4.3";
    function () -> string = language;
}

fn language(call: &mut Call<'_>) -> Text {
    call.ports.language()
}
