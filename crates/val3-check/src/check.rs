//! The check: which pieces of work there are, and what is wrong in each.

use std::cell::OnceCell;
use std::iter::Sum;

use val3_analysis::db::{Db, File, FileStatus, Project};
use val3_analysis::items::faults::text_faults;
use val3_analysis::items::project;
use val3_analysis::problem::{FileRole, Problem, ProblemKind};
use val3_analysis::{data_check, header_check, infer, interfaces, project_check};
use val3_syntax::error::{SyntaxError, SyntaxErrorKind};

use crate::diagnostic::{Diagnostic, RelatedNote, Span};
use crate::echoes::without_echoes;
use crate::fix::Site;
use crate::lint::Program;
use crate::rule::{Rule, Severity};
use crate::rules::{word_problem, word_syntax};
use crate::settings::{Settings, WorkspaceSettings};
use crate::suppression::{self, Used};
use crate::{fix, keywords, lint, related};

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
    /// The application, library or type it belongs to.
    pub fn project(self) -> Project {
        match self {
            Self::Program(project, _) | Self::Data(project, _) | Self::Project(project) => project,
        }
    }

    fn is_excluded(self, db: &dyn Db) -> bool {
        let configuration = self.project().configuration(db);
        configuration.is_some_and(|configuration| {
            let file = configuration.file(db);
            // A project that is here in spite of its folder being excluded was asked for by its name.
            file.excludes(self.file(db).path(db)) && !file.excludes(self.project().manifest(db).path(db))
        })
    }

    /// The file that is looked at.
    pub fn file(self, db: &dyn Db) -> File {
        match self {
            Self::Program(_, file) | Self::Data(_, file) => file,
            Self::Project(project) => project.manifest(db),
        }
    }
}

/// The pieces of work of some projects, without excluded files, in the order of the projects' files.
pub fn units(db: &dyn Db, projects: &[Project]) -> Vec<Unit> {
    let of_project = |project: &Project| {
        let project = *project;
        let data = project::data_files(db, project).iter().map(move |file| Unit::Data(project, *file));
        let programs = project::program_files(db, project).iter().map(move |file| Unit::Program(project, *file));
        std::iter::once(Unit::Project(project)).chain(data.chain(programs).filter(|unit| !unit.is_excluded(db)))
    };
    let mut units: Vec<Unit> = projects.iter().flat_map(of_project).collect();
    // A file that is named twice is checked once.
    let mut seen = rustc_hash::FxHashSet::default();
    units.retain(|unit| seen.insert(*unit));
    units
}

/// What the check of one piece of work gives.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Checked {
    /// Everything that is wrong and wanted, by position.
    pub findings: Vec<Diagnostic>,
    /// How many findings comments silence.
    pub silenced: usize,
    /// The comments that did.
    pub(crate) used: Used,
}

impl Sum for Checked {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.fold(Self::default(), |mut sum, part| {
            sum.findings.extend(part.findings);
            sum.silenced += part.silenced;
            sum.used.extend(part.used);
            sum
        })
    }
}

/// What is wrong in a piece of work whatever the other programs of its application do.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Alone {
    found: Vec<Diagnostic>,
    /// There are faults, asked for or not: what a lint would say beside one is most often its echo.
    faulty: bool,
}

/// Checks one piece of work.
pub fn check_unit(db: &dyn Db, unit: Unit, settings: &WorkspaceSettings) -> Checked {
    let mut check = Check::new(db, unit, settings, Alone::default());
    check.alone();
    check.as_member();
    check.finish()
}

/// The first part of [`check_unit`]: it looks at no other program, so that an edit elsewhere seldom concerns it.
pub fn check_alone(db: &dyn Db, unit: Unit, settings: &WorkspaceSettings) -> Alone {
    let mut check = Check::new(db, unit, settings, Alone::default());
    check.alone();
    check.so_far
}

/// The second part of [`check_unit`]: what shows when the whole application is in view.
pub fn check_member(db: &dyn Db, unit: Unit, settings: &WorkspaceSettings, alone: Alone) -> Checked {
    let mut check = Check::new(db, unit, settings, alone);
    check.as_member();
    check.finish()
}

/// What only the whole shows, after every unit was checked: comments that silenced nothing; and an add-on that is
/// missing is one finding an application, however often it is used.
pub fn finish(db: &dyn Db, units: &[Unit], settings: &WorkspaceSettings, mut checked: Checked) -> Checked {
    for unit in units {
        if let Unit::Program(project, file) = *unit {
            let settings = settings.of(db, project);
            let idle = suppression::unused(db, project, file, settings, &checked.used);
            checked.findings.extend(idle.into_iter().filter_map(|found| settings.judged(found)));
        }
    }
    let mut seen = rustc_hash::FxHashSet::default();
    checked.findings.retain(|diagnostic| {
        !is_said_once(diagnostic.rule) || seen.insert((diagnostic.application, diagnostic.message.clone()))
    });
    checked
}

/// One finding of this rule is enough for an application, so that the place where it stands means little.
pub fn is_said_once(rule: &Rule) -> bool {
    rule.code == MISSING_ADD_ON
}

