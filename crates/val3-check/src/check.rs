//! The check: which pieces of work there are, and what is wrong in each.

use val3_analysis::db::{Db, File, FileStatus, Project};
use val3_analysis::items::faults::text_faults;
use val3_analysis::items::project;
use val3_analysis::problem::{FileRole, Problem, ProblemKind};
use val3_analysis::{data_check, header_check, infer, interfaces, project_check};
use val3_syntax::error::{SyntaxError, SyntaxErrorKind};

use crate::diagnostic::{Diagnostic, RelatedNote, Span};
use crate::echoes::without_echoes;
use crate::options::Asked;
use crate::rule::{Rule, Severity};
use crate::rules::{word_problem, word_syntax};
use crate::{keywords, lint, related};

/// The rule of which one finding an application is enough.
const MISSING_ADD_ON: &str = "V0104";

/// A piece of work that needs no other: pieces may be checked side by side, each on its own clone of the database.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Unit {
    /// A `.pgx`: header and code.
    Program(Project, File),
    /// A `.dtx`.
    Data(Project, File),
    /// A `.pjx` with its libraries.
    Project(Project),
}

impl Unit {
    /// The file that is looked at.
    pub fn file(self, db: &dyn Db) -> File {
        match self {
            Self::Program(_, file) | Self::Data(_, file) => file,
            Self::Project(project) => project.manifest(db),
        }
    }
}

/// The pieces of work of some projects, in the order of the projects' files.
pub fn units(db: &dyn Db, projects: &[Project]) -> Vec<Unit> {
    let of_project = |project: &Project| {
        let project = *project;
        let data = project::data_files(db, project).iter().map(move |file| Unit::Data(project, *file));
        let programs = project::program_files(db, project).iter().map(move |file| Unit::Program(project, *file));
        std::iter::once(Unit::Project(project)).chain(data).chain(programs)
    };
    let mut units: Vec<Unit> = projects.iter().flat_map(of_project).collect();
    // A file that is named twice is checked once.
    let mut seen = rustc_hash::FxHashSet::default();
    units.retain(|unit| seen.insert(*unit));
    units
}

/// Everything that is wrong in one piece of work, by position.
pub fn check_unit(db: &dyn Db, unit: Unit) -> Vec<Diagnostic> {
    check_unit_with(db, unit, Asked::default())
}

/// As [`check_unit`], with other settings and with rules that are off by default.
pub fn check_unit_with(db: &dyn Db, unit: Unit, asked: Asked<'_>) -> Vec<Diagnostic> {
    let mut check = Check { db, unit, asked, found: Vec::new() };
    check.run();
    check.found.sort_by_key(|diagnostic| (diagnostic.place.range.start(), diagnostic.rule.code));
    check.found
}

/// What only the whole shows: an add-on that is missing is one finding an application, however often it is used.
pub fn finish(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut seen = rustc_hash::FxHashSet::default();
    diagnostics.retain(|diagnostic| {
        diagnostic.rule.code != MISSING_ADD_ON || seen.insert((diagnostic.application, diagnostic.message.clone()))
    });
    diagnostics
}

struct Check<'db> {
    db: &'db dyn Db,
    unit: Unit,
    asked: Asked<'db>,
    found: Vec<Diagnostic>,
}

