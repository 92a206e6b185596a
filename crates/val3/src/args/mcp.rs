//! Arguments of `val3 mcp`.

use camino::Utf8PathBuf;

/// Arguments of `val3 mcp`.
#[derive(Debug, clap::Args)]
pub(crate) struct McpArgs {
    /// A folder that the tools may use; relative paths begin in the first one; may be repeated [default: the current folder]
    #[arg(long, value_name = "DIR")]
    pub(crate) root: Vec<Utf8PathBuf>,
    /// Also offer tools that change files: write_program, write_data, rename
    #[arg(long)]
    pub(crate) write: bool,
    /// Offer only these tools, such as check,explain
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) tools: Vec<String>,
}
