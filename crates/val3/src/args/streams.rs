//! Files that replace the standard input and the standard output, because shells may change the encoding with `>` and
//! may not support `<`.

use camino::Utf8PathBuf;

/// The destination of text.
#[derive(Debug, Clone, clap::Args)]
pub(crate) struct OutputArgs {
    /// Write to a file instead of to the standard output, whose encoding some shells change
    #[arg(help_heading = "Output", long, value_name = "FILE")]
    pub(crate) output: Option<Utf8PathBuf>,
}

/// The source of text.
#[derive(Debug, clap::Args)]
pub(crate) struct InputArgs {
    /// Read a file instead of the standard input
    #[arg(hide_short_help = true, help_heading = "Input", long, value_name = "FILE")]
    pub(crate) input: Option<Utf8PathBuf>,
}
