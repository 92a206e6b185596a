//! Laws of refactorings: no new findings, no lost comment, formatted code if the file was formatted, and an inverse
//! that restores every byte.

use val3_analysis::db::{File, FileRange, FileStatus};
use val3_fmt::CodeStyle;
use val3_ide::{FilePosition, SourceChange, assists, resolve_assist};
use val3_syntax::{SyntaxKind, TextRange, TextSize};

use crate::assists::edited_cell::{Before, Counts, EditedCell, counted, surplus};

/// Assists with their inverses.
const INVERSES: [(&str, &str); 14] = [
    ("invert-if", "invert-if"),
    ("split-if", "merge-if"),
    ("merge-if", "split-if"),
    ("switch-to-if", "if-to-switch"),
    ("if-to-switch", "switch-to-if"),
    ("array-to-collection", "collection-to-array"),
    ("collection-to-array", "array-to-collection"),
    ("extract-variable", "inline-variable"),
    ("toggle-access", "toggle-access"),
    ("move-parameter-left", "move-parameter-right"),
    ("move-parameter-right", "move-parameter-left"),
    ("pass-by-reference", "pass-by-value"),
    ("pass-by-value", "pass-by-reference"),
    ("extract-program", "inline-program"),
];

/// Assists whose inverse restores the behaviour, but not the lines or the keys of a collection.
const LOSSY: [&str; 4] = ["switch-to-if", "if-to-switch", "extract-program", "collection-to-array"];

/// Assists that move or copy code to another program, with its findings.
const MOVES_CODE: [&str; 2] = ["extract-program", "inline-program"];

/// Findings that an assist may add, because they are true and no fault of the assist.
const MAY_COME: [(&str, &str); 16] = [
    // The user completes the condition `true` and the loop around old lines.
    ("surround-if", "V0301"),
    ("surround-while", "V0301"),
    ("surround-while", "V0302"),
    ("surround-while", "V0308"),
    ("surround-while", "V0342"),
    ("surround-for", "V0342"),
    // The access determines which uses are known.
    ("toggle-access", "V0113"),
    ("toggle-access", "V0114"),
    ("toggle-access", "V0117"),
    // The last call is inlined, and an unused local is added under a new name.
    ("inline-program", "V0117"),
    ("inline-program", "V0115"),
    // An empty `case` is usual, but an empty branch is not; neither is storing a literal that is never used.
    ("switch-to-if", "V0330"),
    ("extract-constant", "V0312"),
    ("extract-variable", "V0312"),
    ("extract-variable-all", "V0312"),
    // The new variable may only be written.
    ("create-local", "V0120"),
];

/// Result at one range.
#[derive(Debug, Default)]
pub(crate) struct RunStatus {
    /// Broken laws.
    pub(crate) failures: Vec<String>,
    /// Texts of the edits, if there are failures.
    pub(crate) texts: Vec<String>,
    /// Findings that the change removes.
    pub(crate) removed: Vec<String>,
    /// Result of the inverse; `None` if there is no inverse, or it is not offered.
    pub(crate) returned: Option<Returned>,
}

/// Comparison between the original files and the files after an assist and its inverse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Returned {
    Other,
    /// The same lines, possibly in another order or with other whitespace.
    Lines,
    Bytes,
}

/// A cell to which assists are applied, with its findings.
pub(crate) struct Laws {
    pub(crate) cell: EditedCell,
    pub(crate) findings: Counts,
}

impl Laws {
    pub(crate) fn of(cell: EditedCell) -> Self {
        let findings = cell.findings();
        Self { cell, findings }
    }

    /// Applies the assist `id` at a range, and then its inverse.
    pub(crate) fn check(&mut self, id: &str, place: FileRange) -> RunStatus {
        let mut status = RunStatus::default();
        let Some(change) = resolve_assist(self.cell.db(), id, place) else {
            status.failures.push("it is offered and changes nothing".to_owned());
            return status;
        };
        if let Err(failure) = self.judge(id, place, &change, &mut status) {
            status.failures.push(failure);
        }
        if !status.failures.is_empty() {
            status.texts = change.edits.into_iter().map(|edit| edit.text).collect();
        }
        status
    }

