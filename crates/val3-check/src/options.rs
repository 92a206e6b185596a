//! What may be set about rules: the conventions of a shop.

use std::sync::LazyLock;

use crate::rule::Rule;

/// The settings of rules. Each is used by the rule that its documentation names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// V0117: programs that somebody other than the application's own code starts, besides `start` and `stop`.
    pub entry_points: Vec<String>,
    /// V0117: beginnings of the names of such programs.
    pub entry_prefixes: Vec<String>,
    /// V0710, V0711: how the name of global data begins, by type as code writes it (`num`, `jointRx` is `joint`). Data
    /// of a type that is not listed may begin with anything.
    pub prefixes: Vec<(String, String)>,
    /// V0711: what stands before that in the name of a local variable.
    pub local_prefix: String,
    /// V0711: what stands before that in the name of a parameter.
    pub parameter_prefix: String,
    /// V0714: words in comments that mark unfinished work, in any letter case.
    pub marks: Vec<String>,
    /// V0716: the most characters in a line of code.
    pub line_length: usize,
    /// V0717: the most parameters of a program.
    pub parameters: usize,
}

/// The conventions that most public programs follow.
impl Default for Options {
    fn default() -> Self {
        let prefixes = [
            ("bool", "b"),
            ("num", "n"),
            ("string", "s"),
            ("dio", "d"),
            ("aio", "a"),
            ("sio", "si"),
            ("screen", "sc"),
            ("trsf", "tr"),
            ("frame", "f"),
            ("tool", "t"),
            ("point", "p"),
            ("joint", "j"),
            ("config", "c"),
            ("mdesc", "m"),
        ];
        Self {
            entry_points: Vec::new(),
            entry_prefixes: Vec::new(),
            prefixes: prefixes.map(|(ty, prefix)| (ty.to_owned(), prefix.to_owned())).to_vec(),
            local_prefix: "l_".to_owned(),
            parameter_prefix: "x_".to_owned(),
            marks: ["todo", "fixme", "xxx", "hack"].map(str::to_owned).to_vec(),
            line_length: 259,
            parameters: 10,
        }
    }
}

static DEFAULT: LazyLock<Options> = LazyLock::new(Options::default);

/// What is asked of the rules beyond what they do on their own.
#[derive(Debug, Clone, Copy)]
pub struct Asked<'a> {
    /// Their settings.
    pub options: &'a Options,
    /// Rules that are off by default and shall run.
    pub rules: &'a [&'static Rule],
}

impl Default for Asked<'_> {
    fn default() -> Self {
        Self { options: &DEFAULT, rules: &[] }
    }
}

impl Asked<'_> {
    /// The rule shall run.
    pub(crate) fn contains(&self, rule: &Rule) -> bool {
        !rule.off || self.rules.contains(&rule)
    }
}
