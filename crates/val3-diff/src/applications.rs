//! Applications, libraries and user types of a tree, and their counterparts in the other tree.

mod matching;

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;
use val3_analysis::paths::{ResolvedPath, Roots, file_in, path_key, project};

use crate::read::project::ProjectVersion;
use crate::tree::{has_extension, text_of};

pub(crate) use matching::{Matched, matched};

/// Files of a tree by path.
pub(crate) type TreeFiles<'t> = BTreeMap<Utf8PathBuf, &'t [u8]>;

/// A file in an application.
#[derive(Debug, Clone)]
pub(crate) struct SourceFile<'t> {
    /// Path in the tree.
    pub(crate) path: Utf8PathBuf,
    pub(crate) bytes: &'t [u8],
    /// Whether the project file lists the file.
    pub(crate) listed: bool,
}

/// A project with its files, or the files in a folder that belong to no project.
#[derive(Debug, Clone, Default)]
pub(crate) struct Application<'t> {
    /// Path of the `.pjx`, or of the folder.
    pub(crate) path: Utf8PathBuf,
    /// Name of the `.pjx` without its extension, or of the folder.
    pub(crate) name: String,
    /// Project file; `None` if it does not exist or is broken.
    pub(crate) project: Option<ProjectVersion>,
    /// Bytes of the project file.
    pub(crate) manifest: Option<&'t [u8]>,
    /// Program files by their path below the folder, in lower case.
    pub(crate) programs: BTreeMap<String, SourceFile<'t>>,
    /// Data files, with the same kind of key.
    pub(crate) data: BTreeMap<String, SourceFile<'t>>,
}

impl<'t> Application<'t> {
    /// Returns the folder of the files.
    pub(crate) fn folder(&self) -> &Utf8Path {
        if self.manifest.is_some() { self.path.parent().unwrap_or(Utf8Path::new("")) } else { &self.path }
    }

    /// Returns the data files in use with their keys: the listed files in the order of the project file, or all files
    /// without a project file.
    pub(crate) fn data_files(&self) -> Vec<(&str, &SourceFile<'t>)> {
        let all = self.data.iter().map(|(key, file)| (key.as_str(), file));
        match &self.project {
            Some(project) => {
                project.manifest.data.iter().filter_map(|reference| self.listed_data_file(reference)).collect()
            }
            None => all.collect(),
        }
    }

    fn listed_data_file(&self, reference: &SmolStr) -> Option<(&str, &SourceFile<'t>)> {
        let path = path_key(file_in(self.folder(), reference).as_str());
        let (key, file) = self.data.iter().find(|(_, file)| path_key(file.path.as_str()) == path)?;
        Some((key, file))
    }

    /// Returns the listed program and data files: path in lower case, and reference in the project file.
    fn listed(&self) -> BTreeMap<String, String> {
        let manifest = self.project.as_ref().map(|project| &project.manifest);
        let references = manifest.into_iter().flat_map(|manifest| manifest.programs.iter().chain(&manifest.data));
        let path = |reference: &str| path_key(file_in(self.folder(), reference).as_str());
        references.map(|reference| (path(reference), reference.to_string())).collect()
    }
}

/// Returns the applications of a tree, sorted by path.
pub(crate) fn applications<'t>(files: &TreeFiles<'t>) -> Vec<Application<'t>> {
    let projects = files.iter().filter(|(path, _)| has_extension(path, &["pjx"]));
    let mut found: Vec<Application<'t>> = projects.map(|(path, bytes)| application(path, bytes)).collect();
    let listed: Vec<BTreeMap<String, String>> = found.iter().map(Application::listed).collect();
    let mut by_folder: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (index, application) in found.iter().enumerate() {
        by_folder.entry(path_key(application.folder().as_str())).or_default().push(index);
    }
    let mut loose: BTreeMap<Utf8PathBuf, Application<'t>> = BTreeMap::new();
    for (path, bytes) in files.iter().filter(|(path, _)| has_extension(path, &["pgx", "dtx"])) {
        let candidates = path.ancestors().skip(1).find_map(|folder| by_folder.get(&path_key(folder.as_str())));
        let key = path_key(path.as_str());
        let lists = |index: &&usize| listed.get(**index).is_some_and(|listed| listed.contains_key(&key));
        let owner = candidates.and_then(|all| all.iter().find(lists).or(all.first()));
        let is_listed = owner.is_some_and(|owner| lists(&owner));
        let file = SourceFile { path: path.clone(), bytes, listed: is_listed };
        match owner.and_then(|owner| found.get_mut(*owner)) {
            Some(application) => add(application, file),
            None => add(loose.entry(folder(path).to_owned()).or_insert_with(|| of_folder(folder(path))), file),
        }
    }
    found.extend(loose.into_values().map(named_by_file));
    found
}

