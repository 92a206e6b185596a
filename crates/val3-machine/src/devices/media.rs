//! Files on the media as instructions reach them.

use val3_lang::ports::{Media, Time};
use val3_lang::values::Text;
use val3_vm::CYCLE;

use super::Devices;
use super::outside::Media as OutsideMedia;
use crate::event::EventKind;
use crate::files::{self, ControllerPath, FileFault, LibraryPath, OpenFiles, OpenMode, list};
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

    /// Does something with an open file; the default answer for a number of no file.
    fn of_file<T: Clone + Default + 'static>(&mut self, file: f64, act: impl FnOnce(&mut OpenFiles, usize) -> T) -> T {
        number(file).map(|file| self.outside.ask(|media| act(&mut media.files, file))).unwrap_or_default()
    }

    fn on_media<T: Clone + 'static>(
        &mut self,
        act: impl FnOnce(&mut OutsideMedia) -> Result<T, FileFault>,
    ) -> Result<T, FileFault> {
        self.outside.ask(act)
    }

    fn spend(&mut self, time: Time, bytes: usize) {
        let bytes = PER_BYTE.saturating_mul(bytes as Time);
        self.state.elapsed = self.state.elapsed.saturating_add(time).saturating_add(bytes);
    }
}

impl Media for Devices {
    fn delete_library(&mut self, from: &str, path: &str) -> u16 {
        self.access(0);
        let library = controller_path(from, path).and_then(|path| LibraryPath::new(&path));
        let deleted = library.and_then(|library| self.outside.ask(|media| library.delete(&media.roots)));
        let code = deleted.err().map_or(0, FileFault::code);
        self.record(EventKind::Lib { op: "delete", alias: String::new(), path: path.to_owned(), code });
        code
    }

    fn list(&mut self, from: &str, path: &str) -> Option<Vec<String>> {
        self.access(0);
        let path = controller_path(from, path).ok()?;
        self.outside.ask(|media| list(&media.roots, &path).ok())
    }

    fn open_file(&mut self, from: &str, path: &str, mode: &str) -> Option<u8> {
        self.access(0);
        let (path, mode) = (controller_path(from, path).ok()?, OpenMode::parse(mode)?);
        let number = self.outside.ask(|media| media.files.open(&media.roots, &path, mode)).ok()?;
        u8::try_from(number).ok()
    }

    fn read_lines(&mut self, file: f64, most: usize) -> Vec<String> {
        let lines = self.of_file(file, |files, file| files.lines(file, most));
        self.transfer(lines.iter().map(String::len).sum());
        lines
    }

    fn read_bytes(&mut self, file: f64, most: usize) -> Vec<u8> {
        let bytes = self.of_file(file, |files, file| files.bytes(file, most));
        self.transfer(bytes.len());
        bytes
    }

    fn write_lines(&mut self, file: f64, lines: &[Text]) -> usize {
        self.transfer(lines.iter().map(|line| line.as_str().len()).sum());
        self.of_file(file, |files, file| files.write_lines(file, lines.iter().map(Text::as_str)))
    }

    fn write_bytes(&mut self, file: f64, numbers: &[f64]) -> usize {
        let bytes: Vec<u8> = numbers.iter().copied().map(byte_of).collect();
        self.transfer(bytes.len());
        self.of_file(file, |files, file| files.write_bytes(file, &bytes))
    }

    fn close_file(&mut self, file: f64) -> bool {
        self.transfer(0);
        self.of_file(file, |files, file| files.close(file).is_ok())
    }

    fn file_exists(&mut self, from: &str, path: &str) -> bool {
        self.access(0);
        self.on_media(|media| files::file_exists(&media.roots, &controller_path(from, path)?)).unwrap_or(false)
    }

    fn delete_file(&mut self, from: &str, path: &str) -> bool {
        self.access(0);
        self.on_media(|media| files::delete(&media.roots, &controller_path(from, path)?)).is_ok()
    }

    fn copy_file(&mut self, from: &str, source: &str, target: &str) -> bool {
        self.access(0);
        let path = |path| controller_path(from, path);
        self.on_media(|media| files::copy(&media.roots, &path(source)?, &path(target)?)).is_ok()
    }

    fn rename_file(&mut self, from: &str, old: &str, new: &str) -> bool {
        self.access(0);
        let path = |path| controller_path(from, path);
        self.on_media(|media| files::rename(&media.roots, &path(old)?, &path(new)?)).is_ok()
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
