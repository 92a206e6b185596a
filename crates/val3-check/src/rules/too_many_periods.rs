//! V0324: more different periods than the controller supports.

use val3_analysis::db::FileRange;
use val3_lang::tasks::{MAX_PERIODS, PERIOD_STEP, period_steps};

use crate::diagnostic::Wording;
use crate::english::and;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The synchronous tasks of an application have more than two different periods.
    ///
    /// ## Why
    /// All synchronous tasks that exist at the same time can have at most two different periods; the creation of a task
    /// with a third one raises run-time error 32 (5.10). A task that needs a longer period can count the turns of a
    /// shorter one.
    ///
    /// ## Bad
    /// ```val3
    /// bool bLate
    ///
    /// taskCreateSync "fast",0.004,bLate,watching()
    /// taskCreateSync "medium",0.02,bLate,watching()
    /// taskCreateSync "slow",0.1,bLate,watching()
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
    /// taskCreateSync "fast",0.004,bLate,watching()
    /// taskCreateSync "medium",0.02,bLate,watching()
    /// taskCreateSync "slow",0.02,bLate,watching()
    ///
    /// program watching()
    /// begin
    ///   putln("watching")
    /// end
    /// ```
    V0324 "too-many-periods" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut creations = program.task_creations().filter(|task| task.is_synchronous()).peekable();
    if creations.peek().is_none() {
        return;
    }
    let periods = periods(program);
    let Some(surplus) = periods.get(MAX_PERIODS..).filter(|surplus| !surplus.is_empty()) else { return };
    for task in creations {
        let steps = program.body.number(task.pace).and_then(period_steps);
        if steps.is_some_and(|steps| surplus.contains(&steps)) {
            let mut reported = found.report(&RULE, program.range(task.pace), word(&periods));
            for period in periods.iter().take(MAX_PERIODS) {
                let message = format!("{} ms here", milliseconds(*period));
                reported = reported.related_at(asked_for(program, *period), message);
            }
        }
    }
}

/// Different periods of the tasks that the application may create, in multiples of 4 ms. A shorter period creates no
/// task.
fn periods(program: &ProgramView<'_>) -> Vec<u32> {
    let application = program.application();
    let created = application.tasks.iter();
    let created =
        created.filter(|task| task.created_by.as_ref().is_some_and(|name| application.run_by.contains_key(name)));
    let mut periods: Vec<u32> = Vec::new();
    for period in created.filter_map(|task| task.start.period).filter(|period| *period > 0) {
        if !periods.contains(&period) {
            periods.push(period);
        }
    }
    periods
}

/// First location in the application that uses a period.
fn asked_for(program: &ProgramView<'_>, period: u32) -> Option<FileRange> {
    let tasks = &program.application().tasks;
    let creator = tasks.iter().find(|task| task.start.period == Some(period))?.created_by.as_deref()?;
    let creator = program.other(creator)?;
    let mut paces = creator.task_creations().filter(|task| task.is_synchronous()).map(|task| task.pace);
    let pace = paces.find(|pace| creator.body.number(*pace).and_then(period_steps) == Some(period))?;
    Some(creator.span(pace))
}

fn milliseconds(steps: u32) -> f64 {
    f64::from(steps) * PERIOD_STEP * 1000.0
}

fn word(periods: &[u32]) -> Wording {
    let mut sorted = periods.to_vec();
    sorted.sort_unstable();
    let shown: Vec<String> = sorted.iter().map(|steps| milliseconds(*steps).to_string()).collect();
    Wording::new(
        format!("the synchronous tasks of this application have {} different periods", periods.len()),
        format!("{MAX_PERIODS} are supported at a time"),
        format!("the periods are {} ms: choose {MAX_PERIODS} of them", and(&shown)),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    const WATCHING: &str = "bool b\nprogram watching()\nbegin\nend\n";

    #[test]
    fn a_third_period_is_reported() {
        let code = "call more()\ntaskCreateSync \"a\",0.004,b,watching()\ntaskCreateSync \"c\",0.016,b,watching()\n\
                    program more()\nbegin\ntaskCreateSync \"b\",0.02,b,watching()\nend\n";
        expect![[r#"
            start.pgx:7 `0.016` the synchronous tasks of this application have 3 different periods
              | 2 are supported at a time
              ? the periods are 4, 16 and 20 ms: choose 2 of them
              > more.pgx:5 `0.02` 20 ms here
              > start.pgx:6 `0.004` 4 ms here
        "#]]
        .assert_eq(&check(&RULE, &format!("{WATCHING}{code}")));
    }

    #[test]
    fn two_and_unknown_periods_are_not_reported() {
        let code = "num n\ntaskCreateSync \"a\",0.004,b,watching()\ntaskCreateSync \"b\",0.02,b,watching()\n\
                    taskCreateSync \"c\",0.021,b,watching()\ntaskCreateSync \"d\",n,b,watching()\n\
                    taskCreateSync \"f\",0.001,b,watching()\n\
                    program idle()\nbegin\ntaskCreateSync \"e\",0.1,b,watching()\nend\n";
        assert_eq!(check(&RULE, &format!("{WATCHING}{code}")), "");
    }
}
