//! Declares an unresolved name as a parameter, passed by reference if the program changes it. An argument is added to
//! every call.

mod callers;

use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind};
use val3_analysis::items::project::{items, signature};
use val3_lang::instruction::ArgumentForm;
use val3_lang::types::Container;

use super::context::Context;
use super::expected::{UnknownName, unknown};
use super::{AssistKind, Assists};
use crate::declare;
use crate::edit::SourceChange;

const ID: &str = "create-parameter";
const GROUP: Option<&str> = Some("Create");

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let unknown = unknown(context)?;
    // The controller starts these programs itself, without arguments.
    if context.options().entry_points.iter().any(|name| *name == *context.header().name) {
        return None;
    }
    let by_reference =
        unknown.ty().container != Container::Element || unknown.is_linkable() || is_written(context, &unknown);
    let declaration = declare::parameter(context.db, context.file, &unknown.parameter(context), by_reference)?;
    let title = format!("Create parameter `{} {}`", unknown.shown(context.db), unknown.name);
    let kind = AssistKind::QuickFix;
    let passed = match callers::pass(context, &unknown, by_reference) {
        Ok(passed) => passed,
        Err(reason) => {
            assists.refuse(GROUP, ID, kind, title, reason);
            return None;
        }
    };
    let title = match &passed.default {
        Some(value) => format!("{title}, passing `{value}` in its calls"),
        None => title,
    };
    assists.add_in(GROUP, ID, kind, title, || Some(SourceChange::of(std::iter::once(declaration).chain(passed.edits))));
    Some(())
}

/// Whether the program assigns to the name, or passes it to a call that may.
fn is_written(context: &Context<'_>, unknown: &UnknownName) -> bool {
    let body = context.body();
    let names = |id| root_name(body, id) == Some(&unknown.name);
    let assigned = body.stmts().iter().any(|stmt| match &stmt.kind {
        StmtKind::Assign { target, .. } => names(*target),
        StmtKind::For { counter: Some(counter), .. } => names(*counter),
        _ => false,
    });
    assigned
        || body.exprs().any(|(call, expr, _)| match expr {
            Expr::Assign(target, _) => names(*target),
            Expr::Call(callee, arguments) => {
                let mut named = (0..).zip(arguments.iter()).filter(|(_, argument)| names(**argument));
                named.any(|(at, _)| takes_reference(context, call, *callee, at))
            }
            _ => false,
        })
}

/// Name at the start of `name[…].field`.
fn root_name(body: &Body, mut id: ExprId) -> Option<&SmolStr> {
    while let Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) = body.expr(id) {
        id = *base;
    }
    match body.expr(id) {
        Expr::Name(name) => Some(name),
        _ => None,
    }
}

