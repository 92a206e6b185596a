//! Programs with a mistake.

use std::sync::Arc;

use val3_files::FileClass;
use val3_syntax::encoding;

use super::original::Originals;
use super::sites::{Site, sites};

/// A program with a mistake that tests execute.
pub(super) struct Mutant {
    /// Its file.
    pub(super) file: String,
    /// The project file of its application or library.
    pub(super) project_file: String,
    pub(super) site: Site,
    /// The line with the place, without the blanks around it.
    pub(super) source: String,
    /// The numbers of the tests that execute the line.
    pub(super) tests: Vec<usize>,
    /// The text of the file without the mistake.
    text: Arc<str>,
}

impl Mutant {
    /// The text of the file with the mistake.
    pub(super) fn text(&self) -> Arc<str> {
        self.site.applied(&self.text).into()
    }
}

/// The mistakes in all lines that tests execute, by file and place.
pub(super) fn mutants(originals: &Originals<'_>) -> Vec<Mutant> {
    let mut found = Vec::new();
    for (file, program) in originals.coverage.programs() {
        // Only a test has written the others, in the memory of the controller.
        let Ok(bytes) = val3_files::read(file.into(), FileClass::Program) else { continue };
        let text: Arc<str> = encoding::decode(bytes).text.into();
        for site in sites(&text) {
            let tests = originals.tests.iter().enumerate().filter(|(_, test)| test.executes(file, site.line));
            let tests: Vec<usize> = tests.map(|(number, _)| number).collect();
            if tests.is_empty() {
                continue;
            }
            found.push(Mutant {
                file: file.to_owned(),
                project_file: program.project_file.clone(),
                source: site.source(&text),
                site,
                tests,
                text: Arc::clone(&text),
            });
        }
    }
    found
}
