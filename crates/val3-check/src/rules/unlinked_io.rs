//! V0316: a local input, output or serial line that is used before it is linked.

use rustc_hash::FxHashSet;
use val3_analysis::body::{Expr, ExprId};
use val3_analysis::effects::{Access, AccessKind, RootVariable};
use val3_analysis::flow::{FlowNode, FlowNodeId, forward};
use val3_lang::runtime_errors::UNLINKED;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Locals, ProgramView};
use crate::rule::rule;

rule! {
    /// A local `dio`, `aio` or `sio` is read or written before it is linked.
    ///
    /// ## Why
    /// A local variable starts without a link to a physical input or output. Reading or writing it stops the task with
    /// run-time error 123. Assigning a value to it writes the output and does not link it.
    ///
    /// ## Bad
    /// ```val3
    /// program lamp()
    ///   dio l_doLamp
    /// begin
    ///   l_doLamp=true
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// dio doGreen
    ///
    /// program lamp()
    ///   dio l_doLamp
    /// begin
    ///   dioLink(l_doLamp,doGreen)
    ///   l_doLamp=true
    /// end
    /// ```
    V0316 "unlinked-io" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut types = program.header.locals.iter().filter_map(|local| BaseType::from_file_name(&local.type_name));
    if !types.any(|(ty, _)| ty.is_linkable()) {
        return;
    }
    let arguments = Arguments::of(program);
    let local_use = program.local_use();
    let step = |id: FlowNodeId, _: &FlowNode, before: &Locals| before | arguments.linked(local_use.at(id));
    let facts = forward(program.flow(), 0, step, |known: &mut Locals, more| {
        let before = *known;
        *known |= more;
        *known != before
    });
    let mut told = 0;
    for (id, _) in program.flow().points() {
        let Some(mut linked) = facts.before(id).copied() else { continue };
        for (bit, access) in local_use.at(id) {
            let ty = program.inference.ty(access.id).base.builtin().filter(|ty| ty.is_linkable());
            if let (RootVariable::Local(name), Some(ty)) = (&access.root, ty)
                && arguments.uses(access)
                && (linked | told) & bit == 0
            {
                told |= bit;
                found.report(&RULE, program.range(access.id), word(name, ty));
            }
            linked |= if arguments.may_link(access) { *bit } else { 0 };
        }
    }
}

/// Arguments of calls: arguments that must be linked, and all others.
struct Arguments {
    needed: FxHashSet<ExprId>,
    others: FxHashSet<ExprId>,
}

impl Arguments {
    fn of(program: &ProgramView<'_>) -> Self {
        let mut arguments = Self { needed: FxHashSet::default(), others: FxHashSet::default() };
        for (id, expr, _) in program.body.exprs() {
            let Expr::Call(_, args) = expr else { continue };
            let needs_link = program.call_of(id).is_some_and(|call| call.instruction.errors.contains(&UNLINKED));
            let kind = if needs_link { &mut arguments.needed } else { &mut arguments.others };
            kind.extend(args.iter().copied());
        }
        arguments
    }

    /// Whether the variable is passed to a program or instruction that may link it.
    fn may_link(&self, access: &Access) -> bool {
        access.kind == AccessKind::Reference && !self.needed.contains(&access.id)
    }

    /// Variables that may be linked.
    fn linked(&self, accesses: &[(Locals, &Access)]) -> Locals {
        let linked = accesses.iter().filter(|(_, access)| self.may_link(access));
        linked.fold(0, |all, (bit, _)| all | bit)
    }

    /// Whether the input or output itself is read or written.
    fn uses(&self, access: &Access) -> bool {
        self.needed.contains(&access.id) || access.kind != AccessKind::Reference && !self.others.contains(&access.id)
    }
}

fn word(name: &str, ty: BaseType) -> Wording {
    Wording::new(
        format!("the {} `{name}` is not linked when it is used (run-time error {UNLINKED})", ty.name()),
        "no link yet",
        "link it to an input or output of the application before this line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!(
            "dio dA\naio aA\nnum nA\nbool bA\nstring sA\n\nprogram start()\n  dio l_d\n  dio l_dAll[8]\n  aio l_a\n  \
             sio l_s\nbegin\n{code}\nend\n\nprogram show(dio x_d)\nbegin\nend"
        )
    }

    #[test]
    fn unlinked_variables_are_reported() {
        expect![[r#"
            start.pgx:11 `l_d` the dio `l_d` is not linked when it is used (run-time error 123)
              | no link yet
              ? link it to an input or output of the application before this line
            start.pgx:12 `l_dAll` the dio `l_dAll` is not linked when it is used (run-time error 123)
              | no link yet
              ? link it to an input or output of the application before this line
            start.pgx:14 `l_a` the aio `l_a` is not linked when it is used (run-time error 123)
              | no link yet
              ? link it to an input or output of the application before this line
            start.pgx:15 `l_s` the sio `l_s` is not linked when it is used (run-time error 123)
              | no link yet
              ? link it to an input or output of the application before this line
        "#]]
        .assert_eq(&check(
            &RULE,
            &program("if l_d\nnA=dioGet(l_dAll)\nendIf\nnA=aioSet(l_a,1)\nsA=l_s\nl_d=true\ndioLink(l_d,dA)"),
        ));
    }

    #[test]
    fn linked_variables_and_status_queries_are_not_reported() {
        let lines = ["dioLink(l_d,dA)\nl_d=true", "if bA\ndioLink(l_d,dA)\nendIf\nbA=l_d", "nA=ioStatus(l_d)"];
        for line in lines.into_iter().chain(["dioLink(l_dAll[0],dA)\nnA=dioGet(l_dAll)", "call show(l_d)"]) {
            assert_eq!(check(&RULE, &program(line)), "", "{line}");
        }
    }
}
