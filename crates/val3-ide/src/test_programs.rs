//! Programs that are tests.

use smol_str::SmolStr;
use val3_analysis::db::{Db, FileRange, Project};
use val3_analysis::items::program::header;
use val3_analysis::items::{declarations, project};
use val3_analysis::test_applications::has_tests;
use val3_lang::test_names;

/// A program that is a test.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestProgram {
    /// Program name.
    pub name: SmolStr,
    /// Location of the name in its declaration.
    pub place: FileRange,
}

/// Tests of a project, sorted by name.
pub fn test_programs(db: &dyn Db, project: Project) -> Vec<TestProgram> {
    if !has_tests(db, project) {
        return Vec::new();
    }
    let files = project::program_files(db, project).iter();
    let found = files.filter_map(|file| {
        let name = header(db, *file).name.clone();
        let place = declarations::program(db, *file).filter(|_| test_names::is_test(&name))?;
        Some(TestProgram { name, place })
    });
    let mut found: Vec<TestProgram> = found.collect();
    found.sort_by(|one, other| one.name.cmp(&other.name));
    found
}

/// Whether a program of a project is a test.
pub(crate) fn is_test(db: &dyn Db, project: Project, program: &str) -> bool {
    test_names::is_test(program) && has_tests(db, project)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::testing::{MarkedListing, shown};

    #[test]
    fn tests_are_programs_of_applications_with_tests() {
        let marked = MarkedListing::new(
            "program testOfNothing()\nbegin\nend\n--- mainTest\nprogram testSum()\nbegin\nend\n\
             program setup()\nbegin\nend\nprogram testAll()\nbegin\nend",
        );
        let db = marked.db();
        let found = marked.workspace.projects.iter().flat_map(|project| test_programs(db, *project));
        let lines: String = found.map(|test| format!("{}\n", shown(db, test.place))).collect();
        expect![[r#"
            mainTest/testAll.pgx:3 testAll
            mainTest/testSum.pgx:3 testSum
        "#]]
        .assert_eq(&lines);
    }
}
