//! Appearance of text (`setTextMode`, 4.3).

/// Text mode; `number as u8` is the argument of `setTextMode`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TextMode {
    /// 0: dark on light.
    #[default]
    Standard,
    /// 1: light on dark.
    Inverse,
    /// 2: dark on light, flashing.
    Flashing,
    /// 3: light on dark, flashing.
    InverseFlashing,
}

impl TextMode {
    /// Returns the mode with this number; `None` for any other number, which is run-time error 70.
    #[must_use]
    pub fn from_number(number: f64) -> Option<Self> {
        let modes = [Self::Standard, Self::Inverse, Self::Flashing, Self::InverseFlashing];
        modes.into_iter().find(|mode| f64::from(mode.number()) == number)
    }

    /// Returns the number of the mode.
    #[must_use]
    pub fn number(self) -> u8 {
        self as u8
    }

    /// Whether the text is light on dark.
    #[must_use]
    pub fn is_inverse(self) -> bool {
        matches!(self, Self::Inverse | Self::InverseFlashing)
    }

    /// Whether the text flashes.
    #[must_use]
    pub fn is_flashing(self) -> bool {
        matches!(self, Self::Flashing | Self::InverseFlashing)
    }
}

#[cfg(test)]
mod tests {
    use super::TextMode;

    #[test]
    fn there_are_four() {
        let modes: Vec<_> = [0.0, 1.0, 2.0, 3.0].into_iter().filter_map(TextMode::from_number).collect();
        assert_eq!(modes.iter().map(|mode| mode.number()).collect::<Vec<_>>(), [0, 1, 2, 3]);
        assert_eq!(modes.iter().map(|mode| mode.is_inverse()).collect::<Vec<_>>(), [false, true, false, true]);
        assert_eq!(modes.iter().map(|mode| mode.is_flashing()).collect::<Vec<_>>(), [false, false, true, true]);
    }

    #[test]
    fn other_numbers_are_no_mode() {
        for number in [-1.0, 4.0, 0.5, f64::NAN] {
            assert_eq!(TextMode::from_number(number), None, "{number}");
        }
    }
}
