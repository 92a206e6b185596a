//! V0533: a file feature that the declared version does not have.

use smol_str::SmolStr;
use val3_analysis::items::declarations::{is_old, program_file, version};
use val3_analysis::items::manifest::manifest;
use val3_lang::versions::Version;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProjectView};
use crate::rule::rule;

rule! {
    /// The files of a project use a feature that the declared version does not have.
    ///
    /// ## Why
    /// Controllers of that version do not load the project. Those up to s6 read another form of files and have neither
    /// user types nor collections. Program files in sub-folders exist from s8.20 on.
    ///
    /// ## Bad
    /// ```val3
    /// version s6.8
    /// putln("ready")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// version s7.3
    /// putln("ready")
    /// ```
    V0533 "version-feature" Warning, Project: check
}

fn check(view: &ProjectView<'_>, found: &mut Findings) {
    let Some(declared) = version(view.db, view.project) else { return };
    let version = view.items.version;
    if !version.has_user_types() && !is_old(view.db, view.project) {
        found.report(&RULE, declared, word_form(version));
    }
    if !version.allows_sub_folders() {
        sub_folders(view, found, declared);
    }
}

/// Entry of the first program file in a sub-folder.
pub(super) fn file_in_sub_folder(view: &ProjectView<'_>) -> Option<TextRange> {
    let manifest = manifest(view.db, view.project.manifest(view.db));
    let nested = |path: &&SmolStr| path.trim().trim_start_matches("./").contains(['/', '\\']);
    program_file(view.db, view.project, manifest.programs.iter().find(nested)?)
}

fn sub_folders(view: &ProjectView<'_>, found: &mut Findings, declared: TextRange) {
    if let Some(range) = file_in_sub_folder(view) {
        found.report(&RULE, range, word_sub_folder(view.items.version)).related(declared, "declared here");
    }
}

fn word_form(version: Version) -> Wording {
    Wording::new(
        format!("the project declares {version}, and its files have the form of s7"),
        "older than the form of the files",
        "declare the version of the controllers that run it",
    )
}

fn word_sub_folder(version: Version) -> Wording {
    Wording::new(
        format!("program files in sub-folders exist from s8.20 on, and the project declares {version}"),
        "in a sub-folder",
        "put the program in the folder of the project file",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn new_files_of_an_old_version_are_reported() {
        expect![[r#"
            main.pjx:3 `s6.8` the project declares s6.8, and its files have the form of s7
              | older than the form of the files
              ? declare the version of the controllers that run it
        "#]]
        .assert_eq(&check(&RULE, "version s6.8\ncls()"));
        assert_eq!(check(&RULE, "version s7.0\ncls()"), "");
    }

    fn check_program_file(version: &str, file: &str) -> String {
        let programs = format!("<Programs><Program file=\"{file}\"/></Programs>");
        let project = format!("<Project>\n<Parameters version=\"{version}\"/>\n{programs}\n</Project>");
        let program = "<Programs><Program name=\"p\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>";
        check(&RULE, &format!("=== a/a.pjx\n{project}\n=== a/{file}\n{program}"))
    }

    #[test]
    fn sub_folders_of_an_old_version_are_reported() {
        expect![[r#"
            a.pjx:3 `comm/p.pgx` program files in sub-folders exist from s8.20 on, and the project declares s8.13
              | in a sub-folder
              ? put the program in the folder of the project file
              > a.pjx:2 `s8.13` declared here
        "#]]
        .assert_eq(&check_program_file("s8.13", "comm/p.pgx"));
        assert_eq!(check_program_file("s8.20.2", "comm/p.pgx"), "");
        assert_eq!(check_program_file("s8.13", "p.pgx"), "");
    }
}