    fn judge(
        &mut self,
        id: &str,
        place: FileRange,
        change: &SourceChange,
        status: &mut RunStatus,
    ) -> Result<(), String> {
        status.failures.extend(self.lost(change)?);
        status.failures.extend(self.undo_differs(change)?);
        let laid_out: Vec<File> =
            change.edits.iter().map(|edit| edit.file).filter(|file| self.keeps_layout(id, *file)).collect();
        let before = self.cell.apply(change)?;
        status.failures.extend(change.new_name.and_then(|name| self.not_renamed(name)));
        let disordered = laid_out.into_iter().find(|file| !self.is_laid_out(*file));
        status.failures.extend(disordered.map(|file| format!("another layout: {}", file.path(self.cell.db()))));
        let (old, new) = (comparable(id, &self.findings), comparable(id, &self.cell.findings()));
        let added = surplus(&new, &old).into_iter().filter(|found| !may_come(id, found));
        status.failures.extend(added.map(|finding| format!("new finding: {finding}")));
        status.removed = surplus(&old, &new);
        let inverse = INVERSES.iter().find(|(one, _)| *one == id).map(|(_, inverse)| *inverse);
        if let Some(inverse) = inverse {
            let places = return_places(place, change);
            status.returned = self.returns(inverse, &places, &before);
            if status.returned.is_some_and(|returned| returned < required(id)) {
                status.failures.push(format!("`{inverse}` does not give back every byte"));
            }
        }
        self.cell.restore(&before);
        Ok(())
    }

    /// Returns the reason why a name that a change has invented cannot be renamed.
    fn not_renamed(&self, FileRange { file, range }: FileRange) -> Option<String> {
        match val3_ide::prepare_rename(self.cell.db(), FilePosition { file, offset: range.start() }) {
            Ok((found, _)) if found == range => None,
            Ok((found, name)) => Some(format!("the new name is `{name}` at {found:?}, not at {range:?}")),
            Err(refusal) => Some(format!("the new name: {}", refusal.0)),
        }
    }

    /// Whether the file is formatted, and the code that may move to it too.
    fn keeps_layout(&self, id: &str, file: File) -> bool {
        if !MOVES_CODE.contains(&id) {
            return self.is_laid_out(file);
        }
        let folder = |file: &File| file.path(self.cell.db()).parent();
        let sources = self.cell.project_files().into_iter().filter(|other| folder(other) == folder(&file));
        sources.chain([file]).all(|file| self.is_laid_out(file))
    }

    /// Whether the formatter changes nothing.
    fn is_laid_out(&self, file: File) -> bool {
        val3_ide::format_file(self.cell.db(), file, &CodeStyle::default()).is_empty()
    }

    /// Returns syntax errors that a change adds, and comments that it loses.
    fn lost(&self, change: &SourceChange) -> Result<Vec<String>, String> {
        let edited = self.cell.texts(change)?;
        let old = || edited.iter().map(|(file, _)| &**file.text(self.cell.db()));
        let new = || edited.iter().map(|(_, text)| text).chain(change.creates.iter().map(|(_, text)| text));
        let faults = surplus(&counted(new().flat_map(|text| faults(text))), &counted(old().flat_map(faults)));
        let comments = surplus(&counted(old().flat_map(comments)), &counted(new().flat_map(|text| comments(text))));
        let faults = faults.into_iter().map(|fault| format!("syntax error: {fault}"));
        Ok(faults.chain(comments.into_iter().map(|comment| format!("lost comment: {comment}"))).collect())
    }

    /// Returns files whose bytes differ after the change is undone in an editor.
    fn undo_differs(&self, change: &SourceChange) -> Result<Vec<String>, String> {
        let texts = self.cell.texts(change)?;
        let differs = texts.iter().filter(|(file, text)| !self.undo_restores(*file, text, change));
        Ok(differs.map(|(file, _)| format!("undo changes {}", file.path(self.cell.db()))).collect())
    }

    fn undo_restores(&self, file: File, text: &str, change: &SourceChange) -> bool {
        let db = self.cell.db();
        let FileStatus::Read { encoding, .. } = file.status(db) else { return false };
        // The editor reads the saved bytes again.
        let saved = val3_syntax::encoding::decode(encoding.encode(text)).text;
        let old: &str = file.text(db);
        let mut undone = saved.clone();
        let edits: Vec<_> = change.edits.iter().filter(|edit| edit.file == file).collect();
        for edit in edits {
            // All previous edits are undone, so the edit starts at its offset in the old text.
            let start = usize::from(edit.range.start());
            undone.replace_range(start..start + edit.text.len(), &old[std::ops::Range::<usize>::from(edit.range)]);
        }
        saved == text && self.cell.bytes(file.path(db)) == Some(&encoding.encode(&undone))
    }

