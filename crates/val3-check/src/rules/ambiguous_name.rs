//! V0123: a variable with the name of a program or a library identifier.

use val3_analysis::db::{Db, File, FileRange};
use val3_analysis::items::declarations::{self, Declared, all_locals, all_params};
use val3_analysis::items::shared_names::shared_names;

use crate::diagnostic::{MOST_RELATED, Wording};
use crate::english::count;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A local variable or a parameter has the name of a program or of a library identifier of the project.
    ///
    /// ## Why
    /// VAL 3 distinguishes them by their position in the line, but readers confuse them: `pick=true` looks like an
    /// action of the program `pick`. Each name is reported once, in the first program that has such a variable.
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
    V0123 "ambiguous-name" Info, Member: check
}

/// Reports each name once, in the first program of the project that declares it.
fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let shared = shared_names(program.db, program.project);
    if shared.is_empty() {
        return;
    }
    let variables = variables(program.db, program.file);
    for (what, Declared { name, range, .. }) in variables {
        let (Some(other), Some([first, rest @ ..])) = (other_use(program, &name), shared.get(&name).map(Vec::as_slice))
        else {
            continue;
        };
        if *first != program.file {
            continue;
        }
        let place = match program.items.programs.get(&name) {
            Some(file) => declarations::program(program.db, *file),
            None => declarations::library(program.db, program.project, name.clone()),
        };
        let mut reported =
            found.report(&RULE, range, word(what, &name, other, rest.len())).related_at(place, "declared here");
        for file in rest.iter().take(MOST_RELATED) {
            reported = reported.related_at(variable(program.db, *file, &name), "a variable here too");
        }
    }
}

/// Parameters and locals of a program file.
fn variables(db: &dyn Db, file: File) -> impl Iterator<Item = (&'static str, Declared)> {
    let params = all_params(db, file).into_iter().map(|declared| ("parameter", declared));
    params.chain(all_locals(db, file).into_iter().map(|declared| ("local variable", declared)))
}

fn variable(db: &dyn Db, file: File, name: &str) -> Option<FileRange> {
    let (_, found) = variables(db, file).find(|(_, declared)| declared.name == name)?;
    Some(FileRange { file, range: found.range })
}

fn other_use(program: &ProgramView<'_>, name: &str) -> Option<&'static str> {
    if program.items.programs.contains_key(name) {
        Some("a program")
    } else {
        program.items.libraries.contains_key(name).then_some("a library identifier")
    }
}

fn word(what: &str, name: &str, other: &str, programs: usize) -> Wording {
    let more = if programs > 0 { format!(" and in {}", count(programs, "other program")) } else { String::new() };
    Wording::new(
        format!("`{name}` is a {what} here{more}, and also {other} of the project"),
        format!("also {other}"),
        "rename it",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_data_item_may_not_share_its_name_with_a_program_or_library() {
        let listing =
            "library part \"Disk://part/part.pjx\"\nprogram p(num p)\n  num part\nbegin\nend\n--- part\npublic num nW";
        expect![[r#"
            p.pgx:5 `p` `p` is a parameter here, and also a program of the project
              | also a program
              ? rename it
              > p.pgx:3 `p` declared here
            p.pgx:8 `part` `part` is a local variable here, and also a library identifier of the project
              | also a library identifier
              ? rename it
              > main.pjx:11 `part` declared here
        "#]]
        .assert_eq(&check(&RULE, listing));
    }

    #[test]
    fn each_name_is_reported_once() {
        let listing =
            "program p(num p)\nbegin\nend\nprogram q()\n  num p\nbegin\nend\nprogram r(num q, bool p)\nbegin\nend";
        expect![[r#"
            p.pgx:5 `p` `p` is a parameter here and in 2 other programs, and also a program of the project
              | also a program
              ? rename it
              > p.pgx:3 `p` declared here
              > q.pgx:5 `p` a variable here too
              > r.pgx:6 `p` a variable here too
            r.pgx:5 `q` `q` is a parameter here, and also a program of the project
              | also a program
              ? rename it
              > q.pgx:3 `q` declared here
        "#]]
        .assert_eq(&check(&RULE, listing));
    }

    #[test]
    fn different_names_are_not_reported() {
        assert_eq!(check(&RULE, "program p(num x_p)\n  num P\nbegin\nend"), "");
    }
}
