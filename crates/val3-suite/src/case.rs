//! The tests of an application.

use val3_bytecode::{Image, Program};
use val3_lang::test_names::is_test;
use val3_session::Application;

use crate::table::{Table, table};

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
    /// The row of its table with which it is executed, from 0; none for a test without a table.
    pub row: Option<u32>,
    /// The path by which people know its application, if another one has the same name.
    pub application_path: Option<String>,
    /// The path by which people know a scenario, without its extension, if another one of the application has the same name.
    pub scenario_path: Option<String>,
    /// The columns of its table, in order; none for a test without a table.
    pub columns: Vec<String>,
    /// The reason why it cannot be executed.
    pub refusal: Option<String>,
}

impl TestCase {
    /// Its name among all tests: `application:program`, with the row of its table as `application:program[2]`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}:{}", self.application, self.title())
    }

    /// Its name among all tests for people, which no other test has: [`name`](Self::name), with paths instead of names that
    /// several applications or scenarios have.
    #[must_use]
    pub fn shown_name(&self) -> String {
        format!("{}:{}", self.shown_application(), self.shown_title())
    }

    /// The name of its application, or its path if another one has the same name.
    #[must_use]
    pub fn shown_application(&self) -> &str {
        self.application_path.as_deref().unwrap_or(&self.application)
    }

    /// Its name among the tests of its application for people.
    #[must_use]
    pub fn shown_title(&self) -> String {
        self.scenario_path.clone().unwrap_or_else(|| self.title())
    }

    /// The name that all rows of its table share: `application:program`.
    #[must_use]
    pub fn program_name(&self) -> String {
        format!("{}:{}", self.application, self.program)
    }

    /// Its name among the tests of its application.
    #[must_use]
    pub fn title(&self) -> String {
        self.row.map_or_else(|| self.program.clone(), |row| format!("{}[{row}]", self.program))
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
            row: None,
            application_path: None,
            scenario_path: None,
            columns: Vec::new(),
            refusal: None,
        }
    }
}

/// The tests of an application, by name; a test with a table once for each row.
#[must_use]
pub fn cases(application: &Application, image: &Image) -> Vec<TestCase> {
    let tests = image.programs.iter().filter(|program| is_test(&program.name));
    let mut found: Vec<TestCase> = tests.flat_map(|program| of(application, image, program)).collect();
    // The sort is stable: rows keep their order.
    found.sort_by(|one, other| one.program.cmp(&other.program));
    found
}

fn of(application: &Application, image: &Image, program: &Program) -> Vec<TestCase> {
    let case = TestCase {
        kind: TestKind::Program,
        application: image.name.clone(),
        program: program.name.clone(),
        file: image.files.get(program.file as usize).cloned().unwrap_or_default(),
        line: program.lines.first().map_or(1, |line| line.row),
        row: None,
        application_path: None,
        scenario_path: None,
        columns: Vec::new(),
        refusal: None,
    };
    match table(application, image, program) {
        Ok(None) => vec![case],
        Ok(Some(Table { rows, columns })) => {
            let row = |row| TestCase { row: Some(row), columns: columns.clone(), ..case.clone() };
            (0..rows).map(row).collect()
        }
        Err(refusal) => vec![TestCase { refusal: Some(refusal), ..case }],
    }
}
