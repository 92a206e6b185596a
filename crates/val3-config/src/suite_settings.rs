//! The tests of applications.

use std::collections::BTreeMap;

use camino::Utf8PathBuf;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Patterns;

/// The tests that `val3 test` executes: the table `[test]`. Arguments of the command take precedence.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct SuiteSettings {
    /// Folders of applications whose programs `test…` are tests, in addition to folders that are named `…Test` or lie below
    /// a folder `tests`: `["**/checks"]`. Patterns as for `exclude`.
    pub applications: Patterns,
    /// The seconds of the controller's clock after which a test has failed; the default is 60.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    pub limit: Option<f64>,
    /// Libraries that are loaded in place of others while tests are executed, by library identifier:
    /// `{ feeder = "stubs/feeder" }`. A path names a folder or a `.pjx`, relative to the folder of this file.
    #[schemars(with = "BTreeMap<String, String>")]
    pub replace: BTreeMap<String, Utf8PathBuf>,
}
