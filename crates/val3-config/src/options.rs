//! Options of rules.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use val3_lang::versions::Version;

use crate::version;

/// Options of rules: the table `[lint]`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Options {
    /// The largest number of characters in a line of code.
    pub line_length: usize,
    /// The maximum parameter count of a program.
    pub parameters: usize,
    /// The largest complexity of a program. The complexity is 1 plus 1 for each `if`, `elseIf`, loop, `case`, `and`
    /// and `or`.
    pub complexity: usize,
    /// Programs that are called from outside the code, so that they always count as used.
    pub entry_points: Vec<String>,
    /// Name prefixes of further entry points.
    pub entry_prefixes: Vec<String>,
    /// Name prefixes of global data, by type: `num = "n"`. The key of a user type is its name. Data of
    /// other types can have any name.
    pub prefixes: BTreeMap<String, String>,
    /// The text before the prefix of the type in names of local variables: with "l_", the name of a local `num` is
    /// `l_nCount`, for example.
    pub local_prefix: String,
    /// The text before the prefix of the type in names of parameters.
    pub parameter_prefix: String,
    /// Whether points, joints, moves and speeds are compared with the arm and with `cell.toml`, as by `val3 check
    /// --motion` (V0411 to V0413, V0415, V0416, V0420, V0421).
    pub motion: bool,
    /// The version of VAL 3 to which the applications are moved: required changes are reported, as by `val3 check --for`
    /// (V0540 to V0542).
    #[serde(with = "version", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub target_version: Option<Version>,
    /// Words in comments that mark work to be done, in any letter case.
    pub task_words: Vec<String>,
}

/// Prefixes that most public programs use, by type.
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
            motion: false,
            target_version: None,
            task_words: words(&["todo", "fixme", "xxx", "hack"]),
        }
    }
}
