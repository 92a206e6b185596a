//! V0419: blending distances without effect.

use val3_analysis::items::limits::blends;
use val3_analysis::items::manifest::length_unit;
use val3_lang::types::LengthUnit;

use crate::diagnostic::Wording;
use crate::lint::{DataFile, Findings};
use crate::rule::rule;

rule! {
    /// A motion descriptor in a data file blends, with a distance below 0.1 mm.
    ///
    /// ## Why
    /// `leave` and `reach` are in the length unit of the application, usually mm (10.5.1). A corner of 0.01 mm is not
    /// rounded: the arm nearly stops at it. Usually the distance was meant in metres.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mFast
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1">
    ///       <Value key="0" blend="joint" leave="0.01" reach="0.01" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mFast
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1">
    ///       <Value key="0" blend="joint" leave="10" reach="10" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0419 "tiny-blend" Info, Data: check
}

/// Minimum visible distance, in mm.
const SMALLEST: f64 = 0.1;

fn check(data: &DataFile<'_>, found: &mut Findings) {
    if !counts_millimetres(data) {
        return;
    }
    for blend in blends(data.view.db, data.file) {
        let [leave, reach] = blend.distances;
        if leave > 0.0 && reach > 0.0 && leave.max(reach) < SMALLEST {
            found.report(&RULE, blend.range, word(leave, reach));
        }
    }
}

fn counts_millimetres(data: &DataFile<'_>) -> bool {
    let unit = length_unit(data.view.db, data.view.project.manifest(data.view.db));
    unit == LengthUnit::Millimetre
}

fn word(leave: f64, reach: f64) -> Wording {
    Wording::new(
        format!("the corner is blended from {leave} mm before to {reach} mm after its point, which has no effect"),
        "these distances are in mm",
        "write millimetres, or `blend=\"off\"`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn descriptor(values: &str) -> String {
        let data = format!(
            "<Data name=\"mA\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\"><Value key=\"0\" {values} /></Data>"
        );
        check(&RULE, &format!("mdesc mA\n=== main/main.dtx\n<Database><Datas>{data}</Datas></Database>"))
    }

    #[test]
    fn distances_without_effect_are_reported() {
        expect![[r#"
            main.dtx:1 `0.010` the corner is blended from 0.01 mm before to 0.01 mm after its point, which has no effect
              | these distances are in mm
              ? write millimetres, or `blend="off"`
        "#]]
        .assert_eq(&descriptor("blend=\"Cartesian\" leave=\"0.010\" reach=\"0.010\""));
    }

    #[test]
    fn other_distances_are_not_reported() {
        assert_eq!(descriptor("blend=\"off\" leave=\"0.01\" reach=\"0.01\""), "");
        assert_eq!(descriptor("blend=\"joint\" leave=\"0\" reach=\"0\""), "");
        assert_eq!(descriptor("blend=\"joint\" leave=\"0.01\" reach=\"5\""), "");
        assert_eq!(descriptor("leave=\"0.01\" reach=\"0.01\""), "");
    }
}
