//! Output files of a command, which may also be devices and pipes such as `/dev/stdout`.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};

use camino::Utf8Path;

use crate::{NewFile, Unwritable};

/// Output that must be complete at the end of the command. A file appears only when the output is committed.
#[derive(Debug)]
pub enum OutputFile {
    /// A file.
    File(NewFile),
    /// A device or pipe, which receives the output while it is written.
    Stream(File),
}

impl OutputFile {
    /// Starts the output.
    ///
    /// # Errors
    /// Like [`NewFile::create`].
    pub fn open(path: &Utf8Path) -> Result<Self, Unwritable> {
        if is_stream(path) { Ok(Self::Stream(open_stream(path)?)) } else { NewFile::create(path).map(Self::File) }
    }

    /// Completes the output.
    ///
    /// # Errors
    /// Like [`NewFile::commit`].
    pub fn commit(self) -> Result<(), Unwritable> {
        match self {
            Self::File(file) => file.commit(),
            Self::Stream(mut stream) => Ok(stream.flush()?),
        }
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::File(file) => file.write(bytes),
            Self::Stream(stream) => stream.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::File(file) => file.flush(),
            Self::Stream(stream) => stream.flush(),
        }
    }
}

/// Output that other programs read while it is written, and that remains if the process is killed: the event record of
/// a run.
#[derive(Debug)]
pub struct LogFile(File);

impl LogFile {
    /// Opens the output, and truncates an existing file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn open(path: &Utf8Path) -> Result<Self, Unwritable> {
        match fs::metadata(path) {
            _ if is_stream(path) => Ok(Self(open_stream(path)?)),
            Ok(found) if found.is_dir() => Err(Unwritable::NotRegular),
            Ok(_) => Ok(Self(OpenOptions::new().write(true).truncate(true).open(path)?)),
            // `create_new` does not follow a symbolic link whose target does not exist.
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Self(File::create_new(path)?)),
            Err(error) => Err(error.into()),
        }
    }
}

impl Write for LogFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Whether the path is a device or pipe, or an open file of this process, for example `/dev/stdout` or
/// `/proc/self/fd/3`. An open file is written as a stream even if it is a regular file.
fn is_stream(path: &Utf8Path) -> bool {
    let opened = ["/dev/fd", "/dev/stdin", "/dev/stdout", "/dev/stderr", "/proc"];
    opened.iter().any(|folder| path.starts_with(folder))
        || fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
}

fn open_stream(path: &Utf8Path) -> io::Result<File> {
    OpenOptions::new().append(true).open(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::folder;

    #[test]
    fn an_output_keeps_the_old_file_until_it_is_complete() {
        let (_kept, folder) = folder();
        let path = folder.join("plot.svg");
        fs::write(&path, "old").unwrap();
        let mut output = OutputFile::open(&path).unwrap();
        output.write_all(b"half").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"old");
        drop(output);
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(folder.read_dir_utf8().unwrap().count(), 1);
        let mut output = OutputFile::open(&path).unwrap();
        output.write_all(b"new").unwrap();
        output.commit().unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
    }

    #[test]
    fn a_log_is_readable_while_it_is_written() {
        let (_kept, folder) = folder();
        let path = folder.join("events.jsonl");
        let mut log = LogFile::open(&path).unwrap();
        log.write_all(b"one\n").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"one\n");
        assert_eq!(LogFile::open(&folder).unwrap_err(), Unwritable::NotRegular);
    }

    /// Files in memory are regular files.
    #[cfg(unix)]
    #[test]
    fn only_open_files_and_devices_are_streams() {
        for path in ["/dev/stdout", "/dev/fd/3", "/proc/self/fd/1", "/dev/null"] {
            assert!(is_stream(Utf8Path::new(path)), "{path}");
        }
        let (_kept, folder) = folder();
        for path in [folder.join("plot.svg").as_path(), &folder, Utf8Path::new("/dev/shm/no-such-plot.svg")] {
            assert!(!is_stream(path), "{path}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn devices_and_pipes_receive_the_output_as_a_stream() {
        let mut null = OutputFile::open(Utf8Path::new("/dev/null")).unwrap();
        null.write_all(b"lost").unwrap();
        null.commit().unwrap();
        let (_kept, folder) = folder();
        let pipe = folder.join("pipe");
        rustix::fs::mknodat(rustix::fs::CWD, pipe.as_std_path(), rustix::fs::FileType::Fifo, 0o600.into(), 0).unwrap();
        let reader = File::options().read(true).write(true).open(&pipe).unwrap();
        let mut log = LogFile::open(&pipe).unwrap();
        log.write_all(b"event").unwrap();
        let mut event = [0; 5];
        io::Read::read_exact(&mut &reader, &mut event).unwrap();
        assert_eq!(&event, b"event");
    }
}
