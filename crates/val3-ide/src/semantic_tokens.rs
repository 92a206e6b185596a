//! What each word of a file is, for colours.

use rowan::NodeOrToken;
use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_analysis::items::program::header;
use val3_analysis::items::project::items;
use val3_analysis::occurrences::{Occurrence, Symbol, Usage, occurrences};
use val3_lang::instruction::Availability;
use val3_lang::instructions;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextRange};

use crate::owner::owner;

/// A coloured word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SemanticToken {
    /// Where it stands; it never holds a line end.
    pub range: TextRange,
    /// What it is.
    pub kind: TokenKind,
    /// More about it: a set of [`TokenModifier`] bits.
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
            /// The names that a client is told, in the order of the numbers.
            pub const NAMES: &'static [&'static str] = &[$($text),*];
        }
    };
}

names! {
    /// The kinds of words.
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
        /// A value of an enumeration.
        Enumerator = "enumMember",
    }
}

names! {
    /// What a word can be besides its kind.
    TokenModifier {
        /// It is declared here.
        Declaration = "declaration",
        /// It gets a value here.
        Modification = "modification",
        /// It is global data.
        Global = "global",
        /// It is a local variable.
        Local = "local",
        /// It is a parameter passed by reference.
        ByReference = "byReference",
        /// Other projects may use it.
        Public = "public",
        /// It belongs to a library.
        OfLibrary = "library",
        /// It comes with the language.
        DefaultLibrary = "defaultLibrary",
        /// Newer controllers lack it.
        Deprecated = "deprecated",
        /// It needs an add-on.
        AddOn = "addOn",
    }
}

impl TokenModifier {
    /// The bit of the modifier.
    pub fn bit(self) -> u32 {
        1 << self as u32
    }
}

/// The words of a file, or of a part of it, in the order of the text.
pub fn semantic_tokens(db: &dyn Db, file: File, within: Option<TextRange>) -> Vec<SemanticToken> {
    let mut collector = Collector { names: names(db, file), within, found: Vec::new() };
    collector.walk(View::root(parse(db, file).green()), false);
    collector.found
}

/// The names of a file by where they start.
fn names(db: &dyn Db, file: File) -> FxHashMap<TextRange, SemanticToken> {
    let Some(project) = owner(db, file) else { return FxHashMap::default() };
    let occurrences = occurrences(db, project, file).iter();
    occurrences.map(|occurrence| (occurrence.range, token(db, project, occurrence))).collect()
}

struct Collector {
    names: FxHashMap<TextRange, SemanticToken>,
    within: Option<TextRange>,
    found: Vec<SemanticToken>,
}

impl Collector {
    fn walk(&mut self, node: View<'_>, in_code: bool) {
        if self.within.is_some_and(|within| within.intersect(node.range()).is_none()) {
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

    fn token(&mut self, token: TokenView<'_>, in_code: bool) {
        let range = token.range();
        if self.within.is_some_and(|within| within.intersect(range).is_none()) {
            return;
        }
        match token.kind() {
            SyntaxKind::IDENT => self.found.extend(self.names.get(&range)),
            SyntaxKind::XML_STRING => self.names_in(range),
            kind if in_code => {
                self.found.extend(plain(kind).map(|kind| SemanticToken { range, kind, modifiers: 0 }));
            }
            _ => {}
        }
    }

    /// An attribute holds a name as a whole or at its start.
    fn names_in(&mut self, value: TextRange) {
        let mut inside: Vec<SemanticToken> =
            self.names.values().filter(|token| value.contains_range(token.range)).copied().collect();
        inside.sort_by_key(|token| token.range.start());
        self.found.extend(inside);
    }
}

/// Words of the code that are no names.
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

fn token(db: &dyn Db, here: val3_analysis::db::Project, found: &Occurrence) -> SemanticToken {
    use TokenModifier as M;
    let (kind, mut modifiers) = match &found.symbol {
        Symbol::Local(..) => (TokenKind::Variable, M::Local.bit()),
        Symbol::Param(file, name) => {
            let by_reference = header(db, *file).params.iter().any(|param| param.name == *name && param.by_reference);
            (TokenKind::Parameter, if by_reference { M::ByReference.bit() } else { 0 })
        }
        Symbol::Data(project, name) => {
            let public = items(db, *project).data.get(name).is_some_and(|item| item.decl.public);
            let of_library = if *project == here { 0 } else { M::OfLibrary.bit() };
            (TokenKind::Variable, M::Global.bit() | if public { M::Public.bit() } else { 0 } | of_library)
        }
        Symbol::Program(project, _) => (TokenKind::Program, if *project == here { 0 } else { M::OfLibrary.bit() }),
        Symbol::Library(..) => (TokenKind::Library, 0),
        Symbol::Type(..) => (TokenKind::Type, 0),
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
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::testing::Marked;

    fn shown(listing: &str) -> String {
        let marked = Marked::new(listing);
        let at = marked.at();
        let text = at.file.text(marked.db());
        let tokens = semantic_tokens(marked.db(), at.file, None);
        let line = |token: &SemanticToken| {
            let names = TokenModifier::NAMES.iter().enumerate().filter(|(bit, _)| token.modifiers & (1 << bit) != 0);
            let modifiers: String = names.map(|(_, name)| format!(".{name}")).collect();
            let word = &text[std::ops::Range::<usize>::from(token.range)];
            format!("{word} {}{modifiers}\n", TokenKind::NAMES[token.kind as usize])
        };
        tokens.iter().map(line).collect()
    }

    #[test]
    fn code() {
        expect![[r#"
            other function.declaration
            x_n parameter.declaration.byReference
            num type.defaultLibrary
            l_i variable.declaration.local
            num type.defaultLibrary
            begin keyword
            // note comment
            l_i variable.modification.local
            = operator
            x_n parameter.byReference
            + operator
            part namespace
            nB variable.global.public.library
            * operator
            sin method.defaultLibrary
            2 number
            if keyword
            l_i variable.local
            == operator
            1 number
            putln method.defaultLibrary
            "x" string
            endIf keyword
            end keyword
        "#]].assert_eq(&shown(
            "library part \"Disk://part/part.pjx\"\nnum nA\ncall other(nA)\nprogram other(num& x_n)\n  num l_i\nbegin\n  // $0note\n  l_i=x_n+part:nB*sin(2)\n  if l_i==1\n    putln(\"x\")\n  endIf\nend\n--- part\npublic num nB",
        ));
    }
}
