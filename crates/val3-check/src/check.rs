//! The check: its units of work and their findings.

use std::cell::OnceCell;
use std::iter::Sum;

use smol_str::SmolStr;
use val3_analysis::db::{Db, File, FileRange, FileStatus, Project};
use val3_analysis::items::faults::text_faults;
use val3_analysis::items::project;
use val3_analysis::problem::{FileRole, Problem, ProblemKind};
use val3_analysis::{data_check, header_check, infer, interfaces, pages, project_check};
use val3_lang::foreign_names;
use val3_syntax::error::{SyntaxError, SyntaxErrorKind};
use val3_syntax::{TextSize, TextSlice};

use crate::cascades::without_cascades;
use crate::diagnostic::{Diagnostic, MOST_RELATED, RelatedNote};
use crate::fix::Site;
use crate::lint::ProgramView;
use crate::rule::{Rule, Severity};
use crate::rules::{word_problem, word_syntax};
use crate::settings::{Settings, WorkspaceSettings};
use crate::shared_causes::join_causes;
use crate::suppression::{self, UsedComments};
use crate::{fix, habits, keywords, lint, related};

/// A rule that reports one finding per application.
const MISSING_ADD_ON: &str = "V0104";

/// A unit of work. Units are independent, so they may be checked in parallel, each on its own clone of the database.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CheckUnit {
    /// A `.pgx`: header and code.
    Program(Project, File),
    /// A `.dtx`.
    Data(Project, File),
    /// A `.pjx` with its libraries.
    Project(Project),
}

impl CheckUnit {
    /// Application, library or type of the unit.
    pub fn project(self) -> Project {
        match self {
            Self::Program(project, _) | Self::Data(project, _) | Self::Project(project) => project,
        }
    }

    fn is_excluded(self, db: &dyn Db) -> bool {
        let configuration = self.project().configuration(db);
        configuration.is_some_and(|configuration| {
            let file = configuration.file(db);
            // A project in an excluded folder is only loaded if the user has named it.
            file.excludes(self.file(db).path(db)) && !file.excludes(self.project().manifest(db).path(db))
        })
    }

    /// The checked file.
    pub fn file(self, db: &dyn Db) -> File {
        match self {
            Self::Program(_, file) | Self::Data(_, file) => file,
            Self::Project(project) => project.manifest(db),
        }
    }
}

/// The units of some projects, without excluded files, in the order of the projects' files.
pub fn units(db: &dyn Db, projects: &[Project]) -> Vec<CheckUnit> {
    let mut units = all_units(db, projects);
    units.retain(|unit| matches!(unit, CheckUnit::Project(_)) || !unit.is_excluded(db));
    units
}

/// The units of some projects, with excluded files.
fn all_units(db: &dyn Db, projects: &[Project]) -> Vec<CheckUnit> {
    let mut units = Vec::new();
    for project in projects {
        units.push(CheckUnit::Project(*project));
        units.extend(project::data_files(db, *project).iter().map(|file| CheckUnit::Data(*project, *file)));
        units.extend(project::program_files(db, *project).iter().map(|file| CheckUnit::Program(*project, *file)));
    }
    // A file that is listed twice is checked once.
    let mut seen = rustc_hash::FxHashSet::default();
    units.retain(|unit| seen.insert(*unit));
    units
}

/// Findings with which the controller's compiler rejects a project, at the rules' default levels and in file order.
///
/// The language determines them ([`ProblemKind::is_refused`]). Settings, excluded files and suppression comments have
/// no influence.
pub fn refusals(db: &dyn Db, project: Project) -> Vec<Diagnostic> {
    all_units(db, &[project]).into_iter().flat_map(|unit| unit_refusals(db, unit)).collect()
}

/// Findings with which the controller's compiler rejects a unit, which need not be listed in the project.
pub fn unit_refusals(db: &dyn Db, unit: CheckUnit) -> Vec<Diagnostic> {
    let settings = WorkspaceSettings::default();
    let mut refusals = Vec::new();
    Check::new(db, unit, &settings).each_fault(&mut |fault| refusals.extend(fault.refusal()));
    refusals
}

