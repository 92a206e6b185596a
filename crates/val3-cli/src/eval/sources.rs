//! The application that a scope is: one given, or an empty one, with the variables and one program more.

use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::declarations::listing;
use val3_syntax::TextRange;
use val3_syntax::error::{SyntaxError, SyntaxErrorKind};

use super::locals::Local;
use crate::user_error::UserError;

/// The name of the application where none is given, and of the program that holds a text.
pub(crate) const NAME: &str = "eval__";

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";

/// An application of its own, in a folder that need not exist.
pub(crate) fn empty(folder: &Utf8Path) -> (Utf8PathBuf, String) {
    let manifest = format!(
        "{HEAD}<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n  \
         <Parameters version=\"s7.11\" stackSize=\"100000\" millimeterUnit=\"true\" />\n  \
         <Programs>\n    <Program file=\"{NAME}.pgx\" />\n  </Programs>\n  \
         <Database>\n    <Data file=\"{NAME}.dtx\" />\n  </Database>\n</Project>\n"
    );
    (folder.join(format!("{NAME}.pjx")), manifest)
}

/// The project file of an application, with the program and the data file listed.
pub(crate) fn extended(db: &Database, project: Project) -> Result<(Utf8PathBuf, String), UserError> {
    let file = project.manifest(db);
    let (path, mut text) = (file.path(db).clone(), file.text(db).to_string());
    let mut changes: Vec<(TextRange, String)> = Vec::new();
    for (of_programs, kind) in [(true, "pgx"), (false, "dtx")] {
        let change = listing(db, project, of_programs, &format!("{NAME}.{kind}"));
        let incomplete = || UserError::new(format!("`{path}` is no complete project file"));
        changes.push(change.ok_or_else(incomplete)?);
    }
    changes.sort_unstable_by_key(|(range, _)| std::cmp::Reverse(range.start()));
    changes.iter().for_each(|(range, entry)| text.replace_range(Range::<usize>::from(*range), entry));
    Ok((path, text))
}

/// Whether a block of the code is not closed, and nothing else is wrong.
pub(crate) fn has_open_block(code: &str) -> bool {
    let parse = val3_syntax::parse(&program(code));
    let is_open = |error: &SyntaxError| matches!(error.kind, SyntaxErrorKind::UnclosedBlock { .. });
    !parse.errors().is_empty() && parse.errors().iter().all(is_open)
}

/// The data file with the variables.
pub(crate) fn data(locals: &[Local]) -> String {
    let lines: Vec<String> = locals.iter().map(Local::data).collect();
    format!(
        "{HEAD}<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n{}\n  </Datas>\n</Database>\n",
        lines.join("\n")
    )
}

/// What stands before the code in the file of its program.
pub(crate) const BEFORE: &str = "<Programs xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
     xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"eval__\"><Code><![CDATA[begin\n";

/// The program that executes `code`.
pub(crate) fn program(code: &str) -> String {
    let code = code.replace("]]>", "]]]]><![CDATA[>");
    format!("{BEFORE}{code}\nend]]></Code></Program></Programs>\n")
}
