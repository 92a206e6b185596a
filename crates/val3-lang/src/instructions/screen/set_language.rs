//! `setLanguage` (4.3): changes the language of the controller.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Changes the language of the controller.
    ///
    /// - `sLanguage`: the name of a translation that is installed on the controller (`getLanguage` lists names).
    /// - Result: `false` if it is not installed.
    ///
    /// ## Example
    /// ```val3
    ///   if setLanguage("francais")==false
    ///     logMsg("French is not installed")
    ///   endIf
    /// ```
    "setLanguage": Screen "4.3";
    modifier (string sLanguage) -> bool = set_language;
}

fn set_language(call: &mut Call<'_>, language: Text) -> bool {
    call.ports.set_language(&language)
}
