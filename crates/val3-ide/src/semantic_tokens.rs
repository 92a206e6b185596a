//! Semantic tokens: the kinds of words in a file, for syntax highlighting.

use rowan::NodeOrToken;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::program::header;
use val3_analysis::items::project::items;
use val3_analysis::occurrences::{Occurrence, Symbol, Usage, occurrences};
use val3_lang::instruction::Availability;
use val3_lang::instructions;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextRange, TextSlice};

use crate::owner::owner;

/// A semantic token.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SemanticToken {
    /// Range, which never contains a line end.
    pub range: TextRange,
    /// Kind.
    pub kind: TokenKind,
    /// Modifiers: a set of [`TokenModifier`] bits.
    pub modifiers: u32,
}

macro_rules! names {
    ($(#[$doc:meta])* $enum:ident { $($(#[$item_doc:meta])* $name:ident = $text:literal,)* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $enum {
            $($(#[$item_doc])* $name,)*
        }

        impl $enum {
            /// Names in the protocol, in the order of the discriminants.
            pub const NAMES: &'static [&'static str] = &[$($text),*];
        }
    };
}

names! {
    /// Kinds of tokens.
    TokenKind {
        /// A keyword.
        Keyword = "keyword",
        /// A comment.
        Comment = "comment",
        /// A string.
        String = "string",
        /// A number.
        Number = "number",
        /// An operator.
        Operator = "operator",
        /// Global data or a local variable.
        Variable = "variable",
        /// A parameter.
        Parameter = "parameter",
        /// A program.
        Program = "function",
        /// An instruction.
        Instruction = "method",
        /// A library identifier.
        Library = "namespace",
        /// A type.
        Type = "type",
        /// A field.
        Field = "property",
        /// An enumerator.
        Enumerator = "enumMember",
    }
}

names! {
    /// Modifiers of a token.
    TokenModifier {
        /// Declared here.
        Declaration = "declaration",
        /// Assigned here.
        Modification = "modification",
        /// Global data.
        Global = "global",
        /// A local variable.
        Local = "local",
        /// A parameter passed by reference.
        ByReference = "byReference",
        /// Usable by other projects.
        Public = "public",
        /// Belongs to a library.
        OfLibrary = "library",
        /// Built into the language.
        DefaultLibrary = "defaultLibrary",
        /// Not supported by newer controllers.
        Deprecated = "deprecated",
        /// Requires an add-on.
        AddOn = "addOn",
    }
}

impl TokenModifier {
    /// Bit of the modifier.
    pub fn bit(self) -> u32 {
        1 << self as u32
    }
}

/// Semantic tokens of a file or a range, in the order of the text.
pub fn semantic_tokens(db: &dyn Db, file: File, within: Option<TextRange>) -> Vec<SemanticToken> {
    let project = owner(db, file);
    let names = project.map_or(&[][..], |project| occurrences(db, project, file).as_slice());
    let parse = parse(db, file);
    let mut collector = Collector { db, project, names, within, found: Vec::new() };
    collector.walk(parse.view(), false);
    collector.found
}

struct Collector<'db> {
    db: &'db dyn Db,
    project: Option<Project>,
    /// Names that were not processed yet, in the order of the text.
    names: &'db [Occurrence],
    within: Option<TextRange>,
    found: Vec<SemanticToken>,
}

impl Collector<'_> {
    fn walk(&mut self, node: View<'_>, in_code: bool) {
        if self.is_beyond(node.range()) {
            return;
        }
        let in_code = in_code || node.kind() == SyntaxKind::CODE;
        for child in node.children_with_tokens() {
            match child {
                NodeOrToken::Node(child) => self.walk(child, in_code),
                NodeOrToken::Token(token) => self.token(token, in_code),
            }
        }
    }

    fn is_beyond(&self, range: TextRange) -> bool {
        self.within.is_some_and(|within| within.intersect(range).is_none())
    }

    fn token(&mut self, token: TokenView<'_>, in_code: bool) {
        let range = token.range();
        if self.is_beyond(range) {
            return;
        }
        match token.kind() {
            // An attribute contains names in its entire value or in a part of it.
            SyntaxKind::IDENT | SyntaxKind::XML_STRING => self.names_in(range),
            kind if in_code => {
                self.found.extend(plain(kind).map(|kind| SemanticToken { range, kind, modifiers: 0 }));
            }
            _ => {}
        }
    }

    fn names_in(&mut self, range: TextRange) {
        let passed = self.names.iter().take_while(|name| name.range.start() < range.start()).count();
        self.names = self.names.part(passed..);
        let Some(project) = self.project else { return };
        let inside = self.names.iter().take_while(|name| range.contains_range(name.range));
        self.found.extend(inside.map(|name| token(self.db, project, name)));
    }
}

