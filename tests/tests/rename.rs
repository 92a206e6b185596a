//! Every name in the example cell is renamed: nothing changes for the programs, and the inverse rename restores every
//! byte.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail loudly")]

use std::collections::BTreeMap;
use std::sync::Arc;

use camino::Utf8PathBuf;
use salsa::Setter;
use val3_analysis::db::{Db, File, FileStatus, Project, Sources};
use val3_analysis::load::{Workspace, load};
use val3_analysis::occurrences::{Symbol, Usage, occurrences};
use val3_analysis::system::Memory;
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_check::{check_unit, finish, units};
use val3_ide::{FilePosition, SourceChange, prepare_rename, projects_of, rename};
use val3_syntax::TextSize;
use val3_tests::cell;

type Files = BTreeMap<Utf8PathBuf, Vec<u8>>;

/// A cell as in an editor, with the files that belong to no project.
struct Editor {
    workspace: Workspace,
    others: Files,
}

impl Editor {
    fn open(files: Files) -> Self {
        let system = Memory::new(files.clone());
        let workspace = load(&system, &[Utf8PathBuf::from("/")]).unwrap();
        Self { workspace, others: files }
    }

    fn db(&self) -> &dyn Db {
        &self.workspace.db
    }

    fn opened(&self) -> Vec<File> {
        let db = self.db();
        let mut files: Vec<File> = Sources::get(db).files(db).values().copied().collect();
        files.sort_by_key(|file| file.path(db).clone());
        files
    }

    fn file(&self, path: &Utf8PathBuf) -> File {
        *self.opened().iter().find(|file| file.path(self.db()) == path).unwrap()
    }

    /// Returns every file with its bytes.
    fn files(&self) -> Files {
        let db = self.db();
        let mut files = self.others.clone();
        for file in self.opened() {
            if let FileStatus::Read { encoding, .. } = file.status(db) {
                files.insert(file.path(db).clone(), encoding.encode(file.text(db)));
            }
        }
        files
    }

    fn apply(&mut self, change: &SourceChange) {
        let mut texts: BTreeMap<Utf8PathBuf, (File, String)> = BTreeMap::new();
        for edit in change.edits.iter().rev() {
            let path = edit.file.path(self.db()).clone();
            let text = edit.file.text(self.db()).to_string();
            let (_, text) = texts.entry(path).or_insert((edit.file, text));
            text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
        }
        for (file, text) in texts.into_values() {
            file.set_text(&mut self.workspace.db).to(Arc::from(text));
        }
        if !change.moves.is_empty() {
            let mut files = self.files();
            for (from, to) in &change.moves {
                let bytes = files.remove(from).unwrap();
                files.insert(to.clone(), bytes);
            }
            *self = Self::open(files);
        }
    }

    /// Returns the findings of `val3 check`: code, file, start of the line, message.
    fn findings(&self) -> Vec<String> {
        let db = self.db();
        let projects = &self.workspace.projects;
        let units = units(db, projects);
        let settings = WorkspaceSettings::new(db, projects, &RuleSelection::default()).unwrap();
        let checked = units.iter().map(|unit| check_unit(db, *unit, &settings)).sum();
        let shown = |found: &val3_check::diagnostic::Diagnostic| {
            let text = found.place.file.text(db);
            let line = text[..usize::from(found.place.range.start())].matches('\n').count();
            format!("{} {}:{line} {}", found.rule.code, found.place.file.path(db), found.message)
        };
        let mut findings: Vec<String> = finish(db, &units, &settings, checked).findings.iter().map(shown).collect();
        findings.sort();
        findings
    }

    /// Returns every declared name once, with the declaration's location.
    fn names(&self) -> Vec<(Utf8PathBuf, TextSize, Symbol)> {
        let db = self.db();
        let mut names = Vec::new();
        for file in self.opened() {
            let projects: &[Project] = projects_of(db, file);
            let declared = projects.iter().flat_map(|project| occurrences(db, *project, file));
            for name in declared.filter(|name| name.usage == Usage::Declaration) {
                names.push((file.path(db).clone(), name.range.start(), name.symbol.clone()));
            }
        }
        names
    }
}

fn example(name: &str) -> Editor {
    let files = cell::files(name).into_iter();
    Editor::open(files.map(|(path, bytes)| (Utf8PathBuf::from("/").join(path), bytes)).collect())
}

/// Renames each name to a new name and back. Returns the number of names, and the names that could not be renamed.
fn there_and_back(name: &str) -> (usize, Vec<String>) {
    let mut editor = example(name);
    let before = editor.files();
    let findings = editor.findings();
    let mut refused = Vec::new();
    let mut renamed = 0;
    for (path, offset, symbol) in editor.names() {
        let at = FilePosition { file: editor.file(&path), offset };
        let Ok((_, old)) = prepare_rename(editor.db(), at) else {
            refused.push(format!("{}: {symbol:?}", path.file_name().unwrap()));
            continue;
        };
        let new = format!("zq{renamed}");
        let change = rename(editor.db(), at, &new).unwrap_or_else(|error| panic!("{path} {old}: {}", error.0));
        assert!(!change.edits.is_empty(), "{path} {old}");
        let there = offset_after(&change, at);
        editor.apply(&change);
        let now: Vec<String> = editor.findings().iter().map(|finding| finding.replace(&new, &old)).collect();
        assert_eq!(now, findings, "{path} {old}");
        // A program whose file was moved is declared in the file with the new name.
        let moved = change.moves.iter().find(|(from, _)| *from == path).map_or(&path, |(_, to)| to);
        let at = FilePosition { file: editor.file(moved), offset: there };
        let back = rename(editor.db(), at, &old).unwrap_or_else(|error| panic!("{path} {new}: {}", error.0));
        editor.apply(&back);
        let after = editor.files();
        let differs: Vec<&Utf8PathBuf> =
            after.iter().filter(|(path, bytes)| before.get(*path) != Some(*bytes)).map(|(path, _)| path).collect();
        assert!(differs.is_empty() && after.len() == before.len(), "{path} {old}: {differs:?}");
        renamed += 1;
    }
    (renamed, refused)
}

/// Returns the offset of a position after a change of other text in its file.
fn offset_after(change: &SourceChange, at: FilePosition) -> TextSize {
    let before = change.edits.iter().filter(|edit| edit.file == at.file && edit.range.end() <= at.offset);
    before.fold(at.offset, |offset, edit| offset + TextSize::of(&edit.text) - edit.range.len())
}

#[test]
fn every_name_of_the_palletiser_can_be_renamed() {
    let (renamed, refused) = there_and_back("palletiser");
    assert!(renamed > 150, "{renamed}");
    let is_task = |(_, _, symbol): &(_, _, Symbol)| matches!(symbol, Symbol::Task(..));
    assert!(example("palletiser").names().iter().any(is_task), "tasks are renamed as well");
    assert!(refused.iter().all(|name| name.starts_with("start.pgx") || name.starts_with("stop.pgx")), "{refused:#?}");
}

#[test]
fn every_name_of_the_sorter_can_be_renamed() {
    let (renamed, _) = there_and_back("faulty");
    assert!(renamed >= 30, "{renamed}");
}
