//! `find` (3.4.3): searches for a string in another string.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::{Text, strings};

instruction! {
    /// Searches for a string in another string.
    ///
    /// - `sText1`: the string to search.
    /// - `sText2`: the string to find.
    /// - Result: the position of its first occurrence, counted from 0; -1 if it does not occur.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "PICK;12"
    ///   if find(sLine,";")<0
    ///     logMsg("separator missing: "+sLine)
    ///   endIf
    /// ```
    "find": Strings "3.4.3";
    function (string sText1, string sText2) -> num = find;
}

fn find(_: &mut Call<'_>, text: Text, wanted: Text) -> f64 {
    strings::find(&text, &wanted)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"find("hello wild world","wild")"#, "6");
        check(r#"find("hello wild world","Wild")"#, "-1");
    }
}
