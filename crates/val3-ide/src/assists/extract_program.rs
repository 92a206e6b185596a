//! Takes statements out into a program of their own.

use std::collections::BTreeMap;

use smol_str::SmolStr;
use val3_analysis::body::{Stmt, StmtKind};
use val3_analysis::effects::{Access, AccessKind, Effects, Root};
use val3_analysis::items::declarations;
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;
use val3_syntax::ast::AstNode as _;

use super::context::Context;
use super::{AssistKind, Assists};
use crate::declare::{self, NewProgram, Variable};
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    if context.range.is_empty() {
        return None;
    }
    context.code()?;
    let (stmts, range) = context.stmts()?;
    let whole: Vec<TextRange> = stmts.iter().map(|stmt| stmt.syntax().text_range()).collect();
    let own: Vec<&Stmt> = context
        .body()
        .stmts()
        .into_iter()
        .filter(|stmt| whole.iter().any(|it| it.contains_range(stmt.range)))
        .collect();
    let returns = own.iter().any(|stmt| stmt.kind == StmtKind::Return);
    if own.is_empty() || returns || context.is_broken(range) {
        return None;
    }
    assists.add("extract-program", AssistKind::Extract, "Extract into a program", || extract(context, range));
    Some(())
}

fn extract(context: &Context<'_>, range: TextRange) -> Option<SourceChange> {
    let passed = variables(context, range);
    let name = declare::free_program_name(context.db, context.project, "extracted");
    let params = passed.iter().filter(|found| found.passing != Passing::Inside);
    let locals = passed.iter().filter(|found| found.passing == Passing::Inside);
    let new = NewProgram {
        name: name.clone(),
        public: false,
        params: params.clone().map(|found| (found.variable.clone(), found.passing == Passing::Reference)).collect(),
        locals: locals.clone().map(|found| found.variable.clone()).collect(),
        code: code(context, range),
        line_end: context.line_end().trim_start_matches("&#13;"),
    };
    let mut change = declare::programs(context.db, context.project, &[new])?;
    let arguments: Vec<&str> = params.map(|found| found.variable.name.as_str()).collect();
    change.edits.push(context.replace(range, format!("call {name}({})", arguments.join(","))));
    change.edits.extend(locals.filter_map(|found| without_local(context, &found.variable.name)));
    Some(change)
}

/// How a variable gets into the new program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Passing {
    Value,
    Reference,
    /// It is used there alone, and becomes a local of it.
    Inside,
}

struct Passed {
    variable: Variable,
    passing: Passing,
}

/// The locals and parameters that the statements use, by name.
fn variables(context: &Context<'_>, range: TextRange) -> Vec<Passed> {
    let effects = Effects::new(context.db, context.project, context.file);
    let mut uses: BTreeMap<SmolStr, Vec<&Access>> = BTreeMap::new();
    for access in effects.all() {
        if let Root::Local(name) | Root::Param(name) = &access.root {
            uses.entry(name.clone()).or_default().push(access);
        }
    }
    let in_loop = is_in_loop(context, range);
    uses.into_iter().filter_map(|(name, uses)| passed(context, range, in_loop, &name, &uses)).collect()
}

fn passed(context: &Context<'_>, range: TextRange, in_loop: bool, name: &str, uses: &[&Access]) -> Option<Passed> {
    let is_inside = |access: &&&Access| range.contains_range(context.body().range(access.id));
    let inside: Vec<&&Access> = uses.iter().filter(is_inside).collect();
    let first = inside.first()?;
    let written = inside.iter().any(|access| access.kind != AccessKind::Read);
    let header = context.header();
    let (variable, is_local, by_reference) = match header.locals.iter().find(|local| local.name == name) {
        Some(local) => (declared(name, &local.type_name, local.container, &local.sizes), true, false),
        None => {
            let param = header.params.iter().find(|param| param.name == name)?;
            // A parameter of the old dialect may be an array: it is handed on as it came.
            let sizes = match param.container {
                Container::Array { dims } => vec![2; usize::from(dims)],
                _ => vec![1],
            };
            (declared(name, &param.type_name, param.container, &sizes), false, param.by_reference)
        }
    };
    // A local that keeps its value from one round of a loop to the next has to live outside.
    let starts_anew = !in_loop || first.kind == AccessKind::Write;
    let passing = if is_local && inside.len() == uses.len() && starts_anew {
        Passing::Inside
    } else if is_array(&variable)
        || by_reference && is_linked(&variable)
        || written && (is_local || by_reference || inside.len() < uses.len() || in_loop)
    {
        Passing::Reference
    } else {
        Passing::Value
    };
    Some(Passed { variable, passing })
}

fn declared(name: &str, type_name: &str, container: Container, sizes: &[u32]) -> Variable {
    Variable { name: name.to_owned(), type_name: type_name.to_owned(), container, sizes: sizes.to_vec() }
}

fn is_array(variable: &Variable) -> bool {
    variable.container == Container::Collection || !matches!(variable.sizes.as_slice(), [] | [1])
}

/// Inputs, outputs and serial lines are nothing without their link.
fn is_linked(variable: &Variable) -> bool {
    BaseType::from_name(&variable.type_name).is_some_and(BaseType::is_linkable)
}

/// A loop of the program stands around the statements.
fn is_in_loop(context: &Context<'_>, range: TextRange) -> bool {
    let repeats = |kind: &StmtKind| matches!(kind, StmtKind::While { .. } | StmtKind::Do { .. } | StmtKind::For { .. });
    let around = |stmt: &&Stmt| stmt.range.contains_range(range) && stmt.range != range;
    context.body().stmts().iter().filter(|stmt| around(stmt)).any(|stmt| repeats(&stmt.kind))
}

