//! `toString` (3.4.3): formats a number as a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::{Text, number_text};

instruction! {
    /// Formats a number as a string.
    ///
    /// - `sFormat`: `"size.precision"`: the minimum number of characters, filled with blanks on the left, and the
    ///   number of decimals. Each may be missing: `".2"`, `"8"`, `""`; it then counts as 0.
    /// - `nValue`: the number. Zeros at the end of the decimals become blanks; the part before the point is never cut.
    /// - Result: the string: `toString(".4",3.141592)` is `"3.1416"`, `toString("",3.14)` is `"3"`.
    /// - Error 70: an invalid format.
    ///
    /// ## Example
    /// ```val3
    /// num nWeight = 12.345
    ///   putln("weight "+toString(".2",nWeight)+" kg")
    /// ```
    "toString": Strings "3.4.3", errors [70];
    function (string sFormat, num nValue) -> string = to_string;
}

fn to_string(_: &mut Call<'_>, format: Text, value: f64) -> Result<Text> {
    number_text::to_string(&format, value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check(r#"toString(".4",3.141592654)"#, r#""3.1416""#);
        check(r#"toString("8",3.141592654)"#, r#""       3""#);
        check(r#"toString("8.4",3.141592654)"#, r#""  3.1416""#);
        check(r#"toString("8.4",2.70001)"#, r#""  2.7   ""#);
        check(r#"toString("",3.141592654)"#, r#""3""#);
        check(r#"toString("1.2",1234.1234)"#, r#""1234.12""#);
        check(r#"toString("x",1)"#, "error 70");
    }
}
