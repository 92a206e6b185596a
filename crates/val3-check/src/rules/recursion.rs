//! V0310: programs that call each other in a circle.

use std::collections::VecDeque;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::application::summary;
use val3_analysis::body::{Expr, StmtKind};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program calls itself, directly or through others.
    ///
    /// ## Why
    /// Every call needs stack space of its task for its parameters and locals; the stack has 5000 bytes unless the
    /// project sets another size (2.1.4.2). An intended recursion, in an algorithm, needs an end and a sufficient
    /// stack. Screens and states that call each other have no end: after some hours the task stops. Write them as a
    /// loop with a `switch`.
    ///
    /// ## Bad
    /// ```val3
    /// program menu()
    /// begin
    ///   call settings()
    /// end
    ///
    /// program settings()
    /// begin
    ///   call menu()
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program menu()
    /// begin
    ///   while true
    ///     call settings()
    ///     delay(0.1)
    ///   endWhile
    /// end
    ///
    /// program settings()
    /// begin
    ///   putln("settings")
    /// end
    /// ```
    V0310 "recursion" Info, Member: check
}

/// Reports a circle once, at its alphabetically first program.
fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let circles = &program.application().circles;
    if !circles.contains(program.name()) {
        return;
    }
    for stmt in program.stmts() {
        let StmtKind::Call(call) = stmt.kind else { continue };
        let Expr::Call(callee, _) = program.body.expr(call) else { continue };
        let Expr::Name(name) = program.body.expr(*callee) else { continue };
        if let Some(circle) = circle(program, name) {
            let mut reported = found.report(&RULE, program.range(*callee), word(program.name(), &circle));
            let callees = circle.iter().skip(1).map(SmolStr::as_str).chain([program.name()]);
            for (caller, callee) in circle.iter().zip(callees) {
                let other = program.other(caller);
                let call = other.and_then(|other| Some(other.span(other.first_call_of(callee)?)));
                reported = reported.related_at(call, format!("`{caller}` calls `{callee}` here"));
            }
            return;
        }
    }
}

/// Programs from `first` to the caller of this program, on the shortest way back.
fn circle(program: &ProgramView<'_>, first: &SmolStr) -> Option<Vec<SmolStr>> {
    let start = program.name();
    let mut came_from: FxHashMap<SmolStr, Option<SmolStr>> = FxHashMap::default();
    let mut open = VecDeque::from([(first.clone(), None)]);
    while let Some((name, from)) = open.pop_front() {
        if name == start {
            return Some(way(&came_from, from));
        }
        let is_other = name.as_str() > start && program.application().circles.contains(&name);
        let Some(file) = program.items.programs.get(&name).filter(|_| is_other) else { continue };
        if came_from.contains_key(&name) {
            continue;
        }
        came_from.insert(name.clone(), from);
        let mut calls: Vec<&SmolStr> = summary(program.db, program.project, *file)
            .calls
            .iter()
            .filter_map(|callee| callee.library.is_none().then_some(&callee.program))
            .collect();
        calls.sort_unstable();
        open.extend(calls.into_iter().map(|callee| (callee.clone(), Some(name.clone()))));
    }
    None
}

fn way(came_from: &FxHashMap<SmolStr, Option<SmolStr>>, last: Option<SmolStr>) -> Vec<SmolStr> {
    let step = |name: &SmolStr| came_from.get(name).cloned().flatten();
    let mut way: Vec<SmolStr> = std::iter::successors(last, step).collect();
    way.reverse();
    way
}

fn word(program: &str, circle: &[SmolStr]) -> Wording {
    let help = "for screens and states use a loop with a `switch`; for an algorithm see that it ends, and that the \
                stack of the project (`stackSize`) is large enough";
    if circle.is_empty() {
        return Wording::new(format!("`{program}` calls itself"), "every call needs stack space", help);
    }
    let chain: Vec<String> = circle.iter().map(|name| format!("`{name}`")).chain([format!("`{program}`")]).collect();
    Wording::new(
        format!("`{program}` calls itself through {}", chain.join(" → ")),
        "every call needs stack space",
        help,
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_program_that_calls_itself_is_reported() {
        expect![[r#"
            dig.pgx:9 `dig` `dig` calls itself
              | every call needs stack space
              ? for screens and states use a loop with a `switch`; for an algorithm see that it ends, and that the stack of the project (`stackSize`) is large enough
        "#]].assert_eq(&check(&RULE, "program dig(num x_n)\nbegin\n  if x_n>0\n    call dig(x_n-1)\n  endIf\nend"));
    }

    #[test]
    fn a_circle_of_calls_is_reported() {
        let programs = ["c\nb", "a", "c\nd", "c"].iter().zip(["a", "b", "c", "d"]).map(|(callees, name)| {
            let calls: String = callees.lines().map(|callee| format!("  call {callee}()\n")).collect();
            format!("program {name}()\nbegin\n{calls}end\n")
        });
        expect![[r#"
            a.pgx:6 `b` `a` calls itself through `b` → `a`
              | every call needs stack space
              ? for screens and states use a loop with a `switch`; for an algorithm see that it ends, and that the stack of the project (`stackSize`) is large enough
              > b.pgx:5 `a` `b` calls `a` here
            c.pgx:5 `c` `c` calls itself
              | every call needs stack space
              ? for screens and states use a loop with a `switch`; for an algorithm see that it ends, and that the stack of the project (`stackSize`) is large enough
        "#]].assert_eq(&check(&RULE, &programs.collect::<String>()));
    }

    #[test]
    fn calls_without_a_circle_are_not_reported() {
        let text = "program a()\nbegin\n  call b()\n  call c()\nend\n\nprogram b()\nbegin\n  call c()\nend\n\n\
                    program c()\nbegin\n  taskCreate \"t\",10,c()\nend";
        assert_eq!(check(&RULE, text), "");
    }
}