/// Items that `library` would have to contain to be loaded under the identifier `alias` of a project, in place of the
/// library that the identifier names.
pub fn stand_in_faults(db: &dyn Db, project: Project, alias: &SmolStr, library: Project) -> Vec<Diagnostic> {
    let (unit, settings) = (CheckUnit::Project(project), WorkspaceSettings::default());
    let problems = interfaces::stand_in_problems(db, project, alias, library);
    let mut faults = Vec::new();
    let check = Check::new(db, unit, &settings);
    check.problems(unit.file(db), &problems, &mut |fault| faults.push(fault.diagnostic));
    faults
}

/// Result of a unit's check.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Checked {
    /// The reported findings, sorted by position.
    pub findings: Vec<Diagnostic>,
    /// Number of silenced findings.
    pub silenced: usize,
    /// Comments that silenced them.
    pub(crate) used: UsedComments,
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

/// A unit's faults that are found without lints: in the text, the declarations and the types.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct UnitFaults {
    found: Vec<Diagnostic>,
    /// Whether the unit has faults, reported or not. In this case lints do not run, because most of their findings
    /// would be consequences.
    any: bool,
}

/// Checks one unit.
pub fn check_unit(db: &dyn Db, unit: CheckUnit, settings: &WorkspaceSettings) -> Checked {
    let check = Check::new(db, unit, settings);
    let faults = check.faults();
    let (alone, member) = (check.alone(&faults), check.member(&faults));
    merge_findings(db, faults, alone, member)
}

/// First stage of [`check_unit`], required by the other stages.
pub fn check_faults(db: &dyn Db, unit: CheckUnit, settings: &WorkspaceSettings) -> UnitFaults {
    Check::new(db, unit, settings).faults()
}

/// Second stage of [`check_unit`]. It reads no other program, so an edit elsewhere rarely affects it.
pub fn check_local(db: &dyn Db, unit: CheckUnit, settings: &WorkspaceSettings, faults: &UnitFaults) -> Vec<Diagnostic> {
    Check::new(db, unit, settings).alone(faults)
}

/// Third stage of [`check_unit`]: lints that read the entire application.
pub fn check_in_application(
    db: &dyn Db,
    unit: CheckUnit,
    settings: &WorkspaceSettings,
    faults: &UnitFaults,
) -> Vec<Diagnostic> {
    Check::new(db, unit, settings).member(faults)
}

/// Last stage of [`check_unit`]: merges the findings of the other stages.
pub fn merge_findings(db: &dyn Db, faults: UnitFaults, alone: Vec<Diagnostic>, member: Vec<Diagnostic>) -> Checked {
    let mut found = faults.found;
    found.extend(alone);
    found.extend(member);
    found.sort_by_key(|diagnostic| (diagnostic.place.range.start(), diagnostic.rule.code));
    suppression::apply(db, found)
}

/// Completes a check after all its units: [`finish_each`], and then merges findings whose cause several applications
/// share.
pub fn finish(db: &dyn Db, units: &[CheckUnit], settings: &WorkspaceSettings, checked: Checked) -> Checked {
    let mut checked = finish_each(db, units, settings, checked);
    checked.findings = join_causes(db, checked.findings);
    checked
}

/// Completes each application's check: adds unused suppression comments, and keeps one finding for each missing
/// add-on.
pub fn finish_each(db: &dyn Db, units: &[CheckUnit], settings: &WorkspaceSettings, mut checked: Checked) -> Checked {
    for unit in units {
        if let CheckUnit::Program(project, file) = *unit {
            let settings = settings.of(db, project);
            let idle = suppression::unused(db, project, file, settings, &checked.used);
            checked.findings.extend(idle.into_iter().filter_map(|found| settings.with_level(found)));
        }
    }
    let mut seen = rustc_hash::FxHashSet::default();
    checked.findings.retain(|diagnostic| {
        !is_once_per_application(diagnostic.rule) || seen.insert((diagnostic.application, diagnostic.message.clone()))
    });
    checked
}

/// Whether the rule reports one finding per application, so that the location of the finding is not significant.
pub fn is_once_per_application(rule: &Rule) -> bool {
    rule.code == MISSING_ADD_ON
}

/// A fault of a text, a declaration or a type.
struct DetectedFault {
    diagnostic: Diagnostic,
    /// Whether the controller's compiler rejects it.
    is_refused: bool,
    /// Whether lints would report its consequences, so that they do not run.
    stops_lints: bool,
}

