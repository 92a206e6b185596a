//! Replaces a call by the code of the called program.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind, body};
use val3_analysis::db::File;
use val3_analysis::effects::{AccessKind, Effects, RootVariable};
use val3_analysis::items::program::{Header, LocalDecl, ParamDecl, header};
use val3_lang::types::Container;
use val3_syntax::ast::{AstNode as _, CallStmt, Code};
use val3_syntax::{TextRange, TextSize};

use super::context::Context;
use super::evaluation::is_loop;
use super::lines::{dedented, plain_with, with_comments};
use super::{AssistKind, Assists};
use crate::declare::{self, NewVariable, free};
use crate::edit::SourceChange;
use crate::variables::declares_variable;
use crate::xml_list::whole_line;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let call = context.node::<CallStmt>()?;
    let range = call.syntax().text_range();
    let id = context.expr_at(call.call_expr()?.syntax().text_range())?;
    let Expr::Call(callee, arguments) = context.body().expr(id) else { return None };
    let Expr::Name(name) = context.body().expr(*callee) else { return None };
    let file = *context.items().programs.get(name)?;
    let inlined = InlinedProgram { context, file, body: body(context.db, file), header: header(context.db, file) };
    let names = inlined.names(range, arguments)?;
    // `]]>` would end the CDATA section.
    if !context.is_escaped() && inlined.lines(&names)?.iter().any(|line| line.contains("]]>")) {
        return None;
    }
    assists.add("inline-program", AssistKind::Inline, format!("Inline program `{name}`"), || {
        inlined.change(range, &names)
    });
    Some(())
}

/// The inlined program.
struct InlinedProgram<'c, 'db> {
    context: &'c Context<'db>,
    file: File,
    body: &'db Body,
    header: &'db Header,
}

/// Replacement for a name of the inlined program, unescaped.
struct NewName {
    old: SmolStr,
    new: String,
    /// Variable to be declared in the caller.
    local: Option<NewVariable>,
}

fn is_array(container: Container) -> bool {
    matches!(container, Container::Array { .. })
}

/// Whether one of the new locals has this name, in any letter case.
fn is_new_local(names: &[NewName], name: &str) -> bool {
    names.iter().any(|other| other.local.is_some() && other.new.eq_ignore_ascii_case(name))
}

impl InlinedProgram<'_, '_> {
    /// Replacements of parameters and locals; `None` if the behaviour would change.
    fn names(&self, call: TextRange, arguments: &[ExprId]) -> Option<Vec<NewName>> {
        let is_self = self.file == self.context.file;
        let plain = |kind: &StmtKind| !matches!(kind, StmtKind::Return | StmtKind::Error);
        if is_self || !self.header.complete || arguments.len() != self.header.params.len() {
            return None;
        }
        if !self.body.stmts().iter().all(|stmt| plain(&stmt.kind)) || self.hides_globals() {
            return None;
        }
        // Each call initialises the locals, but in a loop of the caller they would keep their values.
        if self.used_locals().next().is_some() && self.is_repeated(call) {
            return None;
        }
        let params = self.header.params.iter().zip(arguments);
        let mut names: Vec<NewName> = params
            .map(|(param, argument)| {
                let new = self.argument(param, *argument)?;
                Some(NewName { old: param.name.clone(), new, local: None })
            })
            .collect::<Option<_>>()?;
        for local in self.used_locals() {
            let new = free(&local.name, |name| is_new_local(&names, name) || self.context.is_taken(name));
            let variable = NewVariable {
                name: new.clone(),
                type_name: local.type_name.to_string(),
                container: Container::Array { dims: 1 },
                sizes: local.sizes.clone(),
            };
            names.push(NewName { old: local.name.clone(), new, local: Some(variable) });
        }
        Some(names)
    }

    /// Locals that the code uses. Unused locals are not copied to the caller.
    fn used_locals(&self) -> impl Iterator<Item = &LocalDecl> {
        let names = self.body.exprs().filter_map(|(_, expr, _)| match expr {
            Expr::Name(name) => Some(name),
            _ => None,
        });
        let names: FxHashSet<&SmolStr> = names.collect();
        self.header.locals.iter().filter(move |local| names.contains(&local.name))
    }

