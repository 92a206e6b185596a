//! V0719: the code of a key as a number.

use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_lang::instructions::{IS_KEY_PRESSED, READ_KEYS};
use val3_lang::keys::{KEYS, PendantKey};
use val3_lang::operators::BinaryOp;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The code of a key is written as a number in the code.
    ///
    /// ## Why
    /// Few readers know that 271 is F1. A constant with a name (`nKeyF1`) explains it wherever it is used. The rule
    /// only examines numbers that are certainly keys. The rule is off by default, because it enforces a convention that
    /// not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// if getKey()==271
    ///   putln("help")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nKeyF1 = 271
    ///
    /// if getKey()==nKeyF1
    ///   putln("help")
    /// endIf
    /// ```
    V0719 "bare-key-code" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut codes: Vec<ExprId> = compared(program);
    codes.extend(program.calls_of(IS_KEY_PRESSED).filter_map(|call| call.args.last()));
    in_switches(program, &program.body.block, &mut codes);
    for id in codes {
        if let Some(key) = key(program, id) {
            found.report(&RULE, program.range(id), word(key));
        }
    }
}

/// Expressions that are compared with the key that was just read.
fn compared(program: &ProgramView<'_>) -> Vec<ExprId> {
    let sides = program.body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Binary(BinaryOp::Equal | BinaryOp::NotEqual, left, right) => Some((*left, *right)),
        _ => None,
    });
    sides.filter(|(left, _)| reads_key(program, *left)).map(|(_, right)| right).collect()
}

fn in_switches(program: &ProgramView<'_>, block: &[Stmt], codes: &mut Vec<ExprId>) {
    for stmt in block {
        if let StmtKind::Switch { selector: Some(selector), cases } = &stmt.kind
            && reads_key(program, *selector)
        {
            codes.extend(cases.iter().flat_map(|(values, _)| values));
        }
        stmt.blocks().for_each(|inner| in_switches(program, inner, codes));
    }
}

fn reads_key(program: &ProgramView<'_>, id: ExprId) -> bool {
    let Expr::Call(callee, _) = program.body.expr(program.body.without_parentheses(id)) else { return false };
    matches!(program.body.expr(*callee), Expr::Name(name) if READ_KEYS.contains(&name.as_str()))
}

fn key(program: &ProgramView<'_>, id: ExprId) -> Option<&'static PendantKey> {
    let number = program.body.number(id)?;
    KEYS.iter().find(|key| f64::from(key.code) == number)
}

fn word(key: &PendantKey) -> Wording {
    Wording::new(
        format!("{} is the key {} of the pendant", key.code, key.name),
        format!("the key {}", key.name),
        "declare data with a name for this number, and compare with that",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn key_codes_in_comparisons_and_cases_are_reported() {
        expect![[r#"
            start.pgx:5 `255` 255 is the key Esc of the pendant
              | the key Esc
              ? declare data with a name for this number, and compare with that
            start.pgx:5 `282` 282 is the key 2 of the pendant
              | the key 2
              ? declare data with a name for this number, and compare with that
            start.pgx:8 `270` 270 is the key Return of the pendant
              | the key Return
              ? declare data with a name for this number, and compare with that
        "#]]
        .assert_eq(&check(
            &RULE,
            "if getKey()!=255 or isKeyPressed(282)\nendIf\nswitch get()\n  case 270,13\n  break\nendSwitch",
        ));
    }

    #[test]
    fn names_characters_and_other_numbers_are_not_reported() {
        assert_eq!(
            check(&RULE, "num nF1\nif getKey()==nF1 or getKey()==-1 or getKey()==65\nendIf\nif nF1==271\nendIf"),
            ""
        );
    }
}
