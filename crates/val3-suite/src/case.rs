//! The tests of an application.

use val3_bytecode::{Image, Program};
use val3_lang::test_names::is_test;

/// A program that is a test.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestCase {
    /// The name of its application.
    pub application: String,
    /// The name of the program.
    pub program: String,
    /// The file of the program.
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
}

/// The tests of an application, by name.
#[must_use]
pub fn cases(image: &Image) -> Vec<TestCase> {
    let mut found: Vec<TestCase> =
        image.programs.iter().filter(|program| is_test(&program.name)).map(|program| of(image, program)).collect();
    found.sort_by(|one, other| one.program.cmp(&other.program));
    found
}

fn of(image: &Image, program: &Program) -> TestCase {
    TestCase {
        application: image.name.clone(),
        program: program.name.clone(),
        file: image.files.get(program.file as usize).cloned().unwrap_or_default(),
        line: program.lines.first().map_or(1, |line| line.row),
        has_parameters: !program.params.is_empty(),
    }
}
