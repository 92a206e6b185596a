//! Arguments of `val3 test`.

use std::ops::RangeInclusive;

use camino::Utf8PathBuf;
use clap::ValueEnum;

use super::ReportOutput;
use super::controller::ControllerArgs;
use super::coverage::CoverageArgs;
use crate::output::OutputContent;
use crate::output::file_kind::OutputFileKind;
use crate::test::Shard;

/// Format of test results.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum TestFormat {
    /// Text for people
    Human,
    /// One JSON object
    Json,
    /// One JSON object a line, written while the tests are executed
    JsonLines,
    /// JUnit XML, for CI services
    Junit,
    /// One page for browsers
    Html,
    /// Test Anything Protocol, version 14
    Tap,
    /// Workflow commands of GitHub Actions
    Github,
}

impl TestFormat {
    /// Content kind of the output.
    pub(crate) fn content(self) -> OutputContent {
        match self {
            Self::Json | Self::JsonLines => OutputContent::Json,
            Self::Github => OutputContent::Commands,
            Self::Human | Self::Html | Self::Junit | Self::Tap => OutputContent::Words,
        }
    }

    /// File kind of a report in this format.
    pub(crate) fn file_kind(self) -> OutputFileKind {
        match self {
            Self::Json | Self::JsonLines => OutputFileKind::Json,
            Self::Junit => OutputFileKind::XmlReport,
            Self::Html => OutputFileKind::Html,
            Self::Human | Self::Tap | Self::Github => OutputFileKind::Text,
        }
    }
}

/// Arguments of `val3 test`.
#[derive(Debug, clap::Args)]
pub(crate) struct TestArgs {
    /// Applications with tests, cells, folders that contain them, or files of tests: `testName.pgx`, `tests/NAME.toml`, also
    /// with a line as in `testName.pgx:12`
    #[arg(value_name = "PATH", default_value = ".")]
    pub(crate) paths: Vec<Utf8PathBuf>,
    /// Only tests whose names (application:program) contain this text; with several, one of them
    #[arg(help_heading = "Selection", long, value_name = "TEXT")]
    pub(crate) filter: Vec<String>,
    /// No test whose name contains this text; may be repeated
    #[arg(help_heading = "Selection", long, value_name = "TEXT")]
    pub(crate) filter_out: Vec<String>,
    /// Only the test with this name (application:program); may be repeated
    #[arg(hide_short_help = true, help_heading = "Selection", long, value_name = "NAME")]
    pub(crate) exact: Vec<String>,
    /// Print the names of the tests, and execute none
    #[arg(help_heading = "Selection", long)]
    pub(crate) list: bool,
    /// End after the first failure
    #[arg(help_heading = "Execution", long, conflicts_with_all = ["coverage", "coverage_output", "fail_under"])]
    pub(crate) fail_fast: bool,
    /// Execute the tests in a random order, which this number decides; results are the same in any order. With --mutate it
    /// decides which mistakes are tried, and is 1 unless set
    #[arg(hide_short_help = true, help_heading = "Execution", long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Execute only one of several equal parts of the tests, such as 2/3
    #[arg(hide_short_help = true, help_heading = "Selection", long, value_name = "I/N")]
    pub(crate) shard: Option<Shard>,
    /// Selection of tests other than by name
    #[command(flatten)]
    pub(crate) selection: SelectionArgs,
    /// Execute a failed test again, at most this number of times; if it passes then, it is flaky and counts as passed
    #[arg(hide_short_help = true, help_heading = "Execution", long, value_name = "N", default_value_t = 0)]
    pub(crate) retries: u32,
    /// Execute each test this number of times
    #[arg(hide_short_help = true, help_heading = "Execution", long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) repeat: u32,
    /// Execute the tests again whenever a file is changed, until Ctrl-C
    #[arg(help_heading = "Execution", long, conflicts_with_all = ["list", "init", "update", "mutate"])]
    pub(crate) watch: bool,
    /// Threads [default: one for each core]
    #[arg(help_heading = "Execution", long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) jobs: Option<u32>,
    /// How results are written to the standard output
    #[arg(help_heading = "Output", long, default_value = "human")]
    pub(crate) format: TestFormat,
    /// Only failures and the summary, in the format `human`
    #[arg(help_heading = "Output", short, long)]
    pub(crate) quiet: bool,
    /// Also write results in this format to a file, such as junit=tests.xml; may be repeated
    #[arg(help_heading = "Output", long, value_name = "FORMAT=FILE", conflicts_with_all = ["list", "init"])]
    pub(crate) output: Vec<ReportOutput<TestFormat>>,
    /// The seconds of the controller's clock after which a test has failed [default: 60, or the value in val3.toml]
    #[arg(hide_short_help = true, help_heading = "Execution", long, value_name = "SECONDS", value_parser = limit)]
    pub(crate) limit: Option<f64>,
    /// Number of last events that a failure shows, from 0 to 100; repeated ones count once
    #[arg(hide_short_help = true, help_heading = "Output", long, value_name = "N", default_value_t = EVENTS, value_parser = clap::value_parser!(u32).range(0..=100))]
    pub(crate) events: u32,
    /// List this number of the slowest tests, in the format `human`
    #[arg(hide_short_help = true, help_heading = "Output", long, value_name = "N", default_value_t = 0)]
    pub(crate) durations: u32,
    /// Record the motion and the texts of tests again, for `expect.trace`, `screen_file` and `print_file`
    #[arg(hide_short_help = true, help_heading = "Output", long, conflicts_with_all = ["list", "init"])]
    pub(crate) update: bool,
    /// Seed mistakes into the tested programs and their data, in memory, and report the mistakes that no test finds
    #[arg(help_heading = "Mistakes", long, conflicts_with_all = ["list", "init", "new", "update", "fail_fast", "retries", "repeat", "output", "coverage", "coverage_output", "fail_under"])]
    pub(crate) mutate: bool,

