//! Arguments of the commands for shells and packages.

use camino::Utf8PathBuf;
use clap_complete::Shell;

use super::OutputArgs;

/// Arguments of `val3 completions`.
#[derive(Debug, clap::Args)]
pub(crate) struct CompletionsArgs {
    /// The shell
    pub(crate) shell: Shell,
    /// The destination of the script
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `val3 man`.
#[derive(Debug, clap::Args)]
pub(crate) struct ManArgs {
    /// The folder for the pages, which is created
    #[arg(value_name = "DIR")]
    pub(crate) folder: Utf8PathBuf,
}
