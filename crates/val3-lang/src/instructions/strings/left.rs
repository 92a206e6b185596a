//! `left` (3.4.3): returns the first characters of a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::{Text, strings};

instruction! {
    /// Returns the first characters of a string.
    ///
    /// - `sText`: the string.
    /// - `nSize`: the number of characters; the whole string if it has fewer.
    /// - Result: these characters.
    /// - Error 70: `nSize` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "PICK 12"
    ///   if left(sLine,4)=="PICK"
    ///     putln(right(sLine,2))
    ///   endIf
    /// ```
    "left": Strings "3.4.3", errors [70];
    function (string sText, num nSize) -> string = left;
}

fn left(_: &mut Call<'_>, text: Text, size: f64) -> Result<Text> {
    strings::left(&text, size)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"left("hello world",5)"#, r#""hello""#);
        check(r#"left("hello world",20)"#, r#""hello world""#);
        check(r#"left("hello world",-1)"#, "error 70");
    }
}
