//! The tests of an application.

use val3_bytecode::{Image, Program};

/// The beginning of the names of tests.
const TEST: &str = "test";

/// A kind of tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TestKind {
    /// A program of a test application.
    Program,
    /// A file that runs a whole application and says what it expects.
    Scenario,
}

/// A test: a program, or a scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestCase {
    /// Its kind.
    pub kind: TestKind,
    /// The name of its application; of a scenario, of the application that it runs.
    pub application: String,
    /// The name of the program, or that of the file of a scenario without its extension.
    pub program: String,
    /// The file of the program or of the scenario.
    pub file: String,
    /// The line of its first statement, from 1.
    pub line: u32,
    /// Whether it has parameters, with which it cannot be executed.
    pub has_parameters: bool,
}

impl TestCase {
    /// Its name among all tests.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}:{}", self.application, self.program)
    }

    /// The scenario called `name` in `file`, which runs an application.
    #[must_use]
    pub fn scenario(application: &str, name: &str, file: &str) -> Self {
        Self {
            kind: TestKind::Scenario,
            application: application.to_owned(),
            program: name.to_owned(),
            file: file.to_owned(),
            line: 1,
            has_parameters: false,
        }
    }
}

/// Whether an application has tests: `folders` are the names of the folders that lead to it, its own last.
pub fn is_test_application<'n>(folders: impl IntoIterator<Item = &'n str>) -> bool {
    let folders: Vec<&str> = folders.into_iter().collect();
    let [above @ .., name] = folders.as_slice() else { return false };
    name.ends_with("Test") || above.contains(&"tests")
}

/// The tests of an application, by name.
#[must_use]
pub fn cases(image: &Image) -> Vec<TestCase> {
    let mut found: Vec<TestCase> = image
        .programs
        .iter()
        .filter(|program| program.name.starts_with(TEST))
        .map(|program| of(image, program))
        .collect();
    found.sort_by(|one, other| one.program.cmp(&other.program));
    found
}

fn of(image: &Image, program: &Program) -> TestCase {
    TestCase {
        kind: TestKind::Program,
        application: image.name.clone(),
        program: program.name.clone(),
        file: image.files.get(program.file as usize).cloned().unwrap_or_default(),
        line: program.lines.first().map_or(1, |line| line.row),
        has_parameters: !program.params.is_empty(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn test_applications_have_a_name_or_a_folder() {
        for (path, expected) in [
            ("cell/usr/usrapp/palletiserTest", true),
            ("cell/tests/palletiser", true),
            ("cell/usr/usrapp/palletiser", false),
            ("cell/usr/usrapp/tests", false),
            ("cell/usr/usrapp/Testing", false),
            ("", false),
        ] {
            assert_eq!(is_test_application(path.split('/')), expected, "{path}");
        }
    }
}
