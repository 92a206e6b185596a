//! Describes two different strings, with a mark under the first difference.

use unicode_width::UnicodeWidthStr as _;
use val3_lang::values::printed;

use super::positions::sides;

/// Number of columns before the text of a side and its quotation mark.
const INDENT: usize = "  expected  \"".len();

/// Maximum number of columns for both strings in one line.
const LINE: usize = 100;

/// Message for different strings. A mark is added if both begin with the same characters.
pub(super) fn difference(actual: &str, expected: &str) -> String {
    let (left, right) = (printed::string(actual), printed::string(expected));
    let headline = format!("{left} instead of {right}");
    let common = actual.chars().zip(expected.chars()).take_while(|(one, other)| one == other).count();
    if common == 0 {
        return headline;
    }
    let same: String = actual.chars().take(common).collect();
    // Without the quotation marks.
    let columns = INDENT + printed::string(&same).width().saturating_sub(2);
    let is_long = left.width() + right.width() > LINE;
    let headline = if is_long { format!("the strings differ at position {common}, from 0") } else { headline };
    format!("{headline}{}\n{:columns$}^ position {common}, from 0", sides(&left, &right), "")
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    fn check(actual: &str, expected: &str, message: Expect) {
        message.assert_eq(&difference(actual, expected));
    }

    #[test]
    fn a_mark_is_under_the_first_difference() {
        check("a", "A", expect![[r#""a" instead of "A""#]]);
        check("", "A", expect![[r#""" instead of "A""#]]);
        check(
            "hello word",
            "hello world",
            expect![[r#"
                "hello word" instead of "hello world"
                  actual    "hello word"
                  expected  "hello world"
                                      ^ position 9, from 0"#]],
        );
        check(
            "ok",
            "ok ",
            expect![[r#"
                "ok" instead of "ok "
                  actual    "ok"
                  expected  "ok "
                               ^ position 2, from 0"#]],
        );
    }

    #[test]
    fn long_strings_are_shown_once() {
        let long = "abcdefghij".repeat(6);
        check(
            &format!("{long}x"),
            &long,
            expect![[r#"
                the strings differ at position 60, from 0
                  actual    "abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijx"
                  expected  "abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghij"
                                                                                         ^ position 60, from 0"#]],
        );
    }

    #[test]
    fn wide_and_invisible_characters_keep_the_mark_in_its_column() {
        check(
            "你好世界",
            "你好四界",
            expect![[r#"
                "你好世界" instead of "你好四界"
                  actual    "你好世界"
                  expected  "你好四界"
                                 ^ position 2, from 0"#]],
        );
        check(
            "a\rb",
            "a\rc",
            expect![[r#"
                "a"+chr(13)+"b" instead of "a"+chr(13)+"c"
                  actual    "a"+chr(13)+"b"
                  expected  "a"+chr(13)+"c"
                                         ^ position 2, from 0"#]],
        );
    }
}
