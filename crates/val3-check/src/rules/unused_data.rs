//! V0113: private data that no program uses.

use val3_analysis::application::is_library_item;
use val3_analysis::items::declarations::Declared;

use crate::diagnostic::Wording;
use crate::lint::{DataFile, Findings, ProjectView, removal, unused_data};
use crate::rule::rule;

rule! {
    /// No program of the application uses the private data.
    ///
    /// ## Why
    /// The data is left over, or the program that should use it uses other data. Data counts as used if a program names
    /// it, if it is the father of other data, or if a program reads it by its name with `getData`. Public data is not
    /// reported, because other applications may use it, nor is `mNomSpeed`, which the vendor's template creates in each
    /// project. Nothing is reported in an application with user pages (s8), which can name data as well.
    ///
    /// Positions, frames, tools and configurations may be in use at the pendant, for example to jog the arm. No fix
    /// removes them if they have values.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    /// num nLimit
    ///
    /// program start()
    /// begin
    ///   nCount=nCount+1
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// num nLimit
    ///
    /// program start()
    /// begin
    ///   nCount=min(nCount+1,nLimit)
    /// end
    /// ```
    V0113 "unused-data" Info, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    if !unused_data::has_known_uses(&data.view) {
        return;
    }
    for Declared { name, range, element } in unused_data::declared(data, |name| is_unused(&data.view, name)) {
        let is_taught = unused_data::is_taught(data, &name, element);
        let removal = || removal::of_element(data.view.db, data.file, element);
        let edits = (!is_taught).then(removal);
        found.report(&RULE, range, word(&name, is_taught)).fix(format!("remove `{name}`"), false, edits);
    }
}

fn is_unused(view: &ProjectView<'_>, name: &str) -> bool {
    unused_data::uses(view, name).is_some_and(|uses| !uses.may_read() && !uses.may_write())
        && !is_library_item(view.db, name)
        && name != OF_TEMPLATE
}

/// Motion descriptor in the vendor's project template.
const OF_TEMPLATE: &str = "mNomSpeed";

fn word(name: &str, is_taught: bool) -> Wording {
    let help =
        if is_taught { "it may be in use at the pendant" } else { "remove it, or make it public if others need it" };
    Wording::new(format!("no program uses `{name}`"), "never used", help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn data_that_are_never_named_are_reported() {
        expect![[r#"
            main.dtx:4 `nA` no program uses `nA`
              | never used
              ? remove it, or make it public if others need it
              ! remove `nA` (unsafe)
        "#]]
        .assert_eq(&check(&RULE, "num nA\npublic num nB\nprogram start()\nbegin\nend"));
    }

    #[test]
    fn any_use_counts_as_a_use() {
        let listing = "num nA\nnum nB\nbool bC\nnum nD[3]\nnum nE\nprogram start()\nbegin\n  nA=1\n  ?nB\n  \
                       setMutex(bC)\n  if size(nD)>1 and isDefined(nE)\n  endIf\nend";
        assert_eq!(check(&RULE, listing), "");
    }

    fn check_argument(argument: &str) -> String {
        check(&RULE, &format!("num nA\nnum nB1\nnum nX\nprogram start()\nbegin\n  getData({argument},nX)\nend"))
    }

    #[test]
    fn data_named_in_a_string_are_not_reported() {
        assert_eq!(
            check_argument("\"nA[\"+toString(\"\",nX)+\"]\"").lines().next(),
            Some("main.dtx:5 `nB1` no program uses `nB1`")
        );
        assert!(!check_argument("\"nB\"+toString(\"\",nX)").contains("nB1"));
        assert_eq!(check_argument("toString(\"\",nX)"), "");
    }

    #[test]
    fn a_father_counts_as_used() {
        let listing = "=== a/a.pjx\n<Project><Parameters version=\"s7.11\"/><Programs><Program file=\"start.pgx\"/></Programs>\
                       <Database><Data file=\"a.dtx\"/></Database></Project>\n=== a/start.pgx\n\
                       <Programs><Program name=\"start\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>\n\
                       === a/a.dtx\n<Database xmlns:xsi=\"y\"><Datas>\n\
                       <Data name=\"fA\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\"/>\n\
                       <Data name=\"pB\" access=\"public\" xsi:type=\"array\" type=\"pointRx\" size=\"1\">\
                       <Value key=\"0\" fatherId=\"fA[0]\"/></Data>\n</Datas></Database>";
        assert_eq!(check(&RULE, listing), "");
    }

    #[test]
    fn applications_with_faults_are_not_reported() {
        assert_eq!(check(&RULE, "num nA\nprogram start()\nbegin\n  nB=1\nend"), "");
        assert_eq!(check(&RULE, "num nA"), "");
    }

    /// A project that lists one program.
    const PROJECT: &str = "=== main/main.pjx\n<Project xmlns=\"x\"><Parameters version=\"s7.11\"/><Programs>\
                           <Program file=\"start.pgx\"/></Programs><Database><Data file=\"main.dtx\"/></Database>\
                           </Project>\n";

    /// Whether `nA` and `nB1` are reported if an unlisted program has this code.
    fn are_reported(code: &str) -> [bool; 2] {
        let program =
            format!("<Programs><Program name=\"q\"><Code><![CDATA[begin\n{code}\nend]]></Code></Program></Programs>");
        let data = "num nA\nnum nB1\nprogram start()\nbegin\nend\n";
        let found = check(&RULE, &format!("{data}=== main/q.pgx\n{program}\n{PROJECT}"));
        ["nA", "nB1"].map(|name| found.contains(&format!("`{name}` no program uses")))
    }

    #[test]
    fn unlisted_programs_count_as_uses() {
        assert_eq!(are_reported("  cls()"), [true, true]);
        assert_eq!(are_reported("  nA=1"), [false, true]);
        assert_eq!(are_reported("  if (nB1"), [true, false]);
        assert!(!are_reported("  getData(\"nB\"+toString(\"\",nX),nX)")[1]);
    }

    #[test]
    fn user_pages_count_as_uses() {
        let listing = "num nA\nprogram start()\nbegin\nend\n=== main/interface/main.bindings.json\n{}";
        assert_eq!(check(&RULE, listing), "");
    }

    #[test]
    fn taught_values_are_never_removed_and_the_descriptor_of_the_template_is_not_reported() {
        let listing = "point pHome\ntool tGripper\nmdesc mNomSpeed\nnum nOld\nprogram start()\nbegin\ncls()\nend";
        expect![[r#"
            main.dtx:4 `pHome` no program uses `pHome`
              | never used
              ? it may be in use at the pendant
            main.dtx:7 `tGripper` no program uses `tGripper`
              | never used
              ? it may be in use at the pendant
            main.dtx:11 `nOld` no program uses `nOld`
              | never used
              ? remove it, or make it public if others need it
              ! remove `nOld` (unsafe)
        "#]]
        .assert_eq(&check(&RULE, listing));
    }
}
