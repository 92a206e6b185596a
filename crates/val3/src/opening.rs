//! Opens the workspace for a request: threads, files in the database, settings.

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::{ThreadPool, ThreadPoolBuilder};
use rustc_hash::FxHashMap;
use val3_analysis::arm::arm;
use val3_analysis::db::{Database, File, Project};
use val3_analysis::items::project::folder;
use val3_analysis::items::unlisted::{is_data, is_program};
use val3_analysis::load::{self, LoadError, NO_APPLICATION, Workspace};
use val3_analysis::surroundings::cell_faults;
use val3_analysis::system::{Disk, OverlayFs};
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_config::ConfigError;
use val3_session::SessionError;

use crate::baseline::Mode;
use crate::loose::{LooseFiles, archives_under};
use crate::output::to_verbose;
use crate::parallel_disk::ParallelDisk;
use crate::paths::{Paths, current_folder};
use crate::printable::one_line;
use crate::scope::ReportFilter;
use crate::standard_input::StandardInput;
use crate::user_error::UserError;
use crate::{arm_choice, in_memory};

/// Stack size of a thread in bytes, ample for the parser's deepest nesting.
const STACK_SIZE: usize = 16 << 20;

/// Paths to check, and options of the check.
#[derive(Debug, Default)]
pub(crate) struct OpenRequest {
    /// Requested folders and files.
    pub(crate) asked: Vec<Utf8PathBuf>,
    /// Selected rules.
    pub(crate) selection: RuleSelection,
    /// Arm of all applications; without it, each application has its own arm.
    pub(crate) arm: Option<String>,
    /// Baseline of all applications; without it, each `val3.toml` names its application's baseline.
    pub(crate) baseline: Option<Utf8PathBuf>,
    /// Use of baselines in the check.
    pub(crate) mode: Mode,
    /// Number of threads; one for each core by default.
    pub(crate) jobs: Option<u16>,
    /// Whether a requested program or data file restricts the report to its own findings.
    pub(crate) files_alone: bool,
    /// File whose text comes from the standard input.
    pub(crate) input: Option<StandardInput>,
    /// Whether progress is hidden.
    pub(crate) quiet: bool,
}

/// Result of [`open`].
pub(crate) struct OpenedWorkspace {
    /// Worker threads.
    pub(crate) threads: ThreadPool,
    /// Current folder, absolute.
    pub(crate) current: Utf8PathBuf,
    /// Path display.
    pub(crate) paths: Paths,
    /// All files.
    pub(crate) workspace: Workspace,
    /// Settings by application.
    pub(crate) settings: WorkspaceSettings,
    /// Requested paths, absolute.
    pub(crate) asked: Vec<Utf8PathBuf>,
    /// Scope of reported findings.
    pub(crate) scope: ReportFilter,
    /// Files without a project.
    pub(crate) loose: LooseFiles,
    /// Notice about the arm for the user.
    pub(crate) notice: Option<String>,
}

/// Loads all files of the request.
pub(crate) fn open(request: &OpenRequest) -> Result<OpenedWorkspace, UserError> {
    open_with(request, |threads, asked| {
        let (system, mut loose) = system(threads, request.input.as_ref(), &EditedTexts::default(), asked)?;
        let mut workspace = load::load(&system, asked)?;
        loose.report_unreadable(&mut workspace);
        Ok((workspace, loose))
    })
}

/// As [`open`], with a workspace that was loaded before.
pub(crate) fn open_workspace(request: &OpenRequest, workspace: Workspace) -> Result<OpenedWorkspace, UserError> {
    open_with(request, |_, _| Ok((workspace, LooseFiles::default())))
}

fn open_with(
    request: &OpenRequest,
    load: impl FnOnce(&ThreadPool, &[Utf8PathBuf]) -> Result<(Workspace, LooseFiles), LoadError>,
) -> Result<OpenedWorkspace, UserError> {
    let threads = threads(request.jobs)?;
    let current = current_folder()?;
    let paths = Paths::new(&folders(&request.asked), &current).within(repository(&current));
    // An absolute path is required to find the `usrapp` above the current folder.
    let asked: Vec<_> = request.asked.iter().map(|path| current.join(path)).collect();
    let (mut workspace, loose) = load(&threads, &asked).map_err(|error| refused(error, &paths))?;
    if let Some(name) = &request.arm {
        val3_session::request_arm(&mut workspace.db, &workspace.projects, name)?;
    }
    let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &request.selection)
        .map_err(|errors| configuration_refused(errors, &paths))?;
    let scope = if request.files_alone { ReportFilter::new(&asked) } else { ReportFilter::default() };
    let applications: Vec<Project> =
        workspace.projects.iter().copied().filter(|project| !loose.stands_in(&workspace.db, *project)).collect();
    let notice = arm_choice::notice(&workspace.db, &applications, &settings)?;
    check_surroundings(&workspace, &paths)?;
    applications.iter().for_each(|project| mention(&workspace.db, *project, &paths));
    Ok(OpenedWorkspace { threads, current, paths, workspace, settings, asked, scope, loose, notice })
}

