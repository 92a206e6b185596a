//! Fixes of findings. A fix that would add an error anywhere is not offered.

use val3_analysis::db::{Db, File, FileRange};
use val3_analysis::system::System;
use val3_check::diagnostic::{Diagnostic, Fix};
use val3_check::fix::{AddedError, FixGuard};

use crate::edit::{FileEdit, SourceChange};
use crate::trial::TrialProjects;

/// Context in which fixes are tried before they are offered.
#[derive(Clone, Copy)]
pub struct FixContext<'a> {
    /// The current files.
    pub db: &'a dyn Db,
    /// File system with the texts of open documents.
    pub system: &'a dyn System,
    /// Called repeatedly while a fix is tried. It may unwind if the result is no longer needed.
    pub check_cancelled: &'a dyn Fn(),
}

/// A fix of a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct QuickFix<'d> {
    /// The fixed finding.
    pub diagnostic: &'d Diagnostic,
    /// Title, in the imperative.
    pub title: String,
    /// Whether the fix is certainly intended, so that editors may prefer it.
    pub safe: bool,
    /// Edits.
    pub change: SourceChange,
    /// Reason why the fix cannot be applied, as a sentence for the user; `None` if it can.
    pub disabled: Option<String>,
}

/// Fixes of the findings that overlap or touch `at`, safe fixes first.
pub fn quick_fixes<'d>(context: FixContext<'_>, diagnostics: &'d [Diagnostic], at: FileRange) -> Vec<QuickFix<'d>> {
    let touching = diagnostics.iter().filter(|diagnostic| touches(diagnostic.place, at));
    let fixes: Vec<(&Diagnostic, &Fix)> =
        touching.filter_map(|diagnostic| Some((diagnostic, diagnostic.fix.as_ref()?))).collect();
    let mut guard = guard(context, fixes.iter().map(|(_, fix)| *fix));
    let mut found: Vec<QuickFix<'d>> = Vec::new();
    for (diagnostic, fix) in fixes {
        let added = guard.as_mut().and_then(|guard| guard.added_error(context.db, &[fix]));
        found.push(QuickFix {
            diagnostic,
            title: capitalised(&fix.title),
            safe: fix.safe,
            change: SourceChange::of(edits(fix)),
            disabled: added.map(|error| reason(&error)),
        });
    }
    found.sort_by_key(|fix| !fix.safe);
    found
}

/// Whether the ranges overlap or touch.
fn touches(place: FileRange, at: FileRange) -> bool {
    place.file == at.file && place.range.intersect(at.range).is_some()
}

/// Safe fixes of a file that can be applied together without adding an error and do not overlap.
pub fn fix_all(context: FixContext<'_>, diagnostics: &[Diagnostic], file: File) -> SourceChange {
    let of_file = |fix: &&Fix| fix.safe && fix.edits.iter().all(|edit| edit.file == file);
    let fixes: Vec<&Fix> =
        diagnostics.iter().filter_map(|diagnostic| diagnostic.fix.as_ref()).filter(of_file).collect();
    let guard = guard(context, fixes.iter().copied());
    let harmless = guard.map(|mut guard| guard.harmless(context.db, fixes)).unwrap_or_default();
    SourceChange::of(harmless.into_iter().flat_map(edits)).sorted(context.db)
}

/// First error that a change would add anywhere, as a reason for the user.
pub(crate) fn added_error(context: FixContext<'_>, change: &SourceChange) -> Option<String> {
    let fix = Fix { title: String::new(), safe: true, edits: change.edits.clone() };
    let added = guard(context, std::iter::once(&fix))?.added_error(context.db, &[&fix]);
    added.map(|error| reason(&error))
}

/// Guard for these fixes; `None` without fixes, because creating a guard reads and checks all affected projects.
fn guard<'s, 'f>(context: FixContext<'s>, fixes: impl Iterator<Item = &'f Fix>) -> Option<FixGuard<TrialProjects<'s>>> {
    let mut fixes = fixes.peekable();
    fixes.peek()?;
    Some(FixGuard::new(TrialProjects::of_fixes(context.db, context.system, fixes, context.check_cancelled)))
}

fn reason(error: &AddedError) -> String {
    let file = error.path.file_name().unwrap_or(error.path.as_str());
    format!("it would add an error in `{file}`: {}", error.message)
}

fn edits(fix: &Fix) -> impl Iterator<Item = FileEdit> {
    fix.edits.iter().cloned()
}

fn capitalised(title: &str) -> String {
    let mut letters = title.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use val3_analysis::db::Project;
    use val3_check::settings::WorkspaceSettings;
    use val3_check::{check_unit, units};
    use val3_syntax::TextRange;

    use super::*;
    use crate::assists::testing::shown;
    use crate::testing::MarkedListing;

    fn findings(marked: &MarkedListing) -> Vec<Diagnostic> {
        let projects: Vec<Project> = marked.workspace.projects.clone();
        let settings = WorkspaceSettings::default();
        let checked = units(marked.db(), &projects).into_iter().map(|unit| check_unit(marked.db(), unit, &settings));
        checked.sum::<val3_check::Checked>().findings
    }

    fn context(marked: &MarkedListing) -> FixContext<'_> {
        FixContext { db: marked.db(), system: &marked.system, check_cancelled: &|| {} }
    }

    #[test]
    fn the_fix_at_the_cursor_is_offered() {
        let marked = MarkedListing::new("num nCount\nIF nCount==1\nn$0Cuont=2\nENDIF");
        let at = marked.at();
        let findings = findings(&marked);
        let fixes =
            quick_fixes(context(&marked), &findings, FileRange { file: at.file, range: TextRange::empty(at.offset) });
        let [fix] = fixes.as_slice() else { panic!("{fixes:?}") };
        assert_eq!((fix.title.as_str(), fix.safe), ("Write `nCount`", false));
        expect![[r#"
            usrapp/main/start.pgx
            -nCuont=2
            +nCount=2
        "#]]
        .assert_eq(&shown(marked.db(), &fix.change));
    }

    #[test]
    fn all_safe_fixes_of_a_file_are_offered() {
        let marked = MarkedListing::new("num nCount\nI$0F nCount==1\nnCuont=2\nENDIF");
        let change = fix_all(context(&marked), &findings(&marked), marked.at().file);
        expect![[r#"
            usrapp/main/start.pgx
            -IF nCount==1
            -nCuont=2
            -ENDIF
            +if nCount==1
            +nCuont=2
            +endIf
        "#]]
        .assert_eq(&shown(marked.db(), &change));
    }
}
