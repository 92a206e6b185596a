//! V0516: a value whose type differs from its field.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A data file contains a value of the wrong type or container for a field of a user type.
    ///
    /// ## Why
    /// The project of the user type declares what its fields are (chapter 7). A field written with another type or
    /// container does not fit it. This happens when the type was changed after the data was saved.
    ///
    /// ## Bad
    /// ```val3
    /// type Slot "Disk://Slot/Slot.pjx"
    /// tSlot.sName="box"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="tSlot" access="private" xsi:type="array" type="Slot" size="1">
    ///       <Value key="0">
    ///         <Field name="sName" xsi:type="array" type="num" size="1" />
    ///       </Value>
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// --- Slot
    /// public string sName
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// type Slot "Disk://Slot/Slot.pjx"
    /// tSlot.sName="box"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="tSlot" access="private" xsi:type="array" type="Slot" size="1">
    ///       <Value key="0">
    ///         <Field name="sName" xsi:type="array" type="string" size="1" />
    ///       </Value>
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// --- Slot
    /// public string sName
    /// ```
    V0516 "user-field-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(ty: &str, field: &str, expected: &str, found: &str) -> Wording {
    Wording::new(
        format!("the field `{field}` of `{ty}` is `{expected}`, but this value is `{found}`"),
        format!("must be `{expected}`"),
        format!("correct the value, or the public data `{field}` in the project of `{ty}`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn both_types_are_shown() {
        expect![[r#"
            the field `sName` of `Slot` is `string`, but this value is `num`
            | must be `string`
            ? correct the value, or the public data `sName` in the project of `Slot`
        "#]]
        .assert_eq(&word("Slot", "sName", "string", "num").to_string());
    }
}
