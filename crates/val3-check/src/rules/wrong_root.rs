//! V0504: a file with the wrong root element.

use val3_analysis::problem::FileRole;

use crate::{diagnostic::Wording, phrase::file_role, rule::rule};

rule! {
    /// The root element of a file does not belong to this kind of file.
    ///
    /// ## Why
    /// A `.pjx` file contains a project, a `.dtx` file data and a `.pgx` file a program, as the root element states.
    /// With another root the controller does not understand the file and does not load the application. Usually a file
    /// was overwritten by another file. Projects of s5 and s6 use other roots than those of s7 and s8; each file may
    /// have either form.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
    /// </Project>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///   </Datas>
    /// </Database>
    /// ```
    V0504 "wrong-root" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(expected: FileRole, found: &str) -> Wording {
    let [root, old_root] = roots(expected);
    Wording::new(
        format!("a {} starts with the element `{root}`, not `{found}`", kind(expected)),
        label(found),
        format!("`{root}` is the root in s7 and s8, `{old_root}` in s5 and s6"),
    )
}

/// Root elements of s7 and s5.
fn roots(role: FileRole) -> [&'static str; 2] {
    match role {
        FileRole::Project | FileRole::Library | FileRole::Type => ["Project", "project"],
        FileRole::Program => ["Programs", "programList"],
        FileRole::Data => ["Database", "dataList"],
    }
}

/// Kind of file; libraries and types are projects.
fn kind(role: FileRole) -> &'static str {
    match role {
        FileRole::Library | FileRole::Type => file_role(FileRole::Project),
        _ => file_role(role),
    }
}

/// Names the kind of file with this root element.
fn label(found: &str) -> String {
    [FileRole::Project, FileRole::Program, FileRole::Data]
        .into_iter()
        .find(|role| roots(*role).contains(&found))
        .map(|role| format!("the root of a {}", file_role(role)))
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_project_element_in_a_data_file_is_reported() {
        expect![[r#"
            a data file starts with the element `Database`, not `Project`
            | the root of a project file
            ? `Database` is the root in s7 and s8, `dataList` in s5 and s6
        "#]]
        .assert_eq(&word(FileRole::Data, "Project").to_string());
    }

    #[test]
    fn an_unknown_root_is_reported() {
        expect![[r#"
            a project file starts with the element `Project`, not `html`
            ? `Project` is the root in s7 and s8, `project` in s5 and s6
        "#]]
        .assert_eq(&word(FileRole::Library, "html").to_string());
    }
}
