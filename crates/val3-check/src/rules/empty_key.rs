//! V0244: an empty key of a collection.

use rustc_hash::FxHashSet;
use val3_analysis::body::{Expr, ExprId};
use val3_lang::instructions::takes_any_key;
use val3_lang::types::Container;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A collection is used with an empty string as the key.
    ///
    /// ## Why
    /// A key can be any text except the empty one (2.5.1). No value has an empty key, and none can be inserted with it.
    /// The line stops its task whenever it runs. `isDefined`, `next` and `prev` accept any text.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount["bolt"]
    ///
    /// nCount[""]=1
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount["bolt"]
    ///
    /// nCount["bolt"]=1
    /// ```
    V0244 "empty-key" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let calls = program.calls().iter().filter(|call| takes_any_key(call.instruction.name));
    let free: FxHashSet<ExprId> = calls.flat_map(|call| call.args.iter().copied()).collect();
    for (id, expr, _) in program.body.exprs() {
        let Expr::Index(base, keys) = expr else { continue };
        let is_collection = program.inference.ty(*base).container == Container::Collection;
        if let [key] = **keys
            && is_collection
            && !free.contains(&id)
            && program.body.string(key).is_some_and(|key| key.is_empty())
        {
            found.report(&RULE, program.range(key), word(program.text(*base)));
        }
    }
}

fn word(collection: &str) -> Wording {
    Wording::new(format!("`{collection}` has no value with an empty key"), "run-time error", "a key is never empty")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn an_empty_key_is_reported() {
        expect![[r#"
            start.pgx:5 `""` `nC` has no value with an empty key
              | run-time error
              ? a key is never empty
            start.pgx:6 `""` `nC` has no value with an empty key
              | run-time error
              ? a key is never empty
            start.pgx:7 `""+""` `nC` has no value with an empty key
              | run-time error
              ? a key is never empty
        "#]]
        .assert_eq(&check(&RULE, "num nC[\"\"]\nnum nA\nnA=nC[\"\"]\nnC[\"\"]=1\ninsert(nC[\"\"+\"\"])"));
    }

    #[test]
    fn other_keys_and_questions_about_keys_are_not_reported() {
        let code = "if isDefined(nC[\"\"])\nputln(next(nC[\"\"]))\nputln(prev(nC[\"\"]))\nendIf\nnC[s]=1\nnC[\" \"]=1";
        assert_eq!(check(&RULE, &format!("num nC[\"\"]\nstring s\n{code}")), "");
    }
}
