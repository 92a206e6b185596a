//! A cell as in an editor: files that are changed as values.

use camino::Utf8PathBuf;
use val3_analysis::db::{Database, File, FileRange, FileStatus, Sources};
use val3_analysis::items::parse;
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_check::rule::Severity;
use val3_check::settings::WorkspaceSettings;
use val3_check::{check_unit, units};
use val3_ide::{FileEdit, SourceChange};
use val3_syntax::{SyntaxKind, SyntaxNode, SyntaxToken};
use val3_tests::cell::Cell;

/// A name that no example contains.
pub(crate) const UNKNOWN: &str = "zUnknown";

/// The files of a cell, and their analysis.
pub(crate) struct Editor {
    cell: Cell,
    workspace: Workspace,
}

impl Editor {
    /// Reads the files.
    pub(crate) fn open(cell: &Cell) -> Self {
        let files = cell.iter().map(|(path, bytes)| (Utf8PathBuf::from("/").join(path), bytes.clone()));
        let workspace = load(&Memory::new(files), &[Utf8PathBuf::from("/")]).unwrap();
        Self { cell: cell.clone(), workspace }
    }

    pub(crate) fn db(&self) -> &Database {
        &self.workspace.db
    }

    /// Returns the tokens of all code except whitespace and comments, file by file.
    pub(crate) fn tokens(&self) -> Vec<String> {
        let skipped = [SyntaxKind::WHITESPACE, SyntaxKind::NEWLINE, SyntaxKind::COMMENT];
        let of_file = |file: File| texts_of(&self.tree(file), |kind| !skipped.contains(&kind));
        self.files().into_iter().flat_map(of_file).collect()
    }

    /// Returns the files, by path.
    pub(crate) fn files(&self) -> Vec<File> {
        let mut files: Vec<File> = Sources::get(self.db()).files(self.db()).values().copied().collect();
        files.sort_by_key(|file| file.path(self.db()).clone());
        files
    }

    pub(crate) fn tree(&self, file: File) -> SyntaxNode {
        parse(self.db(), file).root()
    }

    /// Returns the errors of all projects, without locations, sorted.
    pub(crate) fn errors(&self) -> Vec<String> {
        let settings = WorkspaceSettings::default();
        let checked = units(self.db(), &self.workspace.projects).into_iter();
        let found = checked.flat_map(|unit| check_unit(self.db(), unit, &settings).findings);
        let errors = found.filter(|found| found.severity == Severity::Error);
        let mut errors: Vec<String> = errors
            .map(|found| format!("{} {}: {}", found.rule.code, found.place.file.path(self.db()), found.message))
            .collect();
        errors.sort();
        errors
    }

    /// Returns the files after a change.
    pub(crate) fn after(&self, change: &SourceChange) -> Cell {
        let mut cell = self.cell.clone();
        for (path, text) in &change.creates {
            let path = path.as_str().trim_start_matches('/').to_owned();
            assert!(cell.iter().all(|(known, _)| *known != path), "{path} is there already");
            cell.push((path, text.clone().into_bytes()));
        }
        for (file, text) in self.texts(change) {
            let FileStatus::Read { encoding, .. } = file.status(self.db()) else { panic!("an unread file changes") };
            let path = file.path(self.db()).as_str().trim_start_matches('/').to_owned();
            let (_, bytes) = cell.iter_mut().find(|(known, _)| *known == path).unwrap();
            *bytes = encoding.encode(&text);
        }
        cell
    }

    /// Returns the new texts of the files that a change edits.
    fn texts(&self, change: &SourceChange) -> Vec<(File, String)> {
        let edited = self.files().into_iter().filter(|file| change.edits.iter().any(|edit| edit.file == *file));
        let text = |file: File| {
            let edits: Vec<_> = change.edits.iter().filter(|edit| edit.file == file).collect();
            let apart = edits.windows(2).all(|pair| pair[0].range.end() <= pair[1].range.start());
            assert!(apart, "edits overlap: {edits:?}");
            let mut text = file.text(self.db()).to_string();
            edits
                .iter()
                .rev()
                .for_each(|edit| text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text));
            (file, text)
        };
        edited.map(text).collect()
    }

    /// Whether a name in the code starts at a range.
    pub(crate) fn is_name(&self, place: FileRange) -> bool {
        self.token(place).kind() == SyntaxKind::IDENT
    }

    fn token(&self, place: FileRange) -> SyntaxToken {
        self.tree(place.file).token_at_offset(place.range.start()).right_biased().unwrap()
    }

    /// Returns the cell with an unknown name in place of the name at a range.
    pub(crate) fn with_unknown_name(&self, place: FileRange) -> Self {
        let edit = FileEdit { file: place.file, range: self.token(place).text_range(), text: UNKNOWN.to_owned() };
        Self::open(&self.after(&SourceChange { edits: vec![edit], ..SourceChange::default() }))
    }

    /// Returns the same range in this editor's file with the same path as in `other`.
    pub(crate) fn same_place(&self, other: &Self, place: FileRange) -> FileRange {
        let path = place.file.path(other.db());
        let file = self.files().into_iter().find(|file| file.path(self.db()) == path).unwrap();
        FileRange { file, ..place }
    }
}

/// Returns the texts of all tokens whose kind is wanted.
fn texts_of(tree: &SyntaxNode, wanted: impl Fn(SyntaxKind) -> bool) -> Vec<String> {
    let tokens = tree.descendants_with_tokens().filter_map(|element| element.into_token());
    tokens.filter(|token| wanted(token.kind())).map(|token| token.text().trim().to_owned()).collect()
}

/// Whether the kind is a statement.
pub(crate) fn is_stmt(kind: SyntaxKind) -> bool {
    use SyntaxKind as K;
    matches!(
        kind,
        K::IF_STMT
            | K::WHILE_STMT
            | K::DO_STMT
            | K::FOR_STMT
            | K::SWITCH_STMT
            | K::CALL_STMT
            | K::TASK_CREATE_STMT
            | K::PRINT_STMT
            | K::ASSIGN_STMT
            | K::EXPR_STMT
    )
}
