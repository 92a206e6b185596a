//! Recognition of applications with tests.

use val3_lang::test_names::is_test_application;

use crate::db::{Db, Project};
use crate::items::project::folder;

/// Whether a project may use private items in its libraries: test applications may, because only `val3` executes tests.
#[must_use]
pub fn sees_private_items(db: &dyn Db, project: Project) -> bool {
    has_tests(db, project)
}

/// Whether the programs `test…` of a project are tests, by its name, folder or configuration.
pub fn has_tests(db: &dyn Db, project: Project) -> bool {
    let folder = folder(db, project);
    project.is_below_tests(db)
        || folder.file_name().is_some_and(is_test_application)
        || project.configuration(db).is_some_and(|configuration| configuration.file(db).lists_tests_in(folder))
}
