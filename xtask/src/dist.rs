//! `dist`: what people download, the archive and the VS Code extension.

use std::fs::{self, File};
use std::io::Read as _;

use anyhow::Context;
use camino::Utf8Path;
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::project;
use crate::vsix::{self, Arguments};

/// What lies beside the binary.
const DOCUMENTS: &[&str] = &["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// Builds `val3`, and packs it as `target/dist/val3-VERSION-TARGET.tar.gz` and into the extension; what is built for tests
/// lies in `target/editors`.
///
/// # Errors
/// When the build fails or the archive cannot be written.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let binary = vsix::binary(arguments)?;
    let vsix = vsix::extension(&binary, arguments)?;
    let name = format!("val3-{}-{}", env!("CARGO_PKG_VERSION"), project::host()?);
    let folder = project::target_folder()?.join(if arguments.debug { "editors" } else { "dist" });
    fs::create_dir_all(&folder).with_context(|| format!("cannot make {folder}"))?;
    let archive = folder.join(format!("{name}.tar.gz"));
    pack(&archive, &name, &binary).with_context(|| format!("cannot write {archive}"))?;
    println!("{archive}\n{vsix}");
    Ok(())
}

/// Writes the archive: one folder with the binary and the documents. The same input gives the same bytes.
fn pack(archive: &Utf8Path, name: &str, binary: &Utf8Path) -> anyhow::Result<()> {
    let gzip = GzEncoder::new(File::create(archive)?, Compression::best());
    let mut tar = tar::Builder::new(gzip);
    let binary_name = binary.file_name().unwrap_or("val3");
    append(&mut tar, &format!("{name}/{binary_name}"), binary, 0o755)?;
    for document in DOCUMENTS {
        append(&mut tar, &format!("{name}/{document}"), &project::root().join(document), 0o644)?;
    }
    tar.into_inner()?.finish()?;
    Ok(())
}

fn append<W: std::io::Write>(
    tar: &mut tar::Builder<W>,
    name: &str,
    source: &Utf8Path,
    mode: u32,
) -> anyhow::Result<()> {
    let mut bytes = Vec::new();
    File::open(source).with_context(|| format!("cannot open {source}"))?.read_to_end(&mut bytes)?;
    let mut header = tar::Header::new_gnu();
    header.set_size(bytes.len() as u64);
    header.set_mode(mode);
    header.set_mtime(0);
    header.set_cksum();
    tar.append_data(&mut header, name, bytes.as_slice())?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_archive_holds_one_folder() {
        let folder = tempfile::tempdir().unwrap();
        let folder = Utf8Path::from_path(folder.path()).unwrap().to_owned();
        let binary = folder.join("val3");
        fs::write(&binary, "binary").unwrap();
        let mut tar = tar::Builder::new(Vec::new());
        append(&mut tar, "val3-1/val3", &binary, 0o755).unwrap();
        let bytes = tar.into_inner().unwrap();
        let mut archive = tar::Archive::new(bytes.as_slice());
        let entry = archive.entries().unwrap().next().unwrap().unwrap();
        assert_eq!(entry.path().unwrap().to_str(), Some("val3-1/val3"));
        assert_eq!(entry.header().mode().unwrap(), 0o755);
    }
}
