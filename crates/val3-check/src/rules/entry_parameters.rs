//! V0329: `start` or `stop` with parameters.

use val3_analysis::application::ENTRY_POINTS;

use crate::diagnostic::Wording;
use crate::english::count;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The program `start` or `stop` of an application has parameters.
    ///
    /// ## Why
    /// The controller calls these programs itself, when the application starts and stops, and passes no arguments. They
    /// cannot have parameters (5.2).
    ///
    /// ## Bad
    /// ```val3
    /// program start(num x_nSpeed)
    /// begin
    ///   put(x_nSpeed)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nSpeed = 50
    ///
    /// program start()
    /// begin
    ///   put(nSpeed)
    /// end
    /// ```
    V0329 "entry-parameters" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let (name, params) = (program.name(), program.header.params.len());
    if ENTRY_POINTS.contains(&name) && params > 0 {
        found.report(&RULE, program.head(), word(name, params));
    }
}

fn word(name: &str, params: usize) -> Wording {
    Wording::new(
        format!("`{name}` has {}, but the controller calls it without any", count(params, "parameter")),
        "called by the controller",
        "use global variables",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::{check, levels};
    use crate::rule::Severity;

    #[test]
    fn start_and_stop_with_parameters_are_reported() {
        expect![[r#"
            stop.pgx:3 `stop` `stop` has 2 parameters, but the controller calls it without any
              | called by the controller
              ? use global variables
        "#]]
        .assert_eq(&check(&RULE, "program stop(num x_n, bool& x_b)\nbegin\nx_b=x_n==1\nend"));
    }

    #[test]
    fn both_entry_points_are_errors() {
        let listing = "program start(num x_n)\nbegin\nput(x_n)\nend\nprogram stop(num x_n)\nbegin\nput(x_n)\nend";
        assert_eq!(levels(&RULE, listing), [Severity::Error; 2]);
    }

    #[test]
    fn other_programs_may_have_parameters() {
        assert_eq!(
            check(&RULE, "program start()\nbegin\ncall begins(1)\nend\nprogram begins(num x_n)\nbegin\nput(x_n)\nend"),
            ""
        );
    }
}
