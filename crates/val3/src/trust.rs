//! `val3 trust`: manages the folders whose settings may reach outside of their cell.
//!
//! The list is the user's file `trust.toml`, outside of all cells. The environment variable VAL3_TRUST adds folders,
//! for CI and for single commands.

use std::fmt::Display;
use std::fs;
use std::process::ExitCode;
use std::sync::LazyLock;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;

use camino::{Utf8Path, Utf8PathBuf};
use toml_edit::{Array, DocumentMut, Item, Value};
use val3_config::trust::UserTrust;
use val3_files::{FileClass, Unreadable, replace};

use crate::args::TrustArgs;
use crate::color::Color;
use crate::output::{to_stderr, to_stdout};
use crate::user_error::UserError;

/// Environment variable with trusted folders, separated as in PATH.
const VARIABLE: &str = "VAL3_TRUST";

/// Key of the list in its file.
const FOLDERS: &str = "folders";

/// Whether this process ignores the user's list and the environment variable.
static TRUSTS_NOTHING: AtomicBool = AtomicBool::new(false);

/// Makes this process trust no folder, because its requests come from a language model and not from the user.
pub(crate) fn trust_nothing() {
    TRUSTS_NOTHING.store(true, Relaxed);
}

/// Registers the user's list for the readers of settings. The list is only read if a setting reaches outside.
pub(crate) fn connect() {
    UserTrust { trusts, is_home }.connect();
}

