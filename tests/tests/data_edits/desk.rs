//! A cell's data file, and the checks of changes to it.

use camino::Utf8PathBuf;
use salsa::Setter as _;
use val3_analysis::db::{File, Project, Sources};
use val3_analysis::items::data::elements;
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_check::rule::Severity;
use val3_ide::{
    DataEdit, DataFinding, DataTables, FixContext, SourceChange, added_data_findings, data_edits, data_findings,
    data_tables, owner,
};
use val3_syntax::TextRange;

/// A data file in its workspace.
pub(crate) struct Desk {
    system: Memory,
    workspace: Workspace,
    file: File,
    project: Project,
}

impl Desk {
    /// Opens every data file of a cell, each in a separate workspace.
    pub(crate) fn open(cell: &[(String, Vec<u8>)]) -> Vec<Self> {
        let names: Vec<Utf8PathBuf> = cell.iter().map(|(path, _)| Utf8PathBuf::from("/").join(path)).collect();
        let open = |path: &Utf8PathBuf| {
            let files = names.iter().zip(cell).map(|(path, (_, bytes))| (path.clone(), bytes.clone()));
            let system = Memory::new(files);
            let workspace = load(&system, &[Utf8PathBuf::from("/")]).unwrap();
            let db = &workspace.db;
            let file = *Sources::get(db).files(db).values().find(|file| file.path(db) == path)?;
            let project = owner(db, file)?;
            Some(Self { system, file, project, workspace })
        };
        names.iter().filter(|path| path.extension() == Some("dtx")).filter_map(open).collect()
    }

    pub(crate) fn tables(&self) -> DataTables {
        data_tables(&self.workspace.db, self.project, self.file).unwrap()
    }

    fn text(&self) -> &str {
        self.file.text(&self.workspace.db)
    }

    fn change(&self, edits: &[DataEdit]) -> SourceChange {
        let change = data_edits(&self.workspace.db, self.project, self.file, edits);
        change.unwrap_or_else(|problem| panic!("{}: {edits:?}", problem.reason))
    }

    fn after(&self, change: &SourceChange) -> String {
        let apart = change.edits.windows(2).all(|pair| pair[0].range.end() <= pair[1].range.start());
        assert!(apart, "edits overlap: {change:?}");
        let mut text = self.text().to_owned();
        for edit in change.edits.iter().rev() {
            text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
        }
        text
    }

    /// Applies changes permanently.
    pub(crate) fn make(&mut self, edits: &[DataEdit]) {
        let text = self.after(&self.change(edits));
        self.file.set_text(&mut self.workspace.db).to(text.into());
    }

    /// Checks that the changes restore every byte.
    pub(crate) fn is_undone(&self, edits: &[DataEdit]) {
        assert_eq!(self.after(&self.change(edits)), self.text(), "{edits:?}");
    }

    /// Checks that a change replaces nothing outside the variable, and that the file remains readable.
    pub(crate) fn keeps_others(&self, edit: &DataEdit) {
        let change = self.change(std::slice::from_ref(edit));
        assert!(!change.is_empty(), "{edit:?}");
        let parse = val3_syntax::parse(self.text());
        let ranges: Vec<TextRange> = elements(parse.view()).map(|element| element.view().range()).collect();
        let touched = ranges.iter().filter(|range| {
            let is_in = |edit: &val3_ide::FileEdit| {
                !edit.range.is_empty() && range.intersect(edit.range).is_some_and(|it| !it.is_empty())
            };
            change.edits.iter().any(is_in)
        });
        assert!(touched.count() <= 1, "{edit:?} {change:?}");
        let after = self.after(&change);
        assert!(val3_syntax::parse(&after).errors().is_empty(), "{edit:?} {after}");
    }

    /// Checks that changes add no error to the file.
    pub(crate) fn adds_no_error(&self, edits: &[DataEdit]) {
        let db = &self.workspace.db;
        let context = FixContext { db, system: &self.system, check_cancelled: &|| {} };
        let before: Vec<DataFinding> = data_findings(db, self.file, []);
        let added = added_data_findings(context, self.file, &self.change(edits), &before);
        let errors = added.iter().filter(|found| found.diagnostic.severity == Severity::Error);
        let errors: Vec<&str> = errors.map(|found| found.diagnostic.message.as_str()).collect();
        assert!(errors.is_empty(), "{edits:?} {errors:?}");
    }
}
