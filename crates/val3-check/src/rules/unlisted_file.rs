//! V0531: a program or data file in the application's folder that the project does not list.

use smol_str::SmolStr;
use val3_analysis::db::FileEdit;
use val3_analysis::items::declarations::{FileList, file_list};
use val3_analysis::items::unlisted::{Unlisted, unlisted, unlisted_in_shared_folder};

use crate::diagnostic::Wording;
use crate::fix::Site;
use crate::lint::{Findings, ProjectView};
use crate::rule::rule;

rule! {
    /// A program or data file is in the folder of a project that does not list it.
    ///
    /// ## Why
    /// Only files that the `.pjx` lists belong to the project. Other files are not loaded, and changes to them have no
    /// effect. Where several projects share a folder, a file that none of them lists is reported at the first. Either the file is left over, or its entry was lost, often when branches were merged.
    ///
    /// ## Bad
    /// ```val3
    /// === main/main.pjx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
    ///   <Parameters version="s7.11" stackSize="5000" millimeterUnit="true" />
    ///   <Programs>
    ///     <Program file="start.pgx" />
    ///   </Programs>
    ///   <Database>
    ///     <Data file="main.dtx" />
    ///   </Database>
    /// </Project>
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas />
    /// </Database>
    /// === main/start.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="start">
    ///     <Code><![CDATA[begin
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// === main/stop.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="stop">
    ///     <Code><![CDATA[begin
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    /// begin
    /// end
    ///
    /// program stop()
    /// begin
    /// end
    /// ```
    V0531 "unlisted-file" Info, Project: check
}

fn check(view: &ProjectView<'_>, found: &mut Findings) {
    let shared = unlisted_in_shared_folder(view.db, view.project);
    for Unlisted { programs, data } in [unlisted(view.db, view.project), &shared] {
        report(view, found, true, programs);
        report(view, found, false, data);
    }
}

fn report(view: &ProjectView<'_>, found: &mut Findings, of_programs: bool, unlisted: &[SmolStr]) {
    let what = if of_programs { "program" } else { "data" };
    for name in unlisted {
        let Some(list) = file_list(view.db, view.project, of_programs) else { continue };
        found.report(&RULE, list.place, word(name, what)).fix(format!("list `{name}`"), false, entry(view, list, name));
    }
}

/// Inserts an entry after the last entry, in the same form and on a separate line.
fn entry(view: &ProjectView<'_>, list: FileList, name: &str) -> Option<FileEdit> {
    let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-'));
    let last = Site::new(view.db, view.project.manifest(view.db), list.last.filter(|_| is_plain)?, None);
    Some(last.element_after(&format!("<{} file=\"{name}\" />", list.item)))
}

fn word(name: &str, what: &str) -> Wording {
    Wording::new(
        format!("the {what} file `{name}` is in the folder but not listed"),
        "not in this list",
        "add it to the project, or move it out of the folder",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn project(programs: &str, files: &[&str]) -> String {
        let parts = [
            "<Project><Parameters version=\"s8.20\"/>",
            programs,
            "<Database><Data file=\"a.dtx\"/></Database></Project>",
        ];
        let program = "<Programs><Program name=\"p\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>";
        let files: String = files.iter().map(|name| format!("=== a/{name}\n{program}\n")).collect();
        let listing = format!("=== a/a.pjx\n{}\n=== a/a.dtx\n<Database><Datas/></Database>\n{files}", parts.concat());
        check(&RULE, &listing)
    }

    #[test]
    fn unlisted_programs_and_data_are_reported() {
        let listed = "<Programs><Program file=\"p.pgx\"/></Programs>";
        expect![[r#"
            a.pjx:1 `Programs` the program file `q.PGX` is in the folder but not listed
              | not in this list
              ? add it to the project, or move it out of the folder
              ! list `q.PGX` (unsafe)
            a.pjx:1 `Database` the data file `b.dtx` is in the folder but not listed
              | not in this list
              ? add it to the project, or move it out of the folder
              ! list `b.dtx` (unsafe)
        "#]]
        .assert_eq(&project(listed, &["p.pgx", "q.PGX", "b.dtx"]));
    }

    #[test]
    fn listed_and_foreign_files_are_not_reported() {
        let listed = "<Programs><Program file=\"P.PGX\"/><Program file=\"./q.pgx\"/></Programs>";
        assert_eq!(project(listed, &["p.pgx", "q.pgx", "a.ltx", "p.pgx.bak", "sub/r.pgx"]), "");
    }

    #[test]
    fn a_folder_with_a_project_that_cannot_be_read_is_not_reported() {
        assert_eq!(project("<Programs/>", &["p.pgx", "b.pjx"]), "");
    }

    #[test]
    fn files_that_no_project_of_a_shared_folder_lists_are_reported_once() {
        let program = "<Programs><Program name=\"p\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>";
        let projects = ["a", "b"].map(|name| {
            format!(
                "=== a/{name}.pjx\n<Project><Parameters version=\"s8.20\"/><Programs><Program file=\"{name}.pgx\"/>\
                 </Programs><Database/></Project>\n=== a/{name}.pgx\n{program}\n"
            )
        });
        expect![[r#"
            a.pjx:1 `Programs` the program file `c.pgx` is in the folder but not listed
              | not in this list
              ? add it to the project, or move it out of the folder
              ! list `c.pgx` (unsafe)
        "#]]
        .assert_eq(&check(&RULE, &format!("{}=== a/c.pgx\n{program}\n", projects.concat())));
    }
}
