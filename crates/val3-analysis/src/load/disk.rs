//! The root of the controller's disk, seen from a project.

use camino::{Utf8Path, Utf8PathBuf};

use crate::paths::{self, Roots, Target};

/// The folder of `Disk://` without a configuration: the nearest `usrapp` above, else the nearest folder above in which a
/// `Disk://` reference of the project names an existing file. A folder above the one around the project must be allowed.
pub(super) fn root(
    folder: &Utf8Path,
    references: &[&str],
    is_allowed: impl Fn(&Utf8Path) -> bool,
    mut is_file: impl FnMut(&Utf8Path) -> bool,
) -> Option<Utf8PathBuf> {
    let is_usrapp = |path: &&Utf8Path| path.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usrapp"));
    if let Some(usrapp) = folder.ancestors().find(is_usrapp) {
        return Some(usrapp.to_owned());
    }
    let references: Vec<&&str> = references.iter().filter(|reference| !reference.starts_with('.')).collect();
    let mut resolves = |disk: &Utf8Path| {
        let roots = Roots { disk: Some(disk.to_owned()), others: Vec::new() };
        references
            .iter()
            .filter(|reference| match paths::project(folder, &roots, reference) {
                Target::Path(path) => is_file(&path),
                Target::Elsewhere => false,
            })
            .count()
    };
    let may_be_disk = |disk: &&Utf8Path| Some(*disk) == folder.parent() || is_allowed(disk);
    let scored = folder.ancestors().skip(1).take(6).take_while(may_be_disk).map(|disk| (resolves(disk), disk));
    // Of equal ones the nearest.
    let best = scored.fold(None, |best: Option<(usize, &Utf8Path)>, (score, disk)| match best {
        Some((top, _)) if top >= score => best,
        _ => Some((score, disk)),
    })?;
    let (score, disk) = best;
    (score > 0 || references.is_empty()).then(|| disk.to_owned())
}
