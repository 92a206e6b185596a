//! Completion context: the syntactic position of the cursor.

use smol_str::SmolStr;
use val3_analysis::db::{Db, Project};
use val3_analysis::items::parse;
use val3_analysis::ty::Base;
use val3_syntax::SyntaxKind::*;
use val3_syntax::{SyntaxNode, SyntaxToken, TextRange, TextSize};

use super::comments;
use super::postfix::Receiver;
use super::text_place::{Collection, TextPlace, collection, text_place};
use crate::FilePosition;
use crate::line::{
    Block, CodePart, Expected, LineTokens, VisibleNames, code_part, ends_value, expected, inside, open_blocks,
    takes_program,
};
use crate::xml_context::XmlContext;

/// Kinds of completions that are possible at a position.
pub(super) enum Context<'db> {
    /// No completions.
    Nothing,
    /// Start of a line, inside these blocks.
    Statement(Vec<Block>, CodePart),
    /// A value.
    Expression(Expected),
    /// A key of a collection, without its quotes.
    Key(Collection, Expected),
    /// Operator keywords after a value.
    Operator(Operators),
    /// Fields of a value, or postfix statements.
    Members(Base, Option<Receiver>),
    /// A documentation comment of the program or its parameters, of which only the letters before the cursor exist.
    Comment,
    /// An item of a library.
    LibraryItem {
        /// Library identifier.
        library: SmolStr,
        /// Expected kind.
        wanted: ExpectedItem,
    },
    /// A called program.
    Program,
    /// The program of a task.
    TaskProgram,
    /// The content of a string.
    Text(TextPlace),
    /// A position in XML.
    Xml(XmlContext<'db>),
}

/// Keywords that may follow a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operators {
    /// `to` of a `for`.
    To,
    /// `step` of a `for`.
    Step,
    /// `and`, `or`, `xor`.
    Logical,
}

/// Expected kind of library item.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum ExpectedItem {
    /// A called program.
    Program,
    /// The start of a line: data to be assigned, or an instruction with an effect.
    Statement,
    /// A value.
    Value(Expected),
}

/// Completion context at a position, and the range of the typed letters.
pub(super) fn context(db: &dyn Db, project: Project, at: FilePosition) -> (Context<'_>, TextRange) {
    let parse = parse(db, at.file);
    let root = parse.root();
    let empty = TextRange::empty(at.offset);
    if !is_in_code(&root, at.offset) {
        let context = XmlContext::at(db, at.file, at.offset);
        return context.map_or((Context::Nothing, empty), |(context, typed)| (Context::Xml(context), typed));
    }
    if let Some(typed) = comments::typed(&root, at.offset) {
        return (Context::Comment, typed);
    }
    let Some(line) = LineTokens::around(&root, at.offset) else { return (Context::Nothing, empty) };
    let names = VisibleNames::new(db, project, at.file);
    match line.current() {
        Some(token) if token.kind() == NUMBER => (Context::Nothing, empty),
        Some(token) if token.kind() == STRING => string(&names, &line, token, at),
        current => {
            let typed = current.map_or(empty, SyntaxToken::text_range);
            let context = code(&names, &line, || {
                let blocks = open_blocks(parse.view(), typed.start().max(at.offset));
                Context::Statement(blocks, code_part(parse.view(), typed.start()))
            });
            (context, typed)
        }
    }
}

/// Whether the position is inside or at the ends of a program's code.
fn is_in_code(root: &SyntaxNode, offset: TextSize) -> bool {
    let is_there = root.text_range().contains_inclusive(offset);
    let tokens = is_there.then(|| root.token_at_offset(offset));
    tokens.into_iter().flatten().any(|token| token.parent_ancestors().any(|node| node.kind() == CODE))
}

fn string<'db>(
    names: &VisibleNames<'_>,
    line: &LineTokens,
    token: &SyntaxToken,
    at: FilePosition,
) -> (Context<'db>, TextRange) {
    let inside = inside(token);
    if !inside.contains_inclusive(at.offset) {
        return (Context::Nothing, TextRange::empty(at.offset));
    }
    (text_place(names, line).map_or(Context::Nothing, Context::Text), inside)
}

fn code<'db>(names: &VisibleNames<'_>, line: &LineTokens, statement: impl FnOnce() -> Context<'db>) -> Context<'db> {
    let before = line.before();
    let Some((last, head)) = before.split_last() else { return statement() };
    match last.kind() {
        DOT => {
            let ty = names.ty(head);
            Context::Members(ty.base, Receiver::of(line, ty))
        }
        COLON => match head.split_last().filter(|(library, _)| library.kind() == IDENT) {
            Some((library, head)) => {
                Context::LibraryItem { library: library.text().into(), wanted: wanted(names, head) }
            }
            None => Context::Nothing,
        },
        _ if takes_program(before) => {
            let is_call = before.first().is_some_and(|first| first.kind() == CALL_KW);
            if is_call { Context::Program } else { Context::TaskProgram }
        }
        _ if ends_value(before) => operators(names, before).map_or(Context::Nothing, Context::Operator),
        RETURN_KW | ELSE_KW | DO_KW | BREAK_KW | DEFAULT_KW | ERROR_TOKEN => Context::Nothing,
        END_KW | END_IF_KW | END_WHILE_KW | END_FOR_KW | END_SWITCH_KW => Context::Nothing,
        _ => match collection(names, line) {
            Some(collection) => Context::Key(collection, expected(names, before)),
            None => Context::Expression(expected(names, before)),
        },
    }
}

fn wanted(names: &VisibleNames<'_>, head: &[SyntaxToken]) -> ExpectedItem {
    if head.is_empty() {
        ExpectedItem::Statement
    } else if takes_program(head) {
        ExpectedItem::Program
    } else {
        ExpectedItem::Value(expected(names, head))
    }
}

fn operators(names: &VisibleNames<'_>, before: &[SyntaxToken]) -> Option<Operators> {
    let has = |kind| before.iter().any(|token| token.kind() == kind);
    let first = before.first().map(SyntaxToken::kind)?;
    if first == FOR_KW {
        return match (has(EQ), has(TO_KW), has(STEP_KW)) {
            (true, false, _) => Some(Operators::To),
            (_, true, false) => Some(Operators::Step),
            _ => None,
        };
    }
    let compares = before.iter().any(|token| (EQ2..=GE).contains(&token.kind()));
    let is_true = names.ty(before).base == Base::of(val3_lang::types::BaseType::Bool);
    let tests = matches!(first, IF_KW | ELSE_IF_KW | WHILE_KW | UNTIL_KW);
    (compares || is_true || tests).then_some(Operators::Logical)
}
