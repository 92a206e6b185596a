//! The parameters of the call around the cursor, with the form that fits so far.

use val3_analysis::body::{Body, Expr, ExprId, body};
use val3_analysis::db::{Db, Project};
use val3_analysis::effects::Effects;
use val3_analysis::infer::infer;
use val3_analysis::ty::{Base, Ty, brackets};
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::{instructions, page};
use val3_syntax::{TextRange, TextSize};

use crate::FilePosition;
use crate::owner::owner;

/// The forms of a call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SignatureHelp {
    /// Every form.
    pub forms: Vec<Form>,
    /// The form that fits the arguments so far.
    pub active_form: usize,
    /// The argument that the cursor is in.
    pub active_parameter: usize,
}

/// One form of a call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Form {
    /// The line: `num movej(joint jPosition, tool tTool, mdesc mDesc)`.
    pub line: String,
    /// Where each parameter stands in the line, in bytes.
    pub parameters: Vec<(u32, u32)>,
    /// A sentence about it.
    pub documentation: String,
}

/// The call around a position.
pub fn signature_help(db: &dyn Db, at: FilePosition) -> Option<SignatureHelp> {
    let project = owner(db, at.file)?;
    let body = body(db, at.file);
    let text: &str = at.file.text(db);
    let (callee, args) = call_around(body, text, at.offset)?;
    let active_parameter = argument(text, body, callee, at.offset);
    let types: Vec<Ty> = args.iter().map(|arg| infer(db, project, at.file).ty(*arg)).collect();
    let (forms, active_form) = match body.expr(callee) {
        Expr::Name(name) | Expr::Path { item: name, .. } if program(db, project, at, callee).is_none() => {
            let found = instructions::find(name)?;
            (instruction_forms(found), best_form(found, &types, active_parameter))
        }
        _ => (vec![program(db, project, at, callee)?], 0),
    };
    Some(SignatureHelp { forms, active_form, active_parameter })
}

/// The innermost call whose parentheses hold the position.
pub(crate) fn call_around<'b>(body: &'b Body, text: &str, offset: TextSize) -> Option<(ExprId, &'b [ExprId])> {
    let calls = body.exprs().filter_map(|(_, expr, range)| match expr {
        Expr::Call(callee, args) => Some((*callee, &**args, range)),
        _ => None,
    });
    let holds = |callee: ExprId, range: TextRange| {
        let closed = text.get(..usize::from(range.end())).is_some_and(|text| text.ends_with(')'));
        body.range(callee).end() < offset && (offset < range.end() || offset == range.end() && !closed)
    };
    let around = calls.filter(|(callee, _, range)| holds(*callee, *range));
    around.min_by_key(|(_, _, range)| range.len()).map(|(callee, args, _)| (callee, args))
}

/// The number of commas of the call itself before the position.
pub(crate) fn argument(text: &str, body: &Body, callee: ExprId, offset: TextSize) -> usize {
    let written = text.get(usize::from(body.range(callee).end())..usize::from(offset)).unwrap_or("");
    let (mut depth, mut commas, mut in_string) = (0, 0, false);
    for letter in written.chars() {
        match letter {
            '"' => in_string = !in_string,
            _ if in_string => {}
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 1 => commas += 1,
            _ => {}
        }
    }
    commas
}

fn instruction_forms(found: &Instruction) -> Vec<Form> {
    let documentation = page::summary(found.page);
    let form = |overload: &Overload| {
        let line = overload.signature(found.name);
        Form { parameters: parameters(&line), line, documentation: documentation.clone() }
    };
    found.overloads.iter().map(form).collect()
}

