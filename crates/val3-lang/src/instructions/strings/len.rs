//! `len` (3.4.3): returns the number of characters in a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::{Text, strings};

instruction! {
    /// Returns the number of characters in a string.
    ///
    /// - `sText`: the string.
    /// - Result: the number of characters, not of bytes: a character outside ASCII occupies 2 to 4 of the 128 bytes.
    ///
    /// `getDisplayLen` returns the number of columns on the pendant.
    ///
    /// ## Example
    /// ```val3
    /// string sName
    ///   if len(sName)==0
    ///     sName="unknown"
    ///   endIf
    /// ```
    "len": Strings "3.4.3";
    function (string sText) -> num = len;
}

fn len(_: &mut Call<'_>, text: Text) -> f64 {
    strings::len(&text) as f64
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"len("hello wild world")"#, "16");
        check(r#"len("")"#, "0");
        check(r#"len("机器人")"#, "3");
    }
}
