//! Summary of omitted differences.

use super::counts::counted;
use crate::model::Ignored;
use crate::read::number::shown;

/// Formats `ignored: 3 positions within 0.01 mm and 0.01°, 2 data named n*Count`; `None` if nothing was omitted.
pub(super) fn ignored(ignored: &Ignored) -> Option<String> {
    let tolerance = ignored.tolerance.map_or(String::new(), |tolerance| {
        format!("within {} mm and {}°", shown(tolerance.distance_mm), shown(tolerance.angle_deg))
    });
    let named = format!("named {}", ignored.patterns.join(" or "));
    let parts = [
        (ignored.within_tolerance, "position", "positions", tolerance.as_str()),
        (ignored.data, "value", "values", named.as_str()),
        (ignored.moved_along, "position", "positions", "that moved along"),
        (ignored.layouts, "program", "programs", "in another layout"),
    ];
    let parts: Vec<String> = parts
        .into_iter()
        .filter(|(count, ..)| *count > 0)
        .map(|(count, one, many, note)| format!("{} {note}", counted(count, one, many)))
        .collect();
    (!parts.is_empty()).then(|| format!("ignored: {}", parts.join(", ")))
}