    /// The number of mistakes that are tried; --seed decides which
    #[arg(help_heading = "Mistakes", long, value_name = "N", default_value_t = 100, requires = "mutate", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) mutations: u32,

    /// Write the library val3assert and a first test next to the application, and execute nothing
    #[arg(long, conflicts_with_all = ["filter", "filter_out", "exact", "list", "fail_fast"])]
    pub(crate) init: bool,
    /// Write a test with this name into the test application PATH, and execute nothing
    #[arg(long, value_name = "NAME", conflicts_with_all = ["init", "filter", "filter_out", "exact", "list", "fail_fast"])]
    pub(crate) new: Option<String>,
    /// The program that the test of --new calls, such as `total` or `pal:total`: with an assertion for each output
    #[arg(hide_short_help = true, long = "for", value_name = "PROGRAM", requires = "new")]
    pub(crate) of: Option<String>,
    /// Write a scenario from a recorded run of the application PATH (`val3 run --events`), and execute no other test
    #[arg(long, value_name = "FILE.jsonl", requires = "to", conflicts_with_all = ["init", "new", "list", "watch", "update", "fail_fast"])]
    pub(crate) record: Option<Utf8PathBuf>,
    /// The scenario that --record writes, such as tests/twoBoxes.toml; an existing file stays unchanged
    #[arg(hide_short_help = true, long, value_name = "FILE.toml", requires = "record")]
    pub(crate) to: Option<Utf8PathBuf>,
    /// Coverage and its destinations
    #[command(flatten)]
    pub(crate) coverage: CoverageArgs,
    /// The properties of the controllers
    #[command(flatten)]
    pub(crate) controller: ControllerArgs,
}

/// Default number of events that a failure shows.
pub(crate) const EVENTS: u32 = 10;

/// Allowed timeouts of a test, in seconds.
pub(crate) const LIMITS: RangeInclusive<f64> = 0.004..=1e6;

fn limit(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds| LIMITS.contains(seconds));
    seconds.ok_or_else(|| "write seconds from 0.004 to 1e6".to_owned())
}

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
