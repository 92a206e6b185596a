//! Options of rules.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Options of rules: the table `[lint]`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Options {
    /// The most characters a line of code may have.
    pub line_length: usize,
    /// The most parameters of a program.
    pub parameters: usize,
    /// The most ways through one program that are easy to follow: 1, and one more for each `if`, `elseIf`, loop,
    /// `case`, `and` and `or`.
    pub complexity: usize,
    /// Programs that are called from outside of the code, and so are never without use.
    pub entry_points: Vec<String>,
    /// Beginnings of the names of further such programs.
    pub entry_prefixes: Vec<String>,
    /// How names of global data begin, by type: `num = "n"`. A user type is asked by its own name. Types that are
    /// absent may have any name.
    pub prefixes: BTreeMap<String, String>,
    /// What stands before the prefix of the type in names of local variables: with "l_", a local `num` is called
    /// `l_nCount`.
    pub local_prefix: String,
    /// What stands before the prefix of the type in names of parameters.
    pub parameter_prefix: String,
    /// Words in comments that mark work to be done, in any letter case.
    pub task_words: Vec<String>,
}

/// The prefixes that most public programs use.
const PREFIXES: [(&str, &str); 14] = [
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

impl Default for Options {
    fn default() -> Self {
        let words = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect();
        Self {
            line_length: 259,
            parameters: 10,
            complexity: 20,
            entry_points: words(&["start", "stop"]),
            entry_prefixes: Vec::new(),
            prefixes: PREFIXES.map(|(ty, prefix)| (ty.to_owned(), prefix.to_owned())).into(),
            local_prefix: "l_".to_owned(),
            parameter_prefix: "x_".to_owned(),
            task_words: words(&["todo", "fixme", "xxx", "hack"]),
        }
    }
}
