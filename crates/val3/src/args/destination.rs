//! The file that replaces the standard output of a command.

use camino::Utf8Path;

use super::{ArmAction, CheckArgs, CliCommand, DiffFormat, FmtArgs, InfoFormat, LogFormat, TransferFormat};
use crate::format::ReportFormat;
use crate::output::file_kind::OutputFileKind;
use crate::user_error::UserError;

impl CliCommand {
    /// Returns the file that replaces the standard output, and its file kind.
    ///
    /// # Errors
    /// The arguments of `check` request another format or several files for a text that is only human-readable.
    pub(crate) fn destination(&self) -> Result<Option<(&Utf8Path, OutputFileKind)>, UserError> {
        let (args, kind) = match self {
            Self::Check(args) => return text_of_check(args),
            Self::Fmt(args) => (&args.output, kind_of_fmt(args)),
            Self::Diff(args) => (&args.output, kind_of_diff(args.format)),
            Self::Run(args) => (&args.output, if args.scene { OutputFileKind::Json } else { OutputFileKind::Text }),
            Self::Eval(args) => (&args.output, OutputFileKind::Text),
            Self::Explain(args) => (&args.output, OutputFileKind::Text),
            Self::Info(args) => (&args.output, kind_of_info(args.format)),
            Self::Log(args) => (&args.output, kind_of_log(args.format)),
            Self::Status(args) => (&args.output, kind_of_transfer(args.format)),
            Self::Push(args) => (&args.output, kind_of_transfer(args.format)),
            Self::Schema(args) => (&args.output, OutputFileKind::Json),
            Self::Completions(args) => (&args.output, OutputFileKind::Text),
            Self::Arm(args) => match &args.action {
                ArmAction::List(args) => (&args.output, OutputFileKind::Text),
                ArmAction::Show(args) => (&args.output, OutputFileKind::Text),
                ArmAction::Urdf(args) => (&args.output, OutputFileKind::Text),
                ArmAction::Measure(_) | ArmAction::Fit(_) => return Ok(None),
            },
            Self::New(_)
            | Self::Merge(_)
            | Self::Pull(_)
            | Self::Test(_)
            | Self::Lsp(_)
            | Self::Mcp(_)
            | Self::Dap(_)
            | Self::Trust(_)
            | Self::Man(_)
            | Self::Guide
            | Self::Version => {
                return Ok(None);
            }
        };
        Ok(args.output.as_deref().map(|path| (path, kind)))
    }
}

fn kind_of_fmt(args: &FmtArgs) -> OutputFileKind {
    if args.check || args.diff { OutputFileKind::Text } else { OutputFileKind::Program }
}

const fn kind_of_diff(format: DiffFormat) -> OutputFileKind {
    match format {
        DiffFormat::Json => OutputFileKind::Json,
        DiffFormat::Html => OutputFileKind::Html,
        DiffFormat::Human | DiffFormat::Markdown => OutputFileKind::Text,
    }
}

const fn kind_of_info(format: InfoFormat) -> OutputFileKind {
    match format {
        InfoFormat::Json => OutputFileKind::Json,
        InfoFormat::Human => OutputFileKind::Text,
    }
}

const fn kind_of_log(format: LogFormat) -> OutputFileKind {
    match format {
        LogFormat::Json | LogFormat::JsonLines => OutputFileKind::Json,
        LogFormat::Human => OutputFileKind::Text,
    }
}

const fn kind_of_transfer(format: TransferFormat) -> OutputFileKind {
    match format {
        TransferFormat::Json => OutputFileKind::Json,
        TransferFormat::Human => OutputFileKind::Text,
    }
}

/// Returns the human-readable output file of `--diff` or `--explain-config`, whose text has no other format:
/// `--output human=FILE`.
fn text_of_check(args: &CheckArgs) -> Result<Option<(&Utf8Path, OutputFileKind)>, UserError> {
    let option = match (args.diff, args.explain_config) {
        (true, _) => "--diff",
        (_, true) => "--explain-config",
        _ => return Ok(None),
    };
    let is_plain =
        args.format == ReportFormat::Human && args.output.iter().all(|output| output.format == ReportFormat::Human);
    match args.output.as_slice() {
        [] if is_plain => Ok(None),
        [output] if is_plain => Ok(Some((&output.path, OutputFileKind::Text))),
        _ => Err(UserError::new(format!("{option} prints only the format `human`"))
            .with_help(format!("omit --format, and write {option} --output human=FILE for a file"))),
    }
}
