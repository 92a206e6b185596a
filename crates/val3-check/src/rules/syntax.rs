//! V0010: a line that is not valid VAL 3.

use val3_syntax::error::Expected;

use crate::{
    diagnostic::Wording,
    phrase::{found_text, shortened},
    rule::rule,
};

rule! {
    /// A line does not have the form of a VAL 3 instruction.
    ///
    /// ## Why
    /// Each line of a program is one assignment, one instruction, one `call` or one part of a control structure, and is
    /// complete. The controller compiles all programs when it loads an application, and does not load it if a single
    /// line is invalid. The rest of the program is checked as if the line were missing.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCount=nCount+
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// nCount=nCount+1
    /// ```
    V0010 "syntax" Error
}

/// Returns the wording for an unexpected text. `found` is empty at the end of a line.
pub(crate) fn expected(expected: Expected, found: &str) -> Wording {
    let what = part(expected);
    Wording::new(
        format!("{what} is expected here, but {}", found_text(found)),
        format!("expected {what}"),
        form(expected),
    )
}

/// Missing part of a line.
fn part(expected: Expected) -> &'static str {
    match expected {
        Expected::Expression => "a value",
        Expected::Name => "a name",
        Expected::Field => "the name of a field",
        Expected::Program => "the name of a program",
        Expected::Statement => "an instruction",
        Expected::ForAssign => "`=`",
        Expected::ForTo => "`to`",
        Expected::ForStep => "a value for the step",
        Expected::OpenParen => "`(`",
        Expected::Comma => "`,`",
        Expected::AssignmentOrCall => "`=` or `(`",
        Expected::CaseValue => "a value",
    }
}

/// Form of the line, if the missing part does not explain it.
fn form(expected: Expected) -> &'static str {
    match expected {
        Expected::Program => "write `call name(…)`, and `call library:name(…)` for a program of a library",
        Expected::Statement => "a line starts with a variable, an instruction or a keyword",
        Expected::OpenParen => "arguments are written in round brackets, `()` if there are none",
        Expected::AssignmentOrCall => {
            "write `name=…` to assign, `name(…)` for an instruction, `call name(…)` for a program"
        }
        Expected::CaseValue => "write `case 1`, or `case 1, 2` for several values",
        _ => "",
    }
}

/// Returns the wording for text after a complete value or instruction.
pub(crate) fn trailing(found: &str) -> Wording {
    Wording::new(
        format!("`{}` cannot follow here", shortened(found)),
        "not expected here",
        if found.starts_with(';') {
            "remove the `;`: in VAL 3 the end of the line ends the instruction"
        } else {
            "an operator or a comma is missing before it, or it belongs on a line of its own"
        },
    )
}

/// Returns the wording for a character that VAL 3 does not use.
pub(crate) fn invalid_character(character: char) -> Wording {
    Wording::new(
        format!("VAL 3 does not use the character {}", shown(character)),
        "not part of VAL 3",
        substitute(character),
    )
}

/// Returns the wording for a number beyond the range of `num`.
pub(crate) fn number_too_large() -> Wording {
    Wording::new("the number is too large for a num", "too large", "the largest number is about 1.8e308")
}

/// Formats the character in backticks, or its number if it is invisible.
fn shown(character: char) -> String {
    if is_invisible(character) {
        return format!("U+{:04X}, which is invisible", u32::from(character));
    }
    format!("`{character}`")
}

/// Whether the character is invisible: blanks, control characters, and marks without width (joiners, direction marks,
/// byte order mark).
fn is_invisible(character: char) -> bool {
    let no_width = matches!(character, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}' | '\u{feff}');
    no_width || character.is_control() || character.is_whitespace()
}

/// Advice with the text that was probably intended.
fn substitute(character: char) -> &'static str {
    match character {
        ';' => "remove it: in VAL 3 the end of the line ends the instruction",
        '\'' | '‘' | '’' | '“' | '”' | '„' | '«' | '»' | '`' => {
            "a string is written between straight double quotes: `\"text\"`"
        }
        '#' => "a comment starts with `//`",
        '–' | '—' | '−' => "write the minus sign `-`",
        '×' => "write `*`",
        '÷' => "write `/`",
        '（' | '）' | '，' | '：' | '；' | '＝' => "write the sign with the keyboard set to Latin letters",
        '\\' => "an instruction cannot continue on the next line",
        _ if is_invisible(character) => "write an ordinary blank, or none; copied text often contains such characters",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_incomplete_line_is_reported() {
        expect![[r#"
            a value is expected here, but the line ends
            | expected a value
        "#]]
        .assert_eq(&expected(Expected::Expression, "").to_string());
    }

    #[test]
    fn a_lone_name_is_reported() {
        expect![[r#"
            `=` or `(` is expected here, but the line ends
            | expected `=` or `(`
            ? write `name=…` to assign, `name(…)` for an instruction, `call name(…)` for a program
        "#]]
        .assert_eq(&expected(Expected::AssignmentOrCall, "").to_string());
    }

    #[test]
    fn a_call_without_brackets_is_reported() {
        expect![[r#"
            `(` is expected here, but `pPlace` was found
            | expected `(`
            ? arguments are written in round brackets, `()` if there are none
        "#]]
        .assert_eq(&expected(Expected::OpenParen, "pPlace").to_string());
    }

    #[test]
    fn text_after_an_instruction_is_reported() {
        expect![[r#"
            `nSpeed=20` cannot follow here
            | not expected here
            ? an operator or a comma is missing before it, or it belongs on a line of its own
        "#]]
        .assert_eq(&trailing("nSpeed=20").to_string());
    }

    #[test]
    fn a_semicolon_is_reported() {
        expect![[r#"
            `;` cannot follow here
            | not expected here
            ? remove the `;`: in VAL 3 the end of the line ends the instruction
        "#]]
        .assert_eq(&trailing(";").to_string());
    }

    #[test]
    fn a_number_beyond_the_range_is_reported() {
        expect![[r#"
            the number is too large for a num
            | too large
            ? the largest number is about 1.8e308
        "#]]
        .assert_eq(&number_too_large().to_string());
    }

    #[test]
    fn a_curly_quote_is_reported() {
        expect![[r#"
            VAL 3 does not use the character `“`
            | not part of VAL 3
            ? a string is written between straight double quotes: `"text"`
        "#]]
        .assert_eq(&invalid_character('“').to_string());
    }

    #[test]
    fn an_invisible_character_is_reported() {
        expect![[r#"
            VAL 3 does not use the character U+00A0, which is invisible
            | not part of VAL 3
            ? write an ordinary blank, or none; copied text often contains such characters
        "#]]
        .assert_eq(&invalid_character('\u{a0}').to_string());
    }
}
