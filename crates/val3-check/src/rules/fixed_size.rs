//! V0235: an instruction that cannot change the size of this array.

use val3_analysis::body::Expr;
use val3_analysis::effects::RootVariable;
use val3_lang::instruction::CallClass;
use val3_lang::instructions::{resizes, resizes_collections, resizes_every_array};
use val3_lang::types::Container;

use crate::diagnostic::Wording;
use crate::lint::{Call, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// An instruction that changes an array's size receives a variable that it does not support.
    ///
    /// ## Why
    /// `insert`, `delete`, `append` and `resize` do not support local variables, and the first three do not support
    /// arrays of two or three dimensions (2.5.4, 2.5.5). A parameter that is no array or collection is a single value
    /// (2.6.2). Use a global array, and `resize` for an array of several dimensions.
    /// `append` and `resize` do not support collections, whose values have keys; use `insert` and `delete`. Otherwise
    /// the line raises run-time error 70.
    ///
    /// ## Bad
    /// ```val3
    /// program fill()
    ///   num l_nTimes[4]
    /// begin
    ///   append(l_nTimes)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nTimes[4]
    ///
    /// append(nTimes)
    /// nTimes[4]=1
    /// ```
    V0235 "fixed-size" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls() {
        let name = call.instruction.name;
        let acts = call.form.is_some_and(|form| form.class == CallClass::Modifier);
        if let Some(wording) = acts.then(|| fault(program, name, *call)).flatten() {
            found.report(&RULE, program.range(call.id), wording);
        }
    }
}

fn fault(program: &ProgramView<'_>, instruction: &str, call: Call<'_>) -> Option<Wording> {
    let argument = *call.args.first().filter(|_| resizes(instruction))?;
    let array = match program.body.expr(argument) {
        Expr::Index(base, _) => *base,
        _ => argument,
    };
    let text = program.text(array);
    let is_whole = matches!(program.body.expr(array), Expr::Name(_));
    let root = program.effects.root(array).filter(|_| is_whole);
    match (program.inference.ty(array).container, root) {
        (Container::Element, Some(RootVariable::Local(_))) => Some(local_value(instruction, text)),
        (Container::Element, Some(RootVariable::Param(_))) => Some(single_parameter(instruction, text)),
        (Container::Array { .. }, Some(RootVariable::Local(_))) => Some(local(instruction, text)),
        (Container::Array { dims: dims @ 2.. }, _) if !resizes_every_array(instruction) => {
            Some(several_dimensions(instruction, text, dims))
        }
        (Container::Collection, _) if !resizes_collections(instruction) => Some(collection(instruction, text)),
        _ => None,
    }
}

fn local(instruction: &str, array: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` does not support the local array `{array}`"),
        "the size of a local array is fixed",
        "use a global array, or declare the local one large enough",
    )
}

fn local_value(instruction: &str, variable: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` does not support the local variable `{variable}`"),
        "a local variable keeps its single value",
        "use a global array, or declare a local array that is large enough",
    )
}

fn single_parameter(instruction: &str, parameter: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` does not support the parameter `{parameter}`, which is a single value"),
        "not an array",
        "declare the parameter as an array",
    )
}

fn collection(instruction: &str, collection: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` does not support the collection `{collection}`"),
        "an array is needed",
        format!("`insert({collection}[…])` adds a value under a key, and `delete` removes it"),
    )
}

fn several_dimensions(instruction: &str, array: &str, dims: u8) -> Wording {
    Wording::new(
        format!("`{instruction}` does not support `{array}`, an array of {dims} dimensions"),
        "one dimension only",
        "use `resize`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::{check, levels};
    use crate::rule::Severity;

    #[test]
    fn resizing_an_array_of_a_fixed_size_is_reported() {
        expect![[r#"
            p.pgx:8 `append(l_n)` `append` does not support the local array `l_n`
              | the size of a local array is fixed
              ? use a global array, or declare the local one large enough
            p.pgx:9 `resize(l_n,1,4)` `resize` does not support the local array `l_n`
              | the size of a local array is fixed
              ? use a global array, or declare the local one large enough
            p.pgx:10 `insert(l_n[0])` `insert` does not support the local array `l_n`
              | the size of a local array is fixed
              ? use a global array, or declare the local one large enough
            p.pgx:11 `delete(l_n[0])` `delete` does not support the local array `l_n`
              | the size of a local array is fixed
              ? use a global array, or declare the local one large enough
            p.pgx:12 `append(nGrid)` `append` does not support `nGrid`, an array of 2 dimensions
              | one dimension only
              ? use `resize`
        "#]]
        .assert_eq(&check(
            &RULE,
            "num nGrid[2,3]\nprogram p()\nnum l_n[2]\nbegin\nappend(l_n)\nresize(l_n,1,4)\ninsert(l_n[0])\n\
             delete(l_n[0])\nappend(nGrid)\nend",
        ));
    }

    #[test]
    fn locals_and_grids_are_errors() {
        let listing = "num nGrid[2,3]\nprogram p()\nnum l_n[2]\nbegin\nappend(l_n)\nappend(nGrid)\nend";
        assert_eq!(levels(&RULE, listing), [Severity::Error; 2]);
    }

    /// A variable with a single value is an array of one element (2.3.4).
    #[test]
    fn resizing_a_local_variable_is_reported() {
        expect![[r#"
            p.pgx:9 `append(l_n)` `append` does not support the local variable `l_n`
              | a local variable keeps its single value
              ? use a global array, or declare a local array that is large enough
            p.pgx:10 `delete(l_n[0])` `delete` does not support the local variable `l_n`
              | a local variable keeps its single value
              ? use a global array, or declare a local array that is large enough
        "#]]
        .assert_eq(&check(
            &RULE,
            "num nCount\nprogram p()\nnum l_n\nstring l_s\nbegin\nappend(l_n)\ndelete(l_n[0])\n\
             l_s=delete(l_s,1,1)\nappend(nCount)\nend",
        ));
    }

    /// A parameter that is taken as an element is a single value, whatever the call passes (2.6.2).
    #[test]
    fn resizing_a_parameter_with_a_single_value_is_reported() {
        expect![[r#"
            p.pgx:9 `append(x_n)` `append` does not support the parameter `x_n`, which is a single value
              | not an array
              ? declare the parameter as an array
        "#]]
        .assert_eq(&check(&RULE, "program p(num& x_n,num& x_nAll[])\nbegin\nappend(x_n)\nappend(x_nAll)\nend"));
    }

    #[test]
    fn append_and_resize_of_a_collection_are_reported() {
        expect![[r#"
            start.pgx:5 `append(nC)` `append` does not support the collection `nC`
              | an array is needed
              ? `insert(nC[…])` adds a value under a key, and `delete` removes it
            start.pgx:6 `resize(nC,1,4)` `resize` does not support the collection `nC`
              | an array is needed
              ? `insert(nC[…])` adds a value under a key, and `delete` removes it
        "#]]
        .assert_eq(&check(&RULE, "num nC[\"\"]\nappend(nC)\nresize(nC,1,4)\ninsert(nC[\"a\"])\ndelete(nC[\"a\"])"));
    }

    #[test]
    fn containers_that_can_grow_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "num nGrid[2,3]\nnum nA[2]\nnum nC[\"\"]\nstring s\nappend(nA)\nresize(nGrid,2,4)\ninsert(nC[s])\ns=delete(s,1,1)"
            ),
            ""
        );
    }
}
