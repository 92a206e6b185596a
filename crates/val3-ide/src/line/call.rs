//! The call around the cursor.

use smol_str::SmolStr;
use val3_syntax::SyntaxKind::*;
use val3_syntax::SyntaxToken;

use super::{LineTokens, open_bracket, pieces};

/// The callee.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Callee {
    /// The library identifier before it.
    pub(crate) library: Option<SmolStr>,
    /// The instruction or program.
    pub(crate) name: SmolStr,
    /// It is called as a program: after `call`, or as the program of a task.
    pub(crate) is_program: bool,
}

/// A call whose arguments are being written.
#[derive(Debug, Clone)]
pub(crate) struct CallSite<'t> {
    /// The callee.
    pub(crate) callee: Callee,
    /// The tokens of each argument, as far as they are written.
    pub(crate) arguments: Vec<&'t [SyntaxToken]>,
    /// The argument that the cursor is in, from 0.
    pub(crate) active: usize,
}

impl<'t> CallSite<'t> {
    /// The innermost call around the cursor: its parentheses are open there, or it is a `taskCreate`.
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

    /// The call whose parentheses open at `open`; `None` where nothing is called there.
    pub(super) fn at_bracket(tokens: &'t [SyntaxToken], open: usize) -> Option<Self> {
        tokens.get(open).filter(|token| token.kind() == L_PAREN)?;
        let callee = callee_before(tokens.get(..open)?)?;
        Some(Self { callee, arguments: pieces(tokens.get(open + 1..)?), active: 0 })
    }

    /// The arguments of `taskCreate` have no parentheses.
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

/// The name at the end of the tokens, and whether it is called as a program.
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

/// A program has to follow these tokens.
pub(crate) fn takes_program(before: &[SyntaxToken]) -> bool {
    let Some((first, rest)) = before.split_first() else { return false };
    let last_of_task =
        |commas: usize| rest.last().is_some_and(|last| last.kind() == COMMA) && pieces(rest).len() == commas + 1;
    match first.kind() {
        CALL_KW => rest.is_empty(),
        TASK_CREATE_KW => last_of_task(2),
        TASK_CREATE_SYNC_KW => last_of_task(3),
        _ => false,
    }
}
