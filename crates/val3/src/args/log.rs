//! Arguments of `val3 log`.

use std::str::FromStr;

use camino::Utf8PathBuf;
use clap::ValueEnum;
use val3_backup::DateTime;
use val3_lang::log_messages::LogLevel;

use super::{ConnectionArgs, OutputArgs};

pub(super) const EXIT_CODES: &str = "\
Exit codes:
  0  every line of the logs was read
  2  wrong usage, a file that cannot be read, or a folder that was not searched";

/// Arguments of `val3 log`.
#[derive(Debug, clap::Args)]
pub(crate) struct LogArgs {
    /// A log (errors.log, system.log, user.log), a folder or a zip with the logs of a controller, or the address of a
    /// controller, `ftp://PROFILE@HOST` or `ftps://PROFILE@HOST`
    #[arg(value_name = "FILE|FOLDER|ADDRESS", default_value = ".")]
    pub(crate) path: Utf8PathBuf,
    /// The folder or zip with the applications, for the source lines of messages [default: the cell around the log, or the
    /// controller]
    #[arg(long, value_name = "DIR")]
    pub(crate) sources: Option<Utf8PathBuf>,
    /// Only messages from this time on: 2021-01-05, 2021-01-05T08:00, or 30m, 2h, 3d before the last message
    #[arg(long, value_name = "TIME")]
    pub(crate) since: Option<Since>,
    /// Only messages of this level or above, and messages whose level is unknown
    #[arg(long, value_name = "LEVEL")]
    pub(crate) level: Option<LevelArgument>,
    /// Wait for further messages of a file, until Ctrl-C
    #[arg(long)]
    pub(crate) follow: bool,
    /// How messages are written to the standard output
    #[arg(help_heading = "Output", long, value_name = "FORMAT", default_value = "human")]
    pub(crate) format: LogFormat,
    /// The connection
    #[command(flatten)]
    pub(crate) connection: ConnectionArgs,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Output format of `val3 log`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LogFormat {
    /// For people: a line for each message, what it means and what to do
    Human,
    /// One JSON document
    Json,
    /// One JSON object a line, for each message
    JsonLines,
}

/// Level in the argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LevelArgument {
    /// Events
    Info,
    /// Warnings
    Warn,
    /// Errors
    Error,
    /// Errors that stop the controller
    Critical,
}

impl From<LevelArgument> for LogLevel {
    fn from(level: LevelArgument) -> Self {
        match level {
            LevelArgument::Info => Self::Info,
            LevelArgument::Warn => Self::Warn,
            LevelArgument::Error => Self::Error,
            LevelArgument::Critical => Self::Critical,
        }
    }
}

/// Time of the first shown message, on the controller's clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Since {
    /// Date and time.
    At(DateTime),
    /// Seconds before the last message, because the time zone of a controller is unknown.
    BeforeLast(u32),
}

impl FromStr for Since {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let time = DateTime::parse(text).map(Self::At);
        time.or_else(|| seconds(text).map(Self::BeforeLast))
            .ok_or("write a date (2021-01-05 or 2021-01-05T08:00) or 30m, 2h, 3d")
    }
}

/// Converts a duration with one unit, such as `30m`, to seconds. `None` for other texts, and for 2^32 seconds or more.
fn seconds(duration: &str) -> Option<u32> {
    let (number, unit) = duration.split_at_checked(duration.len().checked_sub(1)?)?;
    let factor = match unit {
        "s" => 1,
        "m" => 60,
        "h" => 3_600,
        "d" => 86_400,
        _ => return None,
    };
    number.parse::<u32>().ok()?.checked_mul(factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_absolute_or_before_the_last_message() {
        assert_eq!("2h".parse(), Ok(Since::BeforeLast(7_200)));
        assert_eq!("3d".parse(), Ok(Since::BeforeLast(259_200)));
        assert_eq!("2021-01-05".parse(), Ok(Since::At(DateTime::parse("2021-01-05").unwrap())));
        for text in ["", "h", "-2h", "2 h", "2y", "99999999d", "yesterday", "2é"] {
            assert!(text.parse::<Since>().is_err(), "{text}");
        }
    }
}
