//! The file that replaces the standard output of a command.

use camino::Utf8Path;

use super::{ArmAction, CheckArgs, Command, DiffFormat, FmtArgs};
use crate::format::Format;
use crate::output::file_kind::FileKind;
use crate::user_error::UserError;

impl Command {
    /// Returns the file that replaces the standard output, and its file kind.
    ///
    /// # Errors
    /// The arguments of `check` request another format or several files for a text that is only human-readable.
    pub(crate) fn destination(&self) -> Result<Option<(&Utf8Path, FileKind)>, UserError> {
        let (args, kind) = match self {
            Self::Check(args) => return text_of_check(args),
            Self::Fmt(args) => (&args.output, kind_of_fmt(args)),
            Self::Diff(args) => (&args.output, kind_of_diff(args.format)),
            Self::Run(args) => (&args.output, if args.scene { FileKind::Json } else { FileKind::Text }),
            Self::Eval(args) => (&args.output, FileKind::Text),
            Self::Explain(args) => (&args.output, FileKind::Text),
            Self::Schema(args) => (&args.output, FileKind::Json),
            Self::Completions(args) => (&args.output, FileKind::Text),
            Self::Arm(args) => match &args.action {
                ArmAction::List(args) => (&args.output, FileKind::Text),
                ArmAction::Show(args) => (&args.output, FileKind::Text),
                ArmAction::Measure(_) | ArmAction::Fit(_) => return Ok(None),
            },
            Self::New(_)
            | Self::Merge(_)
            | Self::Test(_)
            | Self::Lsp(_)
            | Self::Dap(_)
            | Self::Trust(_)
            | Self::Man(_)
            | Self::Version => {
                return Ok(None);
            }
        };
        Ok(args.output.as_deref().map(|path| (path, kind)))
    }
}

fn kind_of_fmt(args: &FmtArgs) -> FileKind {
    if args.check || args.diff { FileKind::Text } else { FileKind::Program }
}

const fn kind_of_diff(format: DiffFormat) -> FileKind {
    match format {
        DiffFormat::Json => FileKind::Json,
        DiffFormat::Html => FileKind::Html,
        DiffFormat::Human | DiffFormat::Markdown => FileKind::Text,
    }
}

/// Returns the human-readable output file of `--diff` or `--explain-config`, whose text has no other format:
/// `--output human=FILE`.
fn text_of_check(args: &CheckArgs) -> Result<Option<(&Utf8Path, FileKind)>, UserError> {
    let option = match (args.diff, args.explain_config) {
        (true, _) => "--diff",
        (_, true) => "--explain-config",
        _ => return Ok(None),
    };
    let is_plain = args.format == Format::Human && args.output.iter().all(|output| output.format == Format::Human);
    match args.output.as_slice() {
        [] if is_plain => Ok(None),
        [output] if is_plain => Ok(Some((&output.path, FileKind::Text))),
        _ => Err(UserError::new(format!("{option} prints only the format `human`"))
            .with_help(format!("omit --format, and write {option} --output human=FILE for a file"))),
    }
}
