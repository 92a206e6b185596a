//! Changes of files: their effect on findings, their diff, and their execution.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use similar::TextDiff;
use val3_analysis::db::{Database, Db, File, FileEdit, FileStatus};
use val3_analysis::load::Workspace;
use val3_analysis::system::{Disk, OverlayFs, System};
use val3_check::diagnostic::Diagnostic;
use val3_check::rule::Severity;
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_check::{Checked, check_unit, finish, units};
use val3_files::{FileClass, Unwritable, replace, replace_unchanged};
use val3_ide::SourceChange;
use val3_syntax::encoding::{Encoding, decode};

use crate::projects;
use crate::refusal::Refusal;
use crate::roots::Roots;

/// Contents of a file before and after the change, in the file's encoding.
#[derive(Debug, Clone, PartialEq, Eq)]
struct FileChange {
    path: Utf8PathBuf,
    /// Content before; `None` if the file is created.
    before: Option<Vec<u8>>,
    /// Content after; `None` if the file is removed.
    after: Option<Vec<u8>>,
}

/// Changes of files that are written together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Changes {
    files: Vec<FileChange>,
    /// Moved files: old and new path, relative to the root.
    moves: Vec<[String; 2]>,
    /// Old and new name of the declaration that is renamed.
    renamed: Option<[String; 2]>,
}

impl Changes {
    /// Converts a change of source texts to changes of bytes.
    ///
    /// # Errors
    /// A file is outside of the roots, or its encoding does not have a character of the new text.
    pub(crate) fn of(db: &Database, roots: &Roots, change: &SourceChange) -> Result<Self, Refusal> {
        let mut files: BTreeMap<Utf8PathBuf, FileChange> = BTreeMap::new();
        for (path, text) in &change.creates {
            let after = Some(text.clone().into_bytes());
            files.insert(path.clone(), FileChange { path: path.clone(), before: None, after });
        }
        for file in edited_files(change) {
            let edits = change.edits.iter().filter(|edit| edit.file == file);
            let after = FileEdit::apply_all(file.text(db), edits);
            let file = edited(db, roots, file, &after)?;
            files.insert(file.path.clone(), file);
        }
        for (old, new) in &change.moves {
            let moved = match files.remove(old) {
                Some(edited) => edited,
                None => unchanged(old)?,
            };
            files.insert(new.clone(), FileChange { path: new.clone(), before: None, after: moved.after });
            files.insert(old.clone(), FileChange { path: old.clone(), before: moved.before, after: None });
        }
        for path in &change.deletes {
            let file = unchanged(path)?;
            files.insert(path.clone(), FileChange { after: None, ..file });
        }
        let files: Vec<FileChange> = files.into_values().filter(|file| file.before != file.after).collect();
        match files.iter().find(|file| !roots.contains(&Disk.target(&file.path))) {
            Some(file) => {
                Err(Refusal(format!("`{}` would have to be changed, and is outside of `{}`", file.path, roots.first())))
            }
            None => {
                let moves = change.moves.iter().map(|(old, new)| [roots.shown(old), roots.shown(new)]).collect();
                Ok(Self { files, moves, renamed: None })
            }
        }
    }

