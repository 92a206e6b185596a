//! Literals of structured types, with placeholders.

use val3_analysis::items::project::items;
use val3_analysis::ty::Base;
use val3_lang::types::{Arm, BaseType, fields};

use super::list::{CompletionKind, CompletionList};

/// Score bonus of a literal: between variables with the expected type and with other types.
const LITERAL: i32 = 40;

/// Literals `{…}` of the expected types.
pub(super) fn literals(found: &mut CompletionList<'_>, expected: &[Base]) {
    for base in expected {
        if let Base::Builtin(ty, arm) = *base
            && ty.is_structured()
        {
            literal(found, ty, arm);
        }
    }
}

fn literal(found: &mut CompletionList<'_>, ty: BaseType, arm: Option<Arm>) {
    let arm = arm.or(items(found.db, found.project).arm);
    let mut literal = Literal { arm, text: String::new(), snippet: String::new(), places: 0 };
    literal.write(ty);
    let Literal { text, snippet, .. } = literal;
    found.add(&text, CompletionKind::Literal).detail(|| ty.name().to_owned()).snippet(|| snippet).scored(LITERAL);
}

/// A literal as displayed text and as a snippet.
struct Literal {
    arm: Option<Arm>,
    text: String,
    snippet: String,
    places: usize,
}

impl Literal {
    fn write(&mut self, ty: BaseType) {
        let fields = fields(ty, self.arm);
        if fields.is_empty() {
            self.places += 1;
            let value = initial(ty);
            self.text.push_str(value);
            self.snippet.push_str(&format!("${{{}:{value}}}", self.places));
            return;
        }
        self.push('{');
        for (index, field) in fields.iter().enumerate() {
            if index > 0 {
                self.push(',');
            }
            self.write(field.ty);
        }
        self.push('}');
    }

    /// Outside a placeholder, `}` needs no escape in a snippet.
    fn push(&mut self, letter: char) {
        self.text.push(letter);
        self.snippet.push(letter);
    }
}

fn initial(ty: BaseType) -> &'static str {
    match ty {
        BaseType::Bool => "false",
        BaseType::String => "\"\"",
        // An omitted value means no link (2.4.2).
        ty if ty.is_linkable() => "",
        _ => val3_lang::enumerations::values(ty).next().map_or("0", |value| value.name),
    }
}
