//! V0721: two constants of a group with the same value.

use std::collections::BTreeMap;

use smol_str::SmolStr;
use val3_analysis::items::data::single_numbers;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{DataFile, Findings};
use crate::rule::rule;

rule! {
    /// Two numbers of a group of named constants have the same value.
    ///
    /// ## Why
    /// `nState_IDLE`, `nState_RUN` and similar names mean different things, so their values should differ. Two equal
    /// values often come from a copied line. A group is three or more numbers whose names share their first word, which
    /// no program writes, and of which all but a pair or two differ. The rule is off by default, because it enforces a
    /// convention that not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// public num nStateIdle = 1
    /// public num nStateRun = 2
    /// public num nStateStop = 3
    /// public num nStateFault = 3
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// public num nStateIdle = 1
    /// public num nStateRun = 2
    /// public num nStateStop = 3
    /// public num nStateFault = 4
    /// ```
    V0721 "duplicate-constant" Info off, Data: check
}

/// A constant: its name, its value and its name's location.
type Constant = (SmolStr, f64, TextRange);

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let application = data.view.application();
    let mut groups: BTreeMap<SmolStr, Vec<Constant>> = BTreeMap::new();
    for constant in single_numbers(data.view.db, data.file) {
        let is_constant = constant.1.fract() == 0.0 && !application.uses_of(&constant.0).may_write();
        if let Some(group) = group(&constant.0).filter(|_| is_constant) {
            groups.entry(group.into()).or_default().push(constant);
        }
    }
    for group in groups.values() {
        for (first, second) in duplicates(group) {
            found.report(&RULE, second.2, word(second, first)).related(first.2, "the first one");
        }
    }
}

/// Letters of the type and the first word: `nState` in `nStateIdle` and `nState_IDLE`.
fn group(name: &str) -> Option<&str> {
    let first = name.find(|c: char| c.is_ascii_uppercase())?;
    let rest = name.get(first + 1..)?;
    let end = first + 1 + rest.find(|c: char| c.is_ascii_uppercase() || c == '_')?;
    name.get(..end).filter(|group| group.len() < name.len() && group.len() > 2)
}

/// Repeated values, each with the first constant that has it. Empty if only a few of the values differ.
fn duplicates(group: &[Constant]) -> Vec<(&Constant, &Constant)> {
    let mut pairs = Vec::new();
    for (at, second) in group.iter().enumerate() {
        let before = group.iter().take(at);
        pairs.extend(before.into_iter().find(|first| first.1 == second.1).map(|first| (first, second)));
    }
    let differ = group.len() - pairs.len();
    if differ >= 2 && pairs.len() <= 2 && pairs.len() * 2 <= differ { pairs } else { Vec::new() }
}

fn word(second: &Constant, first: &Constant) -> Wording {
    Wording::new(
        format!("`{}` has the same value as `{}`", second.0, first.0),
        format!("{} again", second.1),
        "use a different value",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn group_of(values: &[u8]) -> String {
        let data = values.iter().enumerate().map(|(at, value)| format!("public num nState_{at} = {value}\n"));
        check(&RULE, &data.collect::<String>())
    }

    #[test]
    fn one_value_with_two_names_is_reported() {
        expect![[r#"
            main.dtx:13 `nState_3` `nState_3` has the same value as `nState_1`
              | 2 again
              ? use a different value
              > main.dtx:7 `nState_1` the first one
        "#]]
        .assert_eq(&group_of(&[1, 2, 3, 2]));
    }

    #[test]
    fn different_values_are_not_reported() {
        assert_eq!(group_of(&[1, 2, 3, 4]), "");
    }

    #[test]
    fn unrelated_values_public_data_and_variables_are_not_reported() {
        assert_eq!(group_of(&[0, 0, 0, 1]), "");
        assert_eq!(group_of(&[1, 1]), "");
        assert_eq!(check(&RULE, "public num nA = 1\npublic num nB = 2\npublic num nC = 1"), "");
        let written = "num nStA = 1\nnum nStB = 2\nnum nStC = 1\nprogram start()\nbegin\n  nStC=2\nend";
        assert_eq!(check(&RULE, written), "");
    }

    #[test]
    fn the_group_of_a_name_is_its_first_word() {
        assert_eq!(group("nStateIdle"), Some("nState"));
        assert_eq!(group("nState_IDLE"), Some("nState"));
        assert_eq!(group("nState"), None);
        assert_eq!(group("count"), None);
    }
}
