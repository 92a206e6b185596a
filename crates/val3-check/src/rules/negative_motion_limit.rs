//! V0231: a negative number in a motion descriptor.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_lang::types::{BaseType, fields};

use crate::diagnostic::Wording;
use crate::lint::{Findings, Program};
use crate::rule::rule;

rule! {
    /// A field of a motion descriptor gets a constant below 0.
    ///
    /// ## Why
    /// Speeds, accelerations and blending distances are never negative (10.5.1). The assignment is accepted, but every
    /// move with this descriptor stops its task with a run-time error from 100 to 106.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mSlow
    ///
    /// mSlow.vel=-10
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mSlow
    ///
    /// mSlow.vel=10
    /// ```
    V0231 "negative-motion-limit" Warning, Program: check
}

fn check(program: &Program<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::Assign { target, value } = stmt.kind else { continue };
        match (program.body.expr(target), program.body.expr(value)) {
            (Expr::Field { base, field, .. }, _) if is_descriptor(program, *base) => {
                report(program, field, value, found);
            }
            (_, Expr::Struct(values)) if is_descriptor(program, target) => {
                for (field, value) in fields(BaseType::Mdesc, None).iter().zip(values) {
                    value.iter().for_each(|value| report(program, field.name, *value, found));
                }
            }
            _ => {}
        }
    }
}

fn is_descriptor(program: &Program<'_>, id: ExprId) -> bool {
    program.inference.ty(id).base.builtin() == Some(BaseType::Mdesc)
}

fn report(program: &Program<'_>, field: &str, value: ExprId, found: &mut Findings) {
    if let Some(number) = program.body.number(value).filter(|number| *number < 0.0) {
        found.report(&RULE, program.range(value), word(field, number));
    }
}

pub(super) fn word(field: &str, number: f64) -> Wording {
    Wording::new(
        format!("`{field}` of a motion descriptor cannot be {number}"),
        "every move with it fails",
        "write 0 or more",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn negative_fields_are_reported() {
        expect![[r#"
            start.pgx:5 `-5` `leave` of a motion descriptor cannot be -5
              | every move with it fails
              ? write 0 or more
            start.pgx:6 `-1` `vel` of a motion descriptor cannot be -1
              | every move with it fails
              ? write 0 or more
        "#]]
        .assert_eq(&check(&RULE, "mdesc m\nm.leave=-5\nm={100,-1,100,250,90,off,,}"));
    }

    #[test]
    fn other_fields_are_not_reported() {
        assert_eq!(check(&RULE, "mdesc m\ntrsf t\nm.leave=0\nt.x=-5\nm={100,1,100,250,90,off,,}\nt={-1,,,,,}"), "");
    }
}