    /// Adds the name that the change replaces, so that findings with the old and the new name are recognised as equal.
    pub(crate) fn renaming(self, old: &str, new: &str) -> Self {
        Self { renamed: Some([old.to_owned(), new.to_owned()]), ..self }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// Changed files, each with its changed lines. For a created file, only its number of lines.
    pub(crate) fn diff(&self, roots: &Roots) -> String {
        self.files.iter().map(|file| file.diff(roots)).collect()
    }

    /// Effect of the change on the projects below `path`: the new findings, one per line, and the number of removed
    /// findings.
    ///
    /// # Errors
    /// The projects cannot be read.
    pub(crate) fn effect(&self, roots: &Roots, path: &Utf8Path) -> Result<Effect, Refusal> {
        let mut changed = OverlayFs::new(Disk);
        for FileChange { path, after, .. } in &self.files {
            match after {
                Some(after) => changed.store(path.clone(), after.clone()),
                None => changed.remove(path),
            }
        }
        let (before, after) = (findings(&Disk, roots, path)?, findings(&changed, roots, path)?);
        // Several lines can have the same finding.
        let mut open: BTreeMap<FindingKey, usize> = BTreeMap::new();
        for finding in &before {
            *open.entry(self.key(finding)).or_default() += 1;
        }
        let mut new: Vec<&Finding> = Vec::new();
        for finding in &after {
            match open.get_mut(&self.key(finding)).filter(|count| **count > 0) {
                Some(count) => *count -= 1,
                None => new.push(finding),
            }
        }
        let solved = open.values().sum();
        Ok(Effect {
            has_errors: new.iter().any(|finding| finding.severity == Severity::Error),
            new: new.iter().map(|finding| finding.text.clone()).collect(),
            solved,
        })
    }

    /// File, rule and message of a finding, with new paths and the new name. Findings before and after the change that
    /// have equal keys are the same, even if their lines differ.
    fn key(&self, Finding { path, code, message, .. }: &Finding) -> FindingKey {
        let moved = self.moves.iter().find(|[old, _]| old == path);
        let path = moved.map_or(path, |[_, new]| new);
        let message = self.renamed.as_ref().map_or_else(|| message.clone(), |[old, new]| with_name(message, old, new));
        (path.clone(), code, message)
    }

    /// Writes all files. Each file is either replaced completely or unchanged. Files are removed last, so that the
    /// content of a moved file exists at any time.
    ///
    /// # Errors
    ///
    /// A file cannot be written, or was changed since it was read. Earlier files of the list are written in this case.
    pub(crate) fn write(&self, roots: &Roots) -> Result<(), Refusal> {
        let mut files: Vec<&FileChange> = self.files.iter().collect();
        files.sort_by_key(|file| self.step(file));
        files.into_iter().try_for_each(|file| file.write(roots))
    }

    /// Step in which a file is written. A name that a new file has in other letter case is removed first, because many
    /// disks regard both names as one.
    fn step(&self, file: &FileChange) -> u8 {
        let name = |file: &FileChange| file.path.as_str().to_lowercase();
        match file.after {
            Some(_) => 1,
            None if self.files.iter().any(|other| other.before.is_none() && name(other) == name(file)) => 0,
            None => 2,
        }
    }
}

/// Effect of a change on findings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Effect {
    /// New findings, one per line.
    pub(crate) new: Vec<String>,
    /// Whether one of the new findings is an error.
    pub(crate) has_errors: bool,
    /// Number of findings that have disappeared.
    pub(crate) solved: usize,
}

impl FileChange {
    fn diff(&self, roots: &Roots) -> String {
        let path = roots.shown(&self.path);
        let text = |bytes: &[u8]| decode(bytes.to_vec()).text;
        match (&self.before, &self.after) {
            (None, Some(after)) => format!("created {path}, {} lines\n", text(after).lines().count()),
            (_, None) => format!("removed {path}\n"),
            (Some(before), Some(after)) => {
                let (before, after) = (text(before), text(after));
                let diff = TextDiff::from_lines(before.as_str(), after.as_str());
                let hunks = diff.unified_diff().context_radius(0).to_string();
                format!("changed {path}\n```diff\n{}\n```\n", hunks.trim_end())
            }
        }
    }

    fn write(&self, roots: &Roots) -> Result<(), Refusal> {
        let written: Result<(), Unwritable> = match (&self.before, &self.after) {
            (Some(before), Some(after)) => replace_unchanged(&self.path, FileClass::Program, before, after),
            (None, Some(after)) => replace(&self.path, after),
            (_, None) => return fs::remove_file(&self.path).map_err(|error| self.refused(roots, &error)),
        };
        written.map_err(|reason| self.refused(roots, &reason))
    }

    /// Refusal of the change because the file cannot be written or removed.
    fn refused(&self, roots: &Roots, reason: &dyn Display) -> Refusal {
        let path = roots.shown(&self.path);
        Refusal(format!("cannot write `{path}`: {reason}. Files before it are written: `check` shows the state"))
    }
}

/// Files with edits, without duplicates.
fn edited_files(change: &SourceChange) -> Vec<File> {
    let mut files: Vec<File> = Vec::new();
    for edit in &change.edits {
        if !files.contains(&edit.file) {
            files.push(edit.file);
        }
    }
    files
}

fn edited(db: &Database, roots: &Roots, file: File, after: &str) -> Result<FileChange, Refusal> {
    let path = file.path(db);
    let encoding = match file.status(db) {
        FileStatus::Read { encoding, .. } => *encoding,
        FileStatus::Unreadable(reason) => return Err(Refusal(format!("`{}`: {reason}", roots.shown(path)))),
    };
    let bytes = encoding.encode(after);
    if !reads_back(&bytes, encoding, after) {
        let reason = "the new text has a character that the encoding of the file does not support: use ASCII";
        return Err(Refusal(format!("`{}`: {reason}", roots.shown(path))));
    }
    Ok(FileChange { path: path.clone(), before: Some(encoding.encode(file.text(db))), after: Some(bytes) })
}

fn reads_back(bytes: &[u8], encoding: Encoding, text: &str) -> bool {
    let read = decode(bytes.to_vec());
    read.text == text && read.encoding == encoding
}

fn unchanged(path: &Utf8Path) -> Result<FileChange, Refusal> {
    let bytes = val3_files::read(path, FileClass::Program).map_err(|reason| Refusal(format!("`{path}`: {reason}")))?;
    Ok(FileChange { path: path.to_owned(), before: Some(bytes.clone()), after: Some(bytes) })
}

