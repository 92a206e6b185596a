//! V0534: an application that cannot be started because it has no `stop`.

use val3_analysis::application::{START, STOP};
use val3_analysis::items::declarations::program_file;
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::find_file;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProjectView, is_library};
use crate::rule::{Severity, rule};

rule! {
    /// A project has the program `start` but no program `stop`.
    ///
    /// ## Why
    /// The controller starts an application only if it has both (2.1): `start`, and `stop`, which runs when the
    /// application is stopped. A project without them is a library or a user type. `val3 run` does not run it either.
    /// Many libraries still have one of the two from an earlier use as an application, so it is reported only for
    /// projects that no other project uses. It is an info unless a whole cell is checked, with the configuration of its
    /// controller.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    /// begin
    ///   putln("ready")
    /// end
    ///
    /// === /configs/arm.cfx
    /// <arm><String name="arm" value="tx90-S1" /></arm>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    /// begin
    ///   putln("ready")
    /// end
    ///
    /// program stop()
    /// begin
    /// end
    ///
    /// === /configs/arm.cfx
    /// <arm><String name="arm" value="tx90-S1" /></arm>
    /// ```
    V0534 "missing-stop" Warning, Project: check
}

fn check(view: &ProjectView<'_>, found: &mut Findings) {
    let Some(start) = view.items.programs.get(START) else { return };
    let may_stop = view.items.programs.contains_key(STOP) || view.items.may_have_program(STOP);
    if may_stop || is_library(view.db, view.project) {
        return;
    }
    let is_in_cell = view.project.cell(view.db).is_some();
    let level = if is_in_cell { Severity::Warning } else { Severity::Info };
    let listed = &manifest(view.db, view.project.manifest(view.db)).programs;
    let reference = listed.iter().find(|reference| find_file(view.db, view.project, reference) == Some(*start));
    if let Some(range) = reference.and_then(|reference| program_file(view.db, view.project, reference)) {
        found.report(&RULE, range, word()).level(level);
    }
}

fn word() -> Wording {
    Wording::new(
        "the project has the program `start` but no program `stop`",
        "cannot be started",
        "add a program `stop`, which may be empty",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing;
    use crate::rule::Rule;

    /// Findings in a complete cell.
    fn check(rule: &Rule, listing: &str) -> String {
        let arm = "<arm><String name=\"arm\" value=\"tx90-S1\" /></arm>";
        testing::check(rule, &format!("{listing}\n=== /configs/arm.cfx\n{arm}"))
    }

    #[test]
    fn start_without_stop_is_reported() {
        expect![[r#"
            main.pjx:5 `start.pgx` the project has the program `start` but no program `stop`
              | cannot be started
              ? add a program `stop`, which may be empty
        "#]]
        .assert_eq(&check(&RULE, "cls()"));
    }

    #[test]
    fn the_finding_is_an_info_if_the_cell_is_unknown() {
        assert_eq!(testing::levels(&RULE, "cls()"), [Severity::Info]);
        assert_eq!(testing::levels(&RULE, "cls()\n=== /configs/arm.cfx\n<arm />"), [Severity::Warning]);
    }

    #[test]
    fn applications_with_both_or_neither_are_not_reported() {
        for listing in ["cls()\nprogram stop()\nbegin\nend", "program run()\nbegin\nend", "num nA"] {
            assert_eq!(check(&RULE, listing), "", "{listing}");
        }
    }

    #[test]
    fn a_library_needs_neither() {
        let listing = "library part \"Disk://part/part.pjx\"\ncall part:init()\nprogram stop()\nbegin\nend\n\
                       --- part\ncls()\npublic program init()\nbegin\nend";
        assert_eq!(check(&RULE, listing), "");
    }

    #[test]
    fn a_stop_whose_file_is_missing_is_reported_elsewhere() {
        let project =
            "<Project><Programs><Program file=\"start.pgx\"/><Program file=\"stop.pgx\"/></Programs></Project>";
        let program = "<Programs><Program name=\"start\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>";
        assert_eq!(check(&RULE, &format!("=== a/a.pjx\n{project}\n=== a/start.pgx\n{program}")), "");
    }
}
