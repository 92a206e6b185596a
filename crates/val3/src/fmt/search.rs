//! Finds programs in the requested paths, and each program's style.

use std::collections::BTreeMap;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::{files, nearest_configuration};
use val3_analysis::system::{PathKind, System};
use val3_config::{CodeLayout, ConfigError, ConfigFile};
use val3_files::is_archive_name;
use val3_fmt::CodeStyle;

use crate::paths::{Paths, has_extension};
use crate::user_error::UserError;

/// A program to format.
pub(super) struct FoundProgram {
    pub(super) path: Utf8PathBuf,
    pub(super) style: CodeStyle,
}

/// Finds the programs in the paths, without duplicates, and without programs that a `val3.toml` excludes from a search.
pub(super) fn programs(
    system: &dyn System,
    asked: &[Utf8PathBuf],
    current: &Utf8Path,
    paths: &Paths,
) -> Result<Vec<FoundProgram>, UserError> {
    let mut found = BTreeMap::new();
    let mut has_excluded = false;
    for asked in asked {
        let path = val3_analysis::paths::normalise(&current.join(asked));
        for program in under(system, &path, paths)? {
            let file = configuration(system, &program)?;
            // A program or folder that an argument names is not excluded.
            let excluded = |file: &ConfigFile| program != path && file.excludes(&program) && !file.excludes(&path);
            if file.as_ref().is_some_and(excluded) {
                has_excluded = true;
            } else {
                found.insert(program.clone(), style_in(system, file.as_ref(), &program)?);
            }
        }
    }
    if found.is_empty() && !has_excluded {
        let shown: Vec<String> = asked.iter().map(|path| format!("`{}`", paths.shown(path))).collect();
        return Err(UserError::new(format!("{}: there is no program (`.pgx`) here", shown.join(", ")))
            .with_help("name a program, or a folder that contains some"));
    }
    Ok(found.into_iter().map(|(path, style)| FoundProgram { path, style }).collect())
}

fn under(system: &dyn System, path: &Utf8Path, paths: &Paths) -> Result<Vec<Utf8PathBuf>, UserError> {
    let refused = |reason: &str| UserError::new(format!("`{}`: {reason}", paths.shown(path)));
    match system.kind(path) {
        None => Err(refused("there is no such file or folder")),
        Some(PathKind::File) if has_extension(path, "pgx") => Ok(vec![path.to_owned()]),
        Some(PathKind::File) if has_extension(path, "pjx") => folder(system, path.parent().unwrap_or(path), paths),
        Some(PathKind::File) if is_archive_name(path) => {
            Err(refused("`val3 fmt` formats unpacked programs only; unpack the archive, and name its folder"))
        }
        Some(PathKind::File) => Err(refused("this is not a VAL 3 program; name a `.pgx`, or a folder with programs")),
        Some(PathKind::Folder) if has_extension(path, "pgx") => {
            Err(UserError::new(format!("cannot read `{}`: it is a folder", paths.shown(path))))
        }
        Some(PathKind::Folder) => folder(system, path, paths),
    }
}

fn folder(system: &dyn System, path: &Utf8Path, paths: &Paths) -> Result<Vec<Utf8PathBuf>, UserError> {
    let mut unreadable = Vec::new();
    let found = files(system, path, "pgx", &mut unreadable);
    match unreadable.first() {
        Some((entry, reason)) => Err(UserError::new(format!("cannot read `{}`: {reason}", paths.shown(entry)))),
        None => Ok(found),
    }
}

/// Style of the program at `path`.
pub(super) fn style(system: &dyn System, path: &Utf8Path) -> Result<CodeStyle, UserError> {
    style_in(system, configuration(system, path)?.as_ref(), path)
}

fn style_in(system: &dyn System, file: Option<&ConfigFile>, path: &Utf8Path) -> Result<CodeStyle, UserError> {
    let default = CodeLayout::default();
    val3_ide::style(system, file.map_or(&default, |file| &file.config.format), path)
        .map_err(|error| UserError::new(error.to_string()).with_help("allow reading it, or remove it"))
}

fn configuration(system: &dyn System, program: &Utf8Path) -> Result<Option<ConfigFile>, UserError> {
    let folder = program.parent().unwrap_or(program);
    nearest_configuration(system, folder).map_err(|error: ConfigError| UserError::new(error.to_string()))
}
