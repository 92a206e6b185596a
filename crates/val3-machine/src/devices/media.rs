//! Access of instructions to files on the media.

use val3_lang::ports::MediaPort;
use val3_lang::values::Text;

use super::Devices;
use super::outside::controller_path;
use crate::controller_state::MessageSeverity;
use crate::event::EventKind;
use crate::files::{self, FileFault, LibraryPath, OpenMode, list};
use crate::sio::byte_of;

impl Devices {
    /// Returns `result`, which comes from an instruction that may change files. If a change did not fit into memory,
    /// reports this in the event log.
    pub(super) fn reported<T>(&mut self, result: T) -> T {
        if self.outside.take_overflow() {
            let limit = self.limits.changed >> 20;
            let text = format!(
                "the files that the program has changed in this debugged run take more than {limit} MB: nothing more is written"
            );
            self.report_here(&text, MessageSeverity::Error);
        }
        result
    }
}

impl MediaPort for Devices {
    fn delete_library(&mut self, from: &str, path: &str) -> u16 {
        self.state.media_cost.access(0);
        let library = controller_path(from, path).and_then(|path| LibraryPath::new(&path));
        let deleted = library.and_then(|library| self.outside.ask(|media| library.delete(&media.roots)));
        let code = deleted.err().map_or(0, FileFault::code);
        self.record(EventKind::Lib { op: "delete", alias: String::new(), path: path.to_owned(), code });
        code
    }

    fn list(&mut self, from: &str, path: &str) -> Option<Vec<String>> {
        self.state.media_cost.access(0);
        let path = controller_path(from, path).ok()?;
        self.outside.ask(|media| list(&media.roots, &path).ok())
    }

    fn open_file(&mut self, from: &str, path: &str, mode: &str) -> Option<u8> {
        self.state.media_cost.access(0);
        let (path, mode) = (controller_path(from, path).ok()?, OpenMode::parse(mode)?);
        let number = self.outside.ask(|media| media.files.open(&media.roots, &path, mode));
        let number = self.reported(number).ok()?;
        u8::try_from(number).ok()
    }

    fn read_lines(&mut self, file: f64, most: usize) -> Vec<String> {
        let lines = self.outside.of_file(file, |files, file| files.lines(file, most));
        self.state.media_cost.transfer(lines.iter().map(String::len).sum());
        lines
    }

    fn read_bytes(&mut self, file: f64, most: usize) -> Vec<u8> {
        let bytes = self.outside.of_file(file, |files, file| files.bytes(file, most));
        self.state.media_cost.transfer(bytes.len());
        bytes
    }

    fn write_lines(&mut self, file: f64, lines: &[Text]) -> usize {
        self.state.media_cost.transfer(lines.iter().map(|line| line.as_str().len()).sum());
        let written = self.outside.of_file(file, |files, file| files.write_lines(file, lines.iter().map(Text::as_str)));
        self.reported(written)
    }

    fn write_bytes(&mut self, file: f64, numbers: &[f64]) -> usize {
        let bytes: Vec<u8> = numbers.iter().copied().map(byte_of).collect();
        self.state.media_cost.transfer(bytes.len());
        let written = self.outside.of_file(file, |files, file| files.write_bytes(file, &bytes));
        self.reported(written)
    }

    fn close_file(&mut self, file: f64) -> bool {
        self.state.media_cost.transfer(0);
        self.outside.of_file(file, |files, file| files.close(file).is_ok())
    }

    fn file_exists(&mut self, from: &str, path: &str) -> bool {
        self.state.media_cost.access(0);
        self.outside.ask(|media| files::file_exists(&media.roots, &controller_path(from, path)?)).unwrap_or(false)
    }

    fn delete_file(&mut self, from: &str, path: &str) -> bool {
        self.state.media_cost.access(0);
        self.outside.ask(|media| files::delete(&media.roots, &controller_path(from, path)?)).is_ok()
    }

    fn copy_file(&mut self, from: &str, source: &str, target: &str) -> bool {
        self.state.media_cost.access(0);
        let path = |path| controller_path(from, path);
        let copied = self.outside.ask(|media| files::copy(&media.roots, &path(source)?, &path(target)?)).is_ok();
        self.reported(copied)
    }

    fn rename_file(&mut self, from: &str, old: &str, new: &str) -> bool {
        self.state.media_cost.access(0);
        let path = |path| controller_path(from, path);
        let renamed = self.outside.ask(|media| files::rename(&media.roots, &path(old)?, &path(new)?)).is_ok();
        self.reported(renamed)
    }
}
