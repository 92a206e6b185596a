//! `getDisplayLen` (4.3): returns the number of columns that a string occupies on the pendant.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the number of columns that a string occupies on the pendant.
    ///
    /// - `sText`: the text.
    /// - Result: the number of columns. ASCII characters occupy one column each, as `len` counts; wide characters, such
    ///   as Chinese characters, occupy two.
    ///
    /// ## Example
    /// ```val3
    /// string sName = "bolt"
    ///   gotoxy(40-getDisplayLen(sName),0)
    ///   put(sName)
    /// ```
    "getDisplayLen": Screen "4.3";
    function (string sText) -> num = display_len;
}

fn display_len(call: &mut Call<'_>, text: Text) -> f64 {
    call.ports.display_columns(&text) as f64
}
