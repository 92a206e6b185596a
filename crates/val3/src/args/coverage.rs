//! Coverage arguments of `val3 test`.

use clap::ValueEnum;

use super::ReportOutput;

/// Format of coverage reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum CoverageFormat {
    /// LCOV, for genhtml and services
    Lcov,
    /// Cobertura XML, for services
    Cobertura,
    /// Pages with the code, in a folder
    Html,
    /// One JSON object
    Json,
}

/// Coverage and its destinations.
#[derive(Debug, clap::Args)]
pub(crate) struct CoverageArgs {
    /// Count how often lines and branches are executed, and print a table of it
    #[arg(help_heading = "Coverage", long)]
    coverage: bool,
    /// Write the coverage in a format (lcov, cobertura, html, json) to a file, or to a folder for html; may be repeated
    #[arg(hide_short_help = true, help_heading = "Coverage", long, value_name = "FORMAT=FILE")]
    pub(crate) coverage_output: Vec<ReportOutput<CoverageFormat>>,
    /// Fail if fewer lines than these per cent were executed
    #[arg(hide_short_help = true, help_heading = "Coverage", long, value_name = "PCT", value_parser = percent)]
    pub(crate) fail_under: Option<f64>,
}

impl CoverageArgs {
    /// Whether lines and branches are counted.
    pub(crate) fn is_wanted(&self) -> bool {
        self.coverage || !self.coverage_output.is_empty() || self.fail_under.is_some()
    }
}

fn percent(text: &str) -> Result<f64, String> {
    let percent = text.parse().ok().filter(|percent| (0.0..=100.0).contains(percent));
    percent.ok_or_else(|| "write per cent from 0 to 100".to_owned())
}
