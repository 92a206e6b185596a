//! From what is asked for to what can be checked: threads, files in the database, settings.

use camino::{Utf8Path, Utf8PathBuf};
use rayon::{ThreadPool, ThreadPoolBuilder};
use val3_analysis::items::unlisted::{is_data, is_program};
use val3_analysis::load::{self, LoadError, Workspace};
use val3_check::settings::{Selection, WorkspaceSettings};
use val3_config::ConfigError;

use crate::baseline::Mode;
use crate::overlay::{EditedTexts, OverlayFs, StandardInput};
use crate::paths::Paths;
use crate::scope::Scope;
use crate::user_error::UserError;

/// Bytes of stack a thread, ample for the deepest nesting the parser takes.
const STACK_SIZE: usize = 16 << 20;

/// What is to be checked, and how.
#[derive(Debug, Default)]
pub(crate) struct Request {
    /// Folders and files.
    pub(crate) asked: Vec<Utf8PathBuf>,
    /// The findings that are wanted.
    pub(crate) selection: Selection,
    /// The baseline of all applications; without it each has the one of its `val3.toml`.
    pub(crate) baseline: Option<Utf8PathBuf>,
    /// What happens to the baselines.
    pub(crate) mode: Mode,
    /// Threads; one a core where nothing is said.
    pub(crate) jobs: Option<u16>,
    /// Of single programs and data files that are asked for, only their own findings are reported.
    pub(crate) files_alone: bool,
    /// A file whose text is not the stored one.
    pub(crate) input: Option<StandardInput>,
    /// No progress is shown.
    pub(crate) quiet: bool,
}

/// What [`open`] gives.
pub(crate) struct Opened {
    /// Where the work is done.
    pub(crate) threads: ThreadPool,
    /// The current folder, absolute.
    pub(crate) current: Utf8PathBuf,
    /// How paths are written.
    pub(crate) paths: Paths,
    /// All files.
    pub(crate) workspace: Workspace,
    /// What each application is checked for.
    pub(crate) settings: WorkspaceSettings,
    /// What was asked for, as absolute paths.
    pub(crate) asked: Vec<Utf8PathBuf>,
    /// Which findings are reported.
    pub(crate) scope: Scope,
}

/// Reads everything that is asked for.
pub(crate) fn open(request: &Request) -> Result<Opened, UserError> {
    let threads = threads(request.jobs)?;
    let current = current_folder()?;
    let paths = Paths::new(&folders(&request.asked), &current).within(repository(&current));
    // Only an absolute path shows the `usrapp` above the current folder.
    let asked: Vec<_> = request.asked.iter().map(|path| current.join(path)).collect();
    let edited = EditedTexts::default();
    let system = OverlayFs::new(&threads, request.input.as_ref(), &edited);
    let workspace = load::load(&system, &asked).map_err(|error| refused(error, &paths))?;
    let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &request.selection)
        .map_err(|errors| configuration_refused(errors, &paths))?;
    let scope = if request.files_alone { Scope::new(&asked) } else { Scope::default() };
    Ok(Opened { threads, current, paths, workspace, settings, asked, scope })
}

fn refused(error: LoadError, paths: &Paths) -> UserError {
    match error {
        LoadError::Path { path, reason } => UserError::new(format!("`{}`: {reason}", paths.shown(&path))),
        LoadError::Configuration(errors) => configuration_refused(errors, paths),
    }
}

fn configuration_refused(errors: Vec<ConfigError>, paths: &Paths) -> UserError {
    let shown = |error: ConfigError| ConfigError { path: paths.shown(&error.path).into(), ..error }.to_string();
    UserError::new(errors.into_iter().map(shown).collect::<Vec<_>>().join("\nerror: "))
}

/// Threads with a stack for the deepest nesting.
pub(crate) fn threads(jobs: Option<u16>) -> Result<ThreadPool, UserError> {
    let threads = jobs.map_or(0, usize::from);
    ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK_SIZE).build().map_err(|error| {
        UserError::new(format!("cannot start threads: {error}")).with_help("ask for fewer with --jobs")
    })
}

/// The current folder, absolute.
pub(crate) fn current_folder() -> Result<Utf8PathBuf, UserError> {
    let path = std::env::current_dir().map_err(|error| UserError::new(format!("no current folder: {error}")))?;
    Utf8PathBuf::from_path_buf(path)
        .map_err(|path| UserError::new(format!("the current folder `{}` is not UTF-8", path.display())))
}

/// The nearest folder above `current` that a version control keeps.
fn repository(current: &Utf8Path) -> Option<&Utf8Path> {
    current.ancestors().find(|folder| [".git", ".hg", ".svn"].iter().any(|name| folder.join(name).exists()))
}

/// The folders that were asked for; of a file, the one around it.
fn folders(asked: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
    // A file that is read from the standard input need not be there.
    let is_part = |path: &Utf8Path| (is_program(path.as_str()) || is_data(path.as_str())) && !path.exists();
    let folder = |path: &Utf8PathBuf| match path.parent() {
        Some(parent) if path.is_file() || is_part(path) => parent.to_owned(),
        _ => path.clone(),
    };
    asked.iter().map(folder).collect()
}