/// Runs the command.
///
/// # Errors
/// A folder does not exist, or the list cannot be read or written.
pub(crate) fn run(args: &TrustArgs) -> Result<ExitCode, UserError> {
    let path = list_file()?;
    if let Some(folder) = &args.remove {
        let folder = canonical(folder).unwrap_or_else(|_| folder.clone());
        change(&path, |folders| remove(folders, &folder))?;
        to_stderr(|out| writeln!(out, "`{folder}` is not trusted any more"));
    }
    if let Some(folder) = &args.folder {
        let folder = canonical(folder)?;
        change(&path, |folders| add(folders, &folder))?;
        to_stderr(|out| writeln!(out, "settings in `{folder}` and below may reach outside of their cell"));
    }
    if args.list {
        let folders = listed(&read(&path)?, &path)?;
        to_stdout(Color::Never, |out| folders.iter().try_for_each(|folder| writeln!(out, "{folder}")))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Whether the folder, whose links are resolved, is a trusted folder or in a trusted folder.
fn trusts(folder: &Utf8Path) -> bool {
    if TRUSTS_NOTHING.load(Relaxed) {
        return false;
    }
    let named = std::env::var_os(VARIABLE).unwrap_or_default();
    let of_variable = std::env::split_paths(&named).filter_map(|path| Utf8PathBuf::from_path_buf(path).ok());
    let of_list = list_file().and_then(|path| listed(&read(&path)?, &path)).unwrap_or_else(|error| {
        to_stderr(|out| writeln!(out, "{error}"));
        Vec::new()
    });
    let is_above = |trusted: Utf8PathBuf| canonical(&trusted).is_ok_and(|trusted| folder.starts_with(trusted));
    of_variable.filter(|path| !path.as_str().is_empty()).chain(of_list).any(is_above)
}

fn is_home(folder: &Utf8Path) -> bool {
    static HOME: LazyLock<Option<Utf8PathBuf>> = LazyLock::new(|| canonical(&home()?).ok());
    HOME.as_ref().is_some_and(|home| home == folder)
}

/// User's home folder.
fn home() -> Option<Utf8PathBuf> {
    variable(if cfg!(windows) { "USERPROFILE" } else { "HOME" })
}

/// Path of the list: in `XDG_CONFIG_HOME`, `~/.config`, or on Windows `APPDATA`.
fn list_file() -> Result<Utf8PathBuf, UserError> {
    let system = if cfg!(windows) { variable("APPDATA") } else { home().map(|home| home.join(".config")) };
    let folder = variable("XDG_CONFIG_HOME").filter(|path| path.is_absolute()).or(system);
    folder.map(|folder| folder.join("val3/trust.toml")).ok_or_else(|| {
        UserError::new("the folder of your settings is unknown").with_help("set HOME or XDG_CONFIG_HOME")
    })
}

fn variable(name: &str) -> Option<Utf8PathBuf> {
    std::env::var(name).ok().filter(|path| !path.is_empty()).map(Utf8PathBuf::from)
}

fn canonical(folder: &Utf8Path) -> Result<Utf8PathBuf, UserError> {
    folder.canonicalize_utf8().map_err(|error| UserError::new(format!("`{folder}`: {error}")))
}

/// Reads the list, which is empty without a file.
fn read(path: &Utf8Path) -> Result<DocumentMut, UserError> {
    let text = match val3_files::read_text(path, FileClass::Settings) {
        Ok(text) => text,
        Err(Unreadable::Missing) => String::new(),
        Err(error) => {
            return Err(UserError::new(format!("cannot read your list of trusted folders `{path}`: {error}")));
        }
    };
    text.parse().map_err(|error| faulty(path, &error))
}

fn faulty(path: &Utf8Path, reason: &dyn Display) -> UserError {
    UserError::new(format!("your list of trusted folders `{path}` cannot be used: {reason}"))
        .with_help("it has one line: folders = [\"/path/of/a/folder\"]")
}

/// Folders of the list.
fn listed(document: &DocumentMut, path: &Utf8Path) -> Result<Vec<Utf8PathBuf>, UserError> {
    let Some(item) = document.get(FOLDERS) else { return Ok(Vec::new()) };
    let texts = item.as_array().map(|array| array.iter().map(|entry| entry.as_str().map(Utf8PathBuf::from)).collect());
    texts.flatten().ok_or_else(|| faulty(path, &format!("`{FOLDERS}` must be a list of texts")))
}

/// Changes the list and replaces its file.
fn change(path: &Utf8Path, edit: impl FnOnce(&mut Array) -> Result<(), UserError>) -> Result<(), UserError> {
    let mut document = read(path)?;
    // Checks that each entry is a string.
    listed(&document, path)?;
    let folders = document.entry(FOLDERS).or_insert_with(|| Item::Value(Value::Array(Array::new())));
    if let Some(folders) = folders.as_array_mut() {
        edit(folders)?;
    }
    let refused = |error: &dyn Display| UserError::new(format!("cannot write `{path}`: {error}"));
    let folder = path.parent().unwrap_or(Utf8Path::new("."));
    fs::create_dir_all(folder).map_err(|error| refused(&error))?;
    replace(path, document.to_string().as_bytes()).map_err(|error| refused(&error))
}

fn add(folders: &mut Array, folder: &Utf8Path) -> Result<(), UserError> {
    if !folders.iter().any(|known| known.as_str() == Some(folder.as_str())) {
        folders.push(folder.as_str());
    }
    Ok(())
}

fn remove(folders: &mut Array, folder: &Utf8Path) -> Result<(), UserError> {
    let before = folders.len();
    folders.retain(|known| known.as_str() != Some(folder.as_str()));
    if folders.len() < before {
        return Ok(());
    }
    Err(UserError::new(format!("`{folder}` is not in your list of trusted folders"))
        .with_help("`val3 trust --list` shows it"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_keeps_its_comments() {
        let mut document: DocumentMut = "# mine\nfolders = [\"/a\"] # stays\n".parse().unwrap();
        add(document[FOLDERS].as_array_mut().unwrap(), "/b".into()).unwrap();
        add(document[FOLDERS].as_array_mut().unwrap(), "/b".into()).unwrap();
        assert_eq!(document.to_string(), "# mine\nfolders = [\"/a\", \"/b\"] # stays\n");
        remove(document[FOLDERS].as_array_mut().unwrap(), "/a".into()).unwrap();
        assert_eq!(listed(&document, "t".into()).unwrap(), ["/b"]);
        let error = remove(document[FOLDERS].as_array_mut().unwrap(), "/a".into()).unwrap_err();
        assert!(error.to_string().contains("`/a` is not in your list"));
    }

    #[test]
    fn a_faulty_list_is_an_error() {
        let document: DocumentMut = "folders = [1]\n".parse().unwrap();
        assert!(listed(&document, "t.toml".into()).unwrap_err().to_string().contains("t.toml"));
    }
}
