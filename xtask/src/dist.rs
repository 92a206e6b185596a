//! `dist`: packs the downloads, which are the archive and the VS Code extension.

use std::fs::{self, File};
use std::io::Read as _;

use anyhow::Context;
use camino::{Utf8Path, Utf8PathBuf};
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::debug_info;
use crate::node::Node;
use crate::project;
use crate::vsix::{self, Arguments};

/// Documents packed with the binary.
const DOCUMENTS: &[&str] = &[
    "README.md",
    "CHANGELOG.md",
    "LICENSE-MIT",
    "LICENSE-APACHE",
    // The types of the debug protocol derive from its schema.
    "crates/val3-dap/schema/License-code.txt",
];

/// Builds `val3`, and packs it as `target/packages/val3-VERSION-TARGET.tar.gz` and into the extension; with `--debug` the
/// output folder is `target/editors`. Line tables get a separate archive, `…-debug.tar.gz`
/// (docs/adr/0011-debug-information.md).
///
/// # Errors
/// When the build fails or the archive cannot be written.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let folder = project::target_folder()?.join(if arguments.debug { "editors" } else { "packages" });
    // Before the build, which takes minutes.
    Node::find_or_install()?;
    let parts = debug_info::split(&vsix::binary(arguments)?, &folder.join("parts"))?;
    let vsix = vsix::extension(&parts.binary, arguments)?;
    let name = format!("val3-{}-{}", env!("CARGO_PKG_VERSION"), project::host()?);
    let mut files = vec![(parts.binary, 0o755)];
    files.extend(DOCUMENTS.iter().map(|document| (project::root().join(document), 0o644)));
    println!("{}\n{vsix}", pack(&folder, &name, "", &files)?);
    if let Some(debug) = parts.debug {
        println!("{}", pack(&folder, &name, "-debug", &[(debug, 0o644)])?);
    }
    Ok(())
}

/// Writes the archive `name` + `suffix`: one folder with these files and their modes. The same input gives the same bytes.
fn pack(folder: &Utf8Path, name: &str, suffix: &str, files: &[(Utf8PathBuf, u32)]) -> anyhow::Result<Utf8PathBuf> {
    fs::create_dir_all(folder).with_context(|| format!("cannot make {folder}"))?;
    let archive = folder.join(format!("{name}{suffix}.tar.gz"));
    let written = || format!("cannot write {archive}");
    let gzip = GzEncoder::new(File::create(&archive).with_context(written)?, Compression::best());
    let mut tar = tar::Builder::new(gzip);
    for (file, mode) in files {
        let file_name = file.file_name().context("a file has a name")?;
        append(&mut tar, &format!("{name}/{file_name}"), file, *mode).with_context(written)?;
    }
    tar.into_inner().and_then(GzEncoder::finish).with_context(written)?;
    Ok(archive)
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
