//! `chr` (3.4.3): returns the character with a Unicode code point.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::{Text, strings};

instruction! {
    /// Returns the character with a Unicode code point.
    ///
    /// - `nCodePoint`: the code point; 0 to 127 are the ASCII characters.
    /// - Result: a string with this character; `""` for an invalid code point.
    ///
    /// It returns characters that a string literal cannot contain: `chr(34)` is a quote, `chr(13)` a carriage return.
    ///
    /// ## Example
    /// ```val3
    /// sio sHost
    ///   sHost="name="+chr(34)+"gripper"+chr(34)
    /// ```
    "chr": Strings "3.4.3";
    function (num nCodePoint) -> string = chr;
}

fn chr(_: &mut Call<'_>, code_point: f64) -> Text {
    strings::chr(code_point)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("chr(65)", r#""A""#);
        check("chr(26426)", r#""机""#);
        check("chr(-1)", r#""""#);
        check("chr(55296)", r#""""#);
        check("chr(1114112)", r#""""#);
    }
}
