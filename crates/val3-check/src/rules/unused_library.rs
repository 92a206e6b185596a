//! V0118: a library identifier that is never used.

use val3_analysis::application::unlisted_may_use;
use val3_analysis::items::declarations;
use val3_analysis::items::fathers::fathers;
use val3_analysis::items::manifest::manifest;
use val3_analysis::test_applications::has_tests;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProjectView, removal, unused_data};
use crate::rule::rule;

rule! {
    /// A project declares a library that none of its programs uses.
    ///
    /// ## Why
    /// The library is loaded with the application and needs memory and time without being used, or a program uses the
    /// wrong library.
    ///
    /// Applications with tests are not checked: a library that they load is part of the coverage of their tests.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// putln("ready")
    /// --- part
    /// public num nWeight
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// putln(part:nWeight)
    /// --- part
    /// public num nWeight
    /// ```
    V0118 "unused-library" Info, Project: check
}

fn check(view: &ProjectView<'_>, found: &mut Findings) {
    if !unused_data::has_known_uses(view) || has_tests(view.db, view.project) {
        return;
    }
    for entry in &manifest(view.db, view.project.manifest(view.db)).libraries {
        let name = &entry.alias;
        let is_used = view.application().libraries.contains(name)
            || view.application().is_named_in_text(name)
            || fathers(view.db, view.project).contains(name)
            || unlisted_may_use(view.db, view.project, name);
        if is_used {
            continue;
        }
        if let Some(place) = declarations::library(view.db, view.project, name.clone()) {
            found.report(&RULE, place.range, word(name)).fix(
                format!("remove `{name}`"),
                false,
                removal::of_entry(view.db, place.file, place.range),
            );
        }
    }
}

fn word(name: &str) -> Wording {
    Wording::new(format!("no program uses the library identifier `{name}`"), "never used", "remove the entry")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn library(code: &str) -> String {
        check(
            &RULE,
            &format!(
                "library part \"Disk://part/part.pjx\"\nnum nA\nprogram start()\nbegin\n  {code}\nend\n--- part\npublic num nW\n"
            ),
        )
    }

    #[test]
    fn a_library_that_is_never_named_is_reported() {
        expect![[r#"
            main.pjx:11 `part` no program uses the library identifier `part`
              | never used
              ? remove the entry
              ! remove `part` (unsafe)
        "#]]
        .assert_eq(&library("cls()"));
    }

    #[test]
    fn libraries_of_tests_are_never_reported() {
        let listing = "=== main/main.pjx\n<Project xmlns=\"x\"><Parameters version=\"s7.11\"/></Project>\n=== mainTest/mainTest.pjx\n\
                       <Project xmlns=\"x\"><Parameters version=\"s7.11\"/><Libraries><Library alias=\"main\" \
                       path=\"../main/main.pjx\"/></Libraries></Project>\n";
        assert_eq!(check(&RULE, listing), "");
    }

    /// A project that lists one program and the library.
    const PROJECT: &str = "=== main/main.pjx\n<Project xmlns=\"x\"><Parameters version=\"s7.11\"/><Programs>\
                           <Program file=\"start.pgx\"/></Programs><Database><Data file=\"main.dtx\"/></Database>\
                           <Libraries><Library alias=\"part\" path=\"Disk://part/part.pjx\"/></Libraries></Project>\n";

    #[test]
    fn unlisted_programs_count_as_uses() {
        let program =
            "<Programs><Program name=\"q\"><Code><![CDATA[begin\n  ?part:nW\nend]]></Code></Program></Programs>";
        let listing = "library part \"Disk://part/part.pjx\"\nprogram start()\nbegin\nend\n";
        assert!(check(&RULE, &format!("{listing}--- part\npublic num nW\n")).contains("`part`"));
        assert_eq!(
            check(&RULE, &format!("{listing}=== main/q.pgx\n{program}\n{PROJECT}--- part\npublic num nW\n")),
            ""
        );
    }

    #[test]
    fn items_loading_and_names_in_strings_count_as_uses() {
        assert_eq!(library("?part:nW"), "");
        assert_eq!(library("part:libLoad(\"Disk://part\")"), "");
        assert_eq!(library("getData(\"part:nW\",nA)"), "");
    }
}