impl DetectedFault {
    fn advice(diagnostic: Diagnostic) -> Self {
        Self { diagnostic, is_refused: false, stops_lints: false }
    }

    fn refusal(self) -> Option<Diagnostic> {
        self.is_refused.then_some(self.diagnostic)
    }
}

impl UnitFaults {
    fn add(&mut self, fault: DetectedFault, settings: &Settings) {
        self.any |= fault.stops_lints && fault.diagnostic.severity == Severity::Error;
        self.found.extend(settings.with_level(fault.diagnostic));
    }
}

struct Check<'db> {
    db: &'db dyn Db,
    unit: CheckUnit,
    settings: &'db Settings,
    /// View of the program for lints, created on demand.
    program: OnceCell<ProgramView<'db>>,
}

impl<'db> Check<'db> {
    fn new(db: &'db dyn Db, unit: CheckUnit, settings: &'db WorkspaceSettings) -> Self {
        Self { db, unit, settings: settings.of(db, unit.project()), program: OnceCell::new() }
    }

    fn faults(&self) -> UnitFaults {
        let mut faults = UnitFaults::default();
        self.each_fault(&mut |fault| faults.add(fault, self.settings));
        faults
    }

    fn each_fault(&self, take: &mut dyn FnMut(DetectedFault)) {
        let db = self.db;
        match self.unit {
            CheckUnit::Program(project, file) => {
                let broken = self.text(file, take);
                self.problems(file, header_check::problems(db, project, file), take);
                if !broken {
                    self.problems(file, infer::problems(db, project, file), take);
                    let advice = [keywords::spelling(db, project, file), suppression::unknown(db, project, file)];
                    let versions = lint::versions(self.program(project, file), self.settings);
                    let advice = advice.into_iter().flatten().chain(versions);
                    advice.map(DetectedFault::advice).for_each(take);
                }
            }
            CheckUnit::Data(project, file) => {
                self.text(file, take);
                self.problems(file, data_check::problems(db, project, file), take);
            }
            CheckUnit::Project(project) => {
                let file = project.manifest(db);
                self.text(file, take);
                self.problems(file, project_check::problems(db, project), take);
                self.problems(file, interfaces::problems(db, project), take);
                self.page_problems(project, take);
            }
        }
    }

    fn alone(&self, faults: &UnitFaults) -> Vec<Diagnostic> {
        match self.unit {
            CheckUnit::Program(project, file) if !faults.any => {
                self.with_levels(lint::program(self.program(project, file), self.settings))
            }
            _ => Vec::new(),
        }
    }

    fn member(&self, faults: &UnitFaults) -> Vec<Diagnostic> {
        if faults.any {
            return Vec::new();
        }
        self.with_levels(match self.unit {
            CheckUnit::Program(project, file) => lint::member(self.program(project, file), self.settings),
            CheckUnit::Data(project, file) => lint::data(self.db, project, file, self.settings),
            CheckUnit::Project(project) => lint::project(self.db, project, self.settings),
        })
    }

    fn with_levels(&self, found: Vec<Diagnostic>) -> Vec<Diagnostic> {
        found.into_iter().filter_map(|diagnostic| self.settings.with_level(diagnostic)).collect()
    }

