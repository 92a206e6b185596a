//! V0227: a format text that the instruction refuses.

use val3_lang::arguments::{BINARY_FORMATS, TextForm, text_form};
use val3_lang::runtime_errors::INVALID_PARAMETER;

use crate::diagnostic::Wording;
use crate::english::one_of;
use crate::lint::{Findings, Program};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// The format of a number is written in a way that the instruction does not know.
    ///
    /// ## Why
    /// `toBinary` and `fromBinary` know fourteen encodings, in which every one of more than one byte says the order of
    /// its bytes (3.3.3); `toString` takes `size.precision`, two whole numbers that may be left out (3.4.3). Anything
    /// else is run-time error 70.
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

fn check(program: &Program<'_>, found: &mut Findings) {
    for call in program.calls() {
        let callee = call.instruction.name;
        for (param, argument) in call.arguments() {
            let Some(form @ (TextForm::Binary | TextForm::Number)) = text_form(callee, param.name) else { continue };
            let Some(text) = program.body.string(argument) else { continue };
            if form.fault(&text).is_some() {
                found.report(&RULE, program.range(argument), word(callee, form, &text));
            }
        }
    }
}

fn word(callee: &str, form: TextForm, text: &str) -> Wording {
    let help = match form {
        TextForm::Binary => format!("write {}", one_of(&BINARY_FORMATS)),
        _ => "write `size.precision` such as `8.2`, `.3` or an empty text".to_owned(),
    };
    Wording::new(format!("`{callee}` knows no format `{text}`"), runtime_error(INVALID_PARAMETER), help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn formats_that_are_refused() {
        expect![[r#"
            start.pgx:5 `"8,2"` `toString` knows no format `8,2`
              | run-time error 70: invalid parameter
              ? write `size.precision` such as `8.2`, `.3` or an empty text
            start.pgx:6 `"4"` `toBinary` knows no format `4`
              | run-time error 70: invalid parameter
              ? write `-1`, `1`, `-2l`, `-2b`, `2l`, `2b`, `-4l`, `-4b`, `4l`, `4b`, `4.0l`, `4.0b`, `8.0l` or `8.0b`
            start.pgx:7 `"4l "` `fromBinary` knows no format `4l `
              | run-time error 70: invalid parameter
              ? write `-1`, `1`, `-2l`, `-2b`, `2l`, `2b`, `-4l`, `-4b`, `4l`, `4b`, `4.0l`, `4.0b`, `8.0l` or `8.0b`
        "#]]
        .assert_eq(&check(
            &RULE,
            "string s\nnum n\ns=toString(\"8,2\",n)\ntoBinary(n,1,\"4\",n)\nfromBinary(n,1,\"4l \",n)",
        ));
    }

    #[test]
    fn formats_that_are_known() {
        assert_eq!(
            check(
                &RULE,
                "string s\nnum n\ns=toString(\".3\",n)\ns=toString(\"\",n)\ntoBinary(n,1,\"-4l\",n)\ns=toString(s,n)"
            ),
            ""
        );
    }
}
