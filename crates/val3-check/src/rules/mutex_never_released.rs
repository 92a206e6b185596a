//! V0331: a mutex that is never released.

use val3_analysis::body::ExprId;
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_lang::instructions::SET_MUTEX;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// `setMutex` locks a mutex that no program releases.
    ///
    /// ## Why
    /// `setMutex` waits until the variable is `false` and sets it to `true`. The task that has taken the mutex must set
    /// it back to `false` (5.9). Otherwise the next `setMutex` never returns, even in the same task.
    ///
    /// ## Bad
    /// ```val3
    /// bool bScreen
    ///
    /// setMutex(bScreen)
    /// putln("ready")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bScreen
    ///
    /// setMutex(bScreen)
    /// putln("ready")
    /// bScreen=false
    /// ```
    V0331 "mutex-never-released" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let taken: Vec<ExprId> = program.calls_of(SET_MUTEX).filter_map(|call| call.args.first().copied()).collect();
    if taken.is_empty() || !program.application().sound {
        return;
    }
    let accesses = program.effects.all();
    for &mutex in &taken {
        let Some(RootVariable::Data(name)) = program.effects.root(mutex) else { continue };
        let is_private = program.items.data.get(&name).is_some_and(|item| !item.decl.public);
        let root = RootVariable::Data(name.clone());
        let released_here = accesses.iter().filter(|access| access.root == root).any(|access| match access.kind {
            AccessKind::Read => false,
            AccessKind::Write | AccessKind::WritePart => true,
            AccessKind::Reference => !taken.contains(&access.id),
        });
        if is_private && !released_here && !is_released_elsewhere(program, &name) {
            found.report(&RULE, program.range(mutex), word(program.text(mutex)));
        }
    }
}

/// Whether another program writes the variable, or passes it to a program or instruction that may write it.
fn is_released_elsewhere(program: &ProgramView<'_>, name: &str) -> bool {
    let users = program.application().users.get(name).into_iter().flatten();
    users.filter(|(user, _)| user != program.name()).any(|(_, uses)| uses.may_write())
}

fn word(mutex: &str) -> Wording {
    Wording::new(
        format!("no program releases `{mutex}`"),
        "the next `setMutex` never returns",
        format!("write `{mutex}=false` where the protected part ends"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_mutex_that_is_not_released_is_reported() {
        expect![[r#"
            start.pgx:5 `b[1]` no program releases `b[1]`
              | the next `setMutex` never returns
              ? write `b[1]=false` where the protected part ends
        "#]]
        .assert_eq(&check(&RULE, "bool b[2]\nsetMutex(b[1])\nif b[1]==true\nput(1)\nendIf"));
    }

    #[test]
    fn a_released_mutex_is_not_reported() {
        assert_eq!(check(&RULE, "bool b\nsetMutex(b)\nb=false"), "");
        assert_eq!(check(&RULE, "bool b\nsetMutex(b)\ncall done()\nprogram done()\nbegin\nb=false\nend"), "");
        assert_eq!(
            check(&RULE, "bool b\nsetMutex(b)\ncall done(b)\nprogram done(bool& x_b)\nbegin\nx_b=false\nend"),
            ""
        );
        assert_eq!(check(&RULE, "public bool b\nsetMutex(b)"), "");
    }
}
