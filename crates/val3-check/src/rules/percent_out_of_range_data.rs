//! V0246: a speed in per cent that no arm has, in a data file.

use val3_analysis::items::limits::limits;
use val3_lang::motion::AXIS_SPEED;
use val3_lang::values::HIGHEST_AXIS_SPEED;

use super::percent_out_of_range::word;
use crate::lint::{DataFile, Findings};
use crate::rule::rule;

rule! {
    /// A motion descriptor in a data file has a `vel` above 1000.
    ///
    /// ## Why
    /// `vel`, `accel` and `decel` are in per cent of the nominal values of the arm (10.5.1). The file loads, but every
    /// move with this descriptor stops its task with run-time error 100.
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
    ///       <Value key="0" vel="25000" />
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
    ///       <Value key="0" vel="100" tmax="25000" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0246 "percent-out-of-range-data" Warning, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    for limit in limits(data.view.db, data.file) {
        if limit.attribute == AXIS_SPEED && limit.value > HIGHEST_AXIS_SPEED {
            found.report(&RULE, limit.range, word(limit.value));
        }
    }
}
