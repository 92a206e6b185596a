//! V0326: a latch that is read before it is armed.

use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_lang::instructions::{self, DELAY, GET_LATCH, SET_LATCH};
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// `getLatch` follows `setLatch` without a delay between them.
    ///
    /// ## Why
    /// The latch is armed up to 0.2 ms after `setLatch` (9.2.3). Until then `getLatch` returns the position that was
    /// latched before. A `delay(0)` between the two instructions is long enough.
    ///
    /// ## Bad
    /// ```val3
    /// dio diEdge
    /// joint jEdge
    ///
    /// setLatch(diEdge)
    /// wait(getLatch(jEdge))
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// dio diEdge
    /// joint jEdge
    ///
    /// setLatch(diEdge)
    /// delay(0)
    /// wait(getLatch(jEdge))
    /// ```
    V0326 "latch-without-delay" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    if program.calls_of(SET_LATCH).next().is_none() {
        return;
    }
    for block in program.body.blocks() {
        let mut armed: Option<TextRange> = None;
        for stmt in block {
            let calls = calls(program, stmt);
            let call = |name| calls.iter().find(|(called, _)| *called == name).map(|(_, id)| *id);
            if let (Some(armed), Some(read)) = (armed, call(GET_LATCH)) {
                let edit = program.site(armed).line_after(&format!("{DELAY}(0)"));
                let reported = found.report(&RULE, program.range(read), word()).related(armed, "armed here");
                reported.fix(format!("write `{DELAY}(0)` after `{SET_LATCH}`"), false, [edit]);
            }
            // Any wait, and any block or program that may wait, ends the search.
            let waits = calls.iter().any(|(name, _)| is_blocking(name));
            let is_plain = stmt.blocks().next().is_none() && !matches!(stmt.kind, StmtKind::Call(_));
            armed = call(SET_LATCH).map(|_| stmt.range).or(armed.filter(|_| is_plain && !waits));
        }
    }
}

/// Instructions that a statement calls, in evaluation order as far as the search needs it.
fn calls<'p>(program: &'p ProgramView<'_>, stmt: &Stmt) -> Vec<(&'p str, ExprId)> {
    let parts = stmt.kind.exprs().into_iter().flat_map(|id| program.body.within(id));
    let calls = parts.filter_map(|id| {
        let Expr::Call(callee, _) = program.body.expr(id) else { return None };
        let Expr::Name(name) = program.body.expr(*callee) else { return None };
        Some((name.as_str(), id))
    });
    calls.collect()
}

fn is_blocking(name: &str) -> bool {
    instructions::find(name).is_some_and(|instruction| instruction.blocking)
}

fn word() -> Wording {
    Wording::new(
        "the latch is read before it can be armed",
        "may still return the previously latched position",
        format!("write `{DELAY}(0)` after `{SET_LATCH}`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn an_input_read_at_once_is_reported() {
        expect![[r#"
            start.pgx:6 `getLatch(j)` the latch is read before it can be armed
              | may still return the previously latched position
              ? write `delay(0)` after `setLatch`
              > start.pgx:5 `setLatch(d)` armed here
              ! write `delay(0)` after `setLatch` (unsafe)
            start.pgx:9 `getLatch(j)` the latch is read before it can be armed
              | may still return the previously latched position
              ? write `delay(0)` after `setLatch`
              > start.pgx:7 `setLatch(d)` armed here
              ! write `delay(0)` after `setLatch` (unsafe)
        "#]]
        .assert_eq(&check(
            &RULE,
            "dio d\njoint j\nbool b\nsetLatch(d)\nb=watch(getLatch(j)==true,5)\nsetLatch(d)\nputln(\"armed\")\n\
             while !getLatch(j)\ndelay(0)\nendWhile",
        ));
    }

    #[test]
    fn an_input_read_later_is_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "dio d\njoint j\nbool b\nb=getLatch(j)\nsetLatch(d)\ndelay(0)\nb=getLatch(j)\nsetLatch(d)\ncall p()\n\
                 b=getLatch(j)\nprogram p()\nbegin\nend"
            ),
            ""
        );
    }
}
