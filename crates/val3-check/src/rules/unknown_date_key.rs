//! V0228: a key that `getDate` does not support.

use val3_lang::arguments::{DATE_KEYS, TextForm, text_form};

use crate::diagnostic::Wording;
use crate::english::one_of;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The format of a date contains a `%` without a known key, or no key.
    ///
    /// ## Why
    /// Only nine keys are replaced: `%y %Y %m %d %H %I %p %M %S`. Their letter case matters (4.3). Any other text is
    /// unchanged in the result.
    ///
    /// ## Bad
    /// ```val3
    /// putln(getDate("%d/%m/%Y %h:%M"))
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln(getDate("%d/%m/%Y %H:%M"))
    /// ```
    V0228 "unknown-date-key" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls() {
        for (param, argument) in call.arguments() {
            let Some(form @ TextForm::Date) = text_form(call.instruction.name, param.name) else { continue };
            let Some(text) = program.body.string(argument) else { continue };
            if let Some(key) = form.fault(&text) {
                found.report(&RULE, program.range(argument), word(call.instruction.name, key));
            }
        }
    }
}

fn word(callee: &str, key: &str) -> Wording {
    let (message, label) = match key.starts_with('%') {
        true => (format!("`{callee}` does not support the key `{key}`"), format!("`{key}` is not replaced")),
        false => (format!("`{callee}` gets a format without any key"), "returned unchanged".to_owned()),
    };
    Wording::new(message, label, format!("the keys are {}", one_of(&DATE_KEYS)))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn unknown_keys_are_reported() {
        expect![[r#"
            start.pgx:5 `"%D"` `getDate` does not support the key `%D`
              | `%D` is not replaced
              ? the keys are `%y`, `%Y`, `%m`, `%d`, `%H`, `%I`, `%p`, `%M` or `%S`
            start.pgx:6 `"hh:mm"` `getDate` gets a format without any key
              | returned unchanged
              ? the keys are `%y`, `%Y`, `%m`, `%d`, `%H`, `%I`, `%p`, `%M` or `%S`
            start.pgx:7 `"100%"` `getDate` does not support the key `%`
              | `%` is not replaced
              ? the keys are `%y`, `%Y`, `%m`, `%d`, `%H`, `%I`, `%p`, `%M` or `%S`
        "#]]
        .assert_eq(&check(&RULE, "putln(getDate(\"%D\"))\nputln(getDate(\"hh:mm\"))\nputln(getDate(\"100%\"))"));
    }

    #[test]
    fn known_keys_are_not_reported() {
        assert_eq!(check(&RULE, "string s\nputln(getDate(\"%y-%m-%d %I:%M:%S %p\"))\nputln(getDate(s+\" %d\"))"), "");
    }
}
