//! The library `io` of s5 and s6, which the controller writes: its items are the signals and lines of the cell.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{folder, items};
use val3_analysis::paths::{Target, project as target};

/// The identifier of the library in projects.
const ALIAS: &str = "io";

/// A sentence on the missing library of an application, and the remedy.
pub(crate) fn missing(db: &dyn Db, application: Project) -> Option<(String, String)> {
    let items = items(db, application);
    let library =
        items.libraries.get(ALIAS).filter(|library| library.interface.is_none() && items.version.major < 7)?;
    let declared = &manifest(db, application.manifest(db)).libraries;
    let path = declared.iter().find(|entry| entry.alias == ALIAS).filter(|_| library.autoload)?.path.as_str();
    let place = match target(folder(db, application), application.roots(db), path) {
        Target::Path(manifest) => manifest.parent()?.to_string(),
        Target::Elsewhere => path.to_owned(),
    };
    let message = "the library `io` is missing, whose items are the inputs, outputs and lines of the controller: a line that \
                   uses one of them stops its task with error 80";
    let help = format!(
        "copy the folder `io` from the `usrapp` of the controller to `{place}`; signals that the cell does not configure \
         are then simulated"
    );
    Some((message.to_owned(), help))
}
