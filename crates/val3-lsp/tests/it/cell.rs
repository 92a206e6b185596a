//! A cell on the disk, written from a listing.

use tempfile::TempDir;
use val3_test::Fixture;

/// A folder that exists until the end of the test.
pub struct Cell {
    folder: TempDir,
    fixture: Fixture,
}

impl Cell {
    pub fn new(listing: &str) -> Self {
        let cell = Self { folder: tempfile::tempdir().unwrap(), fixture: Fixture::parse(listing).with_stops() };
        for (path, text) in &cell.fixture.files {
            cell.write(path, text);
        }
        cell
    }

    /// Controller folder.
    pub fn folder(&self) -> String {
        self.path("")
    }

    /// Path of a file, given relative to the controller (`usrapp/main/start.pgx`).
    pub fn path(&self, file: &str) -> String {
        let folder = self.folder.path().canonicalize().unwrap().join("usr");
        folder.join(file).to_str().unwrap().trim_end_matches('/').to_owned()
    }

    pub fn text(&self, file: &str) -> &str {
        self.fixture.text(file)
    }

    pub fn write(&self, file: &str, text: &str) {
        self.write_bytes(file, text.as_bytes());
    }

    pub fn write_bytes(&self, file: &str, bytes: &[u8]) {
        let path = self.folder.path().join("usr").join(file);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }

    /// Moves a file or folder.
    pub fn rename(&self, from: &str, to: &str) {
        let folder = self.folder.path().join("usr");
        std::fs::rename(folder.join(from), folder.join(to)).unwrap();
    }

    pub fn remove_folder(&self, folder: &str) {
        std::fs::remove_dir_all(self.folder.path().join("usr").join(folder)).unwrap();
    }

    pub fn remove(&self, file: &str) {
        std::fs::remove_file(self.folder.path().join("usr").join(file)).unwrap();
    }
}

/// Line and column at which `part` starts in a text.
pub fn place(text: &str, part: &str) -> (u32, u32) {
    let at = text.find(part).unwrap_or_else(|| panic!("{part:?} is not in {text}"));
    let before = &text[..at];
    let line = before.matches('\n').count();
    let column = before.rsplit('\n').next().unwrap().encode_utf16().count();
    (u32::try_from(line).unwrap(), u32::try_from(column).unwrap())
}
