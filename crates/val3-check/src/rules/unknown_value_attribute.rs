//! V0511: an attribute that the values of the type do not have.

use crate::{diagnostic::Wording, phrase::did_you_mean, rule::rule};

rule! {
    /// A value in a data file has an attribute that does not belong to its type.
    ///
    /// ## Why
    /// Each type has its own attributes: a `num` has `value`, a `frame` has `x` to `rz` and `fatherId`, an `mdesc` has
    /// `accel` to `reach`. An attribute with another name has no effect, and the intended one keeps its default value.
    /// Some attributes have another name in files than in code: `tmax` and `rmax` in a file are `tvel` and `rvel` in
    /// code, and `ioLink`, `ioOpen` and `ioClose` are `gripper`, `otime` and `ctime`. The fix writes the name of files.
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
    ///       <Value key="0" valeu="3" />
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
    ///       <Value key="0" value="3" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0511 "unknown-value-attribute" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(ty: &str, attribute: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("a value of type `{ty}` has no attribute `{attribute}`"),
        "it has no effect",
        did_you_mean(near),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_name() {
        expect![[r#"
            a value of type `num` has no attribute `valeu`
            | it has no effect
            ? did you mean `value`?
        "#]]
        .assert_eq(&word("num", "valeu", Some("value")).to_string());
    }

    #[test]
    fn an_unknown_attribute_is_reported() {
        expect![[r#"
            a value of type `mdesc` has no attribute `colour`
            | it has no effect
        "#]]
        .assert_eq(&word("mdesc", "colour", None).to_string());
    }
}
