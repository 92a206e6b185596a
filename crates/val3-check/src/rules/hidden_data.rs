//! V0121: a local variable or parameter that hides global data.

use smol_str::SmolStr;
use val3_analysis::items::declarations::{self, Declared, all_locals, all_params};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A local variable or a parameter has the name of global data.
    ///
    /// ## Why
    /// Within the program the name means the local variable. The program cannot access the global data, and readers
    /// confuse the two. Names with a distinct prefix (`l_` for locals, `x_` for parameters) cannot hide data.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// program start()
    ///   num nCount
    /// begin
    ///   nCount=len("ready")
    ///   putln(nCount)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// program start()
    ///   num l_nCount
    /// begin
    ///   l_nCount=len("ready")
    ///   nCount=l_nCount
    /// end
    /// ```
    V0121 "hidden-data" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let data = &program.items.data;
    let hides = |name: &SmolStr| data.contains_key(name);
    if program.header.locals.iter().any(|local| hides(&local.name)) {
        report(program, found, "local variable", all_locals(program.db, program.file));
    }
    if program.header.params.iter().any(|param| hides(&param.name)) {
        report(program, found, "parameter", all_params(program.db, program.file));
    }
}

fn report(program: &ProgramView<'_>, found: &mut Findings, what: &str, names: Vec<Declared>) {
    for Declared { name, range, .. } in names {
        let Some(item) = program.items.data.get(&name) else { continue };
        let reported = found.report(&RULE, range, word(what, &name));
        if let Some(place) = declarations::data(program.db, item.file, name) {
            reported.related_in(place, "the global data");
        }
    }
}

fn word(what: &str, name: &str) -> Wording {
    Wording::new(
        format!("the {what} `{name}` hides the global data of the same name"),
        "hides global data",
        "rename it",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn locals_and_parameters_that_hide_data_are_reported() {
        expect![[r#"
            p.pgx:5 `bB` the parameter `bB` hides the global data of the same name
              | hides global data
              ? rename it
              > main.dtx:5 `bB` the global data
            p.pgx:8 `nA` the local variable `nA` hides the global data of the same name
              | hides global data
              ? rename it
              > main.dtx:4 `nA` the global data
        "#]]
        .assert_eq(&check(&RULE, "num nA\nbool bB\nprogram p(bool bB)\n  string nA\nbegin\nend"));
    }

    #[test]
    fn different_names_are_not_reported() {
        assert_eq!(check(&RULE, "num nA\nprogram p(num na)\n  string l_nA\nbegin\nend"), "");
    }
}
