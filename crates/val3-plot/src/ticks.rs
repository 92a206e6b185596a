//! Round numbers for grids.

/// Maximum number of values on an axis.
const MOST: f64 = 500.0;

/// Returns the round step (1, 2, 5, 10 …) that is at least `least` pixels wide at `scale` pixels for each unit.
pub(crate) fn step(scale: f64, least: f64) -> f64 {
    let wanted = (least / scale).max(f64::MIN_POSITIVE);
    let power = 10_f64.powi(libm::log10(wanted).floor() as i32);
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|digit| digit * power).find(|step| *step >= wanted).unwrap_or(10.0 * power)
}

/// Returns the multiples of a step within a range.
pub(crate) fn multiples(step: f64, [from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    let first = (from / step).ceil();
    let count = ((to / step).floor() - first).clamp(-1.0, MOST) as i64;
    (0..=count).map(move |index| (first + index as f64) * step)
}

/// Formats a multiple of a step.
pub(crate) fn shown(value: f64, step: f64) -> String {
    let decimals = (-libm::log10(step).floor()).clamp(0.0, 6.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.trim_start_matches('-').chars().all(|digit| matches!(digit, '0' | '.')) { "0".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::{multiples, shown, step};

    #[test]
    fn steps_are_round() {
        assert_eq!([step(1.0, 50.0), step(0.3, 50.0), step(100.0, 50.0), step(4.0, 50.0)], [50.0, 200.0, 0.5, 20.0]);
        assert_eq!(
            multiples(0.5, [-0.6, 1.1]).map(|value| shown(value, 0.5)).collect::<Vec<_>>(),
            ["-0.5", "0", "0.5", "1.0"]
        );
        assert_eq!(multiples(10.0, [1.0, 9.0]).count(), 0);
    }
}
