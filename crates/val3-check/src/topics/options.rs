//! Options in `[lint]`, by the rules that they change.

use crate::rule::Rule;

/// Options of a rule, as spelled in `val3.toml`.
pub(super) fn of_rule(rule: &Rule) -> impl Iterator<Item = &'static str> {
    OPTIONS.iter().filter(|(_, codes)| codes.contains(&rule.code)).map(|(option, _)| *option)
}

/// Options with their rules' codes.
static OPTIONS: &[(&str, &[&str])] = &[
    ("line-length", &["V0716"]),
    ("parameters", &["V0717"]),
    ("complexity", &["V0313"]),
    ("entry-points", &["V0117"]),
    ("entry-prefixes", &["V0117"]),
    ("prefixes", &["V0710", "V0711"]),
    ("local-prefix", &["V0711"]),
    ("parameter-prefix", &["V0711"]),
    ("motion", &["V0411", "V0412", "V0413", "V0415", "V0416", "V0420", "V0421"]),
    ("task-words", &["V0714"]),
];

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use val3_config::Options;

    use super::OPTIONS;
    use crate::rules;

    #[test]
    fn every_option_has_its_rules() {
        let options = serde_json::to_value(Options::default()).unwrap();
        let known: BTreeSet<&str> = options.as_object().unwrap().keys().map(String::as_str).collect();
        let listed: BTreeSet<&str> = OPTIONS.iter().map(|(option, _)| *option).collect();
        assert_eq!(listed, known, "an option in `val3_config::Options` needs a line in `OPTIONS` of this file");
        for code in OPTIONS.iter().flat_map(|(_, codes)| *codes) {
            assert!(rules::find(code).is_some(), "{code}");
        }
    }

    #[test]
    fn the_option_motion_has_the_rules_of_motion() {
        let (_, codes) = OPTIONS.iter().find(|(option, _)| *option == "motion").unwrap();
        assert_eq!(rules::of_motion().map(|rule| rule.code), **codes);
    }
}
