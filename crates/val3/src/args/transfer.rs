//! Arguments of `val3 pull`, `val3 status` and `val3 push`.

use camino::Utf8PathBuf;
use clap::ValueEnum;

use super::{ConnectionArgs, OutputArgs};
use crate::controller::soap_client::SoapTarget;

pub(super) const PULL_EXIT_CODES: &str = "\
Exit codes:
  0  the local files are those of the controller, apart from local changes; or the file of --print was printed
  1  files have changed on both sides: nothing was written; or --merge has left conflicts
  2  wrong usage, a file that cannot be read or written, or the controller cannot be reached";

pub(super) const STATUS_EXIT_CODES: &str = "\
Exit codes:
  0  no difference; with --soap, the state was read
  1  files differ
  2  wrong usage, a file that cannot be read, or the controller cannot be reached";

pub(super) const PUSH_EXIT_CODES: &str = "\
Exit codes:
  0  done, or nothing to push; with --dry-run, the push can be done
  1  the check has found errors, a file has changed on the controller, an application runs or would be removed: nothing was written
  2  wrong usage, a file that cannot be read or written, or the controller cannot be reached";

pub(super) const PASSWORD: &str = "\
Password:
  The environment variable VAL3_PASSWORD, else the entry of the host in ~/.netrc, else a prompt.
  It is neither stored nor shown.";

/// Arguments of `val3 pull`.
#[derive(Debug, clap::Args)]
pub(crate) struct PullArgs {
    /// The controller: `ftp://PROFILE@HOST[:PORT][/FOLDER]`, the same with `ftps://` for TLS, or the folder of an emulator,
    /// which contains `usr`
    /// [default: the controller of the last pull]
    #[arg(value_name = "ADDRESS")]
    pub(crate) address: Option<String>,
    /// The local folder for the files, by their paths on the controller [default: the project around the current folder,
    /// else the current folder]
    #[arg(value_name = "DIR")]
    pub(crate) folder: Option<Utf8PathBuf>,
    /// Pull this application, a folder below usr/usrapp, instead of all; may be repeated
    #[arg(long, value_name = "NAME", conflicts_with = "all")]
    pub(crate) app: Vec<String>,
    /// Also pull the settings: usr/configs, usr/app, usr/applicom and usr/templates
    #[arg(long)]
    pub(crate) all: bool,
    /// Merge files that have changed on both sides, as `val3 merge` does
    #[arg(long)]
    pub(crate) merge: bool,
    /// Keep the local version of files that have changed on both sides, which the next push uploads: a file, by its path as
    /// in `val3 status`, or a folder; may be repeated
    #[arg(long, value_name = "PATH")]
    pub(crate) keep_local: Vec<String>,
    /// Replace the local version of files that have changed on both sides, or that were removed here, by the controller's;
    /// may be repeated
    #[arg(long, value_name = "PATH")]
    pub(crate) keep_controller: Vec<String>,
    /// Remove whole applications and folders here if the controller no longer has them, instead of stopping
    #[arg(long)]
    pub(crate) accept_removals: bool,
    /// Print one file of the controller, by its path as in `val3 status`, and change nothing here or there
    #[arg(
        long,
        value_name = "PATH",
        conflicts_with_all = ["app", "all", "merge", "keep_local", "keep_controller", "accept_removals"]
    )]
    pub(crate) print: Option<String>,
    /// Accept a controller with another serial number than at the last pull, or without one at another address
    #[arg(long)]
    pub(crate) new_controller: bool,
    /// The connection
    #[command(flatten)]
    pub(crate) connection: ConnectionArgs,
}

/// Arguments of `val3 status`.
#[derive(Debug, clap::Args)]
pub(crate) struct StatusArgs {
    /// A folder in the project
    #[arg(value_name = "DIR", default_value = ".")]
    pub(crate) folder: Utf8PathBuf,
    /// Show what a controller does now, by its SOAP interface: position, applications in memory, and tasks with their
    /// lines; compare no files, and change nothing. The port is 5653 if none is named; newer controllers have 851
    #[arg(long, value_name = "PROFILE@HOST:PORT", conflicts_with = "folder")]
    pub(crate) soap: Option<SoapTarget>,
    /// How the differences or the state are written to the standard output
    #[arg(help_heading = "Output", long, value_name = "FORMAT", default_value = "human")]
    pub(crate) format: TransferFormat,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `val3 push`.
#[derive(Debug, clap::Args)]
pub(crate) struct PushArgs {
    /// Applications, by their folders below usr/usrapp [default: all]; or settings, by their paths, such as
    /// usr/configs/sio.cfx
    #[arg(value_name = "APP")]
    pub(crate) selection: Vec<String>,
    /// List the changes and check them, but write nothing
    #[arg(long)]
    pub(crate) dry_run: bool,
    /// Do not let errors of these rules stop the push: codes (V0203), prefixes of codes or names, separated by commas
    #[arg(long, value_name = "CODES", value_delimiter = ',')]
    pub(crate) ignore: Vec<String>,
    /// Confirm that the push removes this application from the controller, because its local files were removed; may be
    /// repeated
    #[arg(long, value_name = "APP")]
    pub(crate) remove: Vec<String>,
    /// State that none of the applications is loaded on the controller, instead of its log or an answer to the question
    #[arg(long)]
    pub(crate) unloaded: bool,
    /// Read from the controller's SOAP interface which applications are loaded, instead of from its log; a loaded application
    /// stops the push. The port is 5653 if none is named; newer controllers have 851
    #[arg(long, value_name = "PROFILE@HOST:PORT", conflicts_with = "unloaded")]
    pub(crate) soap: Option<SoapTarget>,
    /// Accept a controller with another serial number than at the last pull, or without one
    #[arg(long)]
    pub(crate) new_controller: bool,
    /// How the changes are written to the standard output
    #[arg(help_heading = "Output", long, value_name = "FORMAT", default_value = "human")]
    pub(crate) format: TransferFormat,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Output format of `val3 status` and `val3 push`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum TransferFormat {
    /// For people: a line for each file
    Human,
    /// One JSON document
    Json,
}
