//! Creates the called program, with parameters that match the arguments.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_lang::types::Container;
use val3_syntax::SyntaxKind;

use super::context::Context;
use super::expected::type_name;
use super::{AssistKind, Assists};
use crate::declare::{self, NewProgram, NewVariable};

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let token = context.token().filter(|token| token.kind() == SyntaxKind::IDENT)?;
    let id = context.expr_at(token.text_range())?;
    let Expr::Name(name) = context.body().expr(id) else { return None };
    let arguments = called_with(context, id)?;
    if context.items().programs.keys().any(|other| other.eq_ignore_ascii_case(name)) {
        return None;
    }
    assists.add("create-program", AssistKind::QuickFix, format!("Create program `{name}`"), || {
        let new = NewProgram {
            name: name.to_string(),
            params: arguments.iter().enumerate().map(|(at, id)| parameter(context, *id, at)).collect(),
            line_end: context.line_end().trim_start_matches("&#13;"),
            ..NewProgram::default()
        };
        declare::programs(context.db, context.project, &[new])
    });
    Some(())
}

/// Arguments after the name at `id`, if a program is called.
fn called_with<'db>(context: &Context<'db>, id: ExprId) -> Option<&'db [ExprId]> {
    let body = context.body();
    body.stmts().into_iter().find_map(|stmt| {
        let call = match &stmt.kind {
            StmtKind::Call(call) => *call,
            StmtKind::TaskCreate { arguments, .. } => *arguments.last()?,
            _ => return None,
        };
        match body.expr(call) {
            Expr::Call(callee, arguments) if *callee == id => Some(&**arguments),
            _ => None,
        }
    })
}

/// Parameter for the argument, named after it if the argument is a name. The second value is true for passing by
/// reference.
fn parameter(context: &Context<'_>, id: ExprId, at: usize) -> (NewVariable, bool) {
    let ty = context.inference().ty(id);
    let type_name = if ty.is_unknown() { "num".to_owned() } else { type_name(context, ty.base, false) };
    let options = context.options();
    let prefix = &options.parameter_prefix;
    let stem = match context.body().expr(context.body().without_parentheses(id)) {
        Expr::Name(name) => name.strip_prefix(options.local_prefix.as_str()).unwrap_or(name).to_owned(),
        _ => format!("{}{}", options.prefixes.get(&type_name).map_or("n", String::as_str), at + 1),
    };
    let name = if stem.starts_with(prefix.as_str()) { stem } else { format!("{prefix}{stem}") };
    let container = match ty.container {
        // An array name without an index may also pass a single value.
        Container::Array { .. } if !is_array(context, id) => Container::Element,
        other => other,
    };
    let sizes = match container {
        Container::Array { dims } => vec![2; usize::from(dims)],
        _ => vec![1],
    };
    let by_reference = container != Container::Element || ty.base.builtin().is_some_and(|ty| ty.is_linkable());
    (NewVariable { name, type_name, container, sizes }, by_reference)
}

/// Whether the argument names an array with several elements.
fn is_array(context: &Context<'_>, id: ExprId) -> bool {
    let Expr::Name(name) = context.body().expr(id) else { return false };
    let local = context.header().locals.iter().find(|local| local.name == *name).map(|local| &local.sizes);
    let data = context.items().data.get(name).map(|item| &item.decl.sizes);
    local.or(data).is_some_and(|sizes| sizes.as_slice() != [1])
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "create-program";

    #[test]
    fn the_parameters_follow_the_call() {
        check(
            ID,
            "num nA[3]\nstring sB\ncall pi$0ck(nA,sB,1+2,{1,2})",
            expect![[r#"
            new usrapp/main/pick.pgx
            +<?xml version="1.0" encoding="utf-8"?>
            +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
            +  <Program name="pick">
            +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
            +      <Parameter name="x_nA" type="num" xsi:type="array" use="reference" />
            +      <Parameter name="x_sB" type="string" xsi:type="element" />
            +      <Parameter name="x_n3" type="num" xsi:type="element" />
            +      <Parameter name="x_n4" type="num" xsi:type="element" />
            +    </Parameters>
            +    <Code><![CDATA[begin
            +end]]></Code>
            +  </Program>
            +</Programs>
            usrapp/main/main.pjx
            +    <Program file="pick.pgx" />
        "#]],
        );
        check(
            ID,
            "taskCreate \"a\",10,ru$0n()",
            expect![[r#"
            new usrapp/main/run.pgx
            +<?xml version="1.0" encoding="utf-8"?>
            +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
            +  <Program name="run">
            +    <Code><![CDATA[begin
            +end]]></Code>
            +  </Program>
            +</Programs>
            usrapp/main/main.pjx
            +    <Program file="run.pgx" />
        "#]],
        );
    }

    #[test]
    fn existing_programs_are_not_created() {
        for line in ["call oth$0er()", "pi$0ck(1)", "call part:pi$0ck()"] {
            assert_eq!(offered(&format!("{line}\nprogram other()\nbegin\nend"), ID), None, "{line}");
        }
    }
}
