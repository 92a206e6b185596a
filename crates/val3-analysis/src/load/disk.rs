//! The folder of the controller's disk (`Disk://`) for a project.

use camino::{Utf8Path, Utf8PathBuf};

use rustc_hash::FxHashSet;

use super::references::PathArgument;
use super::{Loader, outside};
use crate::items::manifest::manifest as project_manifest;
use crate::paths::{self, ResolvedPath, Roots, path_key, usrapp};
use crate::system::PathKind;

/// Maximum number of folders above a project that are considered as the disk, or as the folder that contains it.
const LEVELS: usize = 6;

impl Loader<'_> {
    /// Returns the projects in reading order: projects that no other project loads come first, because an application
    /// determines the folder of `Disk://` for all projects that it loads.
    pub(super) fn applications_first<'p>(&mut self, manifests: &'p [Utf8PathBuf]) -> Vec<&'p Utf8Path> {
        if manifests.len() < 2 || manifests.iter().all(|manifest| usrapp(manifest).is_some()) {
            return manifests.iter().map(Utf8PathBuf::as_path).collect();
        }
        let mut loaded = FxHashSet::default();
        for manifest in manifests {
            let folder = manifest.parent().unwrap_or(Utf8Path::new(""));
            let configuration = self.configuration(folder);
            let roots = self.roots(manifest, configuration, None);
            let own = path_key(manifest.as_str());
            let targets = self.references_of(manifest).into_iter().filter_map(|reference| {
                match paths::project(folder, &roots, &reference) {
                    ResolvedPath::Path(path) => Some(path_key(path.as_str())),
                    ResolvedPath::Elsewhere => None,
                }
            });
            loaded.extend(targets.filter(|target| *target != own));
        }
        let manifests = manifests.iter().map(Utf8PathBuf::as_path);
        let (libraries, mut order): (Vec<_>, Vec<_>) =
            manifests.partition(|manifest| loaded.contains(&path_key(manifest.as_str())));
        order.extend(libraries);
        order
    }

    /// Returns the folder of `Disk://` for an application without a configuration and without an enclosing `usrapp`:
    /// the [candidate](Self::disk_candidates) in which most of the application's references resolve, or the nearest of
    /// several.
    pub(super) fn own_disk(&mut self, manifest: &Utf8Path) -> Option<Utf8PathBuf> {
        let key = path_key(manifest.as_str());
        if let Some(disk) = self.own_disks.get(&key) {
            return disk.clone();
        }
        let disk = self.guessed_disk(manifest);
        self.own_disks.insert(key, disk.clone());
        disk
    }

    fn guessed_disk(&mut self, manifest: &Utf8Path) -> Option<Utf8PathBuf> {
        let folder = manifest.parent().unwrap_or(Utf8Path::new(""));
        let references = self.references_from_roots(manifest);
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

    /// Returns the references relative to a root, of the project and of the projects that it loads by relative paths.
    fn references_from_roots(&mut self, manifest: &Utf8Path) -> Vec<String> {
        let mut seen = FxHashSet::default();
        let mut queue = vec![manifest.to_owned()];
        let mut found = Vec::new();
        while let Some(manifest) = queue.pop() {
            if !seen.insert(path_key(manifest.as_str())) {
                continue;
            }
            let folder = manifest.parent().unwrap_or(Utf8Path::new("")).to_owned();
            for reference in self.references_of(&manifest) {
                if !reference.starts_with('.') {
                    found.push(reference);
                } else if let ResolvedPath::Path(path) = paths::project(&folder, &Roots::default(), &reference) {
                    queue.push(path);
                }
            }
        }
        found
    }

    /// Returns the paths of referenced projects: libraries, types, and constant arguments of `libLoad`.
    fn references_of(&mut self, manifest: &Utf8Path) -> Vec<String> {
        let Some(file) = self.found_file(manifest) else { return Vec::new() };
        let folder = file.path(&self.db).parent().unwrap_or(Utf8Path::new("")).to_owned();
        let manifest = project_manifest(&self.db, file).clone();
        let outside = self.files_outside(&folder, &manifest);
        let loaded = self.files_of(&folder, &manifest, &outside);
        let named = manifest.projects().into_iter().map(ToOwned::to_owned);
        named.chain(loaded.iter().filter_map(PathArgument::whole).map(ToOwned::to_owned)).collect()
    }

    /// Returns the folders above a project, each followed by its `usr/usrapp`, because test folders are next to `usr`.
    /// Except for the parent folder, they must be in the project's repository, if there is one.
    fn disk_candidates(&mut self, folder: &Utf8Path) -> Vec<Utf8PathBuf> {
        let repository = outside::repository_around(self.system, folder);
        let repository = repository.as_deref();
        let mut candidates = Vec::new();
        for above in folder.ancestors().skip(1).take(LEVELS) {
            if !self.may_be_disk(above, folder, repository) {
                break;
            }
            candidates.push(above.to_owned());
            let usrapp = self.actual(&above.join("usr").join("usrapp"));
            let usrapp = usrapp.filter(|path| self.system.kind(path) == Some(PathKind::Folder));
            candidates.extend(usrapp.filter(|path| self.may_be_disk(path, folder, repository)));
        }
        candidates
    }

    /// Whether `disk` is the parent of the project in `folder`, or in its repository, if there is one.
    fn may_be_disk(&self, disk: &Utf8Path, folder: &Utf8Path, repository: Option<&Utf8Path>) -> bool {
        Some(disk) == folder.parent()
            || repository.is_none_or(|repository| self.system.target(disk).starts_with(repository))
    }

    /// Returns the number of references that resolve to an existing project if `disk` is the folder of `Disk://`.
    fn resolved(&mut self, folder: &Utf8Path, disk: &Utf8Path, references: &[String]) -> usize {
        let roots = Roots { disk: Some(disk.to_owned()), others: Vec::new() };
        let mut count = 0;
        for reference in references {
            if let ResolvedPath::Path(path) = paths::project(folder, &roots, reference)
                && self.is_file(&path)
            {
                count += 1;
            }
        }
        count
    }
}
