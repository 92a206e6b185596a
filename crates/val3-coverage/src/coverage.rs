//! The coverage of programs, added up over controllers.

use std::collections::BTreeMap;

use crate::program::ProgramCoverage;
use crate::share::Share;

/// The coverage of programs by the paths of their files, thus independent of the order in which they were executed.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Coverage {
    programs: BTreeMap<String, ProgramCoverage>,
}

impl Coverage {
    /// Adds counts of the program in a file.
    pub fn add(&mut self, file: String, program: ProgramCoverage) {
        match self.programs.get_mut(&file) {
            Some(known) => known.add(program),
            None => drop(self.programs.insert(file, program)),
        }
    }

    /// Adds the counts of other controllers.
    pub fn merge(&mut self, other: Self) {
        other.programs.into_iter().for_each(|(file, program)| self.add(file, program));
    }

    /// The same coverage with each file as readers know it: `shown` gives its path and its code; `None` leaves it out.
    #[must_use]
    pub fn shown(self, shown: impl Fn(&str) -> Option<(String, Vec<(u32, String)>)>) -> Self {
        let mut coverage = Self::default();
        for (file, program) in self.programs {
            if let Some((path, source)) = shown(&file) {
                coverage.add(path, ProgramCoverage { source, ..program });
            }
        }
        coverage
    }

    /// The files with their programs, by path.
    pub fn programs(&self) -> impl Iterator<Item = (&str, &ProgramCoverage)> {
        self.programs.iter().map(|(file, program)| (file.as_str(), program))
    }

    /// The programs of each application and library: those in one folder.
    #[must_use]
    pub fn projects(&self) -> Vec<Vec<(&str, &ProgramCoverage)>> {
        let mut projects: BTreeMap<&str, Vec<(&str, &ProgramCoverage)>> = BTreeMap::new();
        for (file, program) in self.programs() {
            projects.entry(folder(file)).or_default().push((file, program));
        }
        projects.into_values().collect()
    }

    /// The executed lines of all programs.
    #[must_use]
    pub fn line_share(&self) -> Share {
        self.programs.values().map(ProgramCoverage::line_share).sum()
    }

    /// The taken sides of the branches of all programs.
    #[must_use]
    pub fn branch_share(&self) -> Share {
        self.programs.values().map(ProgramCoverage::branch_share).sum()
    }
}

fn folder(file: &str) -> &str {
    file.rfind('/').and_then(|at| file.get(..at)).unwrap_or_default()
}
