//! Test support: a listing with the cursor at `$0`.

use camino::Utf8PathBuf;
use val3_analysis::db::{Database, Db, File, FileRange, Sources};
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_syntax::{TextRange, TextSize};
use val3_test::{Fixture, ROOT};

use crate::FilePosition;

/// Database of a listing, and the position of `$0` if it exists.
pub(crate) struct MarkedListing {
    pub(crate) system: Memory,
    pub(crate) workspace: Workspace,
    pub(crate) position: Option<FilePosition>,
    /// Range between two `$0`.
    pub(crate) selected: Option<TextRange>,
}

impl MarkedListing {
    pub(crate) fn new(listing: &str) -> Self {
        let mut fixture = Fixture::parse(listing);
        let mut cursor = None;
        for (path, text) in &mut fixture.files {
            while let Some(offset) = text.find("$0") {
                text.replace_range(offset..offset + 2, "");
                let first = cursor.take().map_or(offset, |(_, first, _)| first);
                cursor = Some((path.clone(), first, offset));
            }
        }
        let files = fixture.files.iter().map(|(path, text)| (full(path), text.clone().into_bytes()));
        let system = Memory::new(files);
        let workspace = load(&system, &[Utf8PathBuf::from(ROOT)]).unwrap();
        let size = |at: usize| TextSize::try_from(at).unwrap();
        let selected = cursor.as_ref().map(|(_, first, last)| TextRange::new(size(*first), size(*last)));
        let position =
            cursor.map(|(path, first, _)| FilePosition { file: file(&workspace.db, &path), offset: size(first) });
        Self { system, workspace, position, selected: selected.filter(|range| !range.is_empty()) }
    }

    pub(crate) fn db(&self) -> &Database {
        &self.workspace.db
    }

    /// Position of `$0`.
    pub(crate) fn at(&self) -> FilePosition {
        self.position.unwrap()
    }
}

fn full(path: &str) -> Utf8PathBuf {
    Utf8PathBuf::from(format!("{ROOT}/{path}"))
}

fn file(db: &dyn Db, path: &str) -> File {
    let wanted = full(path);
    *Sources::get(db).files(db).values().find(|file| *file.path(db) == wanted).unwrap()
}

/// Formats a location, for example `main/start.pgx:5 nCount`.
pub(crate) fn shown(db: &dyn Db, place: FileRange) -> String {
    let text = place.file.text(db);
    let range = std::ops::Range::<usize>::from(place.range);
    let line = 1 + text[..range.start].matches('\n').count();
    let path = place.file.path(db).strip_prefix(ROOT).unwrap_or(place.file.path(db)).to_string();
    let path = path.strip_prefix("usrapp/").unwrap_or(&path);
    format!("{path}:{line} {}", &text[range])
}

/// Like [`shown`], one line for each location.
pub(crate) fn shown_all(db: &dyn Db, places: impl IntoIterator<Item = FileRange>) -> String {
    places.into_iter().map(|place| shown(db, place) + "\n").collect()
}
