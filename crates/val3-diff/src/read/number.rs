//! Numbers as displayed in a report.

/// Formats a number with the fewest digits that represent it exactly.
pub(crate) fn shown(number: f64) -> String {
    let magnitude = number.abs();
    if magnitude != 0.0 && !(1e-6..1e15).contains(&magnitude) {
        return format!("{number:e}");
    }
    // Adding zero removes the sign of -0.
    format!("{}", number + 0.0)
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn numbers_are_short() {
        assert_eq!([shown(1.0), shown(-0.0), shown(0.1), shown(-12.25)], ["1", "0", "0.1", "-12.25"]);
        assert_eq!([shown(1e-16), shown(1e300)], ["1e-16", "1e300"]);
    }
}
