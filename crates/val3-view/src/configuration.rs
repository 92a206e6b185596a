//! Arm configurations as text.

use val3_lang::enumerations;
use val3_lang::memory::{Memory, Place};
use val3_lang::types::BaseType;
use val3_lang::values::ConfigValue;

/// Offset of a point's configuration, which follows the coordinates.
const FIRST_NUMBER: u32 = 6;

/// Enumerator index of `ssame`, `esame` and `wsame`.
const SAME: f64 = 0.0;

/// Formats a configuration: shoulder, elbow, wrist; for a SCARA arm only the shoulder.
pub(crate) fn words(ConfigValue(numbers): &ConfigValue, is_scara: bool) -> String {
    let fields = [BaseType::Shoulder, BaseType::Elbow, BaseType::Wrist];
    let fields = numbers.iter().zip(fields).take(count(is_scara));
    let names = fields.filter_map(|(number, field)| {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the place of an enumerator")]
        let place = *number as usize;
        enumerations::values(field).nth(place).map(|row| row.name)
    });
    names.collect::<Vec<_>>().join(" ")
}

/// Reads the configuration of a point; `None` if the point does not exist. A SCARA point has only a shoulder.
pub(crate) fn of_point(memory: &Memory, point: Place, is_scara: bool) -> Option<ConfigValue> {
    let mut numbers = [SAME; 3];
    for (lane, number) in (FIRST_NUMBER..).zip(&mut numbers).take(count(is_scara)) {
        *number = memory.num(point, lane).ok()?;
    }
    Some(ConfigValue(numbers))
}

/// Numbers that teaching writes into a point's configuration, by lane: the configuration of the arm, like the result of
/// `here`. `ssame`, `esame` and `wsame` are kept, because a move from the taught position does not change the joints.
pub(crate) fn taught(
    ConfigValue(present): ConfigValue,
    ConfigValue(arm): ConfigValue,
    is_scara: bool,
) -> impl Iterator<Item = (u32, f64)> + use<> {
    let numbers = present.into_iter().zip(arm).map(|(present, arm)| if present == SAME { SAME } else { arm });
    (FIRST_NUMBER..).zip(numbers).take(count(is_scara))
}

const fn count(is_scara: bool) -> usize {
    if is_scara { 1 } else { 3 }
}
