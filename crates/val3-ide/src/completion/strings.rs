//! Texts that instructions know: paths of libraries, items, names of tasks.

use val3_analysis::application::application;
use val3_analysis::db::Sources;
use val3_analysis::items::project::items;
use val3_lang::instruction::Family;
use val3_lang::instructions;

use super::context::TextPlace;
use super::{CompletionKind, Found};

/// What can stand in a string.
pub(super) fn texts(found: &mut Found<'_>, place: &TextPlace) {
    let Some(instruction) = instructions::find(&place.callee) else { return };
    match (instruction.name, instruction.family) {
        (instructions::LIB_EXIST, _) => library_items(found, place),
        (_, Family::Libraries) => paths(found),
        (_, Family::Tasks) if place.argument == 0 => tasks(found),
        _ => {}
    }
}

/// The libraries of the cell.
fn paths(found: &mut Found<'_>) {
    let db = found.db;
    let own = found.project;
    let mut projects: Vec<_> = Sources::get(db).projects(db).values().copied().collect();
    projects.sort_unstable_by_key(|project| project.manifest(db).path(db));
    for project in projects.into_iter().filter(|project| *project != own) {
        let Some(disk) = project.disk(db) else { continue };
        let Some(folder) = project.manifest(db).path(db).parent() else { continue };
        if let Ok(relative) = folder.strip_prefix(disk) {
            found.add(format!("Disk://{relative}"), CompletionKind::Path, "library");
        }
    }
}

/// Data and programs of the library's interface.
fn library_items(found: &mut Found<'_>, place: &TextPlace) {
    let db = found.db;
    let library = place.library.as_ref().and_then(|library| items(db, found.project).libraries.get(library));
    let Some(interface) = library.and_then(|library| library.interface) else { return };
    let offered = items(db, interface);
    for name in offered.data.iter().filter(|(_, item)| item.decl.public).map(|(name, _)| name) {
        found.add(name.as_str(), CompletionKind::Data, "data");
    }
    for name in offered.programs.keys() {
        found.add(format!("{name}()"), CompletionKind::Program, "program");
    }
}

/// The tasks that the application creates.
fn tasks(found: &mut Found<'_>) {
    let application = application(found.db, found.project);
    for name in application.tasks.iter().filter_map(|task| task.start.name.as_ref()) {
        found.add(name.as_str(), CompletionKind::Text, "task");
    }
}
