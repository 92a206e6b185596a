//! The list of completions that is being collected.

use rowan::NodeOrToken;
use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::project::DataItem;
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;
use val3_lang::types::{self, Container};
use val3_syntax::view::View;
use val3_syntax::{Part, SyntaxKind, TextRange, TextSize};

use crate::FilePosition;
use crate::edit::FileEdit;
use crate::fuzzy::score;
use crate::line::Names;

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
    /// Characters that take the completion when they are typed: those that can follow the name.
    pub commit: &'static [char],
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

/// Bonus of a name that the code already uses.
const USED: i32 = 10;

/// The completions found so far.
pub(super) struct CompletionList<'db> {
    pub(super) db: &'db dyn Db,
    pub(super) project: Project,
    pub(super) file: File,
    /// The range that every completion replaces.
    pub(super) range: TextRange,
    /// The letters before the cursor.
    pub(super) query: &'db str,
    /// A `(` follows: names of what is called are written without their arguments.
    pub(super) is_called: bool,
    /// The text before the range and the text after it.
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

    /// The range is before this text.
    pub(super) fn is_before(&self, text: &str) -> bool {
        self.around.1.starts_with(text)
    }

    /// One of these characters precedes the range.
    pub(super) fn is_preceded_by(&self, letters: [char; 2]) -> bool {
        self.around.0.ends_with(letters)
    }

    /// The names of the program that is edited.
    pub(super) fn names(&self) -> Names<'db> {
        Names::new(self.db, self.project, self.file)
    }

    /// Adds a completion that writes its label, if the letters that were typed fit it.
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

    /// Adds something that is called: its arguments are places to fill.
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

    /// Names that the code uses already are likely to be used again.
    pub(super) fn prefer_used(&mut self) {
        let parse = parse(self.db, self.file);
        let mut used = FxHashSet::default();
        collect_names(parse.view(), &mut used);
        for item in self.items.iter_mut().filter(|item| used.contains(item.label.as_str())) {
            item.score += USED;
        }
    }

    /// The likeliest first; of those that are called and are the same kind of thing only the likeliest.
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

    /// It is a variable or a field of this type.
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
