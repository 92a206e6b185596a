//! Application test cases.

use val3_bytecode::{Image, Program};
use val3_lang::test_names::is_test;
use val3_session::Application;

use crate::table::{CaseTable, table};

/// Kind of a test.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TestKind {
    /// A program of a test application.
    Program,
    /// A file that runs a complete application and states expectations.
    Scenario,
}

/// A test: a program, or a scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestCase {
    /// Kind.
    pub kind: TestKind,
    /// Application name; for a scenario, the name of the application that it runs.
    pub application: String,
    /// Program name, or file name of a scenario without extension.
    pub program: String,
    /// File of the program or scenario.
    pub file: String,
    /// Line of the first statement, from 1.
    pub line: u32,
    /// Row of the table with which the test is executed, from 0; `None` without a table.
    pub row: Option<u32>,
    /// Displayed path of the application, if another application has the same name.
    pub application_path: Option<String>,
    /// Displayed path of the scenario without extension, if another scenario of the application has the same name.
    pub scenario_path: Option<String>,
    /// Columns of the table, in order; empty without a table.
    pub columns: Vec<String>,
    /// Reason why the test cannot be executed.
    pub refusal: Option<String>,
}

impl TestCase {
    /// Name among all tests: `application:program`, or `application:program[2]` for a table row.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}:{}", self.application, self.title())
    }

    /// Unique displayed name among all tests: [`name`](Self::name), with paths in place of names that several
    /// applications or scenarios share.
    #[must_use]
    pub fn shown_name(&self) -> String {
        format!("{}:{}", self.shown_application(), self.shown_title())
    }

    /// Displayed name of the application, or its path if another application has the same name.
    #[must_use]
    pub fn shown_application(&self) -> &str {
        self.application_path.as_deref().unwrap_or(&self.application)
    }

    /// Displayed name among the tests of the application.
    #[must_use]
    pub fn shown_title(&self) -> String {
        self.scenario_path.clone().unwrap_or_else(|| self.title())
    }

    /// Name shared by all rows of the table: `application:program`.
    #[must_use]
    pub fn program_name(&self) -> String {
        format!("{}:{}", self.application, self.program)
    }

    /// Name among the tests of the application.
    #[must_use]
    pub fn title(&self) -> String {
        self.row.map_or_else(|| self.program.clone(), |row| format!("{}[{row}]", self.program))
    }

    /// Creates the test case of a scenario file.
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

/// Returns an application's tests, sorted by name; a test with a table occurs once for each row.
#[must_use]
pub fn cases(application: &Application, image: &Image) -> Vec<TestCase> {
    let tests = image.programs.iter().filter(|program| is_test(&program.name));
    let mut found: Vec<TestCase> = tests.flat_map(|program| of(application, image, program)).collect();
    // A stable sort keeps the order of rows.
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
        Ok(Some(CaseTable { rows, columns })) => {
            let row = |row| TestCase { row: Some(row), columns: columns.clone(), ..case.clone() };
            (0..rows).map(row).collect()
        }
        Err(refusal) => vec![TestCase { refusal: Some(refusal), ..case }],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_contain_rows_and_distinguishing_paths() {
        let mut case = TestCase::scenario("pal", "day", "tests/day.toml");
        assert_eq!((case.name().as_str(), case.shown_name().as_str()), ("pal:day", "pal:day"));
        case.row = Some(2);
        assert_eq!((case.name().as_str(), case.program_name().as_str()), ("pal:day[2]", "pal:day"));
        assert_eq!(case.shown_name(), "pal:day[2]");
        (case.application_path, case.scenario_path) = (Some("a/pal".to_owned()), Some("tests/day".to_owned()));
        assert_eq!((case.name().as_str(), case.shown_name().as_str()), ("pal:day[2]", "a/pal:tests/day"));
    }
}
