//! Files and libraries on the media of the controller (6.6, and the file add-on).
//!
//! `from` is the path of the calling application or library, to which paths with `./` are relative.

use crate::values::Text;

/// Media of the controller.
pub trait MediaPort {
    /// Deletes a library and returns the code of `libDelete`.
    fn delete_library(&mut self, from: &str, path: &str) -> u16;

    /// Returns a folder's entries, sorted by name; `None` if it cannot be read.
    fn list(&mut self, from: &str, path: &str) -> Option<Vec<String>>;

    /// Opens a file in `mode` (`r`, `w`, `a`) and returns its number; `None` if it cannot be opened.
    fn open_file(&mut self, from: &str, path: &str, mode: &str) -> Option<u8>;

    /// Reads at most `most` lines from an open file.
    fn read_lines(&mut self, file: f64, most: usize) -> Vec<String>;

    /// Reads at most `most` bytes from an open file.
    fn read_bytes(&mut self, file: f64, most: usize) -> Vec<u8>;

    /// Writes lines to an open file and returns the number of written lines.
    fn write_lines(&mut self, file: f64, lines: &[Text]) -> usize;

    /// Writes a byte for each number to an open file, the nearest integer modulo 256, and returns the number of written
    /// bytes.
    fn write_bytes(&mut self, file: f64, numbers: &[f64]) -> usize;

    /// Closes an open file; `false` if the file is not open or not all data could be written.
    fn close_file(&mut self, file: f64) -> bool;

    /// Whether the file exists.
    fn file_exists(&mut self, from: &str, path: &str) -> bool;

    /// Deletes a file or folder; `false` if it fails.
    fn delete_file(&mut self, from: &str, path: &str) -> bool;

    /// Copies a file or folder; `false` if it fails.
    fn copy_file(&mut self, from: &str, source: &str, target: &str) -> bool;

    /// Moves a file or folder; `false` if it fails.
    fn rename_file(&mut self, from: &str, old: &str, new: &str) -> bool;
}
