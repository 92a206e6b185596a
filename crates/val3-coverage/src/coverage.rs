//! Coverage of programs, summed over controllers.

use std::collections::BTreeMap;

use crate::program::ProgramCoverage;
use crate::share::Share;

/// Coverage by file path, independent of the execution order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Coverage {
    programs: BTreeMap<String, ProgramCoverage>,
}

/// The programs in an application or library.
#[derive(Debug, Clone, PartialEq)]
pub struct ProjectCoverage<'c> {
    /// Name; with the folder if several applications or libraries have the same name.
    pub name: String,
    /// Files with their programs, sorted by path.
    pub programs: Vec<(&'c str, &'c ProgramCoverage)>,
}

impl ProjectCoverage<'_> {
    /// Returns the share of executed lines.
    #[must_use]
    pub fn line_share(&self) -> Share {
        self.programs.iter().map(|(_, program)| program.line_share()).sum()
    }

    /// Returns the share of taken branch sides.
    #[must_use]
    pub fn branch_share(&self) -> Share {
        self.programs.iter().map(|(_, program)| program.branch_share()).sum()
    }
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

    /// Returns the coverage with displayed paths and code: `shown` returns the path and code of a file, or `None` to
    /// omit the file, and `path` returns the path of a project file.
    #[must_use]
    pub fn shown(
        self,
        shown: impl Fn(&str) -> Option<(String, Vec<(u32, String)>)>,
        path: impl Fn(&str) -> String,
    ) -> Self {
        let mut coverage = Self::default();
        for (file, program) in self.programs {
            if let Some((shown_path, source)) = shown(&file) {
                let project_file = path(&program.project_file);
                coverage.add(shown_path, ProgramCoverage { source, project_file, ..program });
            }
        }
        coverage
    }

    /// Returns the files with their programs, sorted by path.
    pub fn programs(&self) -> impl Iterator<Item = (&str, &ProgramCoverage)> {
        self.programs.iter().map(|(file, program)| (file.as_str(), program))
    }

    /// Returns the programs by application and library, sorted by project file.
    #[must_use]
    pub fn projects(&self) -> Vec<ProjectCoverage<'_>> {
        let mut projects: BTreeMap<(&str, &str), Vec<(&str, &ProgramCoverage)>> = BTreeMap::new();
        for (file, program) in self.programs() {
            projects.entry((&program.project_file, &program.project)).or_default().push((file, program));
        }
        let names: Vec<&str> = projects.keys().map(|(_, name)| *name).collect();
        let named: Vec<String> = projects.keys().map(|(file, name)| unique_name(file, name, &names)).collect();
        named
            .into_iter()
            .zip(projects.into_values())
            .map(|(name, programs)| ProjectCoverage { name, programs })
            .collect()
    }

    /// Returns the share of executed lines in all programs.
    #[must_use]
    pub fn line_share(&self) -> Share {
        self.programs.values().map(ProgramCoverage::line_share).sum()
    }

    /// Returns the share of taken branch sides in all programs.
    #[must_use]
    pub fn branch_share(&self) -> Share {
        self.programs.values().map(ProgramCoverage::branch_share).sum()
    }
}

/// Returns the project name; with the project file's folder if the name occurs more than once in `names`.
fn unique_name(file: &str, name: &str, names: &[&str]) -> String {
    match names.iter().filter(|known| **known == name).count() {
        1 => name.to_owned(),
        _ => format!("{name} ({})", folder(file)),
    }
}

fn folder(file: &str) -> &str {
    file.rfind('/').and_then(|at| file.get(..at)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coverage(programs: &[(&str, &str, &str)]) -> Coverage {
        let mut coverage = Coverage::default();
        for (file, project_file, project) in programs {
            let program = ProgramCoverage {
                project: (*project).to_owned(),
                project_file: (*project_file).to_owned(),
                ..ProgramCoverage::default()
            };
            coverage.add((*file).to_owned(), program);
        }
        coverage
    }

    fn groups(coverage: &Coverage) -> Vec<(String, usize)> {
        coverage.projects().into_iter().map(|project| (project.name, project.programs.len())).collect()
    }

    #[test]
    fn programs_in_folders_belong_to_their_project() {
        let one = coverage(&[("a/motion/go.pgx", "a/a.pjx", "a"), ("a/start.pgx", "a/a.pjx", "a")]);
        assert_eq!(groups(&one), [("a".to_owned(), 2)]);
    }

    #[test]
    fn projects_of_one_name_have_their_folders() {
        let two = coverage(&[("one/a/start.pgx", "one/a/a.pjx", "a"), ("two/a/start.pgx", "two/a/a.pjx", "a")]);
        assert_eq!(groups(&two), [("a (one/a)".to_owned(), 1), ("a (two/a)".to_owned(), 1)]);
    }
}
