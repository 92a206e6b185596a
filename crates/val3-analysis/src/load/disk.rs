//! The root of the controller's disk, seen from a project.

use camino::{Utf8Path, Utf8PathBuf};

use super::{Loader, outside};
use crate::paths::{self, Roots, Target};
use crate::system::Kind;

/// Number of folders above a project that may be the disk, or contain it.
const LEVELS: usize = 6;

impl Loader<'_> {
    /// The folder of `Disk://` without a configuration: the nearest `usrapp` above, otherwise the
    /// [candidate](Self::disk_candidates) in which most references of the project name a file, of equal ones the nearest.
    pub(super) fn disk(&mut self, folder: &Utf8Path, references: &[&str]) -> Option<Utf8PathBuf> {
        let is_usrapp = |path: &&Utf8Path| path.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usrapp"));
        if let Some(usrapp) = folder.ancestors().find(is_usrapp) {
            return Some(usrapp.to_owned());
        }
        let references: Vec<&str> =
            references.iter().filter(|reference| !reference.starts_with('.')).copied().collect();
        if references.is_empty() {
            return folder.parent().map(Utf8Path::to_owned);
        }
        let mut best: Option<(usize, Utf8PathBuf)> = None;
        for disk in self.disk_candidates(folder) {
            let score = self.resolved(folder, &disk, &references);
            if best.as_ref().is_none_or(|(top, _)| score > *top) {
                best = Some((score, disk));
            }
        }
        let (score, disk) = best?;
        (score > 0).then_some(disk)
    }

    /// The folders above a project, each followed by the `usr/usrapp` in it, because tests are beside `usr`. All but the
    /// folder around the project must be in its repository, if it has one.
    fn disk_candidates(&mut self, folder: &Utf8Path) -> Vec<Utf8PathBuf> {
        let repository = outside::repository_around(self.system, folder);
        let system = self.system;
        let is_allowed = |disk: &Utf8Path| {
            Some(disk) == folder.parent()
                || repository.as_ref().is_none_or(|repository| system.target(disk).starts_with(repository))
        };
        let mut candidates = Vec::new();
        for above in folder.ancestors().skip(1).take(LEVELS).take_while(|disk| is_allowed(disk)) {
            let usrapp = self.actual(&above.join("usr").join("usrapp"));
            let usrapp = usrapp.filter(|path| system.kind(path) == Some(Kind::Folder) && is_allowed(path));
            candidates.push(above.to_owned());
            candidates.extend(usrapp);
        }
        candidates
    }

    /// The number of references that name an existing project if `disk` is the folder of `Disk://`.
    fn resolved(&mut self, folder: &Utf8Path, disk: &Utf8Path, references: &[&str]) -> usize {
        let roots = Roots { disk: Some(disk.to_owned()), others: Vec::new() };
        let mut is_project = |reference: &&&str| match paths::project(folder, &roots, reference) {
            Target::Path(path) => self.is_file(&path),
            Target::Elsewhere => false,
        };
        references.iter().filter(|reference| is_project(reference)).count()
    }
}
