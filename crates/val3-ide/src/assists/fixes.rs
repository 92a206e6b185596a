//! The fixes that come with findings.

use val3_analysis::db::{Db, File, FileRange};
use val3_check::diagnostic::{Diagnostic, Fix};

use crate::edit::{FileEdit, SourceChange};

/// The fixes of the findings that `at` touches, each with what it changes: safe ones first.
pub fn quick_fixes<'d>(diagnostics: &'d [Diagnostic], at: FileRange) -> Vec<QuickFix<'d>> {
    let touches = |diagnostic: &&Diagnostic| {
        diagnostic.place.file == at.file && diagnostic.place.range.intersect(at.range).is_some()
    };
    let fixes =
        diagnostics.iter().filter(touches).filter_map(|diagnostic| Some((diagnostic, diagnostic.fix.as_ref()?)));
    let mut found: Vec<QuickFix<'d>> = fixes.map(|(diagnostic, fix)| QuickFix::new(diagnostic, fix)).collect();
    found.sort_by_key(|fix| !fix.safe);
    found
}

/// A fix of a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct QuickFix<'d> {
    /// What it mends.
    pub diagnostic: &'d Diagnostic,
    /// What it does, as an order.
    pub title: String,
    /// It does what was plainly meant; editors may prefer it.
    pub safe: bool,
    /// What it changes.
    pub change: SourceChange,
}

impl<'d> QuickFix<'d> {
    fn new(diagnostic: &'d Diagnostic, fix: &'d Fix) -> Self {
        Self { diagnostic, title: capitalised(&fix.title), safe: fix.safe, change: SourceChange::of(edits(fix)) }
    }
}

fn edits(fix: &Fix) -> impl Iterator<Item = FileEdit> {
    fix.edits.iter().map(|edit| FileEdit { file: edit.place.file, range: edit.place.range, text: edit.text.clone() })
}

/// All safe fixes of a file's findings that do not touch each other, at once.
pub fn fix_all(db: &dyn Db, diagnostics: &[Diagnostic], file: File) -> SourceChange {
    let of_file = |fix: &&Fix| fix.safe && fix.edits.iter().all(|edit| edit.place.file == file);
    let mut edits: Vec<FileEdit> = Vec::new();
    for fix in diagnostics.iter().filter_map(|diagnostic| diagnostic.fix.as_ref()).filter(of_file) {
        let new: Vec<FileEdit> = self::edits(fix).collect();
        let apart = |edit: &FileEdit| edits.iter().all(|other| other.range.intersect(edit.range).is_none());
        if new.iter().all(apart) {
            edits.extend(new);
        }
    }
    SourceChange::of(edits).sorted(db)
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
    use crate::testing::Marked;

    fn findings(marked: &Marked) -> Vec<Diagnostic> {
        let projects: Vec<Project> = marked.workspace.projects.clone();
        let settings = WorkspaceSettings::default();
        let checked = units(marked.db(), &projects).into_iter().map(|unit| check_unit(marked.db(), unit, &settings));
        checked.sum::<val3_check::Checked>().findings
    }

    #[test]
    fn the_fix_at_the_cursor() {
        let marked = Marked::new("num nCount\nIF nCount==1\nn$0Cuont=2\nENDIF");
        let at = marked.at();
        let findings = findings(&marked);
        let fixes = quick_fixes(&findings, FileRange { file: at.file, range: TextRange::empty(at.offset) });
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
    fn all_safe_fixes_of_a_file() {
        let marked = Marked::new("num nCount\nI$0F nCount==1\nnCuont=2\nENDIF");
        let change = fix_all(marked.db(), &findings(&marked), marked.at().file);
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
