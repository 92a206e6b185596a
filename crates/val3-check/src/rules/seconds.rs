//! V0240: a time that was probably intended in milliseconds.

use val3_lang::arguments::counts_seconds;
use val3_lang::values::printed::num;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A constant time is so long that it was probably meant in milliseconds.
    ///
    /// ## Why
    /// The unit of `delay` and `watch` is the second (5.10): `delay(500)` waits for more than eight minutes.
    ///
    /// ## Bad
    /// ```val3
    /// delay(500)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// delay(0.5)
    /// ```
    V0240 "seconds" Info, Program: check
}

/// Minimum number of seconds that is reported, unless it is a whole number of minutes.
const LONG: f64 = 200.0;
const MINUTE: f64 = 60.0;

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls() {
        for (_, argument) in call.arguments().filter(|(param, _)| counts_seconds(param.name)) {
            let Some(value) = program.body.number(argument).filter(|value| is_doubtful(*value)) else { continue };
            let instead = value / 1000.0;
            found.report(&RULE, program.range(argument), word(call.instruction.name, value)).fix(
                format!("write `{instead}`, which is {value} ms"),
                false,
                [program.write(program.range(argument), &instead.to_string())],
            );
        }
    }
}

fn is_doubtful(seconds: f64) -> bool {
    seconds >= LONG && seconds % MINUTE != 0.0
}

fn word(callee: &str, seconds: f64) -> Wording {
    let minutes = num((seconds / MINUTE * 10.0).round() / 10.0);
    Wording::new(
        format!("`{callee}` takes seconds, and {} seconds are {} minutes", num(seconds), minutes),
        "a very long time",
        format!("for {} ms write `{}`", num(seconds), num(seconds / 1000.0)),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn times_that_look_like_milliseconds_are_reported() {
        expect![[r#"
            start.pgx:5 `500` `delay` takes seconds, and 500 seconds are 8.3 minutes
              | a very long time
              ? for 500 ms write `0.5`
              ! write `0.5`, which is 500 ms (unsafe)
            start.pgx:6 `2500` `watch` takes seconds, and 2500 seconds are 41.7 minutes
              | a very long time
              ? for 2500 ms write `2.5`
              ! write `2.5`, which is 2500 ms (unsafe)
        "#]]
        .assert_eq(&check(&RULE, "bool b\ndelay(500)\nb=watch(b,2500)"));
    }

    #[test]
    fn times_in_seconds_are_not_reported() {
        assert_eq!(check(&RULE, "bool b\nnum n\ndelay(0.5)\nb=watch(b,199)\ndelay(600)\ndelay(n)"), "");
    }
}
