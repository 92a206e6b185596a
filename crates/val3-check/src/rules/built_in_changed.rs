//! V0409: `world` or `flange` is changed.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_analysis::effects::RootVariable;
use val3_lang::builtins::{self, Builtin};
use val3_lang::instruction::{ArgumentForm, CallClass};
use val3_lang::instructions::LINK;
use val3_lang::runtime_errors::{FLANGE_CHANGED, WORLD_CHANGED};
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Call, Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// `world` or `flange`, or a field of them, gets a value.
    ///
    /// ## Why
    /// Every frame refers to `world` and every tool to `flange`, directly or through others. After a change to one of
    /// them, each computation with points, frames or tools raises run-time error 161 or 160 (9.4.1, 9.5.1). The error
    /// appears far from the line that causes it.
    ///
    /// ## Bad
    /// ```val3
    /// point pCorner[3]
    ///
    /// if setFrame(pCorner[0],pCorner[1],pCorner[2],world)!=0
    ///   putln("The corners are too close to each other")
    /// endIf
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pCorner[3]
    /// frame fTable
    ///
    /// if setFrame(pCorner[0],pCorner[1],pCorner[2],fTable)!=0
    ///   putln("The corners are too close to each other")
    /// endIf
    /// ```
    V0409 "built-in-changed" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let assigned = program.stmts().iter().filter_map(|stmt| match stmt.kind {
        StmtKind::Assign { target, value } => Some((target, Some(value))),
        StmtKind::For { counter: Some(counter), .. } => Some((counter, None)),
        _ => None,
    });
    let chained = program.body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Assign(target, value) => Some((*target, Some(*value))),
        _ => None,
    });
    let handed_over = program.calls().iter().flat_map(|call| changed(*call)).map(|argument| (argument, None));
    for (target, value) in assigned.chain(chained).chain(handed_over) {
        if let Some(builtin) = built_in(program, target)
            && !value.is_some_and(|value| is_zero(program, value))
        {
            found.report(&RULE, program.range(target), word(builtin));
        }
    }
}

/// Arguments that an instruction writes.
fn changed(call: Call<'_>) -> impl Iterator<Item = ExprId> {
    let acts = call.form.is_some_and(|form| form.class == CallClass::Modifier);
    let is_linked = move |position: usize| position == 0 && call.instruction.name == LINK;
    let arguments = call.arguments().enumerate().filter(move |(position, (param, _))| {
        acts && (is_linked(*position) || !matches!(param.shape, ArgumentForm::Value | ArgumentForm::ProgramCall))
    });
    arguments.map(|(_, (_, argument))| argument)
}

/// Built-in variable that `id` is or belongs to. Files of s5 and s6 declare it.
fn built_in(program: &ProgramView<'_>, id: ExprId) -> Option<&'static Builtin> {
    match program.body.expr(id) {
        Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) => built_in(program, *base),
        Expr::Name(name) => {
            let is_own = matches!(program.effects.root(id), Some(RootVariable::Local(_) | RootVariable::Param(_)));
            builtins::find(name).filter(|builtin| builtin.is_variable && !is_own)
        }
        _ => None,
    }
}

/// Whether all coordinates are 0, the correct value of `world` and `flange`.
fn is_zero(program: &ProgramView<'_>, value: ExprId) -> bool {
    match program.body.expr(program.body.without_parentheses(value)) {
        Expr::Struct(values) => values.iter().all(|value| value.is_some_and(|value| is_zero(program, value))),
        _ => program.body.number(value) == Some(0.0),
    }
}

fn word(builtin: &Builtin) -> Wording {
    let (error, own) = match builtin.ty {
        BaseType::Tool => (FLANGE_CHANGED, "tool, given in `flange`"),
        _ => (WORLD_CHANGED, "frame, given in `world`"),
    };
    Wording::new(
        format!("`{}` must not be changed", builtin.name),
        format!("{} in the next computation of a position", runtime_error(error)),
        format!("change a {own}"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    const DATA: &str = "frame fA\ntool tA\npoint pA\nnum nA\n";

    #[test]
    fn changes_of_world_and_flange_are_reported() {
        expect![[r#"
            start.pgx:5 `world` `world` must not be changed
              | run-time error 161: world was changed
              ? change a frame, given in `world`
        "#]]
        .assert_eq(&check(&RULE, &format!("{DATA}world=fA")).replace(" in the next computation of a position", ""));
        for line in [
            "world.trsf={0,0,1,0,0,0}",
            "world.trsf.x=nA",
            "world[0].trsf.z=-1",
            "flange=tA",
            "flange.trsf=tA.trsf",
            "nA=setFrame(pA,pA,pA,world)",
            "link(world,fA)",
            "link(flange,tA)",
            "fA.trsf=world.trsf=tA.trsf",
            "for world.trsf.x=1 to 2\nnA=1\nendFor",
        ] {
            assert_eq!(check(&RULE, &format!("{DATA}{line}")).matches("must not be changed").count(), 1, "{line}");
        }
    }

    #[test]
    fn uses_of_world_and_flange_are_not_reported() {
        for line in [
            "fA=world",
            "tA=flange",
            "link(fA,world)",
            "link(tA,flange)",
            "nA=setFrame(pA,pA,pA,fA)",
            "world.trsf={0,0,0,0,0,0}",
            "world.trsf.x=0",
            "pA=here(flange,world)",
            "open(flange)",
        ] {
            assert_eq!(check(&RULE, &format!("{DATA}{line}")), "", "{line}");
        }
        assert_eq!(check(&RULE, "program p()\n  frame world\nbegin\n  world.trsf.x=1\nend"), "");
    }
}
