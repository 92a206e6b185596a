//! A cell with its findings, whose program signatures are changed.

use std::collections::BTreeMap;
use std::sync::Arc;

use camino::Utf8PathBuf;
use salsa::Setter as _;
use val3_analysis::db::{Database, File, Sources};
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_ide::{CheckSettings, SourceChange, Variables, project_diagnostics, variables};

/// Files of a cell in one database. Only the queries that a change affects run again.
pub(crate) struct ChangedCell {
    workspace: Workspace,
    settings: CheckSettings,
}

impl ChangedCell {
    /// Reads files with absolute paths.
    pub(crate) fn open(files: impl Iterator<Item = (Utf8PathBuf, Vec<u8>)>) -> Self {
        let workspace = load(&Memory::new(files), &[Utf8PathBuf::from("/")]).unwrap();
        let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &RuleSelection::default()).unwrap();
        let settings = CheckSettings::new(&workspace.db, settings);
        Self { workspace, settings }
    }

    pub(crate) fn db(&self) -> &Database {
        &self.workspace.db
    }

    /// Returns the programs that are called only by programs, with their variables, by path.
    pub(crate) fn programs(&self) -> Vec<(File, Variables)> {
        let mut files: Vec<File> = Sources::get(self.db()).files(self.db()).values().copied().collect();
        files.sort_by_key(|file| file.path(self.db()).clone());
        let found = files.into_iter().filter_map(|file| Some((file, variables(self.db(), file)?)));
        found.filter(|(_, found)| found.fixed.is_none() && !found.program.is_empty()).collect()
    }

    /// Counts the findings without locations. Findings that contain the name `without` are omitted; if it is the new
    /// name of `renamed`, they are counted with the old name instead.
    pub(crate) fn findings(&self, without: &str, renamed: Option<&str>) -> BTreeMap<String, usize> {
        let (db, projects) = (self.db(), &self.workspace.projects);
        let found = projects.iter().flat_map(|project| project_diagnostics(db, self.settings, projects, *project));
        let mut counts = BTreeMap::new();
        for found in found {
            let path = found.place.file.path(db);
            let message = renamed.map_or(found.message.clone(), |old| found.message.replace(without, old));
            if renamed.is_some() || !message.contains(&format!("`{without}`")) {
                *counts.entry(format!("{} {path} {message}", found.rule.code)).or_default() += 1;
            }
        }
        counts
    }

    /// Applies a change. Returns the previous texts.
    pub(crate) fn apply(&mut self, change: &SourceChange) -> Vec<(File, Arc<str>)> {
        let mut texts: BTreeMap<Utf8PathBuf, (File, String)> = BTreeMap::new();
        for edit in change.edits.iter().rev() {
            let path = edit.file.path(self.db()).clone();
            let text = edit.file.text(self.db()).to_string();
            let (_, text) = texts.entry(path).or_insert((edit.file, text));
            text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
        }
        let mut before = Vec::new();
        for (file, text) in texts.into_values() {
            before.push((file, Arc::clone(file.text(self.db()))));
            file.set_text(&mut self.workspace.db).to(Arc::from(text));
        }
        before
    }

    /// Restores the previous texts of files.
    pub(crate) fn restore(&mut self, before: Vec<(File, Arc<str>)>) {
        for (file, text) in before {
            file.set_text(&mut self.workspace.db).to(text);
        }
    }
}
