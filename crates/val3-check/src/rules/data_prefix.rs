//! V0710: global data whose name does not begin with the configured prefix.

use val3_analysis::items::declarations::{Declared, all_data};

use crate::lint::{DataFile, Findings, naming};
use crate::rule::rule;

rule! {
    /// The name of global data does not begin with the prefix of its type.
    ///
    /// ## Why
    /// If names show the type (`nCount`, `pPick`, `bReady`), a line of code can be read without its declarations. The
    /// option `prefixes` sets the letters by type; the name of data of a type without an entry is not checked. A user
    /// type has an entry under its own name. The rule is off by default, because it enforces a convention that not
    /// every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// num count
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// ```
    V0710 "data-prefix" Info off, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let view = &data.view;
    for Declared { name, range, .. } in all_data(view.db, data.file) {
        let item = view.items.data.get(&name).filter(|_| val3_lang::builtins::find(&name).is_none());
        let Some(ty) = item.map(|item| naming::type_name(view.db, item.base)) else { continue };
        if let Some(wording) = naming::check_name(view.options, "data", &ty, "", &name) {
            found.report(&RULE, range, wording);
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn the_prefix_depends_on_the_type() {
        expect![[r#"
            main.dtx:4 `count` the name of the data `count` does not begin with `n`
              | this is a `num`
              ? call it `nCount`
            main.dtx:5 `nReady` the name of the data `nReady` does not begin with `b`
              | this is a `bool`
              ? call it `bReady`
            main.dtx:6 `tOffset` the name of the data `tOffset` does not begin with `tr`
              | this is a `trsf`
              ? call it `trOffset`
        "#]]
        .assert_eq(&check(&RULE, "num count\nbool nReady\ntrsf tOffset\njoint j"));
        assert_eq!(check(&RULE, "num nCount\nbool bReady\ntrsf trOffset\njoint jHome\nnum n2"), "");
    }

    #[test]
    fn letters_within_a_word_are_not_a_prefix() {
        assert!(!check(&RULE, "num number").is_empty());
        assert!(!check(&RULE, "dio door").is_empty());
    }

    #[test]
    fn the_prefixes_can_be_configured() {
        let settings = "=== val3.toml\n[lint]\nprefixes = { num = \"r\", Slot = \"sl\" }";
        assert_eq!(check(&RULE, &format!("num rCount\nbool ready\n{settings}")), "");
        let slot = "type Slot \"Disk://Slot/Slot.pjx\"\nprivate Slot first\n--- Slot\npublic num rA";
        assert!(!check(&RULE, &format!("{slot}\n{settings}")).is_empty());
    }
}
