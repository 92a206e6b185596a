//! Declares an unknown name as a parameter, by reference where the program changes it.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_lang::types::Container;

use super::context::Context;
use super::expected::unknown;
use super::{AssistKind, Assists};
use crate::declare::{self, Variable};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let unknown = unknown(context)?;
    // The controller starts these two, without arguments.
    if context.options().entry_points.iter().any(|name| *name == *context.header().name) {
        return None;
    }
    let variable = unknown.variable(context, false);
    let title = format!("Create parameter `{} {}`", unknown.shown(context.db), unknown.name);
    assists.add_in(Some("Create"), "create-parameter", AssistKind::QuickFix, title, || {
        let by_reference = variable.container == Container::Collection || is_written(context, &variable);
        let edit = declare::parameter(context.db, context.file, &variable, by_reference)?;
        Some(SourceChange::of([edit]))
    });
    Some(())
}

/// The program gives the name a value somewhere.
fn is_written(context: &Context<'_>, variable: &Variable) -> bool {
    let body = context.body();
    let names = |mut id: ExprId| {
        while let Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) = body.expr(id) {
            id = *base;
        }
        matches!(body.expr(id), Expr::Name(name) if *name == variable.name)
    };
    body.stmts().iter().any(|stmt| match &stmt.kind {
        StmtKind::Assign { target, .. } => names(*target),
        StmtKind::For { counter: Some(counter), .. } => names(*counter),
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "create-parameter";

    #[test]
    fn passed_as_it_is_used() {
        check(
            ID,
            "program other(num x_a)\nbegin\n  putln(x_$0b+x_a)\nend",
            expect![[r#"
            usrapp/main/other.pgx
            +      <Parameter name="x_b" type="num" xsi:type="element" />
        "#]],
        );
        check(
            ID,
            "program other()\nbegin\n  x_$0s=\"a\"\nend",
            expect![[r#"
            usrapp/main/other.pgx
            +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
            +      <Parameter name="x_s" type="string" xsi:type="element" use="reference" />
            +    </Parameters>
        "#]],
        );
    }

    #[test]
    fn start_has_none() {
        assert_eq!(offered("putln(x_$0s)", ID), None);
    }
}
