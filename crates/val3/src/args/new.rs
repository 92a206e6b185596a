//! Arguments of `val3 new`.

use camino::Utf8PathBuf;
use clap::ValueEnum;
use val3_lang::versions::Version;

/// Arguments of `val3 new`.
#[derive(Debug, clap::Args)]
pub(crate) struct NewArgs {
    /// The name of the application: letters, digits and `_`, at most 15 for s7
    #[arg(value_name = "NAME")]
    pub(crate) name: String,
    /// The folder for the application. In a cell, the application is written next to the cell's other applications, otherwise
    /// into a new cell: NAME/usr/usrapp/NAME
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub(crate) folder: Utf8PathBuf,
    /// The arm that the point is taught for; `val3 arm list` shows them [default: the cell's arm, else tx2-90]
    #[arg(long, value_name = "NAME")]
    pub(crate) arm: Option<String>,
    /// The version of VAL 3 on the controller, such as s7.11 (CS8) or s8.13 (CS9) [default: the cell's version, else the
    /// newest version for the arm's controller]
    #[arg(long, value_name = "VERSION", value_parser = version)]
    pub(crate) version: Option<Version>,
    /// How the written files are listed
    #[arg(long, default_value = "human")]
    pub(crate) format: NewFormat,
}

/// Output format of `val3 new`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum NewFormat {
    /// Files, and the next commands
    Human,
    /// An object with the paths, on the standard output
    Json,
}

fn version(text: &str) -> Result<Version, String> {
    let version = Version::parse(text).ok_or("write a version such as s7.11 or s8.13")?;
    if [7, 8].contains(&version.major) {
        return Ok(version);
    }
    Err(format!("{version} is not supported here: name a version of s7 (CS8) or s8 (CS9)"))
}
