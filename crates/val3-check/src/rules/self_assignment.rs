//! V0237: a variable assigned to itself.

use val3_analysis::body::StmtKind;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A variable is assigned to itself.
    ///
    /// ## Why
    /// The line changes nothing. Usually one of the two names should be another one: a parameter and its global
    /// variable, another field, another index.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    /// num nTotal
    ///
    /// nCount=nCount
    /// nTotal=nTotal+nCount
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// num nTotal
    ///
    /// nCount=nTotal
    /// nTotal=nTotal+nCount
    /// ```
    V0237 "self-assignment" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::Assign { target, value } = stmt.kind else { continue };
        // An assignment of a serial line to itself reads and writes it.
        let is_line = program.inference.ty(target).base.builtin() == Some(BaseType::Sio);
        if !is_line && program.is_same(target, value) {
            found.report(&RULE, stmt.range, word(program.text(target)));
        }
    }
}

fn word(variable: &str) -> Wording {
    Wording::new(format!("`{variable}` is assigned to itself"), "changes nothing", "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn an_assignment_to_itself_is_reported() {
        expect![[r#"
            start.pgx:5 `n[i] = n[ i ]` `n[i]` is assigned to itself
              | changes nothing
            start.pgx:6 `t.x=(t.x)` `t.x` is assigned to itself
              | changes nothing
            start.pgx:7 `i=i` `i` is assigned to itself
              | changes nothing
        "#]]
        .assert_eq(&check(&RULE, "num n[3]\nnum i\ntrsf t\nn[i] = n[ i ]\nt.x=(t.x)\ni=i"));
    }

    #[test]
    fn other_assignments_are_not_reported() {
        assert_eq!(check(&RULE, "num n[3]\nnum i\ntrsf t\nn[i]=n[i+1]\nt.x=t.y\ni=-i\nn[i]=n[round(clock())]"), "");
    }
}
