//! Tokenizer, and the image that is built while tokens are read.

use std::str::FromStr;
use std::sync::Arc;

use val3_lang::memory::ValueType;
use val3_lines::{ColumnCounting, LineColumn, LineIndex};

use super::error::{AssemblyError, Result};
use crate::{Image, Program};

/// Tokens of a text, with the image so far.
pub(super) struct ListingReader<'t> {
    text: &'t str,
    tokens: Vec<(usize, &'t str)>,
    /// Index of the next token.
    next: usize,
    pub(super) image: Image,
    /// User types.
    pub(super) kinds: Vec<Arc<ValueType>>,
    /// Current program.
    pub(super) code: Program,
    /// Labels of the current program. Until its end, jumps contain indexes into this list.
    pub(super) labels: Vec<Label>,
    /// Called programs. Until the end of the text, calls contain indexes into this list.
    pub(super) callees: Vec<Label>,
}

/// A name that can be used before its declaration.
pub(super) struct Label {
    pub(super) name: String,
    /// Index of the token that uses the name.
    pub(super) used: usize,
    /// Operation or program with this name.
    pub(super) target: Option<u32>,
}

impl<'t> ListingReader<'t> {
    pub(super) fn new(text: &'t str) -> Result<Self> {
        let (image, code) = (Image { stack_size: STACK_SIZE, ..Image::default() }, Program::default());
        let (kinds, labels, callees) = (Vec::new(), Vec::new(), Vec::new());
        let mut reader = Self { text, tokens: Vec::new(), next: 0, image, kinds, code, labels, callees };
        let mut at = 0;
        while let Some(rest) = text.get(at..).filter(|rest| !rest.is_empty()) {
            let blank = rest.len() - rest.trim_start().len();
            let length = if blank > 0 { blank } else { token(rest) };
            let end = at + length;
            if blank == 0 && !rest.starts_with(';') {
                reader.tokens.push((at, text.get(at..end).unwrap_or_default()));
                reader.next = reader.tokens.len();
                if rest.starts_with('"') && (length < 2 || !rest.get(..length).is_some_and(|text| text.ends_with('"')))
                {
                    return reader.fail("the quotation mark that ends this text is missing");
                }
            }
            at = end;
        }
        reader.next = 0;
        Ok(reader)
    }

