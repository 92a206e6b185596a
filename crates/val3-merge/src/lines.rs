//! Merge of texts by lines: code, descriptions, and files that are no XML.

use val3_syntax::TextSlice;

use crate::conflict::Conflict;
use crate::diff3::{Chunk, merge};
use crate::merger::{ElementVersions, Merger};
use crate::same::same;
use crate::text::{ElementText, TextLine, TextSpelling};

/// Conflict marks, as in version control.
const MARKS: [&str; 4] = ["<<<<<<< ours", "||||||| base", "=======", ">>>>>>> theirs"];

/// A merged text.
struct MergedText {
    text: String,
    /// Lines of the merged text at which conflicts start, from 1.
    conflicts: Vec<usize>,
}

impl Merger<'_> {
    /// Merges the text in an element.
    pub(crate) fn text(&mut self, versions: ElementVersions<'_, '_>, path: &str) {
        let ElementVersions { base, ours, theirs } = versions;
        let [in_base, in_ours, in_theirs] = [base, Some(ours), Some(theirs)].map(|node| node.and_then(ElementText::of));
        let (true, Some(in_ours), Some(in_theirs)) = (self.kind.has_lines(ours.name()), in_ours, in_theirs) else {
            return self.whole_text(versions, path);
        };
        if ours.content.is_none() || base.is_some() && in_base.is_none() {
            return self.whole_text(versions, path);
        }
        let Some(content) = ours.content else { return };
        let merged = merged(in_base, in_ours, in_theirs, self.line_end);
        let reason = |line: &usize| format!("both sides have changed line {line}");
        let conflicts = merged.conflicts.iter().map(|line| Conflict { path: path.to_owned(), reason: reason(line) });
        self.conflicts.extend(conflicts);
        self.edit(content, format!("{}{}{}", in_ours.before, merged.text, in_ours.after));
    }

    /// Merges a text that is not split into lines: it must be unchanged on one side.
    fn whole_text(&mut self, versions: ElementVersions<'_, '_>, path: &str) {
        match versions.base {
            Some(base) if same(self.kind, base, versions.ours) => self.replace(versions.ours, versions.theirs),
            _ => self.conflict(versions, path, "ours and theirs have another text".to_owned()),
        }
    }
}

fn merged(base: Option<ElementText<'_>>, ours: ElementText<'_>, theirs: ElementText<'_>, line_end: &str) -> MergedText {
    let our_lines = ours.lines();
    let [base, of_ours, of_theirs] =
        [base, Some(ours), Some(theirs)].map(|content| content.map(decoded_lines).unwrap_or_default());
    let mut out = MergedLines { lines: Vec::new(), conflicts: Vec::new() };
    let encoded = |line: &String| (ours.encoded(line), "");
    for chunk in merge(&base, &of_ours, &of_theirs) {
        match chunk {
            Chunk::Ours(range) => out.add_raw(our_lines.part(range)),
            Chunk::Theirs(range, _) => out.lines.extend(of_theirs.part(range).iter().map(encoded)),
            Chunk::Conflict { base: b, ours: o, theirs: t } => {
                let mark = |mark: &str| (ours.encoded(mark), "");
                if out.lines.is_empty() {
                    // The first line follows a tag, where a mark would not be recognised.
                    out.lines.push((String::new(), ""));
                }
                out.conflicts.push(out.lines.len() + 1);
                let [opening, of_base, middle, closing] = MARKS.map(mark);
                out.lines.push(opening);
                out.add_raw(our_lines.part(o));
                out.lines.push(of_base);
                out.lines.extend(base.get(b).unwrap_or(&[]).iter().map(encoded));
                out.lines.push(middle);
                out.lines.extend(of_theirs.part(t.clone()).iter().map(encoded));
                out.lines.push(closing);
                if t.end == of_theirs.len() {
                    out.lines.push((String::new(), ""));
                }
            }
        }
    }
    out.joined(line_end)
}

fn decoded_lines(content: ElementText<'_>) -> Vec<String> {
    content.lines().iter().map(|line| content.decoded(line)).collect()
}

struct MergedLines {
    lines: Vec<(String, &'static str)>,
    conflicts: Vec<usize>,
}

impl MergedLines {
    /// Adds lines unchanged, with their line ends.
    fn add_raw(&mut self, lines: &[TextLine<'_>]) {
        self.lines.extend(lines.iter().map(|line| (line.raw.to_owned(), line.end)));
    }

    /// Joins the lines. Lines of theirs get the line end of ours.
    fn joined(self, line_end: &str) -> MergedText {
        let last = self.lines.len().saturating_sub(1);
        let mut text = String::new();
        for (at, (line, own_end)) in self.lines.into_iter().enumerate() {
            text += &line;
            if at != last {
                text += if own_end.is_empty() { line_end } else { own_end };
            }
        }
        MergedText { text, conflicts: self.conflicts }
    }
}

/// Merges files by lines, as in version control. Returns the text and the lines at which conflicts start.
pub(crate) fn merge_files(base: &str, ours: &str, theirs: &str, line_end: &str) -> (String, Vec<usize>) {
    let whole = |raw| ElementText { before: "", raw, after: "", form: TextSpelling::Plain };
    let merged = merged(Some(whole(base)), whole(ours), whole(theirs), line_end);
    (merged.text, merged.conflicts)
}