/// Whether the callee's parameter `at` requires a variable, not a value.
fn takes_reference(context: &Context<'_>, call: ExprId, callee: ExprId, at: usize) -> bool {
    if let Some(found) = context.inference().call(call) {
        let mut forms = match found.form {
            Some(form) => std::slice::from_ref(form).iter(),
            None => found.instruction.overloads.iter(),
        };
        return forms.any(|form| {
            let param = form.params.get(at);
            param.is_some_and(|param| !matches!(param.shape, ArgumentForm::Value | ArgumentForm::ProgramCall))
        });
    }
    let (project, name) = match context.body().expr(callee) {
        Expr::Name(name) => (Some(context.project), name),
        Expr::Path { library, item } => {
            (context.items().libraries.get(library).and_then(|library| library.interface), item)
        }
        _ => return false,
    };
    let file = project.and_then(|project| Some((project, *items(context.db, project).programs.get(name)?)));
    file.is_some_and(|(project, file)| {
        signature(context.db, project, file).params.get(at).is_some_and(|param| param.by_reference)
    })
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::ID;
    use crate::assists::testing::{check, done, offered, refused};

    #[test]
    fn the_parameter_is_passed_as_it_is_used() {
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
    fn start_gets_no_parameter() {
        assert_eq!(offered("putln(x_$0s)", ID), None);
    }

    #[test]
    fn every_call_passes_something() {
        let program = "program other(num x_a)\nbegin\n  putln(x_$0b+x_a)\n  call other(1,2)\nend\n\
            program third()\n  num x_b\nbegin\n  call other(3)\n  taskCreate \"t\",10,other(4)\nend";
        check(
            ID,
            &format!("call other(0)\n{program}"),
            expect![[r#"
                usrapp/main/other.pgx
                -    </Parameters>
                -    <Code><![CDATA[begin
                -  putln(x_b+x_a)
                -  call other(1,2)
                +      <Parameter name="x_b" type="num" xsi:type="element" />
                +    </Parameters>
                +    <Code><![CDATA[begin
                +  putln(x_b+x_a)
                +  call other(1,2,x_b)
                usrapp/main/start.pgx
                -call other(0)
                +call other(0,0)
                usrapp/main/third.pgx
                -  call other(3)
                -  taskCreate "t",10,other(4)
                +  call other(3,x_b)
                +  taskCreate "t",10,other(4,x_b)
            "#]],
        );
        let title = "Create parameter `num x_b`, passing `0` in its calls";
        assert_eq!(offered(&format!("call other(0)\n{program}"), ID).as_deref(), Some(title));
        assert_eq!(offered(program, ID).as_deref(), Some("Create parameter `num x_b`"));
    }

    #[test]
    fn calls_of_other_projects_pass_a_value() {
        let done = done(
            "library part \"Disk://part/part.pjx\"\ncall part:show()\n--- part\npublic program show()\nbegin\n  putln(x_$0s)\nend",
            ID,
        );
        assert!(done.contains("+call part:show(0)") || done.contains("+call part:show(\"\")"), "{done}");
    }

    #[test]
    fn escaped_calls_are_changed() {
        let (start, other) = (old("start", "call other()"), old("other", "put(x_$0s+&quot;a&quot;)"));
        let done = done(&format!("num nZ\n{start}{other}"), ID);
        assert!(done.contains("call other(&quot;&quot;)"), "{done}");
    }

    /// A program file in the old dialect.
    fn old(name: &str, code: &str) -> String {
        format!(
            "=== main/{name}.pgx\n<programList xmlns=\"ProgramNameSpace\"><program name=\"{name}\" public=\"false\"><paramSection /><localSection /><source><code>begin\n{code}\nend</code></source></program></programList>\n"
        )
    }

    #[test]
    fn the_assist_is_refused_if_a_caller_has_no_value() {
        for (code, reason) in [
            ("x_$0n[2]=1", "the caller `start` has no value to pass"),
            ("x_$0n=1", "the caller `start` has no value to pass"),
            ("call third(x_$0n)", "the caller `start` has no value to pass"),
            ("putln(x_$0p.trsf.x)", "the caller `start` has no value to pass"),
        ] {
            let listing = format!(
                "call other()\nprogram other()\nbegin\n  {code}\nend\nprogram third(num& x_n)\nbegin\n  x_n=1\nend"
            );
            assert_eq!(refused(&listing, ID).as_deref(), Some(reason), "{code}");
        }
    }

    #[test]
    fn an_array_is_declared_as_one() {
        let declared = |code: &str| done(&format!("program other()\nbegin\n  {code}\nend"), ID);
        let array = "<Parameter name=\"x_n\" type=\"num\" xsi:type=\"array\" use=\"reference\" />";
        assert!(declared("put(x_$0n[2]+1)").contains(array));
        assert!(declared("put(x_$0n[1,2]+1)").contains("use=\"reference\" dimensions=\"2\""));
        assert!(declared("call third(x_$0n)\nend\nprogram third(num& x_n[])\nbegin\n  x_n[0]=1").contains(array));
    }

    #[test]
    fn programs_of_interfaces_keep_their_parameters() {
        let listing = "library part \"Disk://part/part.pjx\" autoload=false\nnum nA\nnA=part:libLoad(\"Disk://box\")\n\
            --- part\npublic program pick()\nbegin\n  putln(x_$0n)\nend\n--- box\npublic program pick()\nbegin\nend";
        assert_eq!(
            refused(listing, ID).as_deref(),
            Some("`box` has the same program, because both implement one interface")
        );
    }
}
