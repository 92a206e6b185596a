//! V0123: a variable that is called like a program or a library identifier.

use val3_analysis::items::declarations::{self, Declared, all_locals, all_params};

use crate::diagnostic::Wording;
use crate::lint::{Findings, Program, span_of};
use crate::rule::rule;

rule! {
    /// A local variable or a parameter has the name of a program or of a library identifier of the project.
    ///
    /// ## Why
    /// VAL 3 tells them apart by where they stand, people do not: `pick=true` looks like something done to the program
    /// `pick`.
    ///
    /// ## Bad
    /// ```val3
    /// call report("ready")
    ///
    /// program report(string report)
    /// begin
    ///   putln(report)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// call report("ready")
    ///
    /// program report(string x_sReport)
    /// begin
    ///   putln(x_sReport)
    /// end
    /// ```
    V0123 "ambiguous-name" Info, Program: check
}

fn check(program: &Program<'_>, found: &mut Findings) {
    let header = program.header;
    if header.locals.iter().any(|local| other_use(program, &local.name).is_some()) {
        report(program, found, "local variable", all_locals(program.db, program.file));
    }
    if header.params.iter().any(|param| other_use(program, &param.name).is_some()) {
        report(program, found, "parameter", all_params(program.db, program.file));
    }
}

fn report(program: &Program<'_>, found: &mut Findings, what: &str, names: Vec<Declared>) {
    for Declared { name, range, .. } in names {
        if let Some(other) = other_use(program, &name) {
            let reported = found.report(&RULE, range, word(what, &name, other));
            let place = match program.items.programs.get(&name) {
                Some(file) => declarations::program(program.db, *file),
                None => declarations::library(program.db, program.project, name),
            };
            reported.related_at(place.map(span_of), "declared here");
        }
    }
}

fn other_use(program: &Program<'_>, name: &str) -> Option<&'static str> {
    if program.items.programs.contains_key(name) {
        Some("a program")
    } else {
        program.items.libraries.contains_key(name).then_some("a library identifier")
    }
}

fn word(what: &str, name: &str, other: &str) -> Wording {
    Wording::new(
        format!("`{name}` is a {what} here and also {other} of the project"),
        format!("also {other}"),
        "give it another name",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn programs_and_libraries() {
        let listing =
            "library part \"Disk://part/part.pjx\"\nprogram p(num p)\n  num part\nbegin\nend\n--- part\npublic num nW";
        expect![[r#"
            p.pgx:5 `p` `p` is a parameter here and also a program of the project
              | also a program
              ? give it another name
              > p.pgx:3 `p` declared here
            p.pgx:8 `part` `part` is a local variable here and also a library identifier of the project
              | also a library identifier
              ? give it another name
              > main.pjx:11 `part` declared here
        "#]]
        .assert_eq(&check(&RULE, listing));
    }

    #[test]
    fn other_names() {
        assert_eq!(check(&RULE, "program p(num x_p)\n  num P\nbegin\nend"), "");
    }
}
