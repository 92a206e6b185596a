//! V0505: an element without an attribute that it needs.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// An element lacks an attribute that it cannot do without.
    ///
    /// ## Why
    /// The attributes say what an element declares: without `name` a variable has no name, without `file` an entry
    /// of the project leads nowhere. The controller reports the file as faulty and does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="private" xsi:type="array" size="1" />
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
    ///     <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
    ///   </Datas>
    /// </Database>
    /// ```
    V0505 "missing-attribute" Error
}

/// Words the finding.
pub(crate) fn word(element: &str, attribute: &str) -> Wording {
    Wording::new(
        format!("the element `{element}` needs the attribute `{attribute}`"),
        format!("`{attribute}` is missing"),
        "",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_attribute_is_named() {
        expect![[r#"
            the element `Data` needs the attribute `type`
            | `type` is missing
        "#]]
        .assert_eq(&word("Data", "type").to_string());
    }
}