struct Check<'db> {
    db: &'db dyn Db,
    unit: Unit,
    settings: &'db Settings,
    so_far: Alone,
    /// The program as lints see it, once they look.
    program: OnceCell<Program<'db>>,
}

impl<'db> Check<'db> {
    fn new(db: &'db dyn Db, unit: Unit, settings: &'db WorkspaceSettings, so_far: Alone) -> Self {
        Self { db, unit, settings: settings.of(db, unit.project()), so_far, program: OnceCell::new() }
    }

    fn finish(self) -> Checked {
        let mut found = self.so_far.found;
        found.sort_by_key(|diagnostic| (diagnostic.place.range.start(), diagnostic.rule.code));
        suppression::apply(self.db, found)
    }

    fn alone(&mut self) {
        let db = self.db;
        match self.unit {
            Unit::Program(project, file) => {
                let broken = self.text(file);
                self.problems(file, header_check::problems(db, project, file));
                if !broken {
                    self.problems(file, infer::problems(db, project, file));
                    self.add_all(keywords::spelling(db, project, file));
                    self.add_all(suppression::unknown(db, project, file));
                }
                if !self.so_far.faulty {
                    self.add_lints(lint::program(self.program(project, file), self.settings));
                }
            }
            Unit::Data(project, file) => {
                self.text(file);
                self.problems(file, data_check::problems(db, project, file));
            }
            Unit::Project(project) => {
                let file = project.manifest(db);
                self.text(file);
                self.problems(file, project_check::problems(db, project));
                self.problems(file, interfaces::problems(db, project));
            }
        }
    }

    fn as_member(&mut self) {
        if !self.so_far.faulty {
            self.add_lints(match self.unit {
                Unit::Program(project, file) => lint::member(self.program(project, file), self.settings),
                Unit::Data(project, file) => lint::data(self.db, project, file, self.settings),
                Unit::Project(project) => lint::project(self.db, project, self.settings),
            });
        }
    }

    fn program(&self, project: Project, file: File) -> &Program<'db> {
        self.program.get_or_init(|| Program::new(self.db, project, file, &self.settings.options))
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
                self.add(self.of_syntax(file, error));
            }
        }
        errors.iter().any(|error| error.kind == SyntaxErrorKind::ConflictMarker)
    }

    fn add_all(&mut self, diagnostics: Vec<Diagnostic>) {
        diagnostics.into_iter().for_each(|diagnostic| self.add(diagnostic));
    }

    fn add_lints(&mut self, diagnostics: Vec<Diagnostic>) {
        let settings = self.settings;
        self.so_far.found.extend(diagnostics.into_iter().filter_map(|diagnostic| settings.judged(diagnostic)));
    }

    fn add(&mut self, diagnostic: Diagnostic) {
        self.so_far.faulty |= diagnostic.severity == Severity::Error;
        self.so_far.found.extend(self.settings.judged(diagnostic));
    }

    fn of_syntax(&self, file: File, error: &SyntaxError) -> Diagnostic {
        let (rule, wording) = word_syntax(&error.kind);
        let related = error
            .related
            .map(|range| RelatedNote { place: Span { file, range }, message: related::other_side(&error.kind) });
        let site = Site::new(self.db, file, error.range, error.related);
        let diagnostic =
            self.diagnostic(rule, wording, Span { file, range: error.range }, related.into_iter().collect());
        Diagnostic { fix: fix::of_syntax(&error.kind, &site), ..diagnostic }
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
            diagnostic.severity = self.doubt(&problem.kind).unwrap_or(diagnostic.severity);
            diagnostic.fix = fix::of_problem(&problem.kind, &Site::new(self.db, place.file, place.range, None));
            self.add(diagnostic);
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

    /// The level of a fault that may lie in what is at hand: a controller can have add-ons and libraries that a
    /// repository lacks.
    fn doubt(&self, kind: &ProblemKind) -> Option<Severity> {
        let project = self.unit.project();
        let (is_uncertain, severity) = match kind {
            // Hardly a repository holds the tables, so that their absence says nothing.
            ProblemKind::MissingAddOn { .. } => {
                let lists_none = project.cell(self.db).is_none_or(|cell| cell.config(self.db).add_ons.is_empty());
                (lists_none, Severity::Info)
            }
            ProblemKind::FileMissing { what: FileRole::Library | FileRole::Type, .. } => {
                (!self.is_in_usrapp(project), Severity::Warning)
            }
            // No public document lists every instruction of s8; what resembles a known one is still a slip.
            ProblemKind::UnknownInstruction { near: None, is: None, .. } => {
                (project::items(self.db, project).version.major >= 8, Severity::Warning)
            }
            _ => return None,
        };
        is_uncertain.then_some(severity)
    }

    fn is_in_usrapp(&self, project: Project) -> bool {
        let configured = project.config(self.db).is_some_and(|config| config.disk.is_some());
        let disk = project.disk(self.db).and_then(|disk| disk.file_name());
        configured || disk.is_some_and(|name| name.eq_ignore_ascii_case("usrapp"))
    }

    fn owner(&self, file: File) -> (Project, Option<String>) {
        let program = match self.unit {
            Unit::Program(_, own) if own == file => {
                Some(val3_analysis::items::program::header(self.db, file).name.to_string())
            }
            _ => None,
        };
        (self.unit.project(), program)
    }
}
