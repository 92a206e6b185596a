//! Completions at the cursor.

mod code;
mod context;
mod literals;
mod missing;
mod names;
mod reach;
mod strings;
mod text_place;
mod xml;

use rowan::NodeOrToken;
use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::occurrences::Symbol;
use val3_lang::{page, statements};
use val3_syntax::view::View;
use val3_syntax::{SyntaxKind, TextRange, TextSize};

use crate::FilePosition;
use crate::edit::FileEdit;
use crate::fuzzy::score;
use crate::hover;
use crate::line::Names;
use crate::owner::owner;
use crate::xml_context::XmlContext;
use crate::xml_cursor::XmlPlace;
use context::{Context, context};

/// Something that can be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Completion {
    /// The displayed name.
    pub label: String,
    /// Its type or signature; may be empty.
    pub detail: String,
    /// Its kind.
    pub kind: CompletionKind,
    /// The replaced range: the word at the cursor.
    pub range: TextRange,
    /// The inserted text. In a snippet, `$1`, `${2:name}` and `$0` are placeholders.
    pub insert: String,
    /// The inserted text for editors without snippets.
    pub plain: String,
    /// `insert` is a snippet.
    pub is_snippet: bool,
    /// How likely it is, higher first.
    pub score: i32,
    /// The item that it names, for its documentation.
    pub symbol: Option<Symbol>,
    /// Its documentation in Markdown, for an item without a symbol.
    pub documentation: Option<String>,
    /// Additional edits: an entry in the project file or the data file.
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
    /// An element of XML.
    Element,
    /// An attribute in XML.
    Attribute,
}

/// The completions at a position, the most probable first.
pub fn completions(db: &dyn Db, at: FilePosition) -> Vec<Completion> {
    let Some(project) = owner(db, at.file) else { return Vec::new() };
    let (context, range) = context(db, project, at);
    let mut found = CompletionList::new(db, project, at, range);
    match context {
        Context::Nothing => {}
        Context::Statement(blocks) => code::statement(&mut found, &blocks),
        Context::Expression(expected) => code::expression(&mut found, &expected),
        Context::Operator(operators) => code::operators(&mut found, operators),
        Context::Members(base) => code::members(&mut found, base),
        Context::LibraryItem { library, wanted } => code::library_items(&mut found, &library, &wanted),
        Context::Key(collection, expected) => {
            strings::quoted_keys(&mut found, &collection);
            code::expression(&mut found, &expected);
        }
        Context::Program => code::programs(&mut found),
        Context::TaskProgram => code::task_programs(&mut found),
        Context::Text(place) => strings::texts(&mut found, &place),
        Context::Xml(context) => xml::complete(&mut found, &context),
    }
    found.prefer_used();
    found.ranked()
}

/// A blank that is typed at a position begins something that can be proposed: the next attribute of a tag. Elsewhere
/// it most often ends a word.
pub fn completes_after_blank(db: &dyn Db, at: FilePosition) -> bool {
    let found = XmlContext::at(db, at.file, at.offset);
    found.is_some_and(|(context, _)| matches!(context.cursor.place, XmlPlace::AttributeName(_)))
}

/// The documentation of a symbol in Markdown.
pub fn documentation(db: &dyn Db, project: Project, symbol: &Symbol) -> Option<String> {
    hover::symbol(db, project, symbol)
}

/// The documentation of a completion in Markdown: that of its symbol, or the page of its keyword.
pub fn completion_documentation(db: &dyn Db, project: Project, completion: &Completion) -> Option<String> {
    if let Some(page) = &completion.documentation {
        return Some(page.clone());
    }
    match (&completion.symbol, completion.kind) {
        (Some(symbol), _) => documentation(db, project, symbol),
        (None, CompletionKind::Keyword) => statements::find(&completion.label).map(|found| page::text(found.page)),
        (None, _) => None,
    }
}

/// Bonus of a name that the code already uses.
const USED: i32 = 10;

/// The completions found so far.
struct CompletionList<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    /// The range that every completion replaces.
    range: TextRange,
    /// The letters before the cursor.
    query: &'db str,
    /// A `(` follows: names of what is called are written without their arguments.
    is_called: bool,
    /// The text before the range and the text after it.
    around: (&'db str, &'db str),
    items: Vec<Completion>,
}

