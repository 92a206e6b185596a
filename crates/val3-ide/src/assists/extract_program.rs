//! Extracts statements into a new program.

mod passing;

use val3_analysis::body::{Stmt, StmtKind};
use val3_analysis::items::declarations;
use val3_syntax::TextRange;
use val3_syntax::ast::AstNode as _;

use passing::{Passing, variables};

use super::context::Context;
use super::{AssistKind, Assists};
use crate::declare::{self, NewProgram};
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
    let params = passed.iter().filter(|found| !found.passing.is_local());
    let locals = passed.iter().filter(|found| found.passing.is_local());
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
    let moved = locals.filter(|found| found.passing == Passing::Inside);
    change.edits.extend(moved.filter_map(|found| without_local(context, &found.variable.name)));
    Some(change.with_new_name(context.file, range.start(), &name))
}

/// Lines of the new program, indented by one level.
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
    fn parameters_follow_from_the_variables() {
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
    fn variables_that_survive_a_loop_round_stay_in_the_caller() {
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
    fn only_values_used_later_are_returned() {
        check(
            ID,
            "program other()\n  num l_a\n  num l_b\n  num l_c\nbegin\n  l_a=1\n  l_b=1\n  $0l_a=l_a+l_b\n  l_b=l_a\n  l_c=l_b\n  putln(l_c)$0\n  l_b=2\n  l_c=l_b\n  putln(l_c)\nend",
            expect![[r#"
                new usrapp/main/extracted.pgx
                +<?xml version="1.0" encoding="utf-8"?>
                +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                +  <Program name="extracted">
                +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
                +      <Parameter name="l_a" type="num" xsi:type="element" />
                +      <Parameter name="l_b" type="num" xsi:type="element" />
                +    </Parameters>
                +    <Locals>
                +      <Local name="l_c" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  l_a=l_a+l_b
                +  l_b=l_a
                +  l_c=l_b
                +  putln(l_c)
                +end]]></Code>
                +  </Program>
                +</Programs>
                usrapp/main/main.pjx
                +    <Program file="extracted.pgx" />
                usrapp/main/other.pgx
                -  l_a=l_a+l_b
                -  l_b=l_a
                -  l_c=l_b
                -  putln(l_c)
                +  call extracted(l_a,l_b)
            "#]],
        );
    }

    #[test]
    fn variables_set_on_one_path_of_a_loop_are_passed_by_reference() {
        check(
            ID,
            "program other()\n  num l_i\n  num l_last\nbegin\n  for l_i=1 to 3\n    $0if l_i==1\n      l_last=l_i\n    endIf\n    putln(l_last)$0\n  endFor\nend",
            expect![[r#"
                new usrapp/main/extracted.pgx
                +<?xml version="1.0" encoding="utf-8"?>
                +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                +  <Program name="extracted">
                +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
                +      <Parameter name="l_i" type="num" xsi:type="element" />
                +      <Parameter name="l_last" type="num" xsi:type="element" use="reference" />
                +    </Parameters>
                +    <Code><![CDATA[begin
                +  if l_i==1
                +    l_last=l_i
                +  endIf
                +  putln(l_last)
                +end]]></Code>
                +  </Program>
                +</Programs>
                usrapp/main/main.pjx
                +    <Program file="extracted.pgx" />
                usrapp/main/other.pgx
                -    if l_i==1
                -      l_last=l_i
                -    endIf
                -    putln(l_last)
                +    call extracted(l_i,l_last)
            "#]],
        );
    }

    #[test]
    fn escaped_code_is_extracted() {
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
    fn code_with_the_end_of_a_cdata_section_is_escaped() {
        check(
            ID,
            "num nA[3]\nnum nB[3]\nbool bA\nstring s\n=== main/start.pgx\n<Programs><Program name=\"start\"><Code>begin\n$0bA=nA[nB[0]]&gt;2\ns=&quot;]]&gt;&quot;$0\nend</Code></Program></Programs>\n",
            expect![[r#"
                new usrapp/main/extracted.pgx
                +<?xml version="1.0" encoding="utf-8"?>
                +<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                +  <Program name="extracted">
                +    <Code>begin
                +  bA=nA[nB[0]]&gt;2
                +  s=&quot;]]&gt;&quot;
                +end</Code>
                +  </Program>
                +</Programs>
                usrapp/main/main.pjx
                +    <Program file="extracted.pgx" />
                usrapp/main/start.pgx
                -bA=nA[nB[0]]&gt;2
                -s=&quot;]]&gt;&quot;
                +call extracted()
            "#]],
        );
    }

    #[test]
    fn a_selection_with_return_or_a_broken_line_is_refused() {
        for code in ["$0return$0", "$0if true\n  return\nendIf$0", "$0putln(1)\nnA==$0", "putln$0(1)"] {
            assert_eq!(offered(&format!("num nA\n{code}"), ID), None, "{code}");
        }
    }
}
