//! Arguments of `val3 info`.

use camino::Utf8PathBuf;
use clap::ValueEnum;

use super::{ConnectionArgs, OutputArgs};

pub(super) const EXIT_CODES: &str = "\
Exit codes:
  0  every file of the description was read
  2  wrong usage, or a file that cannot be read";

/// Arguments of `val3 info`.
#[derive(Debug, clap::Args)]
pub(crate) struct InfoArgs {
    /// A folder or a zip with one or several controllers, or with the content of `usr`; or the address of a controller,
    /// `ftp://PROFILE@HOST` or `ftps://PROFILE@HOST`
    #[arg(value_name = "PATH|ADDRESS", default_value = ".")]
    pub(crate) path: Utf8PathBuf,
    /// How the description is written to the standard output
    #[arg(help_heading = "Output", long, value_name = "FORMAT", default_value = "human")]
    pub(crate) format: InfoFormat,
    /// The connection
    #[command(flatten)]
    pub(crate) connection: ConnectionArgs,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Output format of `val3 info`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum InfoFormat {
    /// For people
    Human,
    /// One JSON document
    Json,
}
