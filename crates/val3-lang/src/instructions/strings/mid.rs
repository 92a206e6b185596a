//! `mid` (3.4.3): returns characters from the middle of a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::{Text, strings};

instruction! {
    /// Returns characters from the middle of a string.
    ///
    /// - `sText`: the string.
    /// - `nSize`: the number of characters; fewer at the end of the string.
    /// - `nPosition`: the first of them, counted from 0. The size comes before the position.
    /// - Result: these characters.
    /// - Error 70: `nSize` or `nPosition` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "hello wild world"
    ///   // "wild"
    ///   putln(mid(sLine,4,6))
    /// ```
    "mid": Strings "3.4.3", errors [70];
    function (string sText, num nSize, num nPosition) -> string = mid;
}

fn mid(_: &mut Call<'_>, text: Text, size: f64, position: f64) -> Result<Text> {
    strings::mid(&text, size, position)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"mid("hello wild world",4,6)"#, r#""wild""#);
        check(r#"mid("hello wild world",20,6)"#, r#""wild world""#);
        check(r#"mid("hello",-1,0)"#, "error 70");
        check(r#"mid("hello",1,-1)"#, "error 70");
    }
}
