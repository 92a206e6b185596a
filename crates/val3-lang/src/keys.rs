//! The keys of the pendant that have no character of their own (12.2).

/// One key.
#[derive(Debug, PartialEq, Eq)]
pub struct Key {
    /// The code that `get` and `getKey` give.
    pub code: u16,
    /// What stands on it.
    pub name: &'static str,
}

const fn row(code: u16, name: &'static str) -> Key {
    Key { code, name }
}

/// Every such key, ascending.
pub static KEYS: [Key; 24] = [
    row(255, "Esc"),
    row(259, "Tab"),
    row(260, "UnTab"),
    row(261, "Up"),
    row(262, "PgUp"),
    row(263, "Bksp"),
    row(264, "Left"),
    row(265, "Home"),
    row(266, "Down"),
    row(267, "PgDn"),
    row(268, "Right"),
    row(269, "End"),
    row(270, "Return"),
    row(271, "F1"),
    row(272, "F2"),
    row(273, "F3"),
    row(274, "F4"),
    row(275, "F5"),
    row(276, "F6"),
    row(277, "F7"),
    row(278, "F8"),
    row(281, "1"),
    row(282, "2"),
    row(283, "3"),
];

#[cfg(test)]
mod tests {
    use super::KEYS;

    #[test]
    fn each_key_has_a_code_of_its_own() {
        assert!(KEYS.is_sorted_by(|a, b| a.code < b.code));
    }
}
