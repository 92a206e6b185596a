//! Files on the media as instructions reach them.

use val3_lang::ports::{Media, Time};
use val3_lang::values::Text;
use val3_vm::CYCLE;

use super::Devices;
use crate::event::What;
use crate::files::{self, ControllerPath, FileFault, LibraryPath, OpenMode, list};
use crate::sio::byte_of;

/// Time to find, create or delete something on a medium: a cycle, after which the run can be ended.
const ACCESS: Time = CYCLE;

/// Time to read from or write to an open file, without the bytes.
const TRANSFER: Time = 100_000;

/// Time for each byte: 4 MB in a second.
const PER_BYTE: Time = 250;

impl Devices {
    /// Charges the current instruction for a path on a medium and for the bytes read or written there.
    pub(super) fn access(&mut self, bytes: usize) {
        self.spend(ACCESS, bytes);
    }

    /// Charges the current instruction for bytes of an open file.
    fn transfer(&mut self, bytes: usize) {
        self.spend(TRANSFER, bytes);
    }

    fn spend(&mut self, time: Time, bytes: usize) {
        let bytes = PER_BYTE.saturating_mul(bytes as Time);
        self.elapsed = self.elapsed.saturating_add(time).saturating_add(bytes);
    }
}

impl Media for Devices {
    fn delete_library(&mut self, from: &str, path: &str) -> u16 {
        self.access(0);
        let library = controller_path(from, path).and_then(|path| LibraryPath::new(&path));
        let code = library.and_then(|library| library.delete(&self.roots)).err().map_or(0, FileFault::code);
        self.record(What::Lib { op: "delete", alias: String::new(), path: path.to_owned(), code });
        code
    }

    fn list(&mut self, from: &str, path: &str) -> Option<Vec<String>> {
        self.access(0);
        list(&self.roots, &controller_path(from, path).ok()?).ok()
    }

    fn open_file(&mut self, from: &str, path: &str, mode: &str) -> Option<u8> {
        self.access(0);
        let (path, mode) = (controller_path(from, path).ok()?, OpenMode::parse(mode)?);
        let number = self.files.open(&self.roots, &path, mode).ok()?;
        u8::try_from(number).ok()
    }

    fn read_lines(&mut self, file: f64, most: usize) -> Vec<String> {
        let lines = number(file).map(|file| self.files.lines(file, most)).unwrap_or_default();
        self.transfer(lines.iter().map(String::len).sum());
        lines
    }

    fn read_bytes(&mut self, file: f64, most: usize) -> Vec<u8> {
        let bytes = number(file).map(|file| self.files.bytes(file, most)).unwrap_or_default();
        self.transfer(bytes.len());
        bytes
    }

    fn write_lines(&mut self, file: f64, lines: &[Text]) -> usize {
        self.transfer(lines.iter().map(|line| line.as_str().len()).sum());
        number(file).map_or(0, |file| self.files.write_lines(file, lines.iter().map(Text::as_str)))
    }

    fn write_bytes(&mut self, file: f64, numbers: &[f64]) -> usize {
        let bytes: Vec<u8> = numbers.iter().copied().map(byte_of).collect();
        self.transfer(bytes.len());
        number(file).map_or(0, |file| self.files.write_bytes(file, &bytes))
    }

    fn close_file(&mut self, file: f64) -> bool {
        self.transfer(0);
        number(file).is_some_and(|file| self.files.close(file).is_ok())
    }

    fn file_exists(&mut self, from: &str, path: &str) -> bool {
        self.access(0);
        controller_path(from, path).and_then(|path| files::file_exists(&self.roots, &path)).unwrap_or(false)
    }

    fn delete_file(&mut self, from: &str, path: &str) -> bool {
        self.access(0);
        controller_path(from, path).and_then(|path| files::delete(&self.roots, &path)).is_ok()
    }

    fn copy_file(&mut self, from: &str, source: &str, target: &str) -> bool {
        self.access(0);
        let (source, target) = (controller_path(from, source), controller_path(from, target));
        source.and_then(|source| files::copy(&self.roots, &source, &target?)).is_ok()
    }

    fn rename_file(&mut self, from: &str, old: &str, new: &str) -> bool {
        self.access(0);
        let (old, new) = (controller_path(from, old), controller_path(from, new));
        old.and_then(|old| files::rename(&self.roots, &old, &new?)).is_ok()
    }
}

/// A path as a program of the application or library at `from` means it.
pub(super) fn controller_path(from: &str, path: &str) -> Result<ControllerPath, FileFault> {
    let from = ControllerPath::parse(from, &ControllerPath::root("Disk"))?;
    let is_file = from.has_extension("pjx") || from.has_extension("zip");
    ControllerPath::parse(path, &if is_file { from.parent() } else { from })
}

/// The number of a file; a number that is none is that of no file.
fn number(file: f64) -> Option<usize> {
    let rounded = (file + 0.5).floor();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let number = (0.0..256.0).contains(&rounded).then_some(rounded as usize);
    number
}
