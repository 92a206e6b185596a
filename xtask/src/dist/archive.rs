//! Archives with one folder. Equal files yield equal bytes.

use std::fs::{self, File};
use std::io::Write as _;

use anyhow::Context;
use camino::{Utf8Path, Utf8PathBuf};
use flate2::Compression;
use flate2::write::GzEncoder;
use zip::write::SimpleFileOptions;

/// A file and its path in the archive.
#[derive(Debug)]
pub(super) struct PackedFile {
    /// Path below the archive's folder, with `/`.
    pub(super) path: String,
    /// File on the disk.
    pub(super) source: Utf8PathBuf,
    /// Whether it can be executed.
    pub(super) is_program: bool,
}

impl PackedFile {
    pub(super) fn new(path: impl Into<String>, source: impl Into<Utf8PathBuf>) -> Self {
        Self { path: path.into(), source: source.into(), is_program: false }
    }

    fn mode(&self) -> u32 {
        if self.is_program { 0o755 } else { 0o644 }
    }

    fn bytes(&self) -> anyhow::Result<Vec<u8>> {
        fs::read(&self.source).with_context(|| format!("cannot read {}", self.source))
    }
}

/// Format of an archive.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    TarGz(Compression),
    Zip,
}

impl Form {
    /// Returns the ending of the file name.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::TarGz(_) => "tar.gz",
            Self::Zip => "zip",
        }
    }
}

/// Writes `files` as the folder `name` of an archive.
///
/// # Errors
/// A file cannot be read, or the archive cannot be written.
pub(super) fn write(archive: &Utf8Path, form: Form, name: &str, files: &[PackedFile]) -> anyhow::Result<()> {
    match form {
        Form::TarGz(compression) => write_tar(File::create(archive)?, compression, name, files),
        Form::Zip => write_zip(File::create(archive)?, name, files),
    }
}

fn write_tar(archive: File, compression: Compression, name: &str, files: &[PackedFile]) -> anyhow::Result<()> {
    let mut tar = tar::Builder::new(GzEncoder::new(archive, compression));
    for file in files {
        let bytes = file.bytes()?;
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        header.set_mode(file.mode());
        header.set_mtime(0);
        tar.append_data(&mut header, format!("{name}/{}", file.path), bytes.as_slice())?;
    }
    tar.into_inner()?.finish()?.flush()?;
    Ok(())
}

fn write_zip(archive: File, name: &str, files: &[PackedFile]) -> anyhow::Result<()> {
    let mut zip = zip::ZipWriter::new(archive);
    for file in files {
        let options = SimpleFileOptions::default().unix_permissions(file.mode());
        zip.start_file(format!("{name}/{}", file.path), options)?;
        zip.write_all(&file.bytes()?)?;
    }
    zip.finish()?.flush()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use flate2::read::GzDecoder;

    use super::*;

    /// Creates a folder with an archive that contains a program and a text.
    fn written(form: Form) -> (tempfile::TempDir, Utf8PathBuf) {
        let scratch = tempfile::tempdir().unwrap();
        let folder = Utf8Path::from_path(scratch.path()).unwrap();
        fs::write(folder.join("built"), "binary").unwrap();
        fs::write(folder.join("text"), "words").unwrap();
        let program = PackedFile { path: "val3".to_owned(), source: folder.join("built"), is_program: true };
        let text = PackedFile::new("docs/text.md", folder.join("text"));
        let archive = folder.join("archive");
        write(&archive, form, "val3-1", &[program, text]).unwrap();
        (scratch, archive)
    }

    #[test]
    fn a_tar_holds_one_folder() {
        let (_scratch, archive) = written(Form::TarGz(Compression::best()));
        let mut tar = tar::Archive::new(GzDecoder::new(File::open(archive).unwrap()));
        let entries = tar.entries().unwrap().map(|entry| {
            let mut entry = entry.unwrap();
            let mut text = String::new();
            entry.read_to_string(&mut text).unwrap();
            (entry.path().unwrap().to_str().unwrap().to_owned(), entry.header().mode().unwrap(), text)
        });
        let entries: Vec<_> = entries.collect();
        let expected = [("val3-1/val3", 0o755, "binary"), ("val3-1/docs/text.md", 0o644, "words")];
        assert_eq!(entries, expected.map(|(path, mode, text)| (path.to_owned(), mode, text.to_owned())));
    }

    #[test]
    fn a_zip_holds_the_same_folder() {
        let (_scratch, archive) = written(Form::Zip);
        let mut zip = zip::ZipArchive::new(File::open(archive).unwrap()).unwrap();
        let mut program = zip.by_name("val3-1/val3").unwrap();
        assert_eq!(program.unix_mode().unwrap() & 0o777, 0o755);
        let mut text = String::new();
        program.read_to_string(&mut text).unwrap();
        assert_eq!(text, "binary");
        drop(program);
        assert!(zip.by_name("val3-1/docs/text.md").is_ok());
    }

    #[test]
    fn the_same_files_give_the_same_bytes() {
        for form in [Form::TarGz(Compression::best()), Form::Zip] {
            let (_one, first) = written(form);
            let (_other, second) = written(form);
            assert!(fs::read(first).unwrap() == fs::read(second).unwrap(), "{}", form.ending());
        }
    }
}
