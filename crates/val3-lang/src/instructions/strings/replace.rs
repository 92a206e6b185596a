//! `replace` (3.4.3): replaces characters of a string by another string.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::{Text, strings};

instruction! {
    /// Replaces characters of a string by another string.
    ///
    /// - `sText`: the string, which is not changed.
    /// - `sReplacement`: the replacement, which may be longer or shorter than the replaced characters.
    /// - `nSize`: the number of replaced characters.
    /// - `nPosition`: the first of them, counted from 0; beyond the end nothing changes.
    /// - Result: the new string, at most 128 bytes.
    /// - Error 70: `nSize` or `nPosition` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "12,5"
    /// num nComma
    ///   nComma=find(sLine,",")
    ///   if nComma>=0
    ///     sLine=replace(sLine,".",1,nComma)
    ///   endIf
    /// ```
    "replace": Strings "3.4.3", errors [70];
    function (string sText, string sReplacement, num nSize, num nPosition) -> string = replace;
}

fn replace(_: &mut Call<'_>, text: Text, replacement: Text, size: f64, position: f64) -> Result<Text> {
    strings::replace(&text, &replacement, size, position)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"replace("hello ? world","wild",1,6)"#, r#""hello wild world""#);
        check(r#"replace("hello","x",1,6)"#, r#""hello""#);
        check(r#"replace("hello","x",-1,0)"#, "error 70");
        check(r#"replace("hello","x",1,-1)"#, "error 70");
    }
}
