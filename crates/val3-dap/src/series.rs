//! Numbers in the values of variables, with their units.

use schemars::JsonSchema;
use serde::Serialize;
use val3_debug::{DataForm, NumberSeries};
use val3_lang::types::{LengthUnit, NumberUnit};

/// A number in each value of a variable.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Series {
    /// Field name, for example `j1` or `x`; empty for the value itself.
    name: String,
    /// Unit: `mm`, `in`, `degrees`, `s`, `%`, `mm/s`, `in/s` or `degrees/s`; `null` for a number without a unit.
    unit: Option<&'static str>,
    /// Whether the number is 0 or 1 because the value is a `bool` or a digital input or output.
    is_digital: bool,
}

/// Returns the type and the numbers of data.
pub(crate) fn described(DataForm { type_name, length_unit, series }: DataForm) -> (String, Vec<Series>) {
    let series = series.into_iter().map(|NumberSeries { name, unit, is_digital }| Series {
        name: name.to_owned(),
        unit: unit_text(unit, length_unit),
        is_digital,
    });
    (type_name, series.collect())
}

/// Formats a unit; `None` for numbers without a unit.
const fn unit_text(unit: NumberUnit, length: LengthUnit) -> Option<&'static str> {
    match (unit, length) {
        (NumberUnit::None, _) => None,
        (NumberUnit::Length, LengthUnit::Millimetre) => Some("mm"),
        (NumberUnit::Length, LengthUnit::Inch) => Some("in"),
        (NumberUnit::LengthPerSecond, LengthUnit::Millimetre) => Some("mm/s"),
        (NumberUnit::LengthPerSecond, LengthUnit::Inch) => Some("in/s"),
        (NumberUnit::Degrees, _) => Some("degrees"),
        (NumberUnit::DegreesPerSecond, _) => Some("degrees/s"),
        (NumberUnit::Percent, _) => Some("%"),
        (NumberUnit::Seconds, _) => Some("s"),
    }
}
