//! A finding as text: its line, message, remedy, and its fix as a diff.

use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use serde_json::Value;
use val3_files::FileClass;

use crate::roots::Roots;
use crate::tools::{items, number, text};

/// Formats a finding of the JSON report. `folder` is the checked folder, to which its paths are relative.
pub(super) fn shown(roots: &Roots, folder: &Utf8Path, finding: &Value) -> String {
    let path = folder.join(text(finding, "file"));
    let line = finding.pointer("/range/start/line").and_then(Value::as_u64).unwrap_or_default();
    let (severity, code, message) = (text(finding, "severity"), text(finding, "code"), text(finding, "message"));
    let mut out = format!("\n{severity} {code} {}:{line}: {message}", roots.shown(&path));
    let stored = FileText::read(roots, &path);
    for key in ["label", "help"] {
        let remark = text(finding, key);
        if !remark.is_empty() {
            out.push_str(&format!(" — {remark}"));
        }
    }
    out.push('\n');
    if let Some(code) = stored.as_ref().and_then(|stored| stored.line(line)) {
        out.push_str(&format!("    {code}\n"));
    }
    for related in items(finding, "related") {
        let path = roots.shown(&folder.join(text(related, "file")));
        let line = related.pointer("/range/start/line").and_then(Value::as_u64).unwrap_or_default();
        out.push_str(&format!("  see {path}:{line}: {}\n", text(related, "message")));
    }
    if let Some(fix) = finding.get("fix").filter(|fix| !fix.is_null()) {
        out.push_str(&fix_text(&path, stored.as_ref(), folder, fix));
    }
    out
}

/// Title of a fix, with a diff if it changes only the file of the finding.
fn fix_text(path: &Utf8Path, stored: Option<&FileText>, folder: &Utf8Path, fix: &Value) -> String {
    let safety = if fix.get("safe").and_then(Value::as_bool) == Some(true) { "safe" } else { "a guess" };
    let title = format!("  fix ({safety}): {}\n", text(fix, "title"));
    let edits = items(fix, "edits");
    let is_here = edits.iter().all(|edit| folder.join(text(edit, "file")) == path);
    let diff = stored.filter(|_| is_here).and_then(|stored| stored.diff(edits));
    diff.map_or(title.clone(), |diff| format!("{title}{diff}"))
}

/// Stored bytes of a file.
struct FileText(Vec<u8>);

impl FileText {
    /// Reads a file; `None` if it is outside of the roots or unreadable.
    fn read(roots: &Roots, path: &Utf8PathBuf) -> Option<Self> {
        let path = roots.resolve(path.as_str()).ok()?;
        val3_files::read(&path, FileClass::Program).ok().map(Self)
    }

    /// Text of a line, counted from 1.
    fn line(&self, number: u64) -> Option<String> {
        let index = usize::try_from(number.checked_sub(1)?).ok()?;
        let line = self.0.split(|byte| *byte == b'\n').nth(index)?;
        Some(String::from_utf8_lossy(line).trim().to_owned())
    }

    /// Lines before and after the edits; `None` if an edit is outside of the file.
    fn diff(&self, edits: &[Value]) -> Option<String> {
        let mut edits: Vec<(Range<usize>, &str)> = edits.iter().map(edit).collect::<Option<_>>()?;
        edits.sort_by_key(|(range, _)| range.start);
        let mut after = self.0.clone();
        for (range, text) in edits.iter().rev() {
            self.0.get(range.clone())?;
            after.splice(range.clone(), text.bytes());
        }
        let (before, after) = (String::from_utf8_lossy(&self.0), String::from_utf8_lossy(&after));
        let diff = similar::TextDiff::from_lines(before.as_ref(), after.as_ref());
        let changed = diff.iter_all_changes().filter(|change| change.tag() != similar::ChangeTag::Equal);
        Some(changed.map(|change| format!("  {}{}\n", change.tag(), change.value().trim_end())).collect())
    }
}

/// Range in bytes and new text of an edit.
fn edit(edit: &Value) -> Option<(Range<usize>, &str)> {
    let at = |end: &str| usize::try_from(number(edit.pointer(&format!("/range/{end}"))?, "offset")).ok();
    Some((at("start")?..at("end")?, text(edit, "text")))
}