    /// Returns the best result of the inverse at these ranges; `None` if it is not offered at any.
    fn returns(&mut self, inverse: &str, places: &[FileRange], before: &Before) -> Option<Returned> {
        let mut returned = None;
        for place in places {
            let is_offered = |assist: &val3_ide::Assist| assist.id == inverse && assist.disabled.is_none();
            if !assists(self.cell.db(), *place, None).iter().any(is_offered) {
                continue;
            }
            let change = resolve_assist(self.cell.db(), inverse, *place);
            let Some(Ok(there)) = change.map(|change| self.cell.apply(&change)) else { continue };
            returned = returned.max(Some(self.compared(before, &there)));
            self.cell.restore(&there);
            if returned == Some(Returned::Bytes) {
                break;
            }
        }
        returned
    }

    /// Compares the present files with the files in `before`; `there` are the files that the inverse has touched.
    fn compared(&self, before: &Before, there: &Before) -> Returned {
        let is_same = |same: fn(&[u8], &[u8]) -> bool| {
            before.iter().all(|(path, bytes)| match (self.cell.bytes(path), bytes) {
                (Some(now), Some(before)) => same(now, before),
                (now, before) => now.is_none() && before.is_none(),
            })
        };
        let only = there.iter().all(|(path, _)| before.iter().any(|(known, _)| known == path));
        if only && is_same(|now, before| now == before) {
            Returned::Bytes
        } else if only && is_same(|now, before| sorted_lines(now) == sorted_lines(before)) {
            Returned::Lines
        } else {
            Returned::Other
        }
    }
}

fn sorted_lines(bytes: &[u8]) -> Vec<&[u8]> {
    let mut lines: Vec<&[u8]> = bytes.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii).collect();
    lines.sort_unstable();
    lines
}

/// Whether an assist has an inverse.
pub(crate) fn has_inverse(id: &str) -> bool {
    INVERSES.iter().any(|(one, _)| *one == id)
}

/// Returns the minimal result that the inverse must reach.
fn required(id: &str) -> Returned {
    match id {
        // A comment between two conditions moves into the block.
        "merge-if" => Returned::Lines,
        _ if LOSSY.contains(&id) => Returned::Other,
        _ => Returned::Bytes,
    }
}

fn may_come(id: &str, finding: &str) -> bool {
    MAY_COME.iter().any(|(assist, code)| *assist == id && finding.starts_with(code))
}

/// Returns the findings; if code moves, without duplicates and files.
fn comparable(id: &str, findings: &Counts) -> Counts {
    if !MOVES_CODE.contains(&id) {
        return findings.clone();
    }
    let message = |finding: &String| {
        let (place, message) = finding.split_once(": ").unwrap_or(("", finding));
        (format!("{}: {message}", place.split(' ').next().unwrap_or("")), 1)
    };
    findings.keys().map(message).collect()
}

/// Returns the ranges at which the inverse may be offered: the original range, and each edit's start and inside.
fn return_places(place: FileRange, change: &SourceChange) -> Vec<FileRange> {
    let cursor = |file, at: usize| FileRange { file, range: TextRange::empty(TextSize::try_from(at).unwrap()) };
    let mut places = vec![cursor(place.file, usize::from(place.range.start()))];
    let mut shift = 0;
    let mut previous = None;
    for edit in &change.edits {
        if previous != Some(edit.file) {
            shift = 0;
            previous = Some(edit.file);
        }
        let start = usize::from(edit.range.start()).wrapping_add_signed(shift);
        let words = edit.text.match_indices(|letter: char| letter.is_alphanumeric()).map(|(at, _)| at);
        let starts = words.filter(|at| *at == 0 || !edit.text[..*at].ends_with(|it: char| it.is_alphanumeric()));
        places.extend(starts.chain([0, edit.text.len()]).take(40).map(|at| cursor(edit.file, start + at)));
        shift += isize::try_from(edit.text.len()).unwrap() - isize::try_from(usize::from(edit.range.len())).unwrap();
    }
    places
}

fn faults(text: &str) -> Vec<String> {
    val3_syntax::parse(text).errors().iter().map(|error| format!("{:?}", error.kind)).collect()
}

fn comments(text: &str) -> Vec<String> {
    let root = val3_syntax::parse(text).root();
    let tokens = root.descendants_with_tokens().filter_map(|element| element.into_token());
    let comments = tokens.filter(|token| token.kind() == SyntaxKind::COMMENT);
    comments.map(|token| token.text().trim().to_owned()).collect()
}
