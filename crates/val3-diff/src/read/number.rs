//! Numbers as a report shows them.

/// A number of a file, in as few digits as give it back.
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
