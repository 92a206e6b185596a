//! V0711: a local variable or parameter without the configured prefix.

use smol_str::SmolStr;
use val3_analysis::items::declarations::{Declared, all_locals, all_params};
use val3_analysis::items::project::resolve_type;
use val3_lang::types::BaseType;

use crate::lint::{Findings, ProgramView, naming};
use crate::rule::rule;

rule! {
    /// The name of a local variable or of a parameter does not begin with the prefix of its scope and its type.
    ///
    /// ## Why
    /// `l_` and `x_` show at a glance whether a line changes a variable of the program, a parameter, or global data.
    /// The options `local-prefix`, `parameter-prefix` and `prefixes` set the letters. Counters of one or two letters
    /// (`l_i`, `i`) are not reported. The rule is off by default, because it enforces a convention that not every shop
    /// has.
    ///
    /// ## Bad
    /// ```val3
    /// program show(num nValue)
    /// begin
    ///   putln(nValue)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program show(num x_nValue)
    /// begin
    ///   putln(x_nValue)
    /// end
    /// ```
    V0711 "variable-prefix" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let ProgramView { db, file, header, options, .. } = program;
    let locals = header.locals.iter().map(|local| &local.type_name);
    let locals = all_locals(*db, *file).into_iter().zip(locals);
    report(program, "local variable", &options.local_prefix, locals, found);
    let params = header.params.iter().map(|param| &param.type_name);
    let params = all_params(*db, *file).into_iter().zip(params);
    report(program, "parameter", &options.parameter_prefix, params, found);
}

/// Reports the names without the prefix of their type after the prefix of their `scope`.
fn report<'p>(
    program: &ProgramView<'_>,
    what: &str,
    scope: &str,
    names: impl Iterator<Item = (Declared, &'p SmolStr)>,
    found: &mut Findings,
) {
    for (Declared { name, range, .. }, ty) in names {
        let Some(base) = resolve_type(&program.items.types, ty) else { continue };
        let ty = naming::type_name(program.db, base);
        let is_counter = ty == BaseType::Num.name() && is_short(name.strip_prefix(scope).unwrap_or(&name));
        if let Some(wording) = naming::check_name(program.options, what, &ty, scope, &name).filter(|_| !is_counter) {
            found.report(&RULE, range, wording);
        }
    }
}

/// Whether the name is short, for example `i` or `k2`: one or two characters without a capital.
fn is_short(name: &str) -> bool {
    name.len() <= 2 && !name.bytes().any(|byte| byte.is_ascii_uppercase())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn the_prefix_has_scope_and_type() {
        expect![[r#"
            p.pgx:5 `nA` the name of the parameter `nA` does not begin with `x_n`
              | this is a `num`
              ? call it `x_nA`
            p.pgx:6 `x_A` the name of the parameter `x_A` does not begin with `x_b`
              | this is a `bool`
              ? call it `x_bA`
            p.pgx:9 `sA` the name of the local variable `sA` does not begin with `l_s`
              | this is a `string`
              ? call it `l_sA`
        "#]]
        .assert_eq(&check(&RULE, "program p(num nA, bool x_A)\n  string sA\nbegin\nend"));
    }

    #[test]
    fn correct_names_and_counters_are_not_reported() {
        assert_eq!(check(&RULE, "program p(num x_nA, bool& x_bA)\n  string l_sA\n  num l_i\n  num i\nbegin\nend"), "");
    }

    #[test]
    fn the_prefixes_can_be_configured() {
        let settings = "=== val3.toml\n[lint]\nlocal-prefix = \"l\"\nparameter-prefix = \"\"";
        let listing = format!("program p(num nA)\n  string lsA\nbegin\nend\n{settings}");
        assert_eq!(check(&RULE, &listing), "");
    }
}
