//! Assist context: a range in a file.

use std::borrow::Cow;

use val3_analysis::body::{Body, ExprId, body};
use val3_analysis::db::{Db, File, FileRange, Project};
use val3_analysis::infer::{Inference, infer};
use val3_analysis::items::parse;
use val3_analysis::items::program::{Header, header};
use val3_analysis::items::project::{Items, items};
use val3_config::Options;
use val3_fmt::{CodeStyle, IndentOverride};
use val3_syntax::ast::{AstNode, Block, Code, Stmt};
use val3_syntax::{
    SyntaxKind, SyntaxNode, SyntaxToken, TextRange, TextSize, TextSlice, decode_entities, text_at, text_size,
};

use super::lines::{is_escaped, with_comments};
use crate::edit::FileEdit;
use crate::owner::owner;
use crate::xml_list::escaped;

/// A range in a file, with queries about it.
pub(crate) struct Context<'db> {
    pub(crate) db: &'db dyn Db,
    pub(crate) project: Project,
    pub(crate) file: File,
    /// Selection; empty for a cursor.
    pub(crate) range: TextRange,
    pub(crate) text: &'db str,
    pub(crate) root: SyntaxNode,
}

impl<'db> Context<'db> {
    /// Creates the context. `None` if no project lists the file or the range is outside its text.
    pub(crate) fn new(db: &'db dyn Db, at: FileRange) -> Option<Self> {
        let project = owner(db, at.file)?;
        let text: &str = at.file.text(db);
        text.get(std::ops::Range::<usize>::from(at.range))?;
        Some(Self { db, project, file: at.file, range: at.range, text, root: parse(db, at.file).root() })
    }