    /// Text that replaces a parameter; `None` if an expression would be evaluated several times.
    fn argument(&self, param: &ParamDecl, argument: ExprId) -> Option<String> {
        let own = self.context.body();
        let text = self.context.plain(own.range(argument));
        let effects = Effects::new(self.context.db, self.context.project, self.file);
        let by_reference = param.by_reference;
        let mut writes = effects.all().iter().filter(|access| access.kind != AccessKind::Read);
        let written = writes.any(|access| matches!(&access.root, RootVariable::Param(name) if *name == param.name));
        // Code with an array parameter may use an index, which a single value does not support.
        if is_array(param.container) && !is_array(self.context.inference().ty(argument).container) {
            return None;
        }
        let simple = match own.expr(own.without_parentheses(argument)) {
            Expr::Number(_) | Expr::String(_) | Expr::Bool(_) => !by_reference,
            // A parameter by value is a copy; a variable in its place may change during the code.
            Expr::Name(_) => by_reference || !written && !self.changes_anything(),
            _ => false,
        };
        (simple && (by_reference || !written)).then_some(text)
    }

    /// Whether the program writes a variable other than its locals, or makes a call that may.
    fn changes_anything(&self) -> bool {
        let effects = Effects::new(self.context.db, self.context.project, self.file);
        let outer = |root: &RootVariable| !matches!(root, RootVariable::Local(_));
        let calls = |kind: &StmtKind| matches!(kind, StmtKind::Call(_) | StmtKind::TaskCreate { .. });
        effects.all().iter().any(|access| access.kind != AccessKind::Read && outer(&access.root))
            || self.body.stmts().iter().any(|stmt| calls(&stmt.kind))
            || effects.may_wait()
    }

    /// Whether a local or parameter of the caller hides a global that the program uses.
    fn hides_globals(&self) -> bool {
        self.body.exprs().any(|(_, expr, _)| match expr {
            Expr::Name(name) => !declares_variable(self.header, name) && declares_variable(self.context.header(), name),
            _ => false,
        })
    }

    fn is_repeated(&self, call: TextRange) -> bool {
        let stmts = self.context.body().stmts();
        stmts.iter().any(|stmt| stmt.range.contains_range(call) && is_loop(stmt))
    }

    fn change(&self, call: TextRange, names: &[NewName]) -> Option<SourceChange> {
        let context = self.context;
        let (outer, line_end) = (context.indentation(call.start()), context.line_end());
        let lines = self.lines(names)?;
        let written = lines.iter().enumerate().map(|(index, line)| match (index, line.as_str()) {
            (0, line) => context.written(line),
            (_, "") => line_end.to_owned(),
            (_, line) => format!("{line_end}{outer}{}", context.written(line)),
        });
        let replaced = match written.collect::<String>() {
            nothing if nothing.is_empty() => context.replace(whole_line(context.text, call), ""),
            code => context.replace(call, code),
        };
        let locals: Vec<&NewVariable> = names.iter().filter_map(|name| name.local.as_ref()).collect();
        let declared = match locals.as_slice() {
            [] => None,
            locals => Some(declare::locals(context.db, context.file, locals)?),
        };
        Some(SourceChange::of(declared.into_iter().chain([replaced])))
    }

    /// Code of the program with the new names, unescaped and without its indentation.
    fn lines(&self, names: &[NewName]) -> Option<Vec<String>> {
        let root = val3_analysis::items::parse(self.context.db, self.file).root();
        let code = root.descendants().find_map(Code::cast)?;
        let text: &str = self.file.text(self.context.db);
        let range = with_comments(&code.block()?);
        // The whitespace before the first line belongs to its indentation.
        let blanks = text.get(..usize::from(range.start()))?;
        let blanks = TextSize::of(blanks) - TextSize::of(blanks.trim_end_matches([' ', '\t']));
        let range = TextRange::new(range.start() - blanks, range.end());
        let plain = plain_with(&code, text, range, &self.uses(names));
        Some(dedented(&plain, TextRange::up_to(TextSize::of(plain.as_str()))))
    }

