//! Values as printed by `val3 eval` and a debugger: each on one line, in VAL 3 notation.

pub use super::number_text::significant as num;

/// Formats a truth value.
#[must_use]
pub fn bool(value: bool) -> &'static str {
    if value { "true" } else { "false" }
}

/// Formats a string in quotes.
///
/// A control character, which a literal cannot contain, is outside of the quotes: `"a"+chr(10)+"b"`.
#[must_use]
pub fn string(text: &str) -> String {
    let mut printed = String::from('"');
    for next in text.chars() {
        if next.is_control() {
            printed += &format!("\"+chr({})+\"", u32::from(next));
        } else {
            printed.push(next);
        }
    }
    printed + "\""
}

/// Formats a structure from its formatted fields: `{1,2,3}`.
#[must_use]
pub fn structure<T: AsRef<str>>(fields: &[T]) -> String {
    let fields: Vec<&str> = fields.iter().map(AsRef::as_ref).collect();
    format!("{{{}}}", fields.join(","))
}

#[cfg(test)]
mod tests {
    use super::{bool, num, string, structure};

    #[test]
    fn simple_values() {
        assert_eq!([bool(true), bool(false)], ["true", "false"]);
        assert_eq!(num(-7.6).as_str(), "-7.6");
    }

    #[test]
    fn strings_are_in_quotes() {
        assert_eq!([string(""), string("机器 1"), string("a\"b")], ["\"\"", "\"机器 1\"", "\"a\"b\""]);
    }

    #[test]
    fn a_string_stays_on_its_line() {
        assert_eq!(string("a\r\nb\0"), r#""a"+chr(13)+""+chr(10)+"b"+chr(0)+"""#);
    }

    #[test]
    fn structures_are_in_braces() {
        assert_eq!(structure(&[1.0, 0.5, -2.0].map(num)), "{1,0.5,-2}");
        assert_eq!(
            structure(&[structure(&[1.0; 6].map(num)), "{ssame,esame,wsame}".into()]),
            "{{1,1,1,1,1,1},{ssame,esame,wsame}}"
        );
        assert_eq!(structure::<&str>(&[]), "{}");
    }
}
