//! V0227: a format text that is invalid or partly ignored.

use val3_lang::arguments::{BINARY_FORMATS, TextForm, text_form};
use val3_lang::runtime_errors::INVALID_PARAMETER;
use val3_lang::values::number_text::ignored;

use crate::diagnostic::Wording;
use crate::english::one_of;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::{Severity, rule};

rule! {
    /// The instruction does not support the format of a number.
    ///
    /// ## Why
    /// `toBinary` and `fromBinary` support fourteen encodings; the names of multi-byte encodings include the byte order
    /// (3.3.3). `toString` expects `size.precision`, two whole numbers that may be omitted (3.4.3). Anything else
    /// raises run-time error 70. Text after `size.precision` is ignored. It is reported as a warning if it contains
    /// digits, as in `"8,2"`, and otherwise as information.
    ///
    /// ## Bad
    /// ```val3
    /// num nValue
    /// string sText
    ///
    /// sText=toString("%8.2f",nValue)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nValue
    /// string sText
    ///
    /// sText=toString("8.2",nValue)
    /// ```
    V0227 "unknown-format" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls() {
        let callee = call.instruction.name;
        for (param, argument) in call.arguments() {
            let Some(form @ (TextForm::Binary | TextForm::Number)) = text_form(callee, param.name) else { continue };
            let Some(text) = program.body.string(argument) else { continue };
            if form.fault(&text).is_some() {
                found.report(&RULE, program.range(argument), word(callee, form, &text));
            } else if let Some(rest) = rest(form, &text) {
                let is_meant = rest.contains(|letter: char| letter.is_ascii_digit());
                let level = if is_meant { Severity::Warning } else { Severity::Info };
                found.report(&RULE, program.range(argument), word_rest(callee, &text, rest)).level(level);
            }
        }
    }
}

/// End of the text, which the instruction ignores.
fn rest(form: TextForm, text: &str) -> Option<&str> {
    let is_number = form == TextForm::Number;
    ignored(text).filter(|rest| is_number && !rest.is_empty())
}

fn word_rest(callee: &str, text: &str, rest: &str) -> Wording {
    let read = text.strip_suffix(rest).unwrap_or(text);
    Wording::new(format!("`{callee}` reads `{read}` and ignores `{rest}`"), "not part of the format", NUMBER_HELP)
}

const NUMBER_HELP: &str = "write `size.precision` such as `8.2`, `.3` or an empty text";

fn word(callee: &str, form: TextForm, text: &str) -> Wording {
    let help = match form {
        TextForm::Binary => format!("write {}", one_of(&BINARY_FORMATS)),
        _ => NUMBER_HELP.to_owned(),
    };
    Wording::new(format!("`{callee}` does not support the format `{text}`"), runtime_error(INVALID_PARAMETER), help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::{check, levels};

    #[test]
    fn invalid_formats_are_reported() {
        expect![[r#"
            start.pgx:5 `"%8.2f"` `toString` does not support the format `%8.2f`
              | run-time error 70: invalid parameter
              ? write `size.precision` such as `8.2`, `.3` or an empty text
            start.pgx:6 `"4"` `toBinary` does not support the format `4`
              | run-time error 70: invalid parameter
              ? write `-1`, `1`, `-2l`, `-2b`, `2l`, `2b`, `-4l`, `-4b`, `4l`, `4b`, `4.0l`, `4.0b`, `8.0l` or `8.0b`
            start.pgx:7 `"4l "` `fromBinary` does not support the format `4l `
              | run-time error 70: invalid parameter
              ? write `-1`, `1`, `-2l`, `-2b`, `2l`, `2b`, `-4l`, `-4b`, `4l`, `4b`, `4.0l`, `4.0b`, `8.0l` or `8.0b`
        "#]]
        .assert_eq(&check(
            &RULE,
            "string s\nnum n\ns=toString(\"%8.2f\",n)\ntoBinary(n,1,\"4\",n)\nfromBinary(n,1,\"4l \",n)",
        ));
    }

    #[test]
    fn the_ignored_end_of_a_format_is_reported() {
        let listing = |format: &str| format!("string s\nnum n\ns=toString(\"{format}\",n)");
        expect![[r#"
            start.pgx:5 `".2,"` `toString` reads `.2` and ignores `,`
              | not part of the format
              ? write `size.precision` such as `8.2`, `.3` or an empty text
        "#]]
        .assert_eq(&check(&RULE, &listing(".2,")));
        for (format, level) in
            [("%8.2f", Severity::Error), ("8,2", Severity::Warning), (".2,", Severity::Info), ("8.2f", Severity::Info)]
        {
            assert_eq!(levels(&RULE, &listing(format)), [level], "{format}");
        }
    }

    #[test]
    fn valid_formats_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "string s\nnum n\ns=toString(\".3\",n)\ns=toString(\"\",n)\ntoBinary(n,1,\"-4l\",n)\ns=toString(s,n)"
            ),
            ""
        );
    }
}
