//! Arguments of `val3 check`.

use camino::Utf8PathBuf;
use val3_lang::versions::Version;

use super::{InputArgs, ReportOutput};
use crate::baseline::Mode;
use crate::format::ReportFormat;
use crate::format::val3check::{DEFAULT_TEMPLATE, Template};
use crate::report::FindingSeverity;

/// Arguments of `val3 check`.
#[derive(Debug, clap::Args)]
pub(crate) struct CheckArgs {
    /// Application folders, .pjx files, cells, or folders that contain them. For a program (.pgx) or data file (.dtx)
    /// only its own findings are reported; `-` reads one from the standard input
    #[arg(value_name = "PATH", default_value = ".")]
    pub(crate) paths: Vec<Utf8PathBuf>,
    /// With `-`: the path of the file that the standard input replaces
    #[arg(hide_short_help = true, help_heading = "Input", long, value_name = "PATH")]
    pub(crate) stdin_path: Option<Utf8PathBuf>,
    /// The source of the text
    #[command(flatten)]
    pub(crate) input: InputArgs,
    /// How findings are written to the standard output
    #[arg(help_heading = "Output", long, default_value = "human")]
    pub(crate) format: ReportFormat,
    /// Also write the findings to a file, in a separate format; may be repeated
    #[arg(help_heading = "Output", long, value_name = "FORMAT=FILE")]
    pub(crate) output: Vec<ReportOutput>,
    /// Show at most this many findings, the most serious ones, and count the others; all findings determine the exit code
    #[arg(help_heading = "Output", long, value_name = "N")]
    pub(crate) max_findings: Option<usize>,
    /// The lowest level at which the check fails
    #[arg(help_heading = "Exit code", long, value_name = "LEVEL", default_value = "error")]
    pub(crate) fail_level: FindingSeverity,
    /// Exit with 0 even when there are findings
    #[arg(hide_short_help = true, help_heading = "Exit code", long)]
    pub(crate) exit_zero: bool,
    /// Report only these rules: codes (V0203), prefixes of codes (V02) or names, separated by commas
    #[arg(help_heading = "Rules", long, value_name = "CODES", value_delimiter = ',')]
    pub(crate) select: Vec<String>,
    /// Report these rules as well, even if they are off: codes, prefixes of codes or names
    #[arg(hide_short_help = true, help_heading = "Rules", long, value_name = "CODES", value_delimiter = ',')]
    pub(crate) extend_select: Vec<String>,
    /// Do not report these rules; takes precedence over --select and --extend-select
    #[arg(help_heading = "Rules", long, value_name = "CODES", value_delimiter = ',')]
    pub(crate) ignore: Vec<String>,
    /// Also compare points, joints and moves with the arm and its cell: reach, limits, singularities, contacts
    #[arg(help_heading = "Rules", long)]
    pub(crate) motion: bool,
    /// With --motion: the arm (tx2-60l) or a file that describes it; takes precedence over val3.toml and the cell
    #[arg(hide_short_help = true, help_heading = "Rules", long, value_name = "NAME")]
    pub(crate) arm: Option<String>,
    /// Also report the changes that are necessary for this version, such as s8.10
    #[arg(help_heading = "Rules", long = "for", value_name = "VERSION", value_parser = target_version)]
    pub(crate) target: Option<Version>,
    /// Apply safe fixes, which do not change what the programs do, and report the other findings
    #[arg(help_heading = "Fixes", long, group = "fixing")]
    pub(crate) fix: bool,
    /// With --fix or --diff: also apply fixes that are a guess, such as a similar name
    #[arg(hide_short_help = true, help_heading = "Fixes", long, requires = "fixing")]
    pub(crate) unsafe_fixes: bool,
    /// Show what --fix would change, and write nothing; exits with 1 if there are changes
    #[arg(help_heading = "Fixes", long, group = "fixing")]
    pub(crate) diff: bool,
    /// Add comments to the programs that silence their findings, and report the other findings
    #[arg(hide_short_help = true, help_heading = "Fixes", long, conflicts_with_all = ["fixing", "write_baseline", "prune_baseline", "explain_config"])]
    pub(crate) add_suppressions: bool,
    /// Count the findings by rule instead of listing them
    #[arg(hide_short_help = true, help_heading = "Output", long, conflicts_with = "diff")]
    pub(crate) statistics: bool,
    /// Print only findings and errors: no summary, no hints, no progress
    #[arg(help_heading = "Output", long, short)]
    pub(crate) quiet: bool,
    /// Check again whenever a file changes, until Ctrl-C, and mark new findings
    #[arg(long, conflicts_with_all = ["diff", "add_suppressions", "write_baseline", "prune_baseline", "explain_config"])]
    pub(crate) watch: bool,
    /// A file with known findings, which are not reported; takes precedence over `baseline` in val3.toml
    #[arg(help_heading = "Known findings", long, value_name = "FILE")]
    pub(crate) baseline: Option<Utf8PathBuf>,
    /// Write all findings to the baseline, so that they are known, and report nothing
    #[arg(help_heading = "Known findings", long, conflicts_with_all = ["prune_baseline", "fixing"])]
    pub(crate) write_baseline: bool,
    /// Remove findings that no longer occur from the baseline
    #[arg(hide_short_help = true, help_heading = "Known findings", long, conflicts_with = "fixing")]
    pub(crate) prune_baseline: bool,
    /// Check nothing; print all settings of the applications with their sources
    #[arg(hide_short_help = true, long)]
    pub(crate) explain_config: bool,
    /// Number of threads [default: one per core]
    #[arg(hide_short_help = true, long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) jobs: Option<u16>,
    /// Template of a val3check record: %e level, %f file, %l line, %m message, %c class, %p program,
    /// %s section
    #[arg(hide_short_help = true, help_heading = "Output", long, value_name = "TEMPLATE", default_value = DEFAULT_TEMPLATE, hide_default_value = true)]
    pub(crate) val3check_template: Template,
}

impl CheckArgs {
    /// How the check uses baselines.
    pub(crate) fn baseline_mode(&self) -> Mode {
        match (self.write_baseline, self.prune_baseline) {
            (true, _) => Mode::Write,
            (_, true) => Mode::Prune,
            _ => Mode::Use,
        }
    }
}

/// Parses a version from s5 to s8.
fn target_version(text: &str) -> Result<Version, String> {
    let version = Version::parse(text).filter(|version| (5..=8).contains(&version.major));
    version.ok_or_else(|| "write a version from s5 to s8, such as s8.10".to_owned())
}
