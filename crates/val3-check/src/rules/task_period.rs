//! V0323: a period that is rounded or has the wrong unit.

use val3_lang::runtime_errors::INVALID_PARAMETER;
use val3_lang::tasks::{PERIOD_STEP, is_exact_period, period_steps};
use val3_lang::values::printed::num;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::{Severity, rule};

rule! {
    /// A synchronous task has a constant period that is not a multiple of 4 ms, or a period of whole seconds.
    ///
    /// ## Why
    /// The controller rounds a period down to a multiple of 0.004 s (5.10): 0.01 s becomes 8 ms, and times that the
    /// task counts in periods are wrong by a quarter. The unit of a period is the second: 16 is a period of 16 s,
    /// usually meant as 16 ms. A period below 4 ms is rounded down to 0, which is run-time error 70: an error up to s7.
    /// No public source states whether a CS9 (s8) accepts shorter periods; there it is information, and `val3 run` uses 4
    /// ms.
    ///
    /// ## Bad
    /// ```val3
    /// bool bLate
    ///
    /// taskCreateSync "watch",0.01,bLate,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bLate
    ///
    /// taskCreateSync "watch",0.012,bLate,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    V0323 "task-period" Warning, Program: check
}

/// Minimum whole number of seconds that is reported as probably intended in milliseconds.
const SLOWEST: f64 = 2.0;

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for task in program.task_creations().filter(|task| task.is_synchronous()) {
        let Some(period) = program.body.number(task.pace).filter(|period| *period > 0.0) else { continue };
        let range = program.range(task.pace);
        if period > SLOWEST {
            let instead = (period / 1000.0).to_string();
            let title = format!("write `{instead}`, which is {period} ms");
            found.report(&RULE, range, seconds(period)).fix(title, false, [program.write(range, &instead)]);
        } else if period_steps(period) == Some(0) {
            let is_accepted = program.items.version.lengthens_short_periods();
            let level = if is_accepted { Severity::Info } else { Severity::Error };
            let title = format!("write `{PERIOD_STEP}`");
            let edit = program.write(range, &PERIOD_STEP.to_string());
            found.report(&RULE, range, too_short(period, is_accepted)).level(level).fix(title, false, [edit]);
        } else if !is_exact_period(period) {
            found.report(&RULE, range, rounded(period));
        }
    }
}

fn seconds(period: f64) -> Wording {
    Wording::new(
        format!("the task runs once in {} seconds", num(period)),
        "a period counts seconds",
        format!("for {} ms write `{}`", num(period), num(period / 1000.0)),
    )
}

fn too_short(period: f64, is_accepted: bool) -> Wording {
    let step = PERIOD_STEP * 1000.0;
    let effect = if is_accepted {
        format!("`val3 run` uses {step} ms; a controller may raise an error")
    } else {
        runtime_error(INVALID_PARAMETER)
    };
    Wording::new(
        format!("the period {} ms is below {step} ms, the shortest one", milliseconds(period)),
        effect,
        format!("write {PERIOD_STEP}, or a multiple of it"),
    )
}

fn rounded(period: f64) -> Wording {
    let step = PERIOD_STEP * 1000.0;
    let below = (period / PERIOD_STEP).floor() * step;
    Wording::new(
        format!("the period {} ms is not a multiple of {step} ms", num(milliseconds(period))),
        format!("rounded down to {} ms", num(below)),
        format!("write {} or {}", num(below / 1000.0), num((below + step) / 1000.0)),
    )
}

/// Converts seconds to milliseconds, without the last digits of a binary fraction.
fn milliseconds(seconds: f64) -> f64 {
    (seconds * 1e6).round() / 1e3
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::{check, levels};

    #[test]
    fn rounded_and_long_periods_are_reported() {
        expect![[r#"
            start.pgx:5 `0.01` the period 10 ms is not a multiple of 4 ms
              | rounded down to 8 ms
              ? write 0.008 or 0.012
            start.pgx:6 `16` the task runs once in 16 seconds
              | a period counts seconds
              ? for 16 ms write `0.016`
              ! write `0.016`, which is 16 ms (unsafe)
            start.pgx:7 `0.0139` the period 13.9 ms is not a multiple of 4 ms
              | rounded down to 12 ms
              ? write 0.012 or 0.016
        "#]].assert_eq(&check(
            &RULE,
            "bool b\ntaskCreateSync \"a\",0.01,b,q()\ntaskCreateSync \"b\",16,b,q()\ntaskCreateSync \"c\",0.0139,b,q()\n\
             program q()\nbegin\nend",
        ));
    }

    #[test]
    fn multiples_of_four_milliseconds_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "num n\nbool b\ntaskCreateSync \"a\",0.004,b,q()\ntaskCreateSync \"b\",0.02,b,q()\n\
                 taskCreateSync \"c\",n,b,q()\ntaskCreateSync \"d\",1,b,q()\ntaskCreate \"e\",10,q()\nprogram q()\nbegin\nend"
            ),
            ""
        );
    }

    fn with_short_period(version: &str) -> String {
        format!("version {version}\nbool bLate\ntaskCreateSync \"w\",0.002,bLate,p()\nprogram p()\nbegin\nend")
    }

    #[test]
    fn periods_below_the_shortest_one_are_errors_up_to_s7() {
        expect![[r#"
            start.pgx:5 `0.002` the period 2 ms is below 4 ms, the shortest one
              | run-time error 70: invalid parameter
              ? write 0.004, or a multiple of it
              ! write `0.004` (unsafe)
        "#]]
        .assert_eq(&check(&RULE, &with_short_period("s7.11")));
        assert_eq!(levels(&RULE, &with_short_period("s7.11")), [Severity::Error]);
        assert_eq!(levels(&RULE, &with_short_period("s8.15")), [Severity::Info]);
        let found = check(&RULE, &with_short_period("s8.15"));
        assert!(found.contains("| `val3 run` uses 4 ms; a controller may raise an error\n"), "{found}");
    }
}
