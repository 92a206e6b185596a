//! V0332: a `return` while a mutex is taken.

use std::collections::BTreeMap;

use smol_str::SmolStr;
use val3_analysis::body::ExprId;
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_analysis::flow::{FlowNode, FlowNodeId, PointKind, forward};
use val3_lang::instructions::SET_MUTEX;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program returns before the line on which it releases a mutex.
    ///
    /// ## Why
    /// The task that has locked a mutex with `setMutex` must set it back to `false` (5.9). A `return` on the way leaves
    /// it taken, and the next `setMutex` never returns, even in the same task. Programs that never release the mutex
    /// themselves are not reported.
    ///
    /// ## Bad
    /// ```val3
    /// bool bScreen
    /// num nCount
    ///
    /// setMutex(bScreen)
    /// if nCount==0
    ///   return
    /// endIf
    /// putln(nCount)
    /// bScreen=false
    /// nCount=0
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bScreen
    /// num nCount
    ///
    /// setMutex(bScreen)
    /// if nCount!=0
    ///   putln(nCount)
    /// endIf
    /// bScreen=false
    /// nCount=0
    /// ```
    V0332 "return-with-mutex" Warning, Member: check
}

/// Taken mutexes, each with the call that has taken it.
type Taken = BTreeMap<SmolStr, ExprId>;

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let returns = program.flow().points().any(|(_, point)| matches!(point.kind, PointKind::Return));
    if !returns || program.calls_of(SET_MUTEX).next().is_none() || !program.application().sound {
        return;
    }
    let step = |id: FlowNodeId, point: &FlowNode, before: &Taken| after(program, id, point, before);
    let facts = forward(program.flow(), Taken::new(), step, |known, other| {
        let count = known.len();
        known.retain(|name, _| other.contains_key(name));
        known.len() != count
    });
    for (id, point) in program.flow().points() {
        let Some(taken) = facts.before(id).filter(|_| matches!(point.kind, PointKind::Return)) else { continue };
        for (name, call) in taken.iter().filter(|(name, _)| is_released(program, name)) {
            found.report(&RULE, point.range, word(name)).related(program.range(*call), "taken here");
        }
    }
}

fn after(program: &ProgramView<'_>, id: FlowNodeId, point: &FlowNode, before: &Taken) -> Taken {
    let mut taken = before.clone();
    if matches!(point.kind, PointKind::Call(_)) {
        taken.retain(|name, _| !program.may_change_elsewhere(name));
    }
    for access in program.effects.at(id).iter().filter(|access| access.kind != AccessKind::Read) {
        if let RootVariable::Data(name) = &access.root {
            taken.remove(name);
        }
    }
    for call in program.calls_at(id).iter().filter(|call| call.instruction.name == SET_MUTEX) {
        let mutex = call.args.first().and_then(|mutex| program.effects.root(*mutex));
        if let Some(RootVariable::Data(name)) = mutex {
            taken.insert(name, call.id);
        }
    }
    taken
}

/// Whether the program itself releases the mutex somewhere.
fn is_released(program: &ProgramView<'_>, name: &str) -> bool {
    let mut writes = program.effects.all().iter().filter(|access| access.kind == AccessKind::Write);
    writes.any(|access| matches!(&access.root, RootVariable::Data(data) if data == name))
}

fn word(mutex: &str) -> Wording {
    Wording::new(
        format!("the program returns while it holds the mutex `{mutex}`"),
        "the next `setMutex` never returns",
        format!("write `{mutex}=false` before this line"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        let others = "program release()\nbegin\nbB=false\nend";
        check(&RULE, &format!("bool bA\nbool bB\nnum nA\nprogram start()\nbegin\n{code}\nend\n{others}"))
    }

    #[test]
    fn a_return_before_the_release_is_reported() {
        expect![[r#"
            start.pgx:7 `return` the program returns while it holds the mutex `bA`
              | the next `setMutex` never returns
              ? write `bA=false` before this line
              > start.pgx:5 `setMutex(bA)` taken here
        "#]]
        .assert_eq(&program("setMutex(bA)\nif nA==1\nreturn\nelseIf nA==2\nbA=false\nreturn\nendIf\nbA=false"));
    }

    #[test]
    fn other_returns_are_not_reported() {
        for code in [
            "setMutex(bA)\nreturn",
            "if nA==1\nreturn\nendIf\nsetMutex(bA)\nbA=false",
            "setMutex(bA)\nbA=false\nif nA==1\nreturn\nendIf",
            "setMutex(bB)\nif nA==1\ncall release()\nreturn\nendIf\nbB=false",
            "if nA==1\nsetMutex(bA)\nendIf\nif nA==1\nreturn\nendIf\nbA=false",
        ] {
            assert_eq!(program(code), "", "{code}");
        }
    }
}
