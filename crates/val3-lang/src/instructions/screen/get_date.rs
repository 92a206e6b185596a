//! `getDate` (4.3): returns the date and time of the controller as a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Gives date and time of the controller as text.
    ///
    /// - `sFormat`: text in which these marks are replaced: `%y` year of two digits, `%Y` of four, `%m` month, `%d`
    ///   day, `%H` hour of 24, `%I` hour of 12, `%p` morning or afternoon, `%M` minutes, `%S` seconds.
    /// - Result: the text with the marks replaced.
    ///
    /// To measure time use `clock`.
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
