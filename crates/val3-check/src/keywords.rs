//! The rule on the spelling of keywords, applied to a program.

use val3_analysis::db::{Db, File, FileRange, Project};
use val3_analysis::items::faults::{OddKeyword, text_faults};
use val3_analysis::items::program;
use val3_syntax::text_at;

use crate::diagnostic::Diagnostic;
use crate::fix::Site;
use crate::rules::keyword_spelling;

/// Keywords that are not written in their usual letter case.
pub(crate) fn spelling(db: &dyn Db, project: Project, file: File) -> Vec<Diagnostic> {
    text_faults(db, file).odd_keywords.iter().map(|keyword| finding(db, project, file, *keyword)).collect()
}

fn finding(db: &dyn Db, project: Project, file: File, keyword: OddKeyword) -> Diagnostic {
    let written = text_at(file.text(db), keyword.range);
    let wording = keyword_spelling::word(written, keyword.canonical);
    let site = Site::new(db, file, keyword.range, None);
    Diagnostic {
        program: Some(program::header(db, file).name.to_string()),
        application: Some(project.manifest(db)),
        fix: Some(keyword_spelling::fix(&site, keyword.canonical)),
        ..Diagnostic::new(&keyword_spelling::RULE, wording, FileRange { file, range: keyword.range })
    }
}
