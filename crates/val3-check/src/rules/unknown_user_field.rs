//! V0515: a value for a field that the user type does not have.

use crate::{diagnostic::Wording, phrase::did_you_mean_or, rule::rule};

rule! {
    /// A data file contains a value for a field that the user type does not have.
    ///
    /// ## Why
    /// The fields of a user type are the public data of its project (chapter 7). When a field is renamed, removed or
    /// made private, older data files keep their values for it. Values are matched by name, so such a value is silently
    /// lost, and the new field keeps its default.
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
    ///         <Field name="sLabel" xsi:type="array" type="string" size="1" />
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
    V0515 "unknown-user-field" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(ty: &str, field: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("the user type `{ty}` has no field `{field}`"),
        "this value is lost",
        did_you_mean_or(near, &format!("remove it, or add public data `{field}` to the project of `{ty}`")),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_field() {
        expect![[r#"
            the user type `Slot` has no field `sNmae`
            | this value is lost
            ? did you mean `sName`?
        "#]]
        .assert_eq(&word("Slot", "sNmae", Some("sName")).to_string());
    }

    #[test]
    fn a_removed_field_is_reported() {
        expect![[r#"
            the user type `Slot` has no field `sLabel`
            | this value is lost
            ? remove it, or add public data `sLabel` to the project of `Slot`
        "#]]
        .assert_eq(&word("Slot", "sLabel", None).to_string());
    }
}
