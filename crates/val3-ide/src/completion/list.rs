//! The list of completions during its collection.

use rowan::NodeOrToken;
use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::project::DataItem;
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;
use val3_lang::types::{self, Container};
use val3_syntax::view::View;
use val3_syntax::{SyntaxKind, TextRange, TextSize, TextSlice};

use crate::FilePosition;
use crate::edit::FileEdit;
use crate::fuzzy::score;
use crate::line::VisibleNames;

/// A completion.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Completion {
    /// Displayed name.
    pub label: String,
    /// Type or signature; may be empty.
    pub detail: String,
    /// Kind.
    pub kind: CompletionKind,
    /// Replaced range: the word at the cursor.
    pub range: TextRange,
    /// Inserted text. In a snippet, `$1`, `${2:name}` and `$0` are placeholders.
    pub insert: String,
    /// Inserted text for editors without snippets.
    pub plain: String,
    /// Whether `insert` is a snippet.
    pub is_snippet: bool,
    /// Score; a higher score is more likely.
    pub score: i32,
    /// Symbol that it names, for its documentation.
    pub symbol: Option<Symbol>,
    /// Documentation in Markdown, for an item without a symbol.
    pub documentation: Option<String>,
    /// Additional edits: an element in the project file or the data file.
    pub additional: Vec<FileEdit>,
    /// Commit characters: typing one of them accepts the completion.
    pub commit: &'static [char],
}

/// Kinds of completions.
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
    /// An enumerator or a built-in constant.
    Constant,
    /// A literal with placeholders.
    Literal,
    /// Text.
    Text,
    /// A path.
    Path,
    /// An XML element.
    Element,
    /// An XML attribute.
    Attribute,
}

/// Score bonus of a name that the code already uses.
const USED: i32 = 10;

/// Completions collected so far.
pub(super) struct CompletionList<'db> {
    pub(super) db: &'db dyn Db,
    pub(super) project: Project,
    pub(super) file: File,
    /// Range that every completion replaces.
    pub(super) range: TextRange,
    /// Letters before the cursor.
    pub(super) query: &'db str,
    /// Whether `(` follows, so that a call is completed without arguments.
    pub(super) is_called: bool,
    /// Text before and after the range.
    pub(super) around: (&'db str, &'db str),
    pub(super) items: Vec<Completion>,
}

impl<'db> CompletionList<'db> {
    pub(super) fn new(db: &'db dyn Db, project: Project, at: FilePosition, range: TextRange) -> Self {
        let text: &str = at.file.text(db);
        let part = |from: TextSize, to: TextSize| text.part(usize::from(from)..usize::from(to));
        let around = (part(TextSize::new(0), range.start()), part(range.end(), TextSize::of(text)));
        let is_called = around.1.starts_with('(');
        let query = part(range.start(), at.offset.max(range.start()));
        Self { db, project, file: at.file, range, query, is_called, around, items: Vec::new() }
    }

    /// Whether this text follows the range.
    pub(super) fn is_before(&self, text: &str) -> bool {
        self.around.1.starts_with(text)
    }

    /// Whether one of these characters precedes the range.
    pub(super) fn is_preceded_by(&self, letters: [char; 2]) -> bool {
        self.around.0.ends_with(letters)
    }

    /// Names visible in the edited program.
    pub(super) fn names(&self) -> VisibleNames<'db> {
        VisibleNames::new(self.db, self.project, self.file)
    }

    /// Adds a completion that inserts its label, if the typed letters match.
    pub(super) fn add(&mut self, label: &str, kind: CompletionKind) -> AddedCompletion<'_> {
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
            commit: &[],
        };
        self.items.push(item);
        AddedCompletion(self.items.last_mut())
    }

    /// Adds a call, with placeholders for its arguments.
    pub(super) fn add_call<'p>(
        &mut self,
        name: &str,
        kind: CompletionKind,
        arguments: impl FnOnce() -> Vec<&'p str>,
    ) -> AddedCompletion<'_> {
        let is_called = self.is_called;
        let added = self.add(name, kind);
        if is_called { added } else { added.with(|item| item.fill(call_snippet(name, &arguments()))) }
    }

    /// Raises the scores of names that the code already uses, because they are likely to be used again.
    pub(super) fn prefer_used(&mut self) {
        let parse = parse(self.db, self.file);
        let mut used = FxHashSet::default();
        collect_names(parse.view(), &mut used);
        for item in self.items.iter_mut().filter(|item| used.contains(item.label.as_str())) {
            item.score += USED;
        }
    }

    /// Sorts by score, highest first. Of completions with the same label and kind, only the first is kept.
    pub(super) fn ranked(mut self) -> Vec<Completion> {
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

/// Snippet of a call, for example `name(${1:a},${2:b})$0`.
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

/// The completion that was just added; `None` if the typed letters do not match, so that its details are not computed.
pub(super) struct AddedCompletion<'f>(Option<&'f mut Completion>);

impl AddedCompletion<'_> {
    pub(super) fn with(mut self, change: impl FnOnce(&mut Completion)) -> Self {
        if let Some(item) = self.0.as_deref_mut() {
            change(item);
        }
        self
    }

    pub(super) fn detail(self, detail: impl FnOnce() -> String) -> Self {
        self.with(|item| item.detail = detail())
    }

    pub(super) fn scored(self, score: i32) -> Self {
        self.with(|item| item.score += score)
    }

    pub(super) fn of(self, symbol: impl FnOnce() -> Symbol) -> Self {
        self.with(|item| item.symbol = Some(symbol()))
    }

    pub(super) fn snippet(self, text: impl FnOnce() -> String) -> Self {
        self.with(|item| item.fill(text()))
    }

    /// Sets the details of a variable or field of this type.
    pub(super) fn variable(self, base: Base, container: Container, sizes: &[u32]) -> Self {
        let has_fields = match base {
            Base::Builtin(ty, arm) => !types::fields(ty, arm).is_empty(),
            Base::User(_) => true,
            Base::Unknown => false,
        };
        let has_elements = container != Container::Element && sizes != [1];
        self.with(|item| {
            item.commit = match (has_fields, has_elements) {
                (true, true) => &['.', '['],
                (true, false) => &['.'],
                (false, true) => &['['],
                (false, false) => &[],
            }
        })
    }

    pub(super) fn data(self, item: &DataItem) -> Self {
        self.variable(item.base, item.decl.container, &item.decl.sizes)
    }

    pub(super) fn adding(self, edits: impl FnOnce() -> Vec<FileEdit>) -> Self {
        self.with(|item| item.additional = edits())
    }
}
