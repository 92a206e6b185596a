//! A finding as text: its line, message and remedy, and its fix as a diff.

use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use serde_json::Value;
use val3_files::FileClass;

use crate::report::{items, number, text};
use crate::roots::Roots;

/// Formats a finding of the JSON report. `folder` is the checked folder, to which the paths in the report are relative.
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

/// Title of a fix, with a diff if only the finding's file is changed.
fn fix_text(path: &Utf8Path, stored: Option<&FileText>, folder: &Utf8Path, fix: &Value) -> String {
    let safety = if fix.get("safe").and_then(Value::as_bool) == Some(true) { "safe" } else { "a guess" };
    let title = format!("  fix ({safety}): {}\n", text(fix, "title"));
    let edits = items(fix, "edits");
    let is_here = edits.iter().all(|edit| folder.join(text(edit, "file")) == path);
    let diff = stored.filter(|_| is_here).and_then(|stored| stored.diff(edits));
    diff.map_or(title.clone(), |diff| format!("{title}{diff}"))
}

/// Content of a file.
struct FileText(Vec<u8>);

impl FileText {
    /// Reads a file; `None` if it is outside of the roots or not readable.
    fn read(roots: &Roots, path: &Utf8PathBuf) -> Option<Self> {
        let path = roots.resolve(path.as_str()).ok()?;
        val3_files::read(&path, FileClass::Program).ok().map(Self)
    }

    /// Text of a line; `number` counts from 1.
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

/// Byte range and replacement text.
fn edit(edit: &Value) -> Option<(Range<usize>, &str)> {
    let at = |end: &str| usize::try_from(number(edit.pointer(&format!("/range/{end}"))?, "offset")).ok();
    Some((at("start")?..at("end")?, text(edit, "text")))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::json;

    use super::*;
    use crate::testing::Folder;

    #[test]
    fn a_finding_has_its_line_and_its_fix_as_a_diff() {
        let folder = Folder::new(&[("app/count.pgx", "begin\n  nSortd=1\nend\n")]);
        let range = |start: u32, end: u32| json!({ "start": { "line": 2, "offset": start }, "end": { "line": 2, "offset": end } });
        let edit = json!({ "file": "count.pgx", "range": range(8, 14), "text": "nSorted" });
        let finding = json!({
            "severity": "error", "code": "V0101", "message": "`nSortd` is not declared", "label": "unknown name",
            "help": "did you mean `nSorted`?", "file": "count.pgx", "range": range(8, 14), "related": [],
            "fix": { "title": "write `nSorted`", "safe": false, "edits": [edit] },
        });
        let roots = folder.roots();
        expect![[r#"

            error V0101 app/count.pgx:2: `nSortd` is not declared — unknown name — did you mean `nSorted`?
                nSortd=1
              fix (a guess): write `nSorted`
              -  nSortd=1
              +  nSorted=1
        "#]]
        .assert_eq(&shown(&roots, &roots.first().join("app"), &finding));
    }

    #[test]
    fn an_unreadable_file_and_a_damaged_fix_leave_the_message() {
        let roots = Folder::new(&[("a.pgx", "begin")]).roots();
        let range = json!({ "start": { "line": 1, "offset": 900 }, "end": { "line": 1, "offset": 901 } });
        let edit = json!({ "file": "a.pgx", "range": range, "text": "x" });
        for file in ["a.pgx", "b.pgx", "../../etc/passwd"] {
            let fix = json!({ "title": "t", "safe": true, "edits": [edit] });
            let finding =
                json!({ "severity": "error", "code": "V1", "message": "m", "file": file, "range": range, "fix": fix });
            let text = shown(&roots, roots.first(), &finding);
            assert!(text.contains("m") && !text.contains("root:"), "{text}");
        }
    }
}
