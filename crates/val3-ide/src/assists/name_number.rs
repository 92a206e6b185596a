//! Replaces a number or string by new global data with this value, named after the key or error code if it is one.

use val3_analysis::body::{Body, Expr, ExprId, StmtKind};
use val3_lang::instructions::{IS_KEY_PRESSED, READ_KEYS, TASK_STATUS};
use val3_lang::keys::KEYS;
use val3_lang::runtime_errors::RUNTIME_ERRORS;
use val3_syntax::ast::{AstNode, Literal};

use super::context::Context;
use super::{AssistKind, Assists};
use crate::declare::{self, NewVariable, free};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let literal = context.node::<Literal>()?;
    let range = literal.syntax().text_range();
    let id = context.expr_at(range)?;
    let (ty, value) = match context.body().expr(id) {
        Expr::Number(number) => ("num", number.to_string()),
        Expr::String(text) => ("string", text.to_string()),
        _ => return None,
    };
    let meaning = meaning(context.body(), id);
    let (title, stem) = match &meaning {
        Some(name) => (format!("Name {value} `{name}`"), name.clone()),
        None => ("Extract into a global constant".to_owned(), unnamed(context, ty)),
    };
    let known = existing(context, ty, &value).filter(|_| meaning.is_some());
    let name = known.clone().unwrap_or_else(|| free(&stem, |name| context.is_taken(name)));
    let edit = match known {
        Some(_) => None,
        None => Some(declare::data(context.db, context.project, &NewVariable::single(&name, ty), Some(&value))?),
    };
    assists.add("extract-constant", AssistKind::Extract, title, || {
        let is_made_up = edit.is_some() && meaning.is_none();
        let change = SourceChange::of(edit.into_iter().chain([context.replace(range, name.as_str())]));
        Some(if is_made_up { change.with_new_name(context.file, range.start(), &name) } else { change })
    });
    Some(())
}

fn unnamed(context: &Context<'_>, ty: &str) -> String {
    let options = context.options();
    format!("{}Constant", options.prefixes.get(ty).map_or("", String::as_str))
}

/// Existing data with this initial value whose name identifies it as a key or error code.
fn existing(context: &Context<'_>, ty: &str, value: &str) -> Option<String> {
    let number: f64 = value.parse().ok().filter(|_| ty == "num")?;
    let files = val3_analysis::items::project::data_files(context.db, context.project);
    let numbers = files.iter().flat_map(|file| val3_analysis::items::data::single_numbers(context.db, *file));
    let named = |name: &str| name.contains("Key") || name.contains("Err");
    let mut known = numbers.filter(|(name, found, _)| *found == number && named(name));
    known.next().map(|(name, ..)| name.to_string())
}

/// Name of the key or run-time error for which the number stands in its context.
fn meaning(body: &Body, id: ExprId) -> Option<String> {
    let number = body.number(id)?;
    if is_compared(body, id, &READ_KEYS) || is_argument(body, id) {
        let key = KEYS.iter().find(|key| f64::from(key.code) == number)?;
        return Some(format!("nKey{}", key.name));
    }
    let error = RUNTIME_ERRORS.iter().find(|row| f64::from(row.number) == number)?;
    let words = error.short.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let name: String = words.take(3).map(capitalised).collect();
    is_compared(body, id, &[TASK_STATUS]).then(|| format!("nErr{name}"))
}

fn capitalised(word: &str) -> String {
    let (first, rest) = word.split_at(1);
    first.to_uppercase() + rest
}

/// Whether the value is compared with a result of these instructions, or is a `case` for it.
fn is_compared(body: &Body, id: ExprId, names: &[&str]) -> bool {
    let gives = |other: ExprId| calls(body, body.without_parentheses(other), names);
    let beside = body.exprs().any(|(_, expr, _)| match expr {
        Expr::Binary(_, left, right) => *left == id && gives(*right) || *right == id && gives(*left),
        _ => false,
    });
    beside
        || body.stmts().iter().any(|stmt| match &stmt.kind {
            StmtKind::Switch { selector: Some(selector), cases } => {
                gives(*selector) && cases.iter().any(|(values, _)| values.contains(&id))
            }
            _ => false,
        })
}

fn is_argument(body: &Body, id: ExprId) -> bool {
    body.exprs().any(|(call, expr, _)| {
        matches!(expr, Expr::Call(_, arguments) if arguments.contains(&id)) && calls(body, call, &[IS_KEY_PRESSED])
    })
}

fn calls(body: &Body, id: ExprId, names: &[&str]) -> bool {
    let Expr::Call(callee, _) = body.expr(id) else { return false };
    matches!(body.expr(*callee), Expr::Name(name) if names.contains(&name.as_str()))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "extract-constant";

    #[test]
    fn key_codes_and_error_numbers_get_names() {
        check(
            ID,
            "if getKey()==27$01\nendIf",
            expect![[r#"
            usrapp/main/main.dtx
            -  <Datas />
            +  <Datas>
            +    <Data name="nKeyF1" access="private" xsi:type="array" type="num" size="1">
            +      <Value key="0" value="271" />
            +    </Data>
            +  </Datas>
            usrapp/main/start.pgx
            -if getKey()==271
            +if getKey()==nKeyF1
        "#]],
        );
        check(
            ID,
            "num nKeyEsc = 255\nif isKeyPressed(25$05)\nendIf",
            expect![[r#"
            usrapp/main/start.pgx
            -if isKeyPressed(255)
            +if isKeyPressed(nKeyEsc)
        "#]],
        );
        check(
            ID,
            "if taskStatus(\"a\")==2$00\nendIf",
            expect![[r#"
            usrapp/main/main.dtx
            -  <Datas />
            +  <Datas>
            +    <Data name="nErrIndexTooLarge" access="private" xsi:type="array" type="num" size="1">
            +      <Value key="0" value="20" />
            +    </Data>
            +  </Datas>
            usrapp/main/start.pgx
            -if taskStatus("a")==20
            +if taskStatus("a")==nErrIndexTooLarge
        "#]],
        );
        check(
            ID,
            "switch get()\ncase 27$00\nbreak\nendSwitch",
            expect![[r#"
            usrapp/main/main.dtx
            -  <Datas />
            +  <Datas>
            +    <Data name="nKeyReturn" access="private" xsi:type="array" type="num" size="1">
            +      <Value key="0" value="270" />
            +    </Data>
            +  </Datas>
            usrapp/main/start.pgx
            -case 270
            +case nKeyReturn
        "#]],
        );
    }

    #[test]
    fn other_values_become_constants() {
        check(
            ID,
            "num nConstant\nnConstant=nConstant*3.2$05",
            expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="nConstant2" access="private" xsi:type="array" type="num" size="1">
            +      <Value key="0" value="3.25" />
            +    </Data>
            usrapp/main/start.pgx
            -nConstant=nConstant*3.25
            +nConstant=nConstant*nConstant2
        "#]],
        );
        check(
            ID,
            "putln(\"a <b> $0\")",
            expect![[r#"
            usrapp/main/main.dtx
            -  <Datas />
            +  <Datas>
            +    <Data name="sConstant" access="private" xsi:type="array" type="string" size="1">
            +      <Value key="0" value="a &lt;b&gt; " />
            +    </Data>
            +  </Datas>
            usrapp/main/start.pgx
            -putln("a <b> ")
            +putln(sConstant)
        "#]],
        );
    }

    #[test]
    fn values_that_need_no_name_are_not_offered() {
        assert_eq!(offered("num nA\nn$0A=1", ID), None);
        assert_eq!(offered("bool bA\nbA=tr$0ue", ID), None);
    }
}
