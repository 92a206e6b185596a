//! Converts diagnostics of the analysis to findings with lines and columns.

use std::sync::Arc;

use camino::Utf8Path;
use rustc_hash::FxHashMap;
use val3_analysis::db::{Database, File, FileEdit, FileRange, FileStatus, Project, Sources};
use val3_analysis::items::faults::text_faults;
use val3_analysis::paths::path_key;
use val3_check::diagnostic::{self, Diagnostic, RelatedNote};
use val3_check::fingerprint::Fingerprint;
use val3_syntax::encoding::Encoding;

use crate::code_lines::CodeLines;
use crate::loose::LooseFiles;
use crate::paths::Paths;
use crate::printable::one_line;
use crate::report::{Finding, Related, ReportRange, ReportedEdit, ReportedFix, SourceFile};

/// Converts diagnostics to findings; each file is indexed once. Use a clone in another thread.
#[derive(Clone)]
pub(crate) struct Translator<'a> {
    db: Database,
    paths: &'a Paths,
    loose: &'a LooseFiles,
    files: FxHashMap<File, IndexedFile>,
}

#[derive(Clone)]
struct IndexedFile {
    source: Arc<SourceFile>,
    codes: Arc<CodeLines>,
}

impl<'a> Translator<'a> {
    /// Creates a translator that displays paths as `paths` defines them.
    pub(crate) fn new(db: Database, paths: &'a Paths, loose: &'a LooseFiles) -> Self {
        Self { db, paths, loose, files: FxHashMap::default() }
    }

    /// Converts a diagnostic to a finding.
    pub(crate) fn finding(&mut self, diagnostic: &Diagnostic) -> Finding {
        let IndexedFile { source, codes } = self.indexed(diagnostic.place.file, diagnostic.application);
        let place = ReportRange { file: source, range: diagnostic.place.range.into() };
        Finding {
            code: diagnostic.rule.code,
            name: diagnostic.rule.name,
            severity: diagnostic.severity.into(),
            fingerprint: Fingerprint::new(&self.db, diagnostic, |file| self.paths.in_repository(file.path(&self.db))),
            message: one_line(&diagnostic.message).into_owned(),
            label: one_line(&diagnostic.label).into_owned(),
            help: one_line(&diagnostic.help).into_owned(),
            program: diagnostic.program.clone(),
            code_line: codes.line(place.range.start, &place.file.lines),
            application: diagnostic.application.map(|file| self.application(file)),
            is_new: false,
            related: diagnostic.related.iter().map(|note| self.related(note, diagnostic.application)).collect(),
            fix: diagnostic.fix.as_ref().map(|fix| self.fix(fix, diagnostic.application)),
            place,
        }
    }

    fn fix(&mut self, fix: &diagnostic::Fix, application: Option<File>) -> ReportedFix {
        ReportedFix {
            title: one_line(&fix.title).into_owned(),
            safe: fix.safe,
            edits: fix.edits.iter().map(|edit| self.edit(edit, application)).collect(),
        }
    }

    fn edit(&mut self, edit: &FileEdit, application: Option<File>) -> ReportedEdit {
        let place = FileRange { file: edit.file, range: edit.range };
        ReportedEdit { place: self.place(place, application), text: edit.text.clone() }
    }

    /// Path of a project file; for a file without a project, the path of the file.
    fn application(&self, manifest: File) -> String {
        let path = manifest.path(&self.db);
        self.paths.relative(self.loose.file_of(path).unwrap_or(path))
    }

    /// Paths of the project files, sorted.
    pub(crate) fn applications(&self, projects: &[Project]) -> Vec<String> {
        let mut paths: Vec<_> = projects.iter().map(|project| self.application(project.manifest(&self.db))).collect();
        paths.sort_unstable();
        paths
    }

    fn related(&mut self, note: &RelatedNote, application: Option<File>) -> Related {
        Related { place: self.place(note.place, application), message: one_line(&note.message).into_owned() }
    }

    fn place(&mut self, FileRange { file, range }: FileRange, application: Option<File>) -> ReportRange {
        ReportRange { file: self.indexed(file, application).source, range: range.into() }
    }

    fn indexed(&mut self, file: File, application: Option<File>) -> IndexedFile {
        if let Some(indexed) = self.files.get(&file) {
            return indexed.clone();
        }
        let indexed = self.index(file, application);
        self.files.insert(file, indexed.clone());
        indexed
    }

    fn index(&self, file: File, application: Option<File>) -> IndexedFile {
        let path = file.path(&self.db);
        let mut source =
            SourceFile::new(&self.paths.relative(path), Arc::clone(file.text(&self.db)), self.encoding(file));
        source.shown = self.paths.shown(path);
        source.in_repository = self.paths.in_repository(path);
        source.disk = application.and_then(|application| self.on_controller(path, application));
        let codes = &text_faults(&self.db, file).codes;
        IndexedFile { source: Arc::new(source), codes: Arc::new(CodeLines::new(codes)) }
    }

    fn encoding(&self, file: File) -> Encoding {
        match file.status(&self.db) {
            FileStatus::Read { encoding, .. } => *encoding,
            FileStatus::Unreadable(_) => Encoding::Utf8,
        }
    }

    /// Path on the controller, for example `Disk://app/prog.pgx`. If the folder of `Disk://` is unknown, it is the
    /// parent of the application's folder.
    fn on_controller(&self, path: &Utf8Path, application: File) -> Option<String> {
        let manifest = application.path(&self.db);
        let project = self.project(manifest);
        let disk = project.and_then(|project| project.disk(&self.db));
        let disk = disk.or_else(|| manifest.parent()?.parent())?;
        let inside = path.strip_prefix(disk).ok()?;
        Some(format!("Disk://{}", inside.as_str().replace('\\', "/")))
    }

    fn project(&self, manifest: &Utf8Path) -> Option<Project> {
        Sources::get(&self.db).projects(&self.db).get(&path_key(manifest.as_str())).copied()
    }
}
