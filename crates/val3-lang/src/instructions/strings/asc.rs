//! `asc` (3.4.3): returns the Unicode code point of a character in a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::{Text, strings};

instruction! {
    /// Returns the Unicode code point of a character in a string.
    ///
    /// - `sText`: the string.
    /// - `nPosition`: the character, counted from 0.
    /// - Result: its code point; -1 if `nPosition` is negative or beyond the end.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "A1"
    ///   if asc(sLine,0)==65
    ///     putln("command A")
    ///   endIf
    /// ```
    "asc": Strings "3.4.3";
    function (string sText, num nPosition) -> num = asc;
}

fn asc(_: &mut Call<'_>, text: Text, position: f64) -> f64 {
    strings::asc(&text, position)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"asc("A",0)"#, "65");
        check(r#"asc("A",1)"#, "-1");
        check(r#"asc("A",-1)"#, "-1");
    }
}
