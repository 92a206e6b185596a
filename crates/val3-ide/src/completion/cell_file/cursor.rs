//! The cursor in a `cell.toml`: the table and the key around it. The text may be incomplete.

use std::ops::Range;

/// Place of the cursor.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct TomlCursor {
    /// Keys of the tables around the cursor, for example `object`, `shapes`; at a value also its key.
    pub(super) path: Vec<String>,
    pub(super) place: TomlPlace,
    /// Byte range of the word, or of the text between quotes.
    pub(super) range: Range<usize>,
    /// Whether the cursor is between quotes.
    pub(super) is_quoted: bool,
}

/// Kind of the text at the cursor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TomlPlace {
    /// The name of a table between brackets, at the start of a line.
    Header,
    /// A key.
    Key,
    /// A value, or an entry of an array.
    Value,
}

/// An open bracket.
enum Open {
    Array,
    /// An inline table of the key.
    Table(Option<String>),
}

/// Reads the text up to the cursor.
struct CursorReader {
    table: Vec<String>,
    open: Vec<Open>,
    /// Key of the value that is being read.
    key: Option<String>,
    /// Last complete word, which `=` makes the key.
    word: Option<String>,
}

impl TomlCursor {
    /// Returns the place at an offset; `None` in a comment.
    pub(super) fn at(text: &str, offset: usize) -> Option<Self> {
        let before = text.get(..offset)?;
        let mut reader = CursorReader { table: Vec::new(), open: Vec::new(), key: None, word: None };
        let mut start = 0;
        for line in before.split_inclusive('\n') {
            let end = start + line.len();
            if let Some(header) = header(line) {
                reader = CursorReader { table: header, open: Vec::new(), key: None, word: None };
            } else if end == offset && !line.ends_with('\n') {
                return reader.cursor(text, start, line);
            } else {
                reader.read(line);
                reader.end_line();
            }
            start = end;
        }
        if start == offset { reader.cursor(text, offset, "") } else { None }
    }
}

impl CursorReader {
    /// Returns the cursor at the end of the last line, which begins at `start`.
    fn cursor(mut self, text: &str, start: usize, line: &str) -> Option<TomlCursor> {
        let indent = line.len() - line.trim_start().len();
        if let Some(name) = line.trim_start().strip_prefix('[').filter(|_| self.open.is_empty() && self.key.is_none()) {
            let name = name.trim_start_matches('[');
            let from = start + line.len() - name.len();
            let is_name = name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
            let range = from..start + line.len();
            let header = TomlCursor { path: Vec::new(), place: TomlPlace::Header, range, is_quoted: false };
            return (is_name && start + indent < from).then_some(header);
        }
        let rest = self.read(line)?;
        let from = start + line.len() - rest.text.len();
        let place = if self.expects_value() { TomlPlace::Value } else { TomlPlace::Key };
        let mut path = self.path();
        path.extend(self.key.filter(|_| place == TomlPlace::Value));
        let after_line = text.get(start + line.len()..).unwrap_or_default();
        let len = after_line.find(|letter| rest.is_ended_by(letter)).unwrap_or(after_line.len());
        Some(TomlCursor { path, place, range: from..start + line.len() + len, is_quoted: rest.quote.is_some() })
    }

    fn expects_value(&self) -> bool {
        self.key.is_some() && !matches!(self.open.last(), Some(Open::Table(of)) if *of == self.key)
    }

    fn path(&self) -> Vec<String> {
        let inner = self.open.iter().filter_map(|open| match open {
            Open::Table(key) => key.clone(),
            Open::Array => None,
        });
        self.table.iter().cloned().chain(inner).collect()
    }

    /// Reads a line. Returns the unfinished word at its end; `None` in a comment.
    fn read<'l>(&mut self, line: &'l str) -> Option<Unfinished<'l>> {
        let mut rest = line;
        while let Some(letter) = rest.chars().next() {
            let next = rest.get(letter.len_utf8()..).unwrap_or_default();
            if letter == '#' {
                return None;
            }
            if letter == '"' || letter == '\'' {
                let Some((inside, after)) = next.split_once(letter) else {
                    return Some(Unfinished { text: next.trim_end_matches(['\n', '\r']), quote: Some(letter) });
                };
                self.word = Some(inside.to_owned());
                rest = after;
                continue;
            }
            if is_word(letter) {
                let len = rest.find(|letter| !is_word(letter)).unwrap_or(rest.len());
                if len == rest.len() {
                    return Some(Unfinished { text: rest, quote: None });
                }
                self.word = rest.get(..len).map(str::to_owned);
                rest = rest.get(len..).unwrap_or_default();
                continue;
            }
            self.punctuation(letter);
            rest = next;
        }
        Some(Unfinished { text: "", quote: None })
    }

    fn punctuation(&mut self, letter: char) {
        match letter {
            '=' if !self.expects_value() => self.key = self.word.take(),
            '{' => self.open.push(Open::Table(self.key.clone())),
            '[' if self.key.is_some() => self.open.push(Open::Array),
            '}' | ']' => {
                if let Some(Open::Table(key)) = self.open.pop() {
                    self.key = key;
                }
            }
            ',' => {
                if let Some(Open::Table(key)) = self.open.last() {
                    self.key = key.clone();
                }
            }
            _ => {}
        }
    }

    fn end_line(&mut self) {
        if self.open.is_empty() {
            (self.key, self.word) = (None, None);
        }
    }
}