/// The lines of the new program, one level deep.
fn code(context: &Context<'_>, range: TextRange) -> Vec<String> {
    let text = context.plain(range);
    let level = context.level();
    let outer = context.indentation(range.start());
    text.lines()
        .map(|line| {
            let line = line.trim_end_matches('\r');
            let inner = line.strip_prefix(outer).unwrap_or(line.trim_start());
            if inner.trim().is_empty() { String::new() } else { format!("{level}{inner}") }
        })
        .collect()
}

fn without_local(context: &Context<'_>, name: &str) -> Option<crate::edit::FileEdit> {
    let locals = declarations::all_locals(context.db, context.file);
    let local = locals.iter().find(|local| local.name == name)?;
    Some(declare::without(context.db, context.file, local.element))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "extract-program";

    #[test]
    fn parameters_and_passing() {
        check(
            ID,
            "num nG\nprogram other(num x_in, num& x_out, string x_s)\n  num l_a\n  num l_b\n  num l_only\n  num l_arr[3]\n  num l_rest\nbegin\n  l_a=1\n  $0// sums up\n  l_only=l_a+x_in\n  if nG==1\n    l_b=l_arr[1]+l_only\n\n    x_out=l_b\n  endIf\n$0  l_rest=l_b\nend",
            expect![[r#"
                new usrapp/main/extracted.pgx
                +<?xml version="1.0" encoding="utf-8"?>
                +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                +  <Program name="extracted">
                +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
                +      <Parameter name="l_a" type="num" xsi:type="element" />
                +      <Parameter name="l_b" type="num" xsi:type="element" use="reference" />
                +      <Parameter name="x_in" type="num" xsi:type="element" />
                +      <Parameter name="x_out" type="num" xsi:type="element" use="reference" />
                +    </Parameters>
                +    <Locals>
                +      <Local name="l_arr" type="num" xsi:type="array" size="3" />
                +      <Local name="l_only" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  // sums up
                +  l_only=l_a+x_in
                +  if nG==1
                +    l_b=l_arr[1]+l_only
                +
                +    x_out=l_b
                +  endIf
                +end]]></Code>
                +  </Program>
                +</Programs>
                usrapp/main/main.pjx
                +    <Program file="extracted.pgx" />
                usrapp/main/other.pgx
                -      <Local name="l_only" type="num" xsi:type="array" size="1" />
                -      <Local name="l_arr" type="num" xsi:type="array" size="3" />
                -      <Local name="l_rest" type="num" xsi:type="array" size="1" />
                -    </Locals>
                -    <Code><![CDATA[begin
                -  l_a=1
                -  // sums up
                -  l_only=l_a+x_in
                -  if nG==1
                -    l_b=l_arr[1]+l_only
                -
                -    x_out=l_b
                -  endIf
                +      <Local name="l_rest" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  l_a=1
                +  call extracted(l_a,l_b,x_in,x_out)
            "#]],
        );
    }

    #[test]
    fn what_lives_on_from_round_to_round_stays_outside() {
        check(
            ID,
            "program other()\n  num l_sum\n  num l_new\n  num l_i\nbegin\n  for l_i=1 to 3\n    $0l_new=l_i\n    l_sum=l_sum+l_new$0\n  endFor\nend",
            expect![[r#"
                new usrapp/main/extracted.pgx
                +<?xml version="1.0" encoding="utf-8"?>
                +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                +  <Program name="extracted">
                +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
                +      <Parameter name="l_i" type="num" xsi:type="element" />
                +      <Parameter name="l_sum" type="num" xsi:type="element" use="reference" />
                +    </Parameters>
                +    <Locals>
                +      <Local name="l_new" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  l_new=l_i
                +  l_sum=l_sum+l_new
                +end]]></Code>
                +  </Program>
                +</Programs>
                usrapp/main/main.pjx
                +    <Program file="extracted.pgx" />
                usrapp/main/other.pgx
                -      <Local name="l_new" type="num" xsi:type="array" size="1" />
                -      <Local name="l_i" type="num" xsi:type="array" size="1" />
                -    </Locals>
                -    <Code><![CDATA[begin
                -  for l_i=1 to 3
                -    l_new=l_i
                -    l_sum=l_sum+l_new
                +      <Local name="l_i" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  for l_i=1 to 3
                +    call extracted(l_i,l_sum)
            "#]],
        );
    }

    #[test]
    fn escaped_code() {
        check(
            ID,
            "num nZ\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\n  <program name=\"start\" public=\"false\">\n    <localSection>\n      <local name=\"l_a\" type=\"num\" size=\"1\"/>\n    </localSection>\n    <source><code>begin\r\n  $0if 1&lt;2\r\n    l_a=1\r\n  endIf$0\r\nend</code></source>\n  </program>\n</programList>\n",
            expect![[r#"
                new usrapp/main/extracted.pgx
                +<?xml version="1.0" encoding="utf-8"?>
                +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                +  <Program name="extracted">
                +    <Locals>
                +      <Local name="l_a" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  if 1<2
                +    l_a=1
                +  endIf
                +end]]></Code>
                +  </Program>
                +</Programs>
                usrapp/main/main.pjx
                +    <Program file="extracted.pgx" />
                usrapp/main/start.pgx
                -      <local name="l_a" type="num" size="1"/>
                -    </localSection>
                -    <source><code>begin
                -  if 1&lt;2
                -    l_a=1
                -  endIf
                +    </localSection>
                +    <source><code>begin
                +  call extracted()
            "#]],
        );
    }

    #[test]
    fn not_across_a_return_or_a_broken_line() {
        for code in ["$0return$0", "$0if true\n  return\nendIf$0", "$0putln(1)\nnA==$0", "putln$0(1)"] {
            assert_eq!(offered(&format!("num nA\n{code}"), ID), None, "{code}");
        }
    }
}
