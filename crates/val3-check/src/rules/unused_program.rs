//! V0117: a private program that is never called.

use val3_analysis::application::{ENTRY_POINTS, is_library_item, unlisted_may_use};
use val3_analysis::items::declarations;
use val3_analysis::test_applications::has_tests;
use val3_lang::test_names::is_executed;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// Nothing in the application calls the private program.
    ///
    /// ## Why
    /// The program is left over, or its call is missing. `start` and `stop`, which the controller calls, are not
    /// reported, nor are tests, `setup` and `teardown`, which `val3 test` executes. Public programs, which other
    /// applications may call, are not reported either. Nothing is reported in an application with user pages (s8), whose
    /// buttons can call programs. A program that only calls itself counts as unused. A program without a line of code is a
    /// place for notes and not reported.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    /// begin
    ///   putln("ready")
    /// end
    ///
    /// program goHome()
    /// begin
    ///   resetMotion()
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    /// begin
    ///   call goHome()
    /// end
    ///
    /// program goHome()
    /// begin
    ///   resetMotion()
    /// end
    /// ```
    V0117 "unused-program" Info, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let name = program.name();
    if program.header.public || program.body.block.is_empty() || !program.application().closed {
        return;
    }
    let callers = program.application().callers.get(name).into_iter().flatten();
    if !is_entry_point(program)
        && !callers.into_iter().any(|caller| caller != name)
        && !is_library_item(program.db, name)
        && !unlisted_may_use(program.db, program.project, name)
        && let Some(place) = declarations::program(program.db, program.file)
    {
        found.report(&RULE, place.range, word(name));
    }
}

fn is_entry_point(program: &ProgramView<'_>) -> bool {
    let name = program.name();
    let options = program.options;
    ENTRY_POINTS.contains(&name)
        || is_executed(name) && has_tests(program.db, program.project)
        || options.entry_points.iter().any(|entry| entry == name)
        || options.entry_prefixes.iter().any(|prefix| name.starts_with(prefix.as_str()))
}

fn word(name: &str) -> Wording {
    Wording::new(
        format!("nothing calls the program `{name}`"),
        "never called",
        "call it, remove it, or make it public if others call it",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    const ALONE: &str = "program start()\nbegin\nend\nprogram notes()\nbegin\nend\nprogram p()\nbegin\n  call p()\nend";

    #[test]
    fn a_program_without_callers_is_reported() {
        expect![[r#"
            p.pgx:3 `p` nothing calls the program `p`
              | never called
              ? call it, remove it, or make it public if others call it
        "#]]
        .assert_eq(&check(&RULE, ALONE));
    }

    #[test]
    fn calls_and_tasks_count_as_uses() {
        let programs = "program p()\nbegin\nend\npublic program q()\nbegin\nend\nprogram stop()\nbegin\nend";
        assert_eq!(check(&RULE, &format!("call p()\n{programs}")), "");
        assert_eq!(check(&RULE, &format!("taskCreate \"t\",10,p()\n{programs}")), "");
    }

    #[test]
    fn entry_points_can_be_configured() {
        let settings = "=== val3.toml\n[lint]\nentry-points = [\"p\"]";
        assert_eq!(check(&RULE, &format!("{ALONE}\n{settings}")), "");
        let settings = "=== val3.toml\n[lint]\nentry-prefixes = [\"p\"]";
        assert_eq!(check(&RULE, &format!("{ALONE}\n{settings}")), "");
    }

    #[test]
    fn programs_that_tests_consist_of_are_executed() {
        let programs =
            "program start()\nbegin\nend\nprogram testP()\nbegin\n  ? 1\nend\nprogram setup()\nbegin\n  ? 2\nend";
        assert_eq!(check(&RULE, &format!("{programs}\n=== val3.toml\n[test]\napplications = [\"**\"]")), "");
        assert_eq!(check(&RULE, programs).matches("nothing calls").count(), 2);
    }

    #[test]
    fn applications_with_faults_are_not_reported() {
        assert_eq!(check(&RULE, "call pp()\nprogram p()\nbegin\nend"), "");
    }
}
