//! V0524: the index of a father outside its array.

use crate::{diagnostic::Wording, phrase::last_key, rule::rule};

rule! {
    /// A father is named with an index that its array does not have.
    ///
    /// ## Why
    /// `fatherId` names one element of an array of frames or tools. Indexes count from 0, so the last one is the size
    /// less 1. The controller reports a father that does not exist as missing linked data.
    ///
    /// ## Bad
    /// ```val3
    /// pPick.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="fTray" access="private" xsi:type="array" type="frame" size="2">
    ///       <Value key="0" fatherId="world[0]" />
    ///       <Value key="1" fatherId="world[0]" />
    ///     </Data>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="fTray[2]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// pPick.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="fTray" access="private" xsi:type="array" type="frame" size="2">
    ///       <Value key="0" fatherId="world[0]" />
    ///       <Value key="1" fatherId="world[0]" />
    ///     </Data>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="fTray[1]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0524 "father-index" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(father: &str, size: &str) -> Wording {
    Wording::new(
        format!("the father `{father}` is outside its array of size `{size}`"),
        last_key(size).map(|last| format!("the last index is `{last}`")).unwrap_or_default(),
        "indexes count from 0",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_last_index_is_named() {
        expect![[r#"
            the father `fTray[2]` is outside its array of size `2`
            | the last index is `1`
            ? indexes count from 0
        "#]]
        .assert_eq(&word("fTray[2]", "2").to_string());
    }
}
