//! Default run: the settings `[run.default]` of a `val3.toml`, for a folder without a named application.

use std::io;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::{LoadError, nearest_configuration};
use val3_analysis::system::{Disk, PathKind, System as _};
use val3_config::{ConfigError, ConfigFile, DefaultRun};
use val3_session::SessionError;

use crate::args::{RunArgs, START};
use crate::output::to_stderr;
use crate::paths::{Paths, current_folder, has_extension};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Files that a default run writes, as displayed paths.
#[derive(Debug, Default)]
pub(super) struct WrittenFiles(Vec<String>);

impl WrittenFiles {
    /// Sets an output file to the configured path, unless an argument names another file.
    fn insert(&mut self, argument: &mut Option<Utf8PathBuf>, configured: Option<Utf8PathBuf>) {
        if let (None, Some(path)) = (&argument, configured) {
            self.0.push(one_line(path.as_str()).into_owned());
            *argument = Some(path);
        }
    }
}

/// Completes the arguments by `[run.default]` of the nearest `val3.toml`, if they name a folder that is no application.
/// Prints the complete command. `None` if no settings apply.
///
/// # Errors
/// The settings are invalid.
pub(super) fn complete(args: &mut RunArgs) -> Result<Option<WrittenFiles>, UserError> {
    let current = current_folder()?;
    let paths = Paths::new(&[], &current);
    let folder = paths.absolute(&args.application);
    if args.program != START || !is_around_applications(&folder) {
        return Ok(None);
    }
    let refused = |error: ConfigError| SessionError::from(LoadError::Configuration(vec![error]));
    let Some(file) = nearest_configuration(&Disk, &folder).map_err(refused)? else {
        return Ok(None);
    };
    let run = &file.config.run.default;
    let Some(application) = &run.application else { return Ok(None) };
    if !paths.absolute(&file.folder().join(application)).starts_with(&folder) {
        return Ok(None);
    }
    check_links(&file).map_err(refused)?;
    let shown = |path: &Utf8Path| Utf8PathBuf::from(paths.to_open(&file.folder().join(path)));
    let written = insert(args, run, &shown, application);
    let (command, settings) = (command(args), paths.shown(&file.path));
    to_stderr(|out| writeln!(out, "note: `[run.default]` in {settings} names this run:\n  {command}"));
    Ok(Some(written))
}

/// Whether the folder is not an application itself.
fn is_around_applications(folder: &Utf8Path) -> bool {
    let has_project = |names: Vec<String>| names.iter().any(|name| has_extension(name.as_ref(), "pjx"));
    Disk.kind(folder) == Some(PathKind::Folder) && !Disk.list(folder).is_ok_and(has_project)
}

/// Checks that no written path contains a link to a location elsewhere.
///
/// # Errors
/// The setting whose path contains a link.
fn check_links(file: &ConfigFile) -> Result<(), ConfigError> {
    let DefaultRun { plot, export, .. } = &file.config.run.default;
    let folder = Disk.target(file.folder());
    for (key, path) in [("plot", plot), ("export", export)] {
        if path.as_ref().is_some_and(|path| Disk.target(&file.folder().join(path)) != folder.join(path)) {
            let key = format!("run.default.{key}");
            let message = format!("`{key}` writes through a link, which could resolve to another file");
            return Err(file.fault(&key, message, "name a file that is not a link".to_owned()));
        }
    }
    Ok(())
}

/// Inserts the settings that no argument replaces.
fn insert(
    args: &mut RunArgs,
    run: &DefaultRun,
    shown: &dyn Fn(&Utf8Path) -> Utf8PathBuf,
    application: &Utf8Path,
) -> WrittenFiles {
    let mut written = WrittenFiles::default();
    args.application = shown(application);
    // A recording contains the actions of its script.
    if args.script.is_none() && args.replay.is_none() {
        args.script = run.script.as_deref().map(shown);
    }
    if args.until.is_none() {
        (args.until, args.until_ok) = (run.until, run.until_ok);
    }
    if run.times && args.times.is_none() {
        args.times = Some(None);
    }
    written.insert(&mut args.plot, run.plot.as_deref().map(shown));
    // A debugged run exports no page, because stepping back can change its history.
    if args.debug_port.is_none() {
        written.insert(&mut args.export, run.export.as_deref().map(shown));
    }
    written
}

/// Formats the arguments that settings may have completed, as a command.
fn command(args: &RunArgs) -> String {
    let mut words = vec!["val3 run".to_owned(), quoted(&args.application)];
    words.extend(args.script.iter().map(|path| format!("--script {}", quoted(path))));
    words.extend(args.until.map(|until| format!("--until {until}")));
    words.extend(args.until_ok.then(|| "--until-ok".to_owned()));
    words.extend(args.times.is_some().then(|| "--times".to_owned()));
    words.extend(args.plot.iter().map(|path| format!("--plot {}", quoted(path))));
    words.extend(args.export.iter().map(|path| format!("--export {}", quoted(path))));
    words.join(" ")
}

/// Quotes a path for a shell.
fn quoted(path: &Utf8Path) -> String {
    match one_line(path.as_str()).into_owned() {
        plain if plain.chars().all(is_plain) => plain,
        other => format!("'{}'", other.replace('\'', r"'\''")),
    }
}

/// Whether the character has no special meaning in a shell.
fn is_plain(c: char) -> bool {
    c.is_alphanumeric() || "/._-+@".contains(c)
}

impl WrittenFiles {
    /// Reports the written files.
    pub(super) fn report(&self) {
        to_stderr(|out| self.0.iter().try_for_each(|path| -> io::Result<()> { writeln!(out, "wrote {path}") }));
    }
}
