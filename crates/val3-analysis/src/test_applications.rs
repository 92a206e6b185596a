//! The applications that have tests.

use camino::Utf8Component;
use val3_lang::test_names::is_test_application;

use crate::db::{Db, Project};
use crate::items::project::folder;

/// Whether the programs `test…` of a project are tests.
pub fn has_tests(db: &dyn Db, project: Project) -> bool {
    let name = |component| match component {
        Utf8Component::Normal(name) => Some(name),
        _ => None,
    };
    is_test_application(folder(db, project).components().filter_map(name))
}