/// Where the parameters stand between the parentheses of a line.
fn parameters(line: &str) -> Vec<(u32, u32)> {
    let (Some(open), Some(close)) = (line.find('('), line.rfind(')')) else { return Vec::new() };
    let mut parameters = Vec::new();
    let mut start = open + 1;
    let inside = line.get(start..close).unwrap_or("");
    let mut depth = 0;
    for (at, letter) in inside.char_indices() {
        match letter {
            '[' | '(' => depth += 1,
            ']' | ')' => depth -= 1,
            ',' if depth == 0 => {
                parameters.push((start, open + 1 + at));
                start = open + 1 + at + 1;
            }
            _ => {}
        }
    }
    if !inside.trim().is_empty() {
        parameters.push((start, close));
    }
    let trimmed = |(from, to): (usize, usize)| {
        let blanks = line.get(from..to).map_or(0, |text| text.len() - text.trim_start().len());
        (u32::try_from(from + blanks).unwrap_or(0), u32::try_from(to).unwrap_or(0))
    };
    parameters.into_iter().map(trimmed).collect()
}

/// The form with room for the arguments whose types agree best.
fn best_form(found: &Instruction, types: &[Ty], active: usize) -> usize {
    let fits = |form: &Overload| {
        let agreeing = form.params.iter().zip(types).filter(|(param, ty)| match (param.ty, ty.base) {
            (None, _) | (_, Base::Unknown) => false,
            (Some(wanted), base) => base.same_as(Base::of(wanted)),
        });
        (form.params.len() > active, form.params.len() >= types.len(), agreeing.count())
    };
    let forms = found.overloads.iter().enumerate();
    // Of forms that fit alike the first stands.
    forms.rev().max_by_key(|(_, form)| fits(form)).map_or(0, |(index, _)| index)
}

/// The program that a callee names.
fn program(db: &dyn Db, project: Project, at: FilePosition, callee: ExprId) -> Option<Form> {
    let signature = Effects::new(db, project, at.file).program(callee)?;
    let params: Vec<String> = signature
        .params
        .iter()
        .map(|param| {
            let reference = if param.by_reference { "&" } else { "" };
            format!("{}{reference} {}{}", param.base.display(db), param.name, brackets(param.container))
        })
        .collect();
    let line = format!("{}({})", signature.name, params.join(", "));
    Some(Form { parameters: parameters(&line), line, documentation: String::new() })
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::Marked;

    fn check(listing: &str, expected: Expect) {
        let marked = Marked::new(listing);
        let shown = signature_help(marked.db(), marked.at()).map_or_else(String::new, |help| {
            let mut shown = String::new();
            for (index, form) in help.forms.iter().enumerate() {
                let mark = if index == help.active_form { "> " } else { "  " };
                let parameter = form.parameters.get(help.active_parameter);
                let parameter = parameter.map_or("", |(from, to)| &form.line[*from as usize..*to as usize]);
                shown += &format!("{mark}{} | {parameter}\n", form.line);
            }
            shown
        });
        expected.assert_eq(&shown);
    }

    #[test]
    fn instructions() {
        check(
            "num nA\nnA=power(2,$0)",
            expect![[r#"
            > num power(num nX, num nY) | num nY
        "#]],
        );
        check(
            "point pA\ntool tA\nmdesc mA\nmovej(pA,$0tA,mA)",
            expect![[r#"
              num movej(joint jPosition, tool tTool, mdesc mDesc) | tool tTool
            > num movej(point pPosition, tool tTool, mdesc mDesc) | tool tTool
        "#]],
        );
        check(
            "num nA\nnA=power(sqrt($0),1)",
            expect![[r#"
            > num sqrt(num nValue) | num nValue
        "#]],
        );
        check(
            "num nA\nnA=power($0",
            expect![[r#"
            > num power(num nX, num nY) | num nX
        "#]],
        );
        check("num nA\nnA=power(2,3)$0", expect![[r#""#]]);
    }

    #[test]
    fn programs() {
        check(
            "call pick(1,$0)\nprogram pick(num x_n, string& x_s, num& x_g[,])\nbegin\nend",
            expect![[r#"
            > pick(num x_n, string& x_s, num& x_g[,]) | string& x_s
        "#]],
        );
    }
}