    pub(crate) fn items(&self) -> &'db Items {
        items(self.db, self.project)
    }

    pub(crate) fn header(&self) -> &'db Header {
        header(self.db, self.file)
    }

    pub(crate) fn body(&self) -> &'db Body {
        body(self.db, self.file)
    }

    pub(crate) fn inference(&self) -> &'db Inference {
        infer(self.db, self.project, self.file)
    }

    /// Rule options of the project.
    pub(crate) fn options(&self) -> Cow<'db, Options> {
        self.project
            .config(self.db)
            .map_or_else(|| Cow::Owned(Options::default()), |config| Cow::Borrowed(&config.lint))
    }

    /// Format style of the code.
    pub(crate) fn style(&self) -> CodeStyle {
        let format = self.project.config(self.db).map(|config| config.format.clone()).unwrap_or_default();
        CodeStyle::new(&format, IndentOverride::default())
    }

    /// One level of indentation.
    pub(crate) fn level(&self) -> String {
        self.style().indent.text(1)
    }

    /// Token at the cursor, or the selected token. A name is preferred to its neighbours.
    pub(crate) fn token(&self) -> Option<SyntaxToken> {
        if !self.range.is_empty() {
            return self.root.covering_element(self.range).into_token();
        }
        self.root.token_at_offset(self.range.start()).max_by_key(|token| match token.kind() {
            SyntaxKind::IDENT | SyntaxKind::NUMBER | SyntaxKind::STRING | SyntaxKind::XML_STRING => 2,
            kind if kind.is_keyword() => 1,
            _ => 0,
        })
    }

    /// Innermost `N` that contains the range.
    pub(crate) fn node<N: AstNode>(&self) -> Option<N> {
        let covering = match self.range.is_empty() {
            true => self.token()?.parent()?,
            false => match self.root.covering_element(self.range) {
                rowan::NodeOrToken::Node(node) => node,
                rowan::NodeOrToken::Token(token) => token.parent()?,
            },
        };
        covering.ancestors().find_map(N::cast)
    }

    /// Code that contains the range.
    pub(crate) fn code(&self) -> Option<Code> {
        let covering = self.root.covering_element(self.range);
        covering.ancestors().find_map(Code::cast)
    }

    /// Innermost expression with exactly this range.
    pub(crate) fn expr_at(&self, range: TextRange) -> Option<ExprId> {
        self.body().exprs().find(|(_, _, found)| *found == range).map(|(id, ..)| id)
    }

    /// Selected statements, all from the same block, and their range including selected comments. For a cursor, the
    /// statement on its line.
    pub(crate) fn stmts(&self) -> Option<(Vec<Stmt>, TextRange)> {
        if self.range.is_empty() {
            let stmt = self.stmt_on_line()?;
            let range = stmt.syntax().text_range();
            return Some((vec![stmt], range));
        }
        let selected = self.trimmed()?;
        let covering = self.root.covering_element(selected);
        let around = covering.ancestors().next()?;
        // A comment before the first statement of a block is outside the block.
        let inner = around.children().filter_map(Block::cast);
        let blocks = inner.chain(around.ancestors().find_map(Block::cast));
        let mut blocks = blocks.filter(|block| with_comments(block).contains_range(selected));
        let stmts = blocks.find_map(|block| whole_stmts(&block, selected))?;
        Some((stmts, selected))
    }

    /// Innermost statement that starts on the cursor's line.
    fn stmt_on_line(&self) -> Option<Stmt> {
        let line = self.line(self.range.start());
        let first = self.text.get(std::ops::Range::<usize>::from(line))?;
        let blanks = TextSize::of(first) - TextSize::of(first.trim_start());
        let at = line.start() + blanks;
        let token = self.root.token_at_offset(at).right_biased()?;
        let stmt = token.parent()?.ancestors().find_map(Stmt::cast)?;
        (stmt.syntax().text_range().start() == at).then_some(stmt)
    }

    /// Selection without surrounding whitespace.
    pub(crate) fn trimmed(&self) -> Option<TextRange> {
        let selected = self.slice(self.range);
        let start = TextSize::of(selected) - TextSize::of(selected.trim_start());
        let len = TextSize::of(selected.trim());
        (len > TextSize::new(0)).then(|| TextRange::at(self.range.start() + start, len))
    }

    pub(crate) fn slice(&self, range: TextRange) -> &'db str {
        text_at(self.text, range)
    }

    /// Line that contains an offset, without its line end.
    fn line(&self, at: TextSize) -> TextRange {
        let at = usize::from(at);
        let start = self.text.get(..at).and_then(|before| before.rfind(['\n', '\r'])).map_or(0, |end| end + 1);
        let rest = self.text.part(at..);
        let end = at + rest.find(['\n', '\r']).unwrap_or(rest.len());
        TextRange::new(text_size(start), text_size(end))
    }

    /// Indentation of the line that contains `at`; empty if the line begins with XML.
    pub(crate) fn indentation(&self, at: TextSize) -> &'db str {
        let line = self.slice(self.line(at));
        let blanks = line.part(..line.len() - line.trim_start_matches([' ', '\t']).len());
        if line.trim_start().starts_with('<') { "" } else { blanks }
    }

    /// Reason why no line can be inserted before `at`; `None` if only whitespace precedes it on its line.
    pub(crate) fn starts_no_line(&self, at: TextSize) -> Option<String> {
        let before = self.slice(TextRange::new(self.line(at).start(), at));
        (!before.trim().is_empty()).then(|| "The statement does not start its line".to_owned())
    }

    /// Line end of the code.
    pub(crate) fn line_end(&self) -> &'static str {
        let code = self.code().map_or(self.text, |code| self.slice(code.syntax().text_range()));
        let Some(at) = code.find(['\n', '\r']) else { return "\n" };
        let (before, rest) = code.split_at(at);
        match (before.ends_with("&#13;"), rest.starts_with("\r\n")) {
            (true, true) => "&#13;\r\n",
            (true, false) => "&#13;\n",
            (false, true) => "\r\n",
            (false, false) => "\n",
        }
    }

    /// Whether the code is outside a CDATA section, so that some characters are escaped.
    pub(crate) fn is_escaped(&self) -> bool {
        self.code().is_none_or(|code| is_escaped(&code))
    }

    /// A part of the code with entities decoded.
    pub(crate) fn plain(&self, range: TextRange) -> String {
        let text = self.slice(range);
        if self.is_escaped() { decode_entities(text).into_owned() } else { text.to_owned() }
    }

    /// Escapes a text if the code of this file requires it.
    pub(crate) fn written(&self, plain: &str) -> String {
        if self.is_escaped() { escaped(plain) } else { plain.to_owned() }
    }

    /// Edit of this file. `text` is inserted unchanged and must already be escaped.
    pub(crate) fn replace(&self, range: TextRange, text: impl Into<String>) -> FileEdit {
        FileEdit { file: self.file, range, text: text.into() }
    }

    /// Whether the range contains a syntax error.
    pub(crate) fn is_broken(&self, range: TextRange) -> bool {
        parse(self.db, self.file).errors().iter().any(|error| error.range.intersect(range).is_some())
    }

    /// Whether the name is declared in the program or its project.
    pub(crate) fn is_taken(&self, name: &str) -> bool {
        let header = self.header();
        let same = |other: &str| other.eq_ignore_ascii_case(name);
        header.locals.iter().any(|local| same(&local.name))
            || header.params.iter().any(|param| same(&param.name))
            || self.items().data.keys().any(|other| same(other))
            || self.items().libraries.keys().any(|other| same(other))
    }
}

/// Statements of a block within `selected`; `None` if there are none or a statement is only partly selected.
fn whole_stmts(block: &Block, selected: TextRange) -> Option<Vec<Stmt>> {
    let touched = block.stmts().filter(|stmt| {
        let common = stmt.syntax().text_range().intersect(selected);
        common.is_some_and(|common| !common.is_empty())
    });
    let stmts: Vec<Stmt> = touched.collect();
    let whole = |stmt: &Stmt| selected.contains_range(stmt.syntax().text_range());
    (!stmts.is_empty() && stmts.iter().all(whole)).then_some(stmts)
}
