//! `dist`: packs the downloads, which are the archive, the Python wheel and the VS Code extension.

mod archive;
mod content;
mod generated;
mod wheel;

use std::fs;

use anyhow::Context;
use camino::{Utf8Path, Utf8PathBuf};
use flate2::Compression;

use crate::build::{Arguments, Build};
use crate::debug_info::Parts;
use crate::node::Node;
use crate::notices;
use crate::project;
use crate::vsix;
use archive::{Form, PackedFile};

/// Builds `val3` and packs it into `target/packages`, or with `--debug` into `target/editors`:
/// `val3-VERSION-TARGET.tar.gz` (`.zip` for Windows), a wheel, and an extension. Line tables get a separate archive,
/// `…-debug.tar.gz` (docs/adr/0011-debug-information.md).
///
/// # Errors
/// The build fails or a package cannot be written.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let build = Build::new(arguments)?;
    // Before the build, which needs minutes.
    Node::find_or_install()?;
    let folder = project::target_folder()?.join(if build.is_debug { "editors" } else { "packages" });
    fs::create_dir_all(&folder).with_context(|| format!("cannot make {folder}"))?;
    let Parts { binary, debug } = build.parts()?;
    let scratch = folder.join("scratch");
    if scratch.exists() {
        fs::remove_dir_all(&scratch).with_context(|| format!("cannot clear {scratch}"))?;
    }
    generated::write(&binary, &scratch)?;
    let notices = scratch.join("THIRD-PARTY.txt");
    fs::write(&notices, notices::of_binary(&build.target)?).with_context(|| format!("cannot write {notices}"))?;
    let name = format!("val3-{}-{}", env!("CARGO_PKG_VERSION"), build.target);
    println!("{}", pack(&build, &folder, &name, "", &content::of_archive(&binary, &notices, &scratch)?)?);
    if let Some(debug) = debug {
        println!("{}", pack(&build, &folder, &name, "-debug", &[PackedFile::new("val3.debug", debug)])?);
    }
    println!("{}", wheel::write(&build, &binary, &scratch, &folder)?);
    println!("{}", vsix::extension(&build, &binary, "packages")?);
    fs::remove_dir_all(&scratch).with_context(|| format!("cannot remove {scratch}"))
}

/// Compression of an archive. Nobody downloads a debug build, which has 250 MB.
fn compression(build: &Build) -> Compression {
    if build.is_debug { Compression::fast() } else { Compression::best() }
}

/// Writes the archive `name` + `suffix`, with the files in a folder called `name`.
fn pack(
    build: &Build,
    folder: &Utf8Path,
    name: &str,
    suffix: &str,
    files: &[PackedFile],
) -> anyhow::Result<Utf8PathBuf> {
    // The Explorer of Windows 10 opens no other archives.
    let form = if build.is_for_windows() { Form::Zip } else { Form::TarGz(compression(build)) };
    let archive = folder.join(format!("{name}{suffix}.{}", form.ending()));
    archive::write(&archive, form, name, files).with_context(|| format!("cannot write {archive}"))?;
    Ok(archive)
}
