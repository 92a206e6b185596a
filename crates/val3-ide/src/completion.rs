//! What can be written at the cursor.

mod code;
mod context;
mod literals;
mod strings;
mod xml_values;

use val3_analysis::db::{Db, File, Project};
use val3_analysis::occurrences::Symbol;
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::edit::FileEdit;
use crate::fuzzy::score;
use crate::hover;
use crate::owner::owner;
use context::{Context, context};

/// Something that can be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Completion {
    /// What is shown.
    pub label: String,
    /// Its type or signature; may be empty.
    pub detail: String,
    /// What it is.
    pub kind: CompletionKind,
    /// What it replaces: the letters typed so far.
    pub range: TextRange,
    /// What is put there. In a snippet `$1`, `${2:name}` and `$0` are places to fill.
    pub insert: String,
    /// `insert` is a snippet.
    pub is_snippet: bool,
    /// How likely it is, higher first.
    pub score: i32,
    /// What it stands for, for its documentation.
    pub symbol: Option<Symbol>,
    /// What else has to change: an entry in the project file.
    pub additional: Vec<FileEdit>,
}

/// The kinds of completions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum CompletionKind {
    /// A local variable.
    Local,
    /// A parameter.
    Parameter,
    /// Global data.
    Data,
    /// A field.
    Field,
    /// A program.
    Program,
    /// An instruction.
    Instruction,
    /// A keyword or a block.
    Keyword,
    /// A library identifier.
    Library,
    /// A type.
    Type,
    /// A value of an enumeration, or one that is built in.
    Constant,
    /// A literal to fill in.
    Literal,
    /// A text.
    Text,
    /// A path.
    Path,
}

/// What can be written at a position, the likeliest first.
pub fn completions(db: &dyn Db, at: FilePosition) -> Vec<Completion> {
    let Some(project) = owner(db, at.file) else { return Vec::new() };
    let (context, typed) = context(db, project, at);
    let mut found = Found { db, project, file: at.file, range: typed, items: Vec::new() };
    match context {
        Context::Nothing => {}
        Context::Statement { closing } => code::statement(&mut found, closing),
        Context::Expression { expected } => code::expression(&mut found, expected),
        Context::Members(base) => code::members(&mut found, base),
        Context::LibraryItem { library, programs_only } => code::library_items(&mut found, &library, programs_only),
        Context::Program => code::programs(&mut found),
        Context::Text(text) => strings::texts(&mut found, &text),
        Context::Attribute(attribute) => xml_values::values(&mut found, &attribute),
    }
    let text: &str = at.file.text(db);
    let query = text.get(usize::from(typed.start())..usize::from(at.offset)).unwrap_or("");
    found.ranked(query)
}

/// The documentation of a completion in Markdown.
pub fn documentation(db: &dyn Db, project: Project, symbol: &Symbol) -> Option<String> {
    hover::symbol(db, project, symbol)
}

/// What was found so far.
struct Found<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    /// What every completion replaces.
    range: TextRange,
    items: Vec<Completion>,
}

impl Found<'_> {
    /// Adds a completion that writes its label.
    fn add(&mut self, label: impl Into<String>, kind: CompletionKind, detail: impl Into<String>) -> Added<'_> {
        let label = label.into();
        let item = Completion {
            insert: label.clone(),
            label,
            detail: detail.into(),
            kind,
            range: self.range,
            is_snippet: false,
            score: 0,
            symbol: None,
            additional: Vec::new(),
        };
        self.items.push(item);
        Added(self.items.last_mut())
    }

    /// Those that fit what was typed, the likeliest first.
    fn ranked(mut self, query: &str) -> Vec<Completion> {
        self.items.retain_mut(|item| match score(query, &item.label) {
            Some(fit) => {
                item.score += fit;
                true
            }
            None => false,
        });
        self.items.sort_by(|a, b| b.score.cmp(&a.score).then_with(|| a.label.cmp(&b.label)));
        self.items.dedup_by(|a, b| a.label == b.label && a.kind == b.kind);
        self.items
    }
}

/// A completion that was just added.
struct Added<'f>(Option<&'f mut Completion>);

impl Added<'_> {
    fn with(mut self, change: impl FnOnce(&mut Completion)) -> Self {
        if let Some(item) = self.0.as_deref_mut() {
            change(item);
        }
        self
    }

    fn scored(self, score: i32) -> Self {
        self.with(|item| item.score += score)
    }

    fn of(self, symbol: Symbol) -> Self {
        self.with(|item| item.symbol = Some(symbol))
    }

    fn snippet(self, text: impl Into<String>) -> Self {
        self.with(|item| {
            item.insert = text.into();
            item.is_snippet = true;
        })
    }
}

#[cfg(test)]
mod tests;
