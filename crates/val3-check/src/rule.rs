//! What a rule is: its code, name, level and page.

/// How serious a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Advice.
    Info,
    /// Nearly always a mistake.
    Warning,
    /// The controller refuses to load it, or it certainly fails when it runs.
    Error,
}

/// One rule.
#[derive(Debug, PartialEq, Eq)]
pub struct Rule {
    /// `V0203`: the first digit is the family (0 syntax, 1 names, 2 types, 3 flow, 4 motion, 5 project and data,
    /// 6 library interfaces, 7 style).
    pub code: &'static str,
    /// `argument-type`.
    pub name: &'static str,
    /// The level unless configured otherwise.
    pub severity: Severity,
    /// Whether it is reported without being asked for; conventions of a shop are not.
    pub on: bool,
    /// The page in Markdown, one leading blank a line: what, why, a bad and a good example.
    pub page: &'static str,
}

/// Declares the rule of a file: `/// page`, then `V0203 "argument-type" Error`, and `off` behind it where the rule is
/// off until configured.
macro_rules! rule {
    (@on) => { true };
    (@on off) => { false };
    ($(#[doc = $line:literal])* $code:ident $name:literal $severity:ident $($off:ident)?) => {
        $(#[doc = $line])*
        pub(crate) static RULE: $crate::rule::Rule = $crate::rule::Rule {
            code: stringify!($code),
            name: $name,
            severity: $crate::rule::Severity::$severity,
            on: $crate::rule::rule!(@on $($off)?),
            page: concat!($($line, "\n"),*),
        };
    };
}
pub(crate) use rule;
