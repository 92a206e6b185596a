//! V0506: an attribute with an invalid value.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// The value of an attribute is not one of its possible values.
    ///
    /// ## Why
    /// Most attributes of project, data and program files have a few possible values (`public` or `private`, `true` or
    /// `false`) or a fixed form (a whole number). With any other value the file is faulty and the application does not
    /// load.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="global" xsi:type="array" type="num" size="1" />
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="public" xsi:type="array" type="num" size="1" />
    ///   </Datas>
    /// </Database>
    /// ```
    V0506 "invalid-attribute" Error
}

/// Returns the wording of the finding. `expected` is read after "must be".
pub(crate) fn word(element: &str, attribute: &str, value: &str, expected: &str) -> Wording {
    Wording::new(
        format!("the attribute `{attribute}` of `{element}` is `{value}`, but must be {expected}"),
        format!("must be {expected}"),
        "",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_possible_values_are_named() {
        expect![[r#"
            the attribute `access` of `Data` is `global`, but must be `public` or `private`
            | must be `public` or `private`
        "#]]
        .assert_eq(&word("Data", "access", "global", "`public` or `private`").to_string());
    }
}