    /// Uses of the renamed names, in the order of the text.
    fn uses<'n>(&self, names: &'n [NewName]) -> Vec<(TextRange, &'n str)> {
        let mut uses: Vec<(TextRange, &str)> = self
            .body
            .exprs()
            .filter_map(|(_, expr, range)| match expr {
                Expr::Name(name) => {
                    let new = names.iter().find(|new| new.old == *name)?;
                    Some((range, new.new.as_str()))
                }
                _ => None,
            })
            .collect();
        uses.sort_by_key(|(range, _)| range.start());
        uses
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "inline-program";

    #[test]
    fn unused_locals_stay_behind() {
        let found = crate::assists::testing::done(
            "while true\n  call oth$0er()\nendWhile\nprogram other()\n  num l_nUnused\nbegin\n  cls()\nend",
            ID,
        );
        assert!(found.contains("+  cls()") && !found.contains("l_nUnused"), "{found}");
    }

    #[test]
    fn parameters_become_the_arguments_of_the_caller() {
        check(
            ID,
            "num nG\nprogram start()\n  num l_i\n  num l_a\nbegin\n  if true\n    ca$0ll pick(l_a,2)\n  endIf\nend\nprogram pick(num& x_a, num x_b)\n  num l_i\n  num l_k[3]\nbegin\n  // counts\n  for l_i=0 to x_b\n    x_a=x_a+l_i+l_k[0]\n\n    putln(\"x_a\")\n  endFor\n  // done\nend",
            expect![[r#"
                usrapp/main/start.pgx
                -    </Locals>
                -    <Code><![CDATA[begin
                -  if true
                -    call pick(l_a,2)
                +      <Local name="l_i2" type="num" xsi:type="array" size="1" />
                +      <Local name="l_k" type="num" xsi:type="array" size="3" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  if true
                +    // counts
                +    for l_i2=0 to 2
                +      l_a=l_a+l_i2+l_k[0]
                +
                +      putln("x_a")
                +    endFor
                +    // done
            "#]],
        );
    }

    #[test]
    fn a_call_of_an_empty_program_is_removed() {
        check(
            ID,
            "num nA\nnA=1\ncall ot$0her()\nprogram other()\nbegin\nend",
            expect![[r#"
            usrapp/main/start.pgx
            -call other()
        "#]],
        );
    }

    #[test]
    fn code_after_an_empty_block_is_inlined() {
        check(
            ID,
            "num nA\ncall ot$0her()\nprogram other()\nbegin\n  // picks\n  switch nA\n    default\n    break\n  endSwitch\n  nA=1\nend",
            expect![[r#"
                usrapp/main/start.pgx
                -call other()
                +// picks
                +switch nA
                +  default
                +  break
                +endSwitch
                +nA=1
            "#]],
        );
    }

    #[test]
    fn escaped_code_is_inlined() {
        check(
            ID,
            "num nA\nprogram other()\nbegin\n  if nA<1\n    nA=2\n  endIf\nend\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\n  <program name=\"start\" public=\"false\">\n    <source><code>begin\r\n  call ot$0her()\r\nend</code></source>\n  </program>\n</programList>\n",
            expect![[r#"
                usrapp/main/start.pgx
                -  call other()
                +  if nA&lt;1
                +    nA=2
                +  endIf
            "#]],
        );
    }

    #[test]
    fn code_with_the_end_of_a_cdata_section_is_refused() {
        assert_eq!(offered(&call_of_escaped("bA=nA[nB[0]]&gt;2"), ID), None);
        assert!(offered(&call_of_escaped("bA=nA[0]&gt;2"), ID).is_some());
    }

    /// A call of a program whose code is escaped, not in a CDATA section.
    fn call_of_escaped(code: &str) -> String {
        format!(
            "num nA[3]\nnum nB[3]\nbool bA\ncall ot$0her()\n=== main/other.pgx\n<Programs><Program name=\"other\"><Code>begin\n\
             {code}\nend</Code></Program></Programs>\n"
        )
    }

    #[test]
    fn calls_that_would_behave_differently_are_refused() {
        let other = |head: &str, code: &str| format!("program other({head})\nbegin\n{code}\nend");
        for listing in [
            format!("call ot$0her()\n{}", other("", "return")),
            format!("num nA\ncall ot$0her(nA)\n{}", other("num x_a", "x_a=1")),
            format!("num nA\ncall ot$0her(nA)\n{}", other("num x_a", "nA=x_a\nnA=x_a")),
            format!(
                "call one(1)\nprogram one(num x_a)\nbegin\n  call ot$0her(x_a)\nend\n{}",
                other("num& x_a[]", "x_a[0]=1")
            ),
            format!("num nA\ncall ot$0her(nA+1)\n{}", other("num x_a", "put(x_a)")),
            format!("num nA\nprogram start()\n  num nA\nbegin\n  call ot$0her()\nend\n{}", other("", "nA=1")),
            "while true\n  call ot$0her()\nendWhile\nprogram other()\n  num l_i\nbegin\n  l_i=l_i+1\nend".to_owned(),
            "program other()\nbegin\n  call ot$0her()\nend".to_owned(),
            "call miss$0ing()".to_owned(),
        ] {
            assert_eq!(offered(&listing, ID), None, "{listing}");
        }
    }
}
