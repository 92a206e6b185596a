//! V0513: two values under one key.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A data file contains two values for the same element.
    ///
    /// ## Why
    /// Each element of an array and each key of a collection has one value. The controller rejects a second value for
    /// the same key. It often comes from a merge in which both sides changed the value.
    ///
    /// ## Bad
    /// ```val3
    /// nCount=nCount+1
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="private" xsi:type="array" type="num" size="1">
    ///       <Value key="0" value="3" />
    ///       <Value key="0" value="4" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// nCount=nCount+1
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="private" xsi:type="array" type="num" size="1">
    ///       <Value key="0" value="4" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0513 "duplicate-key" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(key: &str) -> Wording {
    Wording::new(format!("the key `{key}` has two values"), "the second value", "keep one of the two")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_key_is_named() {
        expect![[r#"
            the key `0` has two values
            | the second value
            ? keep one of the two
        "#]]
        .assert_eq(&word("0").to_string());
    }
}