    /// Returns the next token; empty at the end.
    pub(super) fn peek(&self) -> &'t str {
        self.tokens.get(self.next).map_or("", |(_, token)| token)
    }

    /// Whether the next token is a name that is followed by a colon.
    pub(super) fn is_label(&self) -> bool {
        self.tokens.get(self.next + 1).is_some_and(|(_, token)| *token == ":")
    }

    pub(super) fn take(&mut self) -> &'t str {
        let token = self.peek();
        self.next += 1;
        token
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.next >= self.tokens.len()
    }

    /// Returns the index of the last token read.
    pub(super) fn last(&self) -> usize {
        self.next.saturating_sub(1)
    }

    /// Skips the next token if it is this one, and returns whether it was skipped.
    pub(super) fn accept(&mut self, token: &str) -> bool {
        let is_it = self.peek() == token;
        self.next += usize::from(is_it);
        is_it
    }

    pub(super) fn expect(&mut self, token: &str) -> Result<()> {
        if self.accept(token) { Ok(()) } else { self.unexpected(&format!("`{token}`")) }
    }

    /// Reads items up to the token `end`, with a separator between them unless `separator` is empty.
    pub(super) fn list<T>(
        &mut self,
        separator: &str,
        end: &str,
        mut read: impl FnMut(&mut Self) -> Result<T>,
    ) -> Result<Vec<T>> {
        let mut items = Vec::new();
        while !self.accept(end) {
            if !items.is_empty() && !separator.is_empty() {
                self.expect(separator)?;
            }
            items.push(read(self)?);
        }
        Ok(items)
    }

    /// Reads a whole number.
    pub(super) fn number<N: FromStr>(&mut self) -> Result<N> {
        let token = self.take();
        match token.parse() {
            Ok(number) => Ok(number),
            Err(_) if token.starts_with(|first: char| first.is_ascii_digit()) => {
                self.fail(&format!("`{token}` is too large here"))
            }
            Err(_) => self.wrong(token, "a number"),
        }
    }

    /// Reads a string in quotation marks.
    pub(super) fn quoted(&mut self) -> Result<String> {
        let token = self.take();
        let Some(inner) = token.strip_prefix('"').and_then(|token| token.strip_suffix('"')) else {
            return self.wrong(token, "a text in quotation marks");
        };
        Ok(unescaped(inner))
    }

    /// Reads a name, quoted or not.
    pub(super) fn name(&mut self) -> Result<String> {
        let token = self.peek();
        if token.starts_with('"') {
            return self.quoted();
        }
        self.take();
        let is_name = token.starts_with(|first: char| first.is_alphanumeric() || first == '_');
        if is_name { Ok(token.to_owned()) } else { self.wrong(token, "a name") }
    }

    /// Reads an item's name or number, and returns the number.
    pub(super) fn item(&mut self, what: &str, names: impl Fn(&Self) -> Vec<String>) -> Result<u16> {
        let is_name = !self.peek().starts_with(|first: char| first.is_ascii_digit());
        let name = self.name()?;
        let names = names(self);
        let found = match name.parse::<usize>() {
            Ok(number) if !is_name => Some(number).filter(|number| *number < names.len()),
            _ => names.iter().position(|known| *known == name),
        };
        let found = found.and_then(|number| u16::try_from(number).ok());
        found.map_or_else(|| self.fail(&format!("there is no {what} `{name}`")), Ok)
    }

    /// Reads a letter with a number: `n3`.
    pub(super) fn register(&mut self, letter: char, what: &str) -> Result<u16> {
        let token = self.take();
        match token.strip_prefix(letter).map(str::parse) {
            Some(Ok(number)) => Ok(number),
            _ => self.wrong(token, what),
        }
    }

    /// Whether the next token is one of these letters with a number.
    pub(super) fn is_register(&self, letters: &str) -> bool {
        let mut rest = self.peek().chars();
        rest.next().is_some_and(|letter| letters.contains(letter))
            && !rest.as_str().is_empty()
            && rest.all(|digit| digit.is_ascii_digit())
    }

    /// Returns an error about the next token, which is not the expected one.
    pub(super) fn unexpected<T>(&mut self, expected: &str) -> Result<T> {
        let token = self.take();
        self.wrong(token, expected)
    }

    fn wrong<T>(&self, token: &str, expected: &str) -> Result<T> {
        if token.is_empty() {
            return self.fail(&format!("{expected} is missing at the end of the text"));
        }
        self.fail(&format!("`{token}` is found where {expected} is expected"))
    }

    /// Returns an error about the last token read.
    pub(super) fn fail<T>(&self, message: &str) -> Result<T> {
        self.fail_at(self.last(), message)
    }

    pub(super) fn fail_at<T>(&self, token: usize, message: &str) -> Result<T> {
        let at = self.tokens.get(token).map_or(self.text.len(), |(at, _)| *at);
        let LineColumn { line, column } = LineIndex::new(self.text).line_column(at, ColumnCounting::SHOWN_CHARACTERS);
        Err(AssemblyError { line: line + 1, column: column + 1, message: message.to_owned() })
    }
}

/// Default stack size per task, in bytes.
const STACK_SIZE: u32 = 5000;

/// Returns the length of the token or comment at the beginning of a text.
fn token(text: &str) -> usize {
    let rest = text.get(1..).unwrap_or_default();
    match text.chars().next() {
        Some(';') => text.find('\n').unwrap_or(text.len()),
        Some('"') => 1 + quoted(rest),
        Some('-') if rest.starts_with('>') => 2,
        Some('-') => 1 + rest.find(|other| !is_word(other)).unwrap_or(rest.len()),
        Some(first) if is_word(first) => text.find(|other| !is_word(other)).unwrap_or(text.len()),
        first => first.map_or(1, char::len_utf8),
    }
}

/// Returns the length up to and including the closing quotation mark on the same line.
fn quoted(rest: &str) -> usize {
    let mut is_escaped = false;
    for (at, other) in rest.char_indices() {
        match other {
            '"' if !is_escaped => return at + 1,
            '\n' => return at,
            _ => is_escaped = other == '\\' && !is_escaped,
        }
    }
    rest.len()
}

/// Removes escapes: `\n` is a line break, any other character after a backslash is itself.
fn unescaped(text: &str) -> String {
    let (mut plain, mut is_escaped) = (String::new(), false);
    for other in text.chars() {
        match other {
            '\\' if !is_escaped => is_escaped = true,
            other => plain.push(if std::mem::take(&mut is_escaped) && other == 'n' { '\n' } else { other }),
        }
    }
    plain
}

/// Whether a character belongs to a word or number.
fn is_word(character: char) -> bool {
    character.is_alphanumeric() || character == '_' || character == '.'
}
