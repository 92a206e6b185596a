//! Arguments of `val3 diff`.

use camino::Utf8PathBuf;
use clap::ValueEnum;
use val3_diff::report::Detail;
use val3_diff::{BlankComparison, Exclusions, NamePattern, ReportClass, Tolerance};

use super::{ConnectionArgs, OutputArgs};

pub(super) const EXIT_CODES: &str = "\
Exit codes:
  0  no difference
  1  something differs
  2  wrong usage, or a file, a folder, a revision or a controller that cannot be read";

pub(super) const USAGE: &str = "\
val3 diff [OPTIONS] OLD NEW
       val3 diff [OPTIONS] ftp://PROFILE@HOST [DIR]
       val3 diff [OPTIONS] --git REV [REV] [PATH]
       val3 diff [OPTIONS] --staged [PATH]
       val3 diff [OPTIONS] --base BASE OURS THEIRS
       val3 diff --textconv FILE";

/// Arguments of `val3 diff`.
#[derive(Debug, clap::Args)]
pub(crate) struct DiffArgs {
    /// The old and the new version: application folders, .pjx files, cells, folders that contain them, or two single files;
    /// /dev/null means that the version does not exist. With --git: the folder to compare. Or the address of a controller,
    /// and the folder with its files, by default that of `val3 pull`
    #[arg(value_name = "OLD NEW")]
    pub(crate) paths: Vec<Utf8PathBuf>,
    /// Compare a revision of git with the files of the working tree, or two revisions with each other, also as `OLD..NEW`;
    /// `OLD...NEW` are the changes of NEW since the common ancestor
    #[arg(long, value_name = "REV", num_args = 1..=2, conflicts_with = "textconv")]
    pub(crate) git: Vec<String>,
    /// Compare the last commit, or the revision of `--git`, with the files that are staged for the next commit
    #[arg(long, conflicts_with = "textconv")]
    pub(crate) staged: bool,
    /// Print one file as text with stable lines, for the setting `diff.val3.textconv` of git
    #[arg(long, value_name = "FILE", conflicts_with_all = ["paths", "only", "format"])]
    pub(crate) textconv: Option<Utf8PathBuf>,
    /// Compare two versions, OURS and THEIRS, each with this common ancestor, and name the conflicts of a merge
    #[arg(long, value_name = "BASE", conflicts_with_all = ["git", "textconv"])]
    pub(crate) base: Option<Utf8PathBuf>,
    /// How differences are written to the standard output
    #[arg(long, default_value = "human")]
    pub(crate) format: DiffFormat,
    /// Only these parts, separated by commas
    #[arg(long, value_name = "PARTS", value_delimiter = ',')]
    pub(crate) only: Vec<ReportPart>,
    /// Print a table by application with the numbers of differences and the greatest movement
    #[arg(long, conflicts_with = "textconv")]
    pub(crate) stat: bool,
    /// Omit positions that moved by at most this distance and angle, such as `0.01mm,0.01deg`
    #[arg(long, value_name = "DISTANCE,ANGLE", conflicts_with = "textconv")]
    pub(crate) tolerance: Option<Tolerance>,
    /// Omit data whose names match, such as `n*Count` or `tState.n*`; may be repeated
    #[arg(long, value_name = "PATTERN", conflicts_with = "textconv")]
    pub(crate) ignore_data: Vec<NamePattern>,
    /// Omit differences that have no effect
    #[arg(long, value_name = "WHAT", value_delimiter = ',', conflicts_with = "textconv")]
    pub(crate) ignore: Vec<Ignorable>,
    /// The connection
    #[command(flatten)]
    pub(crate) connection: ConnectionArgs,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// How differences are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DiffFormat {
    /// For people at a terminal
    Human,
    /// One JSON document
    Json,
    /// Markdown, for merge requests
    Markdown,
    /// One page for browsers
    Html,
}

/// Differences without an effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Ignorable {
    /// Blanks, blank lines and the letter case of keywords in programs
    Layout,
}

impl DiffArgs {
    /// Differences that the report omits.
    pub(crate) fn exclusions(&self) -> Exclusions {
        let layout =
            if self.ignore.contains(&Ignorable::Layout) { BlankComparison::Ignored } else { BlankComparison::Compared };
        Exclusions { tolerance: self.tolerance, names: self.ignore_data.clone(), layout }
    }

    /// Detail level of the report.
    pub(crate) fn detail(&self) -> Detail {
        if self.stat { Detail::Statistics } else { Detail::Full }
    }
}

/// A part of the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportPart {
    /// Programs
    Programs,
    /// Data that are neither positions nor inputs and outputs
    Data,
    /// Points, joints, frames, tools and transformations
    Points,
    /// Inputs and outputs, and the files of the cell that describe them
    Io,
    /// Libraries and user types with their interfaces
    Libraries,
    /// Parameters of applications, and other files of the controller's configuration
    Configuration,
    /// Files of other kinds, compared by their bytes
    Files,
}

impl From<ReportPart> for ReportClass {
    fn from(part: ReportPart) -> Self {
        match part {
            ReportPart::Programs => Self::Programs,
            ReportPart::Data => Self::Data,
            ReportPart::Points => Self::Points,
            ReportPart::Io => Self::Io,
            ReportPart::Libraries => Self::Libraries,
            ReportPart::Configuration => Self::Configuration,
            ReportPart::Files => Self::Files,
        }
    }
}