/// File, rule and message of a finding.
type FindingKey = (String, &'static str, String);

/// A finding.
struct Finding {
    severity: Severity,
    /// File relative to the root.
    path: String,
    code: &'static str,
    message: String,
    /// Description for the answer.
    text: String,
}

impl Finding {
    fn of(db: &dyn Db, roots: &Roots, finding: &Diagnostic) -> Self {
        let Diagnostic { rule, severity, message, place, help, .. } = finding;
        let path = roots.shown(place.file.path(db));
        let text = place.file.text(db);
        let start = usize::from(place.range.start());
        let line = 1 + text.get(..start).unwrap_or_default().matches('\n').count();
        let level = format!("{severity:?}").to_lowercase();
        let code = text.lines().nth(line - 1).unwrap_or_default().trim();
        let help = if help.is_empty() { String::new() } else { format!(" — {help}") };
        Self {
            severity: *severity,
            code: rule.code,
            text: format!("{level} {} {path}:{line}: {message}{help}\n    {code}", rule.code),
            message: message.clone(),
            path,
        }
    }
}

/// Replaces a name in a message, also in names of files.
fn with_name(message: &str, old: &str, new: &str) -> String {
    let is_part = |character: char| character.is_alphanumeric() || character == '_';
    let pieces = message.split_inclusive(|character| !is_part(character)).map(|piece| {
        let word = piece.trim_end_matches(|character| !is_part(character));
        if word == old { format!("{new}{}", piece.get(word.len()..).unwrap_or_default()) } else { piece.to_owned() }
    });
    pieces.collect()
}

/// Findings of the projects below a path.
fn findings(system: &dyn System, roots: &Roots, path: &Utf8Path) -> Result<Vec<Finding>, Refusal> {
    let Workspace { db, projects, .. } = projects::read(system, roots, path)?;
    let settings = WorkspaceSettings::new(&db, &projects, &RuleSelection::default())
        .map_err(|errors| Refusal(errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")))?;
    let units = units(&db, &projects);
    let checked: Checked = units.iter().map(|unit| check_unit(&db, *unit, &settings)).sum();
    let found = finish(&db, &units, &settings, checked).findings;
    Ok(found.iter().map(|finding| Finding::of(&db, roots, finding)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Folder;

    fn change(folder: &Folder, path: &str, before: Option<&str>, after: Option<&str>) -> FileChange {
        let [before, after] = [before, after].map(|text| text.map(|text| text.as_bytes().to_vec()));
        FileChange { path: folder.path().join(path), before, after }
    }

    #[test]
    fn a_second_line_with_an_equal_finding_is_new() {
        let project = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
            <Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n  \
            <Parameters version=\"s7.11.3\" />\n  \
            <Programs>\n    <Program file=\"pick.pgx\" />\n  </Programs>\n</Project>\n";
        let program = |code: &str| {
            format!(
                "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
                 <Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  <Program name=\"pick\">\n    \
                 <Code><![CDATA[begin\n{code}end]]></Code>\n  </Program>\n</Programs>\n"
            )
        };
        let (one, two) = (program("  wait(1)\n"), program("  wait(1)\n  wait(1)\n"));
        let folder = Folder::new(&[("cell/cell.pjx", project), ("cell/pick.pgx", &one)]);
        let effect = |before: &str, after: &str| {
            fs::write(folder.path().join("cell/pick.pgx"), before).unwrap();
            let files = vec![change(&folder, "cell/pick.pgx", Some(before), Some(after))];
            let changes = Changes { files, moves: Vec::new(), renamed: None };
            let Effect { new, has_errors, solved } = changes.effect(&folder.roots(), &folder.path()).unwrap();
            (new.len(), has_errors, solved)
        };
        assert_eq!(effect(&one, &two), (1, true, 0));
        assert_eq!(effect(&two, &one), (0, false, 1));
        assert_eq!(effect(&one, &one.replace("begin\n", "begin\n\n")), (0, false, 0));
    }

    #[test]
    fn a_moved_file_keeps_its_content_if_the_new_one_cannot_be_written() {
        let folder = Folder::new(&[("a.pgx", "old")]);
        let changes = |new: &str| {
            let files = vec![change(&folder, "a.pgx", Some("old"), None), change(&folder, new, None, Some("old"))];
            Changes { files, moves: Vec::new(), renamed: None }
        };
        let refusal = changes("none/b.pgx").write(&folder.roots()).unwrap_err();
        assert!(refusal.0.contains("none/b.pgx"), "{refusal}");
        assert!(folder.path().join("a.pgx").is_file());
        changes("b.pgx").write(&folder.roots()).unwrap();
        assert!(folder.path().join("b.pgx").is_file() && !folder.path().join("a.pgx").exists());
        let steps = |changes: &Changes| changes.files.iter().map(|file| changes.step(file)).collect::<Vec<_>>();
        assert_eq!((steps(&changes("b.pgx")), steps(&changes("A.pgx"))), (vec![2, 1], vec![0, 1]));
    }
}
