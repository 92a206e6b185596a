//! `right` (3.4.3): returns the last characters of a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::{Text, strings};

instruction! {
    /// Returns the last characters of a string.
    ///
    /// - `sText`: the string.
    /// - `nSize`: the number of characters; the whole string if it has fewer.
    /// - Result: these characters.
    /// - Error 70: `nSize` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sFile = "log.txt"
    ///   if right(sFile,4)==".txt"
    ///     putln(sFile)
    ///   endIf
    /// ```
    "right": Strings "3.4.3", errors [70];
    function (string sText, num nSize) -> string = right;
}

fn right(_: &mut Call<'_>, text: Text, size: f64) -> Result<Text> {
    strings::right(&text, size)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"right("hello world",5)"#, r#""world""#);
        check(r#"right("hello world",20)"#, r#""hello world""#);
        check(r#"right("hello world",-1)"#, "error 70");
    }
}
