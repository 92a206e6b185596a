//! Postfix statements: `bRun.if` becomes an `if` with this condition.

use val3_analysis::ty::{Base, Ty};
use val3_config::Options;
use val3_lang::types::{Arm, BaseType, Container};
use val3_syntax::SyntaxKind::{COLON, DOT, IDENT, L_BRACK, L_CURLY, L_PAREN, R_BRACK, R_CURLY, R_PAREN};
use val3_syntax::{SyntaxToken, TextRange};

use super::list::{CompletionKind as Kind, CompletionList};
use crate::assists::can_be_local;
use crate::declare::{self, NewVariable, free};
use crate::edit::FileEdit;
use crate::line::LineTokens;

/// Score penalty of postfix statements, because a field follows most dots.
const RARE: i32 = -20;

/// An expression before a dot, with no other code on its line.
pub(super) struct Receiver {
    /// Range of the expression.
    value: TextRange,
    /// Range of the dot.
    dot: TextRange,
    ty: Ty,
}

impl Receiver {
    /// Expression before the last of these tokens, which is a dot; `None` if the line contains other code.
    pub(super) fn of(line: &LineTokens, ty: Ty) -> Option<Self> {
        let (dot, head) = line.before().split_last()?;
        let is_last = line.tokens().len() == line.before().len() + usize::from(line.current().is_some());
        let value = head.first()?.text_range().cover(head.last()?.text_range());
        let is_value = is_last && is_operand(head) && ty.container == Container::Element;
        is_value.then(|| Self { value, dot: dot.text_range(), ty })
    }
}

/// Whether the tokens form a name or a call with indexes and fields, without operators.
fn is_operand(tokens: &[SyntaxToken]) -> bool {
    let mut depth = 0_i32;
    for token in tokens {
        match token.kind() {
            L_PAREN | L_BRACK | L_CURLY => depth += 1,
            R_PAREN | R_BRACK | R_CURLY => depth -= 1,
            IDENT | DOT | COLON => {}
            _ if depth == 0 => return false,
            _ => {}
        }
        if depth < 0 {
            return false;
        }
    }
    depth == 0
}

/// A statement with the expression.
struct Statement<'w> {
    /// Keyword after the dot.
    word: &'w str,
    /// First line of the statement.
    plain: String,
    snippet: String,
    /// Declaration of a variable.
    declares: Option<FileEdit>,
}

/// Statements that fit the type of the expression.
pub(super) fn statements(found: &mut CompletionList<'_>, receiver: &Receiver) {
    let text: &str = found.file.text(found.db);
    let Some(value) = text.get(std::ops::Range::<usize>::from(receiver.value)) else { return };
    let value = value.to_owned();
    if let Base::Builtin(ty, arm) = receiver.ty.base {
        for (word, block) in blocks(ty) {
            let snippet = format!("{word} {}\n{block}", escaped(&value));
            add(found, receiver, Statement { word, plain: format!("{word} {value}"), snippet, declares: None });
        }
        if can_be_local(found.db, receiver.ty.base) {
            variable(found, receiver, ty, arm, &value);
        }
    }
}

/// Blocks whose head can contain the value, with the snippet of the other lines.
fn blocks(ty: BaseType) -> &'static [(&'static str, &'static str)] {
    match ty {
        BaseType::Bool => &[("if", "  $0\nendIf"), ("while", "  $0\nendWhile")],
        BaseType::Num | BaseType::String => &[("switch", "  case ${1:value}\n    $0\n  break\nendSwitch")],
        _ => &[],
    }
}

/// Assignment of the value to a new local.
fn variable(found: &mut CompletionList<'_>, receiver: &Receiver, ty: BaseType, arm: Option<Arm>, value: &str) {
    let default = Options::default();
    let options = found.project.config(found.db).map_or(&default, |config| &config.lint);
    let prefix = options.prefixes.get(ty.name()).map_or("", String::as_str);
    let names = found.names();
    let name = free(&format!("{}{prefix}Value", options.local_prefix), |name| names.is_declared(name));
    let type_name = ty.file_name(arm.or(names.items.arm).unwrap_or(Arm::SixAxis));
    let Some(local) = declare::locals(found.db, found.file, &[&NewVariable::single(&name, &type_name)]) else { return };
    let line = format!("{name}={value}");
    let snippet = escaped(&line);
    add(found, receiver, Statement { word: "var", plain: line, snippet, declares: Some(local) });
}

/// Adds a statement that replaces the expression.
fn add(found: &mut CompletionList<'_>, receiver: &Receiver, statement: Statement<'_>) {
    let removed = FileEdit { file: found.file, range: receiver.value.cover(receiver.dot), text: String::new() };
    let added = found.add(statement.word, Kind::Keyword).scored(RARE).detail(|| statement.plain.clone());
    let added = added.snippet(|| statement.snippet).with(|item| item.plain = statement.plain);
    added.adding(|| statement.declares.into_iter().chain([removed]).collect());
}

/// Escapes text for a snippet.
fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}")
}
