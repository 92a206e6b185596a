//! `getDate` (4.3): returns the date and time of the controller as a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the date and time of the controller as a string.
    ///
    /// - `sFormat`: text in which these marks are replaced: `%y` year with two digits, `%Y` year with four digits, `%m`
    ///   month, `%d` day, `%H` hour (00 to 23), `%I` hour (01 to 12), `%p` AM or PM, `%M` minutes, `%S` seconds.
    /// - Result: the text with the marks replaced.
    ///
    /// To measure time, use `clock`.
    ///
    /// ## Example
    /// ```val3
    ///   putln(getDate("%Y-%m-%d %H:%M:%S"))
    /// ```
    "getDate": Screen "4.3";
    function (string sFormat) -> string = date;
}

fn date(call: &mut Call<'_>, format: Text) -> Text {
    let now = call.now();
    call.ports.date(now).format(&format)
}