impl<'db> CompletionList<'db> {
    fn new(db: &'db dyn Db, project: Project, at: FilePosition, range: TextRange) -> Self {
        let text: &str = at.file.text(db);
        let part = |from: TextSize, to: TextSize| text.get(usize::from(from)..usize::from(to)).unwrap_or("");
        let around = (part(TextSize::new(0), range.start()), part(range.end(), TextSize::of(text)));
        let is_called = around.1.starts_with('(');
        let query = part(range.start(), at.offset.max(range.start()));
        Self { db, project, file: at.file, range, query, is_called, around, items: Vec::new() }
    }

    /// The range is before this text.
    fn is_before(&self, text: &str) -> bool {
        self.around.1.starts_with(text)
    }

    /// One of these characters precedes the range.
    fn is_preceded_by(&self, letters: [char; 2]) -> bool {
        self.around.0.ends_with(letters)
    }

    /// The names of the program that is edited.
    fn names(&self) -> Names<'db> {
        Names::new(self.db, self.project, self.file)
    }

    /// Adds a completion that writes its label, if the letters that were typed fit it.
    fn add(&mut self, label: &str, kind: CompletionKind) -> AddedCompletion<'_> {
        let Some(fit) = score(self.query, label) else { return AddedCompletion(None) };
        let item = Completion {
            insert: label.to_owned(),
            plain: label.to_owned(),
            label: label.to_owned(),
            detail: String::new(),
            kind,
            range: self.range,
            is_snippet: false,
            score: fit,
            symbol: None,
            documentation: None,
            additional: Vec::new(),
        };
        self.items.push(item);
        AddedCompletion(self.items.last_mut())
    }

    /// Adds something that is called: its arguments are places to fill.
    fn add_call<'p>(
        &mut self,
        name: &str,
        kind: CompletionKind,
        arguments: impl FnOnce() -> Vec<&'p str>,
    ) -> AddedCompletion<'_> {
        let is_called = self.is_called;
        let added = self.add(name, kind);
        if is_called { added } else { added.with(|item| item.fill(call_snippet(name, &arguments()))) }
    }

    /// Names that the code uses already are likely to be used again.
    fn prefer_used(&mut self) {
        let parse = parse(self.db, self.file);
        let mut used = FxHashSet::default();
        collect_names(parse.view(), &mut used);
        for item in self.items.iter_mut().filter(|item| used.contains(item.label.as_str())) {
            item.score += USED;
        }
    }

    /// The likeliest first; of those that are called and are the same kind of thing only the likeliest.
    fn ranked(mut self) -> Vec<Completion> {
        self.items.sort_by(|a, b| b.score.cmp(&a.score).then_with(|| a.label.cmp(&b.label)));
        let mut seen = FxHashSet::default();
        self.items.retain(|item| seen.insert((item.label.clone(), item.kind)));
        self.items
    }
}

fn collect_names<'g>(node: View<'g>, names: &mut FxHashSet<&'g str>) {
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(child) => collect_names(child, names),
            NodeOrToken::Token(token) if token.kind() == SyntaxKind::IDENT => drop(names.insert(token.text())),
            NodeOrToken::Token(_) => {}
        }
    }
}

/// `name(${1:a},${2:b})$0`
fn call_snippet(name: &str, arguments: &[&str]) -> String {
    let places: Vec<String> =
        arguments.iter().enumerate().map(|(index, name)| format!("${{{}:{name}}}", index + 1)).collect();
    format!("{}({})$0", name.replace('$', "\\$"), places.join(","))
}

impl Completion {
    fn fill(&mut self, snippet: String) {
        self.insert = snippet;
        self.is_snippet = true;
    }
}

/// A completion that was just added, if what was typed fits it: nothing is worked out for the others.
struct AddedCompletion<'f>(Option<&'f mut Completion>);

impl AddedCompletion<'_> {
    fn with(mut self, change: impl FnOnce(&mut Completion)) -> Self {
        if let Some(item) = self.0.as_deref_mut() {
            change(item);
        }
        self
    }

    fn detail(self, detail: impl FnOnce() -> String) -> Self {
        self.with(|item| item.detail = detail())
    }

    fn scored(self, score: i32) -> Self {
        self.with(|item| item.score += score)
    }

    fn of(self, symbol: impl FnOnce() -> Symbol) -> Self {
        self.with(|item| item.symbol = Some(symbol()))
    }

    fn snippet(self, text: impl FnOnce() -> String) -> Self {
        self.with(|item| item.fill(text()))
    }

    fn adding(self, edits: impl FnOnce() -> Vec<FileEdit>) -> Self {
        self.with(|item| item.additional = edits())
    }
}

#[cfg(test)]
mod tests;
