//! The library `io`, which the controller generates: its items are the signals and lines of the cell. Its name is usual
//! in s5 and s6, and occurs in s7.

use std::collections::BTreeSet;

use camino::Utf8Path;
use smol_str::SmolStr;
use val3_analysis::body::{Expr, body};
use val3_analysis::db::{Db, Project};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{folder, items, program_files};
use val3_analysis::paths::{ResolvedPath, project as target};

/// Library identifier in projects.
const ALIAS: &str = "io";

/// Limit of the items that the message names.
const NAMED: usize = 4;

/// Message about the missing library, and its help; `None` if the application's programs do not use its items.
pub(crate) fn missing(db: &dyn Db, application: Project) -> Option<(String, String)> {
    items(db, application).libraries.get(ALIAS).filter(|library| library.interface.is_none())?;
    let declared = &manifest(db, application.manifest(db)).libraries;
    let path = declared.iter().find(|entry| entry.alias == ALIAS)?.path.as_str();
    let mut roots = application.roots(db).clone();
    // Like the controller of a run, which always has a folder for `Disk`.
    roots.disk = roots.disk.or_else(|| folder(db, application).parent().map(Utf8Path::to_owned));
    let place = match target(folder(db, application), &roots, path) {
        ResolvedPath::Path(manifest) => manifest.parent()?.to_string(),
        ResolvedPath::Elsewhere => path.to_owned(),
    };
    let used = listed(&used_items(db, application))?;
    let message = format!(
        "the library `io` is missing, whose items are the inputs, outputs and lines of the controller: a line that uses {used} \
         stops its task with error 80"
    );
    let help = format!(
        "copy the folder `io` from the `usrapp` of the controller to `{place}`, or write a library with these items there; \
         signals that the cell does not configure are then simulated"
    );
    Some((message, help))
}

/// Items of the library that the programs use.
fn used_items(db: &dyn Db, application: Project) -> BTreeSet<SmolStr> {
    let programs = program_files(db, application).iter();
    programs.flat_map(|file| body(db, *file).exprs()).filter_map(|(_, expr, _)| library_item(expr)).collect()
}

/// Item of the library in an expression `io:NAME`.
fn library_item(expr: &Expr) -> Option<SmolStr> {
    match expr {
        Expr::Path { library, item } if library == ALIAS => Some(item.clone()),
        _ => None,
    }
}

/// The first items as a phrase: "`io:a`, `io:b` or 3 others". `None` without items.
fn listed(items: &BTreeSet<SmolStr>) -> Option<String> {
    let mut words: Vec<String> = items.iter().take(NAMED).map(|item| format!("`{ALIAS}:{item}`")).collect();
    match items.len().saturating_sub(NAMED) {
        0 => {}
        1 => words.push("another one".to_owned()),
        more => words.push(format!("{more} others")),
    }
    let last = words.pop()?;
    Some(if words.is_empty() { last } else { format!("{} or {last}", words.join(", ")) })
}
