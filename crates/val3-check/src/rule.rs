//! Definition of a rule: code, name, level and page.

use crate::lint::{DataFile, Findings, ProgramView, ProjectView};

/// Severity of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Advice.
    Info,
    /// Almost always a mistake.
    Warning,
    /// The controller rejects it, or it certainly fails at run time.
    Error,
}

impl Severity {
    /// Name of the level in reports.
    pub fn word(self) -> &'static str {
        match self {
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// A rule.
#[derive(Debug)]
pub struct Rule {
    /// Code, for example `V0203`. The first digit is the family (0 syntax, 1 names, 2 types, 3 flow, 4 motion, 5
    /// project and data, 6 library interfaces, 7 style).
    pub code: &'static str,
    /// Name, for example `argument-type`.
    pub name: &'static str,
    /// Default level.
    pub severity: Severity,
    /// Whether the rule is on by default. Rules that enforce conventions are off.
    pub on: bool,
    /// Page in Markdown, with one leading blank per line: what, why, a bad and a good example.
    pub page: &'static str,
    /// Function that finds its faults; `None` if the parser or the analysis finds them.
    pub(crate) lint: Option<Lint>,
}

/// A function that finds a rule's faults.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Lint {
    /// In each program without faults.
    Program(fn(&ProgramView<'_>, &mut Findings)),
    /// In each program without faults, with access to the application's other programs. All rules about the arm's state
    /// have this kind, so that the state is computed once.
    Member(fn(&ProgramView<'_>, &mut Findings)),
    /// In each `.dtx`.
    Data(fn(&DataFile<'_>, &mut Findings)),
    /// In each project; findings are located in the `.pjx`.
    Project(fn(&ProjectView<'_>, &mut Findings)),
}

/// Rules with equal codes are equal, because codes are unique.
impl PartialEq for Rule {
    fn eq(&self, other: &Self) -> bool {
        self.code == other.code
    }
}

impl Eq for Rule {}

/// Declares the rule of a file: `/// page`, then `V0203 "argument-type" Error`. The level is followed by `off` for a
/// rule that is off by default, and by `, Program: check`, `, Member: check`, `, Data: check` or `, Project: check` for
/// a lint.
macro_rules! rule {
    ($(#[doc = $line:literal])* $code:ident $name:literal $severity:ident $($off:ident)? $(, $target:ident: $check:ident)?) => {
        $(#[doc = $line])*
        pub(crate) static RULE: $crate::rule::Rule = $crate::rule::Rule {
            code: stringify!($code),
            name: $name,
            severity: $crate::rule::Severity::$severity,
            on: $crate::rule::rule!(@on $($off)?),
            page: concat!($($line, "\n"),*),
            lint: $crate::rule::rule!(@lint $($target $check)?),
        };
    };
    (@on off) => { false };
    (@on) => { true };
    (@lint $target:ident $check:ident) => { Some($crate::rule::Lint::$target($check)) };
    (@lint) => { None };
}
pub(crate) use rule;
