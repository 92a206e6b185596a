//! Arguments of `val3 test` that select tests by properties other than the name.

use camino::Utf8PathBuf;

/// Selection of tests other than by name.
#[derive(Debug, Default, clap::Args)]
pub(crate) struct SelectionArgs {
    /// Only tests with this word in the file's `tags`; with several words, at least one of them
    #[arg(hide_short_help = true, help_heading = "Selection", long, value_name = "WORD")]
    pub(crate) tag: Vec<String>,
    /// No test with this word in the file's `tags`; may be repeated
    #[arg(hide_short_help = true, help_heading = "Selection", long, value_name = "WORD")]
    pub(crate) tag_out: Vec<String>,
    /// Only tests that have failed in this report of --output json=FILE
    #[arg(help_heading = "Selection", long, value_name = "FILE")]
    pub(crate) failed_in: Option<Utf8PathBuf>,
    /// Make the parts of --shard equal in time, by this report of --output json=FILE
    #[arg(hide_short_help = true, help_heading = "Selection", long, value_name = "FILE", requires = "shard")]
    pub(crate) timings: Option<Utf8PathBuf>,
}