fn application<'t>(path: &Utf8Path, bytes: &'t [u8]) -> Application<'t> {
    let project = text_of(bytes).ok().and_then(|text| ProjectVersion::read(&text));
    let name = path.file_stem().unwrap_or("").to_owned();
    Application { path: path.to_owned(), name, project, manifest: Some(bytes), ..Application::default() }
}

fn of_folder<'t>(folder: &Utf8Path) -> Application<'t> {
    let name = folder.file_name().unwrap_or("").to_owned();
    Application { path: folder.to_owned(), name, ..Application::default() }
}

/// Names an application without a folder name after its only file.
fn named_by_file(mut application: Application<'_>) -> Application<'_> {
    let mut files = application.programs.values().chain(application.data.values());
    let only = files.next().filter(|_| files.next().is_none()).and_then(|file| file.path.file_name());
    if let Some(name) = only.filter(|_| application.name.is_empty()) {
        application.name = name.to_owned();
    }
    application
}

fn folder(path: &Utf8Path) -> &Utf8Path {
    path.parent().unwrap_or(Utf8Path::new(""))
}

fn add<'t>(application: &mut Application<'t>, file: SourceFile<'t>) {
    let inner = file.path.strip_prefix(application.folder()).unwrap_or(&file.path);
    let key = path_key(inner.as_str());
    let is_program = has_extension(&file.path, &["pgx"]);
    let files = if is_program { &mut application.programs } else { &mut application.data };
    files.insert(key, file);
}

/// Resolves a reference to a library or user type of the project in `folder`, in lower case. `Disk://` is the folder of
/// applications, which is the root of the tree.
pub(crate) fn target(folder: &Utf8Path, reference: &str) -> Option<String> {
    let roots = Roots { disk: Some("/".into()), others: Vec::new() };
    match project(&Utf8Path::new("/").join(folder), &roots, reference) {
        ResolvedPath::Path(path) => Some(path_key(path.as_str().trim_start_matches('/'))),
        ResolvedPath::Elsewhere => None,
    }
}

/// Returns files that project files list but that are not in the tree: path of the project file, and reference. A
/// project file without any other files is ignored.
pub(crate) fn missing(applications: &[Application<'_>], files: &TreeFiles<'_>) -> BTreeSet<(String, String)> {
    let known: BTreeSet<String> = files.keys().map(|path| path_key(path.as_str())).collect();
    let has_files = |application: &&Application<'_>| !application.programs.is_empty() || !application.data.is_empty();
    let mut missing = BTreeSet::new();
    for application in applications.iter().filter(has_files) {
        let listed = application.listed().into_iter().filter(|(path, _)| !known.contains(path));
        missing.extend(listed.map(|(_, reference)| (application.path.to_string(), reference)));
    }
    missing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::FileTree;

    /// Shows the programs, each with whether it is listed.
    fn shown(application: &Application<'_>) -> String {
        let programs = application.programs.iter().map(|(key, file)| format!("{key}:{}", file.listed));
        format!("{} {}", application.path, programs.collect::<Vec<_>>().join(" "))
    }

    #[test]
    fn files_belong_to_the_project_above_them() {
        let project = "<Project><Programs><Program file=\"START.pgx\"/><Program file=\"sub/x.pgx\"/></Programs>\
            <Database><Data file=\"gone.dtx\"/></Database></Project>";
        let tree = FileTree::new([
            ("a/a.pjx", project),
            ("a/start.pgx", ""),
            ("a/sub/x.pgx", ""),
            ("a/old.pgx", ""),
            ("b/b.pgx", ""),
        ]);
        let files = tree.files(true);
        let found = applications(&files);
        let shown: Vec<String> = found.iter().map(shown).collect();
        assert_eq!(shown, ["a/a.pjx old.pgx:false start.pgx:true sub/x.pgx:true", "b b.pgx:false"]);
        let missing: Vec<_> = missing(&found, &files).into_iter().collect();
        assert_eq!(missing, [("a/a.pjx".to_owned(), "gone.dtx".to_owned())]);
    }
}
