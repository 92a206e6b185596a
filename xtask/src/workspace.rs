//! `workspace`: a large VAL 3 workspace for measurements, without any fault.
//!
//! The programs are meaningless, but have the structure of real ones: the mixture of statements, the depth of blocks,
//! comments, names, data, user types and libraries follow statistics of public programs. The same arguments yield the
//! same bytes.

mod application;
mod body;
mod expression;
mod instruction;
mod model;
mod random;
mod scope;
mod shared;
mod statement;
mod words;
mod xml;

use anyhow::Context;
use camino::{Utf8Path, Utf8PathBuf};

use self::application::ApplicationPlan;
use self::random::Random;

/// Options of `workspace`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder to write; it becomes a controller folder with `usr/usrapp`
    folder: Utf8PathBuf,
    /// Code lines, without blank lines and comments
    #[arg(long, default_value_t = 100_000)]
    lines: usize,
    /// Another seed gives another workspace
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// A file of the workspace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GeneratedFile {
    /// Path below the workspace's folder: `usr/usrapp/cell001/start.pgx`.
    pub path: String,
    /// Content, with its byte order mark.
    pub text: String,
}

/// A generated workspace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Generated {
    /// All files.
    pub files: Vec<GeneratedFile>,
    /// Number of code lines, without blank lines and comments.
    pub code_lines: usize,
}

/// Generates a workspace of `lines` code lines, or slightly more so that the last program is complete.
pub fn generate(lines: usize, seed: u64) -> Generated {
    let mut projects = shared::projects();
    let mut code_lines: usize = projects.iter().map(model::Project::code_lines).sum();
    let mut random = Random::new(seed);
    for number in 1.. {
        if code_lines >= lines {
            break;
        }
        let plan = ApplicationPlan { number, most_lines: lines - code_lines };
        let project = application::build(&plan, &mut random);
        code_lines += project.code_lines();
        projects.push(project);
    }
    let files = projects.iter().flat_map(xml::files).collect();
    Generated { files, code_lines }
}

/// Writes a workspace to a folder and returns its number of code lines.
///
/// # Errors
/// A file cannot be written.
pub fn write(folder: &Utf8Path, workspace: &Generated) -> anyhow::Result<usize> {
    for file in &workspace.files {
        let path = folder.join(&file.path);
        let parent = path.parent().context("a file lies in a folder")?;
        std::fs::create_dir_all(parent).with_context(|| format!("cannot make {parent}"))?;
        std::fs::write(&path, &file.text).with_context(|| format!("cannot write {path}"))?;
    }
    Ok(workspace.code_lines)
}

/// Generates and writes the workspace that the arguments describe.
///
/// # Errors
/// A file cannot be written.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let workspace = generate(arguments.lines, arguments.seed);
    write(&arguments.folder, &workspace)?;
    println!("{} files, {} code lines in {}", workspace.files.len(), workspace.code_lines, arguments.folder);
    Ok(())
}

#[cfg(test)]
mod tests;
