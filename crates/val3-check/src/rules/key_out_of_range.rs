//! V0512: a key outside the size of the array.

use crate::{diagnostic::Wording, phrase::last_key, rule::rule};

rule! {
    /// A data file contains a value for an element that the array does not have.
    ///
    /// ## Why
    /// The `size` of an array is the number of elements. Keys count from 0, so the last key is the size less 1. The
    /// controller reports data with a key beyond it as faulty when it loads the application.
    ///
    /// ## Bad
    /// ```val3
    /// sName[1]="bag"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="sName" access="private" xsi:type="array" type="string" size="2">
    ///       <Value key="2" value="box" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// sName[1]="bag"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="sName" access="private" xsi:type="array" type="string" size="2">
    ///       <Value key="1" value="box" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0512 "key-out-of-range" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(key: &str, size: &str) -> Wording {
    Wording::new(
        format!("the key `{key}` is outside the array of size `{size}`"),
        last_key(size).map(|last| format!("the last key is `{last}`")).unwrap_or_default(),
        "keys count from 0; correct the key or enlarge the size",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_names_the_size_of_an_array() {
        expect![[r#"
            the key `2` is outside the array of size `2`
            | the last key is `1`
            ? keys count from 0; correct the key or enlarge the size
        "#]]
        .assert_eq(&word("2", "2").to_string());
    }

    #[test]
    fn the_message_names_both_dimensions() {
        expect![[r#"
            the key `3,0` is outside the array of size `3 4`
            | the last key is `2,3`
            ? keys count from 0; correct the key or enlarge the size
        "#]]
        .assert_eq(&word("3,0", "3 4").to_string());
    }
}