/// Text at the end of a line.
struct Unfinished<'l> {
    text: &'l str,
    /// Its opening quote.
    quote: Option<char>,
}

impl Unfinished<'_> {
    /// Whether the letter ends the word, or the text between quotes, which ends with the line at the latest.
    fn is_ended_by(&self, letter: char) -> bool {
        match self.quote {
            Some(quote) => letter == quote || letter == '\n' || letter == '\r',
            None => !is_word(letter),
        }
    }
}

fn is_word(letter: char) -> bool {
    letter.is_alphanumeric() || matches!(letter, '_' | '-' | '.' | '+')
}

/// Name in a complete header: `[[object]]`, `[a.b]`.
fn header(line: &str) -> Option<Vec<String>> {
    let line = line.split_once('#').map_or(line, |(line, _)| line).trim();
    let name = line.strip_prefix('[')?.strip_suffix(']')?;
    let name = name.strip_prefix('[').and_then(|name| name.strip_suffix(']')).unwrap_or(name).trim();
    let is_name = name.starts_with(|letter: char| letter.is_ascii_alphabetic() || letter == '_')
        && name.chars().all(|letter| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '.' | '-'));
    is_name.then(|| name.split('.').map(str::to_owned).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Formats the cursor at `|`: path, place, text.
    fn shown(marked: &str) -> String {
        let offset = marked.find('|').unwrap();
        let text = marked.replacen('|', "", 1);
        let Some(TomlCursor { path, place, range, is_quoted }) = TomlCursor::at(&text, offset) else {
            return "none".to_owned();
        };
        let quote = if is_quoted { "'" } else { "" };
        format!("{} {place:?} {quote}{}{quote}", path.join("."), &text[range])
    }

    #[test]
    fn keys_belong_to_the_table_above() {
        assert_eq!(shown("cl|"), " Key cl");
        assert_eq!(shown("clearance = 1\n|"), " Key ");
        assert_eq!(shown("[[object]]\nname = \"a\"\n  b|o"), "object Key bo");
        assert_eq!(shown("[[object]]\nshapes = [{ at = [1, 2, 3], bo| }]"), "object.shapes Key bo");
        assert_eq!(shown("[[object]]\nshapes = [{ sphere = { ra|"), "object.shapes.sphere Key ra");
        assert_eq!(shown("[[object]]\nshapes = [\n  { box = [1] },\n  { |"), "object.shapes Key ");
        assert_eq!(shown("[[gripper]]\nholding = { 'Io-1\\%|'"), "gripper.holding Key 'Io-1\\%'");
    }

    #[test]
    fn values_belong_to_their_key() {
        assert_eq!(shown("[[object]]\nin = \"fP|al\" # x"), "object.in Value 'fPal'");
        assert_eq!(shown("[[object]]\nin = |"), "object.in Value ");
        assert_eq!(shown("[[object]]\nhull = tr|"), "object.hull Value tr");
        assert_eq!(shown("allow = [[\"a\", \"|"), "allow Value ''");
        assert_eq!(shown("[[object]]\nshapes = [{ mesh = '|' }]"), "object.shapes.mesh Value ''");
        assert_eq!(shown("[[sensor]]\nbeam = { from = [0, |"), "sensor.beam.from Value ");
        assert_eq!(shown("[[gripper]]\nholding = { a = 1, b = |"), "gripper.holding.b Value ");
    }

    #[test]
    fn headers_are_completed_at_the_start_of_a_line() {
        assert_eq!(shown("a = 1\n[[ob|"), " Header ob");
        assert_eq!(shown("[|"), " Header ");
        assert_eq!(shown("a = [[|"), "a Value ");
    }

    #[test]
    fn a_header_ends_an_incomplete_table() {
        assert_eq!(shown("[[object]]\nshapes = [{ box = [1,\n[[object]]\nin = '|"), "object.in Value ''");
        assert_eq!(shown("[[object]]\nname = \"a\nin = '|"), "object.in Value ''");
    }

    #[test]
    fn comments_have_no_place() {
        assert_eq!(shown("a = 1 # |"), "none");
        assert_eq!(shown("# |\n"), "none");
    }
}
