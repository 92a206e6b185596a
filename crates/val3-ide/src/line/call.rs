//! The call that contains the cursor.

use smol_str::SmolStr;
use val3_syntax::SyntaxKind::*;
use val3_syntax::SyntaxToken;

use super::{LineTokens, open_bracket, pieces};

/// The callee.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Callee {
    /// Library identifier before the name.
    pub(crate) library: Option<SmolStr>,
    /// Name of the instruction or program.
    pub(crate) name: SmolStr,
    /// Whether it is called as a program: after `call`, or as the program of a task.
    pub(crate) is_program: bool,
}

/// A call that may be incomplete.
#[derive(Debug, Clone)]
pub(crate) struct CallSite<'t> {
    /// The callee.
    pub(crate) callee: Callee,
    /// Tokens by existing argument.
    pub(crate) arguments: Vec<&'t [SyntaxToken]>,
    /// Index of the argument at the cursor, from 0.
    pub(crate) active: usize,
}

impl<'t> CallSite<'t> {
    /// Innermost call around the cursor: its parentheses are open, or it is a `taskCreate`.
    pub(crate) fn around(line: &'t LineTokens) -> Option<Self> {
        let before = line.before();
        let mut end = before.len();
        while let Some(open) = before.get(..end).and_then(open_bracket) {
            if let Some(site) = Self::at_bracket(line.tokens(), open) {
                let active = pieces(before.get(open + 1..)?).len().saturating_sub(1);
                return Some(Self { active, ..site });
            }
            end = open;
        }
        Self::task_creation(line)
    }

    /// Call whose parentheses open at `open`; `None` if it is no call.
    pub(super) fn at_bracket(tokens: &'t [SyntaxToken], open: usize) -> Option<Self> {
        tokens.get(open).filter(|token| token.kind() == L_PAREN)?;
        let callee = callee_before(tokens.get(..open)?)?;
        Some(Self { callee, arguments: pieces(tokens.get(open + 1..)?), active: 0 })
    }

    /// `taskCreate` at the cursor, whose arguments have no parentheses.
    fn task_creation(line: &'t LineTokens) -> Option<Self> {
        let (keyword, before) = line.before().split_first()?;
        if !matches!(keyword.kind(), TASK_CREATE_KW | TASK_CREATE_SYNC_KW) {
            return None;
        }
        let name = val3_lang::keywords::canonical(keyword.text())?;
        let callee = Callee { library: None, name: name.into(), is_program: false };
        let active = pieces(before).len().saturating_sub(1);
        Some(Self { callee, arguments: pieces(line.tokens().get(1..)?), active })
    }
}

/// Callee name at the end of the tokens.
fn callee_before(tokens: &[SyntaxToken]) -> Option<Callee> {
    let (name, before) = tokens.split_last().filter(|(name, _)| name.kind() == IDENT)?;
    let library = before
        .split_last()
        .filter(|(colon, _)| colon.kind() == COLON)
        .and_then(|(_, library)| library.split_last())
        .filter(|(library, _)| library.kind() == IDENT);
    let head = library.map_or(before, |(_, head)| head);
    Some(Callee {
        library: library.map(|(library, _)| library.text().into()),
        name: name.text().into(),
        is_program: takes_program(head),
    })
}

/// Whether a program name must follow these tokens.
pub(crate) fn takes_program(before: &[SyntaxToken]) -> bool {
    let Some((first, rest)) = before.split_first() else { return false };
    match first.kind() {
        CALL_KW => rest.is_empty(),
        TASK_CREATE_KW => ends_before(rest, 2),
        TASK_CREATE_SYNC_KW => ends_before(rest, 3),
        _ => false,
    }
}

/// Whether the argument with this index must follow the tokens.
fn ends_before(arguments: &[SyntaxToken], index: usize) -> bool {
    arguments.last().is_some_and(|last| last.kind() == COMMA) && pieces(arguments).len() == index + 1
}
