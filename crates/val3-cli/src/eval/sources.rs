//! The application that a scope is: one given, or an empty one, with the variables and one program more.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::declarations::{file_list, is_old};
use val3_syntax::encoding::decode;

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
    let path = file.path(db).clone();
    let mut text = decode(std::fs::read(&path).map_err(|error| unreadable(&path, &error))?).text;
    let lists = [(true, "pgx"), (false, "dtx")].map(|(programs, kind)| (file_list(db, project, programs), kind));
    let mut entries: Vec<(usize, String)> = Vec::new();
    for (list, kind) in lists {
        let Some((list, last)) = list.and_then(|list| list.last.map(|last| (list, last))) else {
            return Err(UserError::new(format!("`{path}` lists no .{kind} file")).with_help("list one"));
        };
        entries.push((last.end().into(), format!("<{} file=\"{NAME}.{kind}\" />", list.item)));
    }
    entries.sort_unstable_by_key(|(at, _)| std::cmp::Reverse(*at));
    entries.iter().for_each(|(at, entry)| text.insert_str(*at, entry));
    if is_old(db, project) {
        return Err(UserError::new(format!("`{path}` is of s5 or s6, whose files hold other data"))
            .with_help("save the application for s7 or later"));
    }
    Ok((path, text))
}

fn unreadable(path: &Utf8Path, error: &std::io::Error) -> UserError {
    UserError::new(format!("cannot read `{path}`: {error}"))
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

/// The program that executes `code`.
pub(crate) fn program(code: &str) -> String {
    let code = code.replace("]]>", "]]]]><![CDATA[>");
    format!(
        "{HEAD}<Programs xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  \
         <Program name=\"{NAME}\">\n    <Code><![CDATA[begin\n{code}\nend]]></Code>\n  </Program>\n</Programs>\n"
    )
}