/// Kind of a code token that is no name.
fn plain(kind: SyntaxKind) -> Option<TokenKind> {
    Some(match kind {
        SyntaxKind::COMMENT => TokenKind::Comment,
        SyntaxKind::STRING => TokenKind::String,
        SyntaxKind::NUMBER => TokenKind::Number,
        kind if kind.is_keyword() => TokenKind::Keyword,
        SyntaxKind::QUESTION => TokenKind::Keyword,
        kind if (SyntaxKind::EQ..=SyntaxKind::PERCENT).contains(&kind) => TokenKind::Operator,
        _ => return None,
    })
}

fn token(db: &dyn Db, here: Project, found: &Occurrence) -> SemanticToken {
    use TokenModifier as M;
    let (kind, mut modifiers) = match &found.symbol {
        Symbol::Local(..) => (TokenKind::Variable, M::Local.bit()),
        Symbol::Param(file, name) => {
            let by_reference = header(db, *file).params.iter().any(|param| param.name == *name && param.by_reference);
            (TokenKind::Parameter, if by_reference { M::ByReference.bit() } else { 0 })
        }
        Symbol::Data(project, _) if is_field(db, here, *project) => (TokenKind::Field, 0),
        Symbol::Data(project, name) => {
            let public = items(db, *project).data.get(name).is_some_and(|item| item.decl.public);
            let of_library = if *project == here { 0 } else { M::OfLibrary.bit() };
            (TokenKind::Variable, M::Global.bit() | if public { M::Public.bit() } else { 0 } | of_library)
        }
        Symbol::Program(project, name) => {
            let file = items(db, *project).programs.get(name);
            let public = file.is_some_and(|file| header(db, *file).public);
            let of_library = if *project == here { 0 } else { M::OfLibrary.bit() };
            (TokenKind::Program, if public { M::Public.bit() } else { 0 } | of_library)
        }
        Symbol::Library(..) => (TokenKind::Library, 0),
        Symbol::Type(..) => (TokenKind::Type, 0),
        Symbol::Task(..) | Symbol::Element(..) => (TokenKind::String, 0),
        Symbol::BuiltinType(_) => (TokenKind::Type, M::DefaultLibrary.bit()),
        Symbol::Instruction(name) => (TokenKind::Instruction, instruction(name)),
        Symbol::Builtin(_) => (TokenKind::Variable, M::DefaultLibrary.bit()),
        Symbol::Enumerator(_) => (TokenKind::Enumerator, M::DefaultLibrary.bit()),
        Symbol::Field(..) => (TokenKind::Field, M::DefaultLibrary.bit()),
    };
    modifiers |= match found.usage {
        Usage::Declaration => M::Declaration.bit(),
        Usage::Write | Usage::Reference => M::Modification.bit(),
        Usage::Read => 0,
    };
    SemanticToken { range: found.range, kind, modifiers }
}

/// Whether data in `project` are fields of a user type, because it is no library of `here`.
fn is_field(db: &dyn Db, here: Project, project: Project) -> bool {
    project != here && !items(db, here).libraries.values().any(|library| library.interface == Some(project))
}

fn instruction(name: &str) -> u32 {
    let availability = instructions::find(name).map(|found| found.availability);
    TokenModifier::DefaultLibrary.bit()
        | match availability {
            Some(Availability::AddOn(_)) | None => TokenModifier::AddOn.bit(),
            Some(Availability::Version { until: Some(_), .. }) => TokenModifier::Deprecated.bit(),
            _ => 0,
        }
}

#[cfg(test)]
mod tests;
