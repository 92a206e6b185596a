//! Files and libraries on the media of the controller (6.6, and the file add-on).
//!
//! `from` is the path of the application or library whose program calls: a path that begins with `./` begins there.

use crate::values::Text;

/// The media of the controller.
pub trait MediaPort {
    /// `libDelete`: its code.
    fn delete_library(&mut self, from: &str, path: &str) -> u16;

    /// The entries of a folder, by name; `None` if it cannot be read.
    fn list(&mut self, from: &str, path: &str) -> Option<Vec<String>>;

    /// Opens a file for `mode` (`r`, `w`, `a`); its number, `None` where that is not possible.
    fn open_file(&mut self, from: &str, path: &str, mode: &str) -> Option<u8>;

    /// Reads at most `most` lines of an open file; fewer at its end.
    fn read_lines(&mut self, file: f64, most: usize) -> Vec<String>;

    /// Reads at most `most` bytes of an open file; fewer at its end.
    fn read_bytes(&mut self, file: f64, most: usize) -> Vec<u8>;

    /// Writes lines to an open file; how many it took.
    fn write_lines(&mut self, file: f64, lines: &[Text]) -> usize;

    /// Writes a byte for each number to an open file, the nearest whole one modulo 256; how many it took.
    fn write_bytes(&mut self, file: f64, numbers: &[f64]) -> usize;

    /// Closes an open file; `false` where there is none, or where not all of it could be written.
    fn close_file(&mut self, file: f64) -> bool;

    /// There is a file.
    fn file_exists(&mut self, from: &str, path: &str) -> bool;

    /// Deletes a file or folder; whether that was possible.
    fn delete_file(&mut self, from: &str, path: &str) -> bool;

    /// Copies a file or folder; whether that was possible.
    fn copy_file(&mut self, from: &str, source: &str, target: &str) -> bool;

    /// Moves a file or folder; whether that was possible.
    fn rename_file(&mut self, from: &str, old: &str, new: &str) -> bool;
}
