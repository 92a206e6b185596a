//! Expected type of the value that starts with the next token.

use val3_analysis::items::project::SignatureParam;
use val3_analysis::ty::{Base, Ty};
use val3_lang::instruction::ArgumentForm;
use val3_lang::types::{BaseType, Container, fields};
use val3_syntax::SyntaxKind::{self, *};
use val3_syntax::{SyntaxToken, TextSlice};

use super::call::CallSite;
use super::{VisibleNames, open_bracket, pieces};

/// Expected value at a position.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Expected {
    /// Possible types of the value; empty if the context does not determine them.
    pub(crate) bases: Vec<Base>,
    /// Whether a variable is required.
    pub(crate) variable: bool,
}

impl Expected {
    /// No expectation.
    pub(crate) fn anything() -> Self {
        Self::default()
    }

    fn value(base: Base) -> Self {
        Self { bases: Some(base).filter(|base| *base != Base::Unknown).into_iter().collect(), variable: false }
    }

    /// Values that can be compared with, combined with or assigned to an operand of this type. Inputs, outputs and
    /// serial lines represent the values that are read from or written to them (3.5 to 3.7).
    fn like(ty: Ty) -> Self {
        match ty.base {
            Base::Builtin(BaseType::Dio, _) => Self::of(BaseType::Bool),
            Base::Builtin(BaseType::Aio, _) => Self::of(BaseType::Num),
            Base::Builtin(BaseType::Sio, _) => {
                Self { bases: vec![Base::of(BaseType::String), Base::of(BaseType::Num)], variable: false }
            }
            base => Self::value(base),
        }
    }

    fn variable(base: Base) -> Self {
        Self { variable: true, ..Self::value(base) }
    }

    fn of(ty: BaseType) -> Self {
        Self::value(Base::of(ty))
    }
}

/// Expected value after these tokens of a line.
pub(crate) fn expected(names: &VisibleNames<'_>, before: &[SyntaxToken]) -> Expected {
    let Some((last, head)) = before.split_last() else { return Expected::anything() };
    match last.kind() {
        IF_KW | ELSE_IF_KW | WHILE_KW | UNTIL_KW | AND_KW | OR_KW | XOR_KW | BANG => Expected::of(BaseType::Bool),
        TO_KW | STEP_KW => Expected::of(BaseType::Num),
        FOR_KW => Expected::variable(Base::of(BaseType::Num)),
        EQ => Expected::like(names.ty(head)),
        CASE_KW => selector(names, last),
        TASK_CREATE_KW | TASK_CREATE_SYNC_KW => Expected::of(BaseType::String),
        kind if is_operator(kind) && ends_value(head) => Expected::like(names.ty(head)),
        kind if is_operator(kind) => expected(names, head),
        L_PAREN | L_BRACK | L_CURLY | COMMA => within_brackets(names, before),
        _ => Expected::anything(),
    }
}

fn is_operator(kind: SyntaxKind) -> bool {
    (EQ2..=PERCENT).contains(&kind)
}

/// Whether the tokens end with a value, so that an operator follows.
pub(crate) fn ends_value(tokens: &[SyntaxToken]) -> bool {
    tokens.last().is_some_and(|last| {
        matches!(last.kind(), IDENT | NUMBER | STRING | R_PAREN | R_BRACK | R_CURLY | TRUE_KW | FALSE_KW)
    })
}

/// Selector type in the `switch` that contains a `case`.
fn selector(names: &VisibleNames<'_>, case: &SyntaxToken) -> Expected {
    let Some(switch) = case.parent_ancestors().find(|node| node.kind() == SWITCH_STMT) else {
        return Expected::anything();
    };
    let tokens = std::iter::successors(switch.first_token(), SyntaxToken::next_token);
    let line: Vec<SyntaxToken> =
        tokens.take_while(|token| token.kind() != NEWLINE).filter(|token| !token.kind().is_trivia()).collect();
    Expected::like(names.ty(&line))
}

/// Expected value after an opening bracket or a comma.
fn within_brackets(names: &VisibleNames<'_>, before: &[SyntaxToken]) -> Expected {
    let Some(open) = open_bracket(before) else { return without_brackets(names, before) };
    let (head, inside) = (before.part(..open), before.part(open + 1..));
    let index = pieces(inside).len().saturating_sub(1);
    match before.get(open).map(SyntaxToken::kind) {
        Some(L_CURLY) => literal_field(names, expected(names, head).bases.first().copied(), index),
        Some(L_BRACK) if names.ty(head).container == Container::Collection => Expected::of(BaseType::String),
        Some(L_BRACK) => Expected::of(BaseType::Num),
        _ => match CallSite::at_bracket(before, open) {
            Some(call) => argument(names, &call, index),
            None => expected(names, head),
        },
    }
}

/// Expected argument of `taskCreate`, or value of `case`.
fn without_brackets(names: &VisibleNames<'_>, before: &[SyntaxToken]) -> Expected {
    let Some((first, rest)) = before.split_first() else { return Expected::anything() };
    match (first.kind(), pieces(rest).len()) {
        (CASE_KW, _) => selector(names, first),
        (TASK_CREATE_KW | TASK_CREATE_SYNC_KW, 2) => Expected::of(BaseType::Num),
        (TASK_CREATE_SYNC_KW, 3) => Expected::variable(Base::of(BaseType::Bool)),
        _ => Expected::anything(),
    }
}

/// Expected value at an index of a `{…}`.
fn literal_field(names: &VisibleNames<'_>, whole: Option<Base>, index: usize) -> Expected {
    let Some(Base::Builtin(ty, arm)) = whole else { return Expected::anything() };
    fields(ty, arm.or(names.items.arm)).get(index).map_or(Expected::anything(), |field| Expected::of(field.ty))
}

/// Expected argument at an index: of every form that fits the preceding arguments.
fn argument(names: &VisibleNames<'_>, call: &CallSite<'_>, index: usize) -> Expected {
    let is_program = call.callee.is_program || val3_lang::instructions::find(&call.callee.name).is_none();
    if is_program {
        let param = names.signature(&call.callee).and_then(|signature| signature.params.get(index));
        return param.map_or(Expected::anything(), program_parameter);
    }
    let forms = names.forms(call, index);
    let params: Vec<_> = forms.iter().filter_map(|form| form.params.get(index)).collect();
    let mut bases: Vec<Base> =
        params.iter().filter_map(|param| param.ty).map(|ty| Base::of(ty).on_arm(names.items.arm)).collect();
    if bases.len() < params.len() {
        bases.clear();
    }
    bases.dedup();
    let accepts_value =
        params.iter().any(|param| matches!(param.shape, ArgumentForm::Value | ArgumentForm::ProgramCall));
    Expected { bases, variable: !params.is_empty() && !accepts_value }
}

fn program_parameter(param: &SignatureParam) -> Expected {
    if param.by_reference { Expected::variable(param.base) } else { Expected::value(param.base) }
}
