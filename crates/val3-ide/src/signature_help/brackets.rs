//! Signature help in `{…}` and `[…]`: type fields, array indexes, collection keys.

use val3_analysis::ty::Base;
use val3_lang::types::{Arm, BaseType, Container, Field, fields};
use val3_syntax::SyntaxKind::{COLON, DOT, IDENT};
use val3_syntax::SyntaxToken;

use super::{CallForm, SignatureHelp, places};
use crate::hover::{field_line, keys_of};
use crate::line::{Bracket, LineTokens, VisibleNames, expected};
use crate::markdown::code;

/// Limit of displayed keys.
const SHOWN: usize = 10;

/// Help for the bracket around the cursor; `None` for a call.
pub(super) fn help(names: &VisibleNames<'_>, line: &LineTokens) -> Option<SignatureHelp> {
    let (bracket, active_parameter) = Bracket::around(line)?;
    let forms: Vec<CallForm> = match bracket {
        Bracket::Literal(head) => {
            let expected = expected(names, head).bases.into_iter();
            expected.filter_map(|base| literal(names, base, active_parameter)).collect()
        }
        Bracket::Index(head) => index(names, head).into_iter().collect(),
    };
    (!forms.is_empty()).then_some(SignatureHelp { forms, active_form: 0, active_parameter })
}

/// Help for a literal, for example `mdesc {num accel, num vel, …}`.
fn literal(names: &VisibleNames<'_>, base: Base, active: usize) -> Option<CallForm> {
    let Base::Builtin(ty, arm) = base else { return None };
    let arm: Option<Arm> = arm.or(names.items.arm);
    let fields = fields(ty, arm);
    if fields.is_empty() {
        return None;
    }
    let shown: Vec<String> = fields.iter().map(|field| format!("{} {}", field.ty.name(), field.name)).collect();
    let line = format!("{} {{{}}}", ty.name(), shown.join(", "));
    let documentation = fields.get(active).map(|field| page(names, ty, field)).unwrap_or_default();
    Some(CallForm { parameters: places(&line, shown.into_iter()), documentation, line })
}

fn page(names: &VisibleNames<'_>, ty: BaseType, field: &Field) -> String {
    format!("`{}.{}`: {}", ty.name(), field.name, field_line(names.db, names.project, field))
}

/// Help for an index, for example `num nGrid[0..2, 0..3]` or `dio dIn[key]`.
fn index(names: &VisibleNames<'_>, head: &[SyntaxToken]) -> Option<CallForm> {
    let ty = names.ty(head);
    let name = head.last().filter(|last| last.kind() == IDENT)?.text();
    let type_name = ty.base.display(names.db);
    let (shown, documentation) = match ty.container {
        Container::Collection => (vec!["key".to_owned()], keys(names, head, name)),
        Container::Array { dims } => (dimensions(names, head, dims), String::new()),
        // A single value has only the index 0.
        Container::Element if ty.base != Base::Unknown => (vec!["0".to_owned()], String::new()),
        Container::Element => return None,
    };
    let line = format!("{type_name} {name}[{}]", shown.join(", "));
    let start = u32::try_from(type_name.len() + 1 + name.len() + 1).ok()?;
    let mut at = start;
    let parameters = shown.iter().map(|shown| {
        let end = at + u32::try_from(shown.len()).unwrap_or(0);
        let place = (at, end);
        at = end + 2;
        place
    });
    Some(CallForm { parameters: parameters.collect(), documentation, line })
}

/// Index ranges, by dimension.
fn dimensions(names: &VisibleNames<'_>, head: &[SyntaxToken], dims: u8) -> Vec<String> {
    match names.sizes(head).filter(|sizes| sizes.len() == usize::from(dims)) {
        Some(sizes) => sizes.iter().map(|size| format!("0..{}", size.saturating_sub(1))).collect(),
        None if dims == 1 => vec!["index".to_owned()],
        None => (1..=dims).map(|dimension| format!("index {dimension}")).collect(),
    }
}

/// Keys of a collection in the project or in a library.
fn keys(names: &VisibleNames<'_>, head: &[SyntaxToken], name: &str) -> String {
    let before = head.split_last().map_or(&[][..], |(_, before)| before);
    let project = match before.split_last() {
        Some((colon, library)) if colon.kind() == COLON => {
            library.last().and_then(|library| names.interface(library.text()))
        }
        Some((dot, _)) if dot.kind() == DOT => None,
        _ => Some(names.project),
    };
    let keys = project.map(|project| keys_of(names.db, project, name)).unwrap_or_default();
    let shown: Vec<String> = keys.iter().take(SHOWN).map(|key| code(&format!("\"{key}\""))).collect();
    let more = if keys.len() > SHOWN { format!(" and {} more", keys.len() - SHOWN) } else { String::new() };
    if shown.is_empty() { String::new() } else { format!("keys: {}{more}", shown.join(", ")) }
}