    fn program(&self, project: Project, file: File) -> &ProgramView<'db> {
        self.program.get_or_init(|| ProgramView::new(self.db, project, file, &self.settings.options))
    }

    /// Reports the faults of a file's text. Returns whether the rest of the file cannot be checked.
    fn text(&self, file: File, take: &mut dyn FnMut(DetectedFault)) -> bool {
        if matches!(file.status(self.db), FileStatus::Unreadable(_)) {
            return true;
        }
        let errors = &text_faults(self.db, file).errors;
        let mut too_deep = false;
        for error in errors {
            // Deeply nested text causes many equal faults; one of them is enough.
            let again = error.kind == SyntaxErrorKind::NestingTooDeep && std::mem::replace(&mut too_deep, true);
            if !again {
                // The controller does not load a file with a syntax error.
                take(DetectedFault { diagnostic: self.of_syntax(file, error), is_refused: true, stops_lints: true });
            }
        }
        errors.iter().any(|error| error.kind == SyntaxErrorKind::ConflictMarker)
    }

    fn of_syntax(&self, file: File, error: &SyntaxError) -> Diagnostic {
        let (rule, mut wording) = word_syntax(&error.kind);
        if let Some(advice) = habits::advice(line_around(file.text(self.db), error.range.start())) {
            advice.clone_into(&mut wording.help);
        }
        let related = error
            .related
            .map(|range| RelatedNote { place: FileRange { file, range }, message: related::other_side(&error.kind) });
        let site = Site::new(self.db, file, error.range, error.related);
        let diagnostic =
            self.diagnostic(rule, wording, FileRange { file, range: error.range }, related.into_iter().collect());
        Diagnostic { fix: fix::of_syntax(&error.kind, &site), ..diagnostic }
    }

    fn problems(&self, file: File, problems: &[Problem], take: &mut dyn FnMut(DetectedFault)) {
        for problem in without_cascades(self.db, file, problems) {
            let (rule, wording) = word_problem(&problem.kind);
            let related = problem
                .related
                .iter()
                .take(MOST_RELATED)
                .map(|other| RelatedNote { place: other.place, message: related::role(other.role) });
            let place = problem.place;
            let mut diagnostic = self.diagnostic(rule, wording, place, related.collect());
            let doubt = self.doubt(&problem.kind);
            diagnostic.severity = doubt.unwrap_or(diagnostic.severity);
            diagnostic.fix = fix::of_problem(&problem.kind, &Site::new(self.db, place.file, place.range, None));
            let is_refused = problem.kind.is_refused() && doubt.is_none();
            take(DetectedFault { diagnostic, is_refused, stops_lints: true });
        }
    }

    /// Faults of a project's user pages, whose files contain no VAL 3 text.
    fn page_problems(&self, project: Project, take: &mut dyn FnMut(DetectedFault)) {
        for problem in pages::problems(self.db, project) {
            let (rule, wording) = word_problem(&problem.kind);
            let diagnostic = self.diagnostic(rule, wording, problem.place, Vec::new());
            take(DetectedFault::advice(diagnostic));
        }
    }

    fn diagnostic(
        &self,
        rule: &'static Rule,
        wording: crate::diagnostic::Wording,
        place: FileRange,
        related: Vec<RelatedNote>,
    ) -> Diagnostic {
        let (project, program) = self.owner(place.file);
        let application = Some(project.manifest(self.db));
        Diagnostic { related, program, application, ..Diagnostic::new(rule, wording, place) }
    }

    /// Level of a fault that may not exist on the controller, which can have add-ons and libraries that the checked
    /// files do not contain.
    fn doubt(&self, kind: &ProblemKind) -> Option<Severity> {
        let project = self.unit.project();
        let (is_uncertain, severity) = match kind {
            ProblemKind::MissingAddOn { lists_others, .. } => (!lists_others, Severity::Info),
            ProblemKind::FileMissing { what: FileRole::Library | FileRole::Type, .. } => {
                (!self.is_in_usrapp(project), Severity::Warning)
            }
            // Every known tool writes the attribute. No source states whether a controller requires it.
            ProblemKind::MissingAttribute { default: Some(_), .. } => (true, Severity::Warning),
            // The path may name another medium, a connection, or a part of a cell.
            ProblemKind::UnresolvedPath { near: None, .. } => (true, Severity::Info),
            // No public document lists every instruction of s8. A name that resembles a known name is still a
            // misspelling, and a name from another language is not an instruction in any version.
            ProblemKind::UnknownInstruction { name, near: None, is: None } => {
                let is_new = project::items(self.db, project).version.language() >= 8;
                (is_new && foreign_names::remedy(name).is_none(), Severity::Warning)
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
            CheckUnit::Program(_, own) if own == file => {
                Some(val3_analysis::items::program::header(self.db, file).name.to_string())
            }
            _ => None,
        };
        (self.unit.project(), program)
    }
}

/// The line of a text that contains an offset.
fn line_around(text: &str, at: TextSize) -> &str {
    let at = usize::from(at);
    let (before, after) = (text.part(..at), text.part(at..));
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let end = after.find('\n').map_or(text.len(), |end| at + end);
    text.part(start..end)
}