impl Check<'_> {
    fn run(&mut self) {
        let db = self.db;
        match self.unit {
            Unit::Program(project, file) => {
                let broken = self.text(file);
                self.problems(file, header_check::problems(db, project, file));
                if !broken {
                    self.problems(file, infer::problems(db, project, file));
                    self.found.extend(keywords::spelling(db, project, file));
                }
                if self.is_sound() {
                    self.found.extend(lint::program(db, project, file, self.asked));
                }
            }
            Unit::Data(project, file) => {
                self.text(file);
                self.problems(file, data_check::problems(db, project, file));
                if self.is_sound() {
                    self.found.extend(lint::data(db, project, file, self.asked));
                }
            }
            Unit::Project(project) => {
                let file = project.manifest(db);
                self.text(file);
                self.problems(file, project_check::problems(db, project));
                self.problems(file, interfaces::problems(db, project));
                if self.is_sound() {
                    self.found.extend(lint::project(db, project, self.asked));
                }
            }
        }
    }

    /// No error so far: what the lints would say beside one is most often its echo.
    fn is_sound(&self) -> bool {
        self.found.iter().all(|diagnostic| diagnostic.severity < Severity::Error)
    }

    /// The faults of a file's text; true if the rest of it cannot be judged.
    fn text(&mut self, file: File) -> bool {
        if matches!(file.status(self.db), FileStatus::Unreadable(_)) {
            return true;
        }
        let errors = &text_faults(self.db, file).errors;
        let mut too_deep = false;
        for error in errors {
            // What nests too deep does so in many places; one of them is enough to find it.
            let again = error.kind == SyntaxErrorKind::NestingTooDeep && std::mem::replace(&mut too_deep, true);
            if !again {
                self.found.push(self.of_syntax(file, error));
            }
        }
        errors.iter().any(|error| error.kind == SyntaxErrorKind::ConflictMarker)
    }

    fn of_syntax(&self, file: File, error: &SyntaxError) -> Diagnostic {
        let (rule, wording) = word_syntax(&error.kind);
        let related = error
            .related
            .map(|range| RelatedNote { place: Span { file, range }, message: related::other_side(&error.kind) });
        self.diagnostic(rule, wording, Span { file, range: error.range }, related.into_iter().collect())
    }

    fn problems(&mut self, file: File, problems: &[Problem]) {
        for problem in without_echoes(self.db, file, problems) {
            let (rule, wording) = word_problem(&problem.kind);
            let related = problem.related.iter().map(|other| RelatedNote {
                place: Span { file: other.place.file, range: other.place.range },
                message: related::role(other.role),
            });
            let place = Span { file: problem.place.file, range: problem.place.range };
            let mut diagnostic = self.diagnostic(rule, wording, place, related.collect());
            if self.is_uncertain(&problem.kind) {
                diagnostic.severity = Severity::Warning;
            }
            self.found.push(diagnostic);
        }
    }

    fn diagnostic(
        &self,
        rule: &'static Rule,
        wording: crate::diagnostic::Wording,
        place: Span,
        related: Vec<RelatedNote>,
    ) -> Diagnostic {
        let (project, program) = self.owner(place.file);
        Diagnostic {
            rule,
            severity: rule.severity,
            message: wording.message,
            place,
            label: wording.label,
            related,
            help: wording.help,
            program,
            application: Some(project.manifest(self.db)),
            fix: None,
        }
    }

    /// The fault may lie in what is at hand: a controller can have add-ons and libraries that a repository lacks.
    fn is_uncertain(&self, kind: &ProblemKind) -> bool {
        let project = self.owner_project();
        match kind {
            ProblemKind::MissingAddOn { .. } => {
                project.cell(self.db).is_none_or(|cell| cell.config(self.db).add_ons.is_empty())
            }
            ProblemKind::FileMissing { what: FileRole::Library | FileRole::Type, .. } => !self.is_in_usrapp(project),
            // No public document lists every instruction of s8; what resembles a known one is still a slip.
            ProblemKind::UnknownInstruction { near: None, is: None, .. } => {
                project::items(self.db, project).version.major >= 8
            }
            _ => false,
        }
    }

    fn is_in_usrapp(&self, project: Project) -> bool {
        let disk = project.disk(self.db).as_ref().and_then(|disk| disk.file_name());
        disk.is_some_and(|name| name.eq_ignore_ascii_case("usrapp"))
    }

    fn owner_project(&self) -> Project {
        match self.unit {
            Unit::Program(project, _) | Unit::Data(project, _) | Unit::Project(project) => project,
        }
    }

    fn owner(&self, file: File) -> (Project, Option<String>) {
        let program = match self.unit {
            Unit::Program(_, own) if own == file => {
                Some(val3_analysis::items::program::header(self.db, file).name.to_string())
            }
            _ => None,
        };
        (self.owner_project(), program)
    }
}
