//! Fault location, as used by the rule's fix.

use std::borrow::Cow;
use std::ops::Range;
use val3_lang::foreign_names::remedy;

use val3_analysis::db::{Db, File, FileEdit};
use val3_analysis::items::parse;
use val3_syntax::xml::line_end;
use val3_syntax::{SyntaxKind, TextRange, TextSize, TextSlice, decode_entities};

use crate::diagnostic::Fix;

/// A fault in a file.
#[derive(Clone, Copy)]
pub(crate) struct Site<'a> {
    db: &'a dyn Db,
    file: File,
    /// Marked range.
    pub(crate) range: TextRange,
    /// Other range of the fault, in the same file.
    pub(crate) related: Option<TextRange>,
}

impl<'a> Site<'a> {
    /// Creates the location of a fault at `range` of `file`.
    pub(crate) fn new(db: &'a dyn Db, file: File, range: TextRange, related: Option<TextRange>) -> Self {
        Self { db, file, range, related }
    }

    /// Marked text, encoded like the file.
    pub(crate) fn text(&self) -> &'a str {
        self.slice(self.range.start(), self.range.end())
    }

    /// Text before the marked text on its line.
    pub(crate) fn before(&self) -> &'a str {
        self.slice(self.line_start(self.range.start()), self.range.start())
    }

    /// Text after the marked text on its line.
    pub(crate) fn after(&self) -> &'a str {
        let rest = self.slice(self.range.end(), TextSize::of(self.whole()));
        rest.split(['\r', '\n']).next().unwrap_or(rest)
    }

    /// Indentation of the line that contains `range`.
    pub(crate) fn indentation(&self, range: TextRange) -> &'a str {
        let line = self.slice(self.line_start(range.start()), range.end());
        line.part(..line.len() - line.trim_start().len())
    }

    /// The same fault, with its other range as the marked range.
    pub(crate) fn other_side(&self) -> Option<Self> {
        Some(Self { range: self.related?, related: Some(self.range), ..*self })
    }

    /// Range of the marked text if it is `name`, or of the part on one side of `:` or before `[`.
    fn part(&self, name: &str) -> Option<TextRange> {
        let text = self.text();
        if decode_entities(text) == name {
            return Some(self.range);
        }
        let len = TextSize::of(name);
        if text.strip_prefix(name).is_some_and(|rest| rest.starts_with([':', '['])) {
            return Some(TextRange::at(self.range.start(), len));
        }
        let is_last = text.strip_suffix(name).is_some_and(|rest| rest.ends_with(':'));
        is_last.then(|| TextRange::new(self.range.end() - len, self.range.end()))
    }

    /// Replaces `range` with `text`, which is escaped if the file requires it.
    pub(crate) fn replace(&self, range: TextRange, text: &str) -> FileEdit {
        self.write(range, &self.escaped(range.start(), text))
    }

    /// Replaces `range` with raw text of the file, without escaping.
    pub(crate) fn write(&self, range: TextRange, text: &str) -> FileEdit {
        FileEdit { file: self.file, range, text: text.to_owned() }
    }

    /// Inserts a line before the line of the marked text, or after the marked position if that is the end of the code.
    /// `None` if the line does not start in the code.
    pub(crate) fn insert_line(&self, line: &str) -> Option<FileEdit> {
        let start = self.line_start(self.range.start());
        let line_end = self.line_end_before(start);
        let (at, text) = if self.range.is_empty() {
            (self.range.start(), format!("{line_end}{line}"))
        } else {
            (start, format!("{line}{line_end}"))
        };
        let in_code = self.code().is_some_and(|code| code.contains_inclusive(start));
        in_code.then(|| self.write(TextRange::empty(at), &text))
    }

    /// Inserts a line of code before the line on which the marked text starts, with the same indentation.
    pub(crate) fn line_before(&self, code: &str) -> FileEdit {
        let start = self.line_start(self.range.start());
        let (code, line_end) = (self.escaped(self.range.start(), code), self.line_end_before(start));
        self.write(TextRange::empty(start), &format!("{}{code}{line_end}", self.indentation(self.range)))
    }

    /// Inserts a line of code after the marked statement, with the indentation of the statement's first line.
    pub(crate) fn line_after(&self, code: &str) -> FileEdit {
        let line_end = self.line_end_before(self.line_start(self.range.start()));
        let code = self.escaped(self.range.end(), code);
        self.write(TextRange::empty(self.range.end()), &format!("{line_end}{}{code}", self.indentation(self.range)))
    }

    /// Inserts an element after the marked element. If the marked element has its own line, the new element gets a line
    /// with the same indentation.
    pub(crate) fn element_after(&self, element: &str) -> FileEdit {
        let behind = TextRange::empty(self.range.end());
        if !self.before().trim().is_empty() {
            return self.write(behind, element);
        }
        let line_end = self.line_end_before(self.line_start(self.range.start()));
        self.write(behind, &format!("{line_end}{}{element}", self.indentation(self.range)))
    }

    /// Removes the line of the marked text with its line end.
    pub(crate) fn remove_line(&self) -> FileEdit {
        let end = self.range.end() + TextSize::of(self.after());
        let rest = self.slice(end, TextSize::of(self.whole()));
        let line_end = ["\r\n", "\n", "\r"].into_iter().find(|line_end| rest.starts_with(line_end)).unwrap_or("");
        self.write(TextRange::new(self.line_start(self.range.start()), end + TextSize::of(line_end)), "")
    }

    /// Arguments of the marked call, in order.
    pub(crate) fn arguments(&self) -> Option<Vec<TextRange>> {
        let parse = parse(self.db, self.file);
        let mut calls = parse.view().path_to(self.range).filter(|node| node.kind() == SyntaxKind::CALL_EXPR);
        let call = calls.find(|call| call.range() == self.range)?;
        let list = call.children().find(|node| node.kind() == SyntaxKind::ARG_LIST)?;
        Some(list.children().map(|argument| argument.range()).collect())
    }

    /// Code that contains the location.
    fn code(&self) -> Option<TextRange> {
        let parse = parse(self.db, self.file);
        let code = parse.view().path_to(self.range).find(|node| node.kind() == SyntaxKind::CODE)?;
        Some(code.range())
    }

    /// Escapes text outside of a CDATA section. In a CDATA section, no character is escaped.
    fn escaped<'t>(&self, at: TextSize, text: &'t str) -> Cow<'t, str> {
        let is_plain = !text.contains(['&', '<', '>', '"']);
        let before = self.slice(TextSize::new(0), at);
        if is_plain || before.rfind("<![CDATA[") > before.rfind("]]>") {
            return Cow::Borrowed(text);
        }
        let escaped = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        Cow::Owned(escaped.replace('"', "&quot;"))
    }

    fn line_start(&self, at: TextSize) -> TextSize {
        let before = self.slice(TextSize::new(0), at);
        let start = before.rfind(['\r', '\n']).map_or(0, |end| end + 1);
        at - (TextSize::of(before) - TextSize::of(before.part(..start)))
    }

    /// Line end at `start`; at the start of the file, the line end that the file uses.
    fn line_end_before(&self, start: TextSize) -> &'a str {
        let before = self.slice(TextSize::new(0), start);
        let ends = ["&#13;\r\n", "&#13;\n", "\r\n", "\r", "\n"];
        ends.into_iter().find(|end| before.ends_with(end)).unwrap_or_else(|| line_end(self.whole()))
    }

    fn slice(&self, start: TextSize, end: TextSize) -> &'a str {
        self.whole().part(Range::from(TextRange::new(start.min(end), end)))
    }

    fn whole(&self) -> &'a str {
        self.file.text(self.db)
    }
}

/// Replaces `name` with `near`, as a guess.
pub(crate) fn rename(site: &Site<'_>, name: &str, near: Option<&str>) -> Option<Fix> {
    // A name from another language is not a misspelling.
    let near = near.filter(|_| remedy(name).is_none())?;
    let part = site.part(name)?;
    Some(Fix::guess(format!("write `{near}`"), vec![site.replace(part, near)]))
}
