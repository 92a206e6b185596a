//! Arguments of `val3 merge`.

use camino::Utf8PathBuf;

pub(super) const EXIT_CODES: &str = "\
Exit codes:
  0    merged, without a conflict; or installed
  1    conflicts: both versions are in the file, and `val3 check` reports each
  2    wrong usage, or git cannot be set up
  129  a file cannot be read or written; git then stops its merge";

pub(super) const USAGE: &str = "\
val3 merge [OPTIONS] BASE OURS THEIRS
       val3 merge --install";

/// Arguments of `val3 merge`.
#[derive(Debug, clap::Args)]
pub(crate) struct MergeArgs {
    /// Three versions of one file: the common ancestor, the version that is replaced by the result, and the version whose
    /// changes are added to it; /dev/null as BASE means that both sides have added the file
    #[arg(value_names = ["BASE", "OURS", "THEIRS"], num_args = 3, required_unless_present = "install")]
    pub(crate) files: Vec<Utf8PathBuf>,
    /// The path of the file in the repository, for its kind and for messages
    #[arg(long, value_name = "PATH", conflicts_with = "install")]
    pub(crate) path: Option<Utf8PathBuf>,
    /// Print the result instead of replacing OURS
    #[arg(long, short = 'p', conflicts_with = "install")]
    pub(crate) stdout: bool,
    /// Let git merge the files of this repository with `val3 merge`: writes .gitattributes and the configuration of the
    /// repository
    #[arg(long, conflicts_with = "files")]
    pub(crate) install: bool,
}
