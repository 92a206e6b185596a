//! V0242: a number in a motion descriptor of a data file that no move accepts.

use val3_analysis::items::limits::limits;

use super::negative_motion_limit::{is_too_small, word};
use crate::lint::{DataFile, Findings};
use crate::rule::rule;

rule! {
    /// A motion descriptor in a data file has a number below 0, or a speed or acceleration of 0.
    ///
    /// ## Why
    /// Speeds and accelerations are above 0, and blending distances are not negative (10.5.1). The file loads, but every
    /// move with this descriptor stops its task with a run-time error from 100 to 106.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mSlow
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
    ///   <Datas>
    ///     <Data name="mSlow" access="private" xsi:type="array" type="mdesc" size="1">
    ///       <Value key="0" vel="-20" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mSlow
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
    ///   <Datas>
    ///     <Data name="mSlow" access="private" xsi:type="array" type="mdesc" size="1">
    ///       <Value key="0" vel="20" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0242 "negative-motion-data" Warning, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    for limit in limits(data.view.db, data.file) {
        if is_too_small(limit.attribute, limit.value) {
            found.report(&RULE, limit.range, word(limit.attribute, limit.value));
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn data(values: &str) -> String {
        format!("cls()\n=== main/main.dtx\n<Database xmlns:xsi=\"x\"><Datas>\n{values}\n</Datas></Database>\n")
    }

    fn descriptor(attributes: &str) -> String {
        data(&format!(
            "<Data name=\"m\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\">\n\
             <Value key=\"0\" {attributes} />\n</Data>"
        ))
    }

    #[test]
    fn negative_numbers_are_reported() {
        expect![[r#"
            main.dtx:3 `-1` `tmax` of a motion descriptor cannot be -1
              | every move with it fails
              ? write a number above 0
            main.dtx:3 `-0.5` `reach` of a motion descriptor cannot be -0.5
              | every move with it fails
              ? write 0 or more
        "#]]
        .assert_eq(&check(&RULE, &descriptor("tmax=\"-1\" reach=\"-0.5\" leave=\"0\"")));
    }

    #[test]
    fn speeds_of_zero_are_reported() {
        expect![[r#"
            main.dtx:3 `0` `vel` of a motion descriptor cannot be 0
              | every move with it fails
              ? write a number above 0
        "#]]
        .assert_eq(&check(&RULE, &descriptor("vel=\"0\" reach=\"0\" leave=\"0\"")));
    }

    #[test]
    fn valid_numbers_and_other_types_are_not_reported() {
        assert_eq!(check(&RULE, &descriptor("tmax=\"1\" reach=\"50\" blend=\"off\"")), "");
        let trsf = "<Data name=\"t\" access=\"private\" xsi:type=\"array\" type=\"trsf\" size=\"1\">\n\
                    <Value key=\"0\" x=\"-5\" />\n</Data>";
        assert_eq!(check(&RULE, &data(trsf)), "");
    }

    #[test]
    fn the_old_dialect_is_checked() {
        let old = "cls()\n=== main/main.dtx\n<dataList xmlns=\"DataNameSpace\"><mdescSection>\n\
                   <mdesc name=\"m\" public=\"false\" size=\"1\"><valueMdesc index=\"0\">\n\
                   <mdescValue accel=\"100\" vel=\"-1\" /></valueMdesc></mdesc>\n</mdescSection></dataList>\n";
        assert!(check(&RULE, old).contains("`vel` of a motion descriptor cannot be -1"));
    }
}