/// Checks the `cell.toml` of each application.
fn check_surroundings(workspace: &Workspace, paths: &Paths) -> Result<(), UserError> {
    let db = &workspace.db;
    let mut files: Vec<File> = workspace.projects.iter().filter_map(|project| project.surroundings(db)).collect();
    files.sort_unstable_by_key(|file| file.path(db));
    files.dedup();
    let faults: Vec<ConfigError> = files.into_iter().flat_map(|file| cell_faults(db, file)).collect();
    if faults.is_empty() { Ok(()) } else { Err(configuration_refused(faults, paths)) }
}

/// Writes the settings and the arm of an application if `--verbose` is set.
pub(crate) fn mention(db: &Database, project: Project, paths: &Paths) {
    to_verbose(|| {
        let settings = project.configuration(db).map(|configuration| paths.shown(&configuration.file(db).path));
        let settings = settings.unwrap_or_else(|| "no val3.toml".to_owned());
        let arm = arm(db, project).as_ref().map_or("no known arm", |arm| arm.model.name());
        format!("{}: settings {settings}, arm {arm}", paths.shown(folder(db, project)))
    });
}

/// Edited texts by file path.
pub(crate) type EditedTexts = FxHashMap<Utf8PathBuf, Arc<str>>;

/// Returns the file system that the threads read: the disk, overlaid with requested archives, the standard input and
/// the edited texts. The second value contains the requested files without a project.
///
/// # Errors
/// A requested archive cannot be read.
pub(crate) fn system<'t>(
    threads: &'t ThreadPool,
    input: Option<&StandardInput>,
    edited: &EditedTexts,
    asked: &[Utf8PathBuf],
) -> Result<(OverlayFs<ParallelDisk<'t>>, LooseFiles), LoadError> {
    let mut system = OverlayFs::new(ParallelDisk::new(threads));
    in_memory::add(&mut system, asked)?;
    if let Some(input) = input {
        system.store(input.path.clone(), input.bytes.clone());
    }
    edited.iter().for_each(|(path, text)| system.edit(path, Arc::clone(text)));
    let loose = LooseFiles::lay_over(&mut system, asked);
    Ok((system, loose))
}

impl From<SessionError> for UserError {
    fn from(error: SessionError) -> Self {
        let help = error.help();
        match (error, current_folder()) {
            (SessionError::Load(error), Ok(current)) => refused(error, &Paths::new(&[], &current)),
            (SessionError::Several { path, applications }, Ok(current)) => {
                let path = path.strip_prefix(&current).map(Utf8Path::to_owned).unwrap_or(path);
                let path = if path.as_str().is_empty() { ".".into() } else { path };
                Self::new(SessionError::Several { path, applications }.to_string()).with_help(help)
            }
            (error, _) => Self::new(error.to_string()).with_help(help),
        }
    }
}

fn refused(error: LoadError, paths: &Paths) -> UserError {
    match error {
        LoadError::Path { path, reason } => UserError::new(format!("`{}`: {reason}", paths.shown(&path))),
        LoadError::NoApplication { folder } => no_application(&folder, paths),
        LoadError::Configuration(errors) => configuration_refused(errors, paths),
    }
}

/// Error for a folder without a project. It names backup archives in the folder.
fn no_application(folder: &Utf8Path, paths: &Paths) -> UserError {
    let error = UserError::new(format!("`{}`: {NO_APPLICATION}", paths.shown(folder)));
    let archives = archives_under(&Disk, folder);
    let Some(first) = archives.first() else { return error };
    let more = match archives.len() {
        1 => String::new(),
        count => format!(", as are {} more", count - 1),
    };
    error.with_help(format!(
        "`{}` is an archive{more}: check, diff and run read an archive that is named, other commands its unpacked folder",
        paths.shown(&first.path)
    ))
}

fn configuration_refused(errors: Vec<ConfigError>, paths: &Paths) -> UserError {
    let worded =
        errors.into_iter().map(|error| configuration_fault(error, paths)).collect::<Vec<_>>().join("\nerror: ");
    let (message, details) = worded.split_once('\n').unwrap_or((&worded, ""));
    UserError::new(message).with_details(details)
}

/// Text of a configuration error with a displayed path.
fn configuration_fault(error: ConfigError, paths: &Paths) -> String {
    let (path, message) = (paths.shown(&error.path).into(), one_line(&error.message).into_owned());
    ConfigError { path, message, ..error }.to_string()
}

/// Creates threads with a stack for the deepest nesting.
pub(crate) fn threads(jobs: Option<u16>) -> Result<ThreadPool, UserError> {
    let threads = jobs.map_or(0, usize::from);
    ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK_SIZE).build().map_err(|error| {
        UserError::new(format!("cannot start threads: {error}")).with_help("use fewer threads with --jobs")
    })
}

/// Nearest folder, from `current` upwards, that is under version control.
pub(crate) fn repository(current: &Utf8Path) -> Option<&Utf8Path> {
    current.ancestors().find(|folder| [".git", ".hg", ".svn"].iter().any(|name| folder.join(name).exists()))
}

/// Requested folders; for a file, its folder.
fn folders(asked: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
    let parents = asked.iter().map(|path| path.parent().filter(|_| is_file(path)).unwrap_or(path));
    parents.map(Utf8Path::to_owned).collect()
}

/// Whether the path names a file. A file that the standard input replaces need not exist.
fn is_file(path: &Utf8Path) -> bool {
    path.is_file() || (is_program(path.as_str()) || is_data(path.as_str())) && !path.exists()
}
