//! Settings in a `val3.toml`.

use std::collections::BTreeMap;

use camino::Utf8PathBuf;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use val3_lang::versions::Version;

use crate::{ArmSetting, CodeLayout, Level, Options, Patterns, RunSettings, SuiteSettings, version};

/// Settings of the `val3` tools for the applications below a folder. Only the nearest file above an application
/// is used. Files are never merged, so an empty file cancels the settings of the folders above it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Config {
    /// The version of VAL 3 that the applications run on, such as "s8.12", instead of the one they declare.
    #[serde(with = "version", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub version: Option<Version>,
    /// The arm: "six-axis", "scara", "other", its model, such as "tx2-60l", or a file that describes it, relative to the
    /// folder of this file.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub arm: Option<ArmSetting>,
    /// The folder of `Disk://`, relative to the folder of this file.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub disk: Option<Utf8PathBuf>,
    /// The folders of other roots of paths: `{ USB0 = "usb" }`.
    #[schemars(with = "BTreeMap<String, String>")]
    pub roots: BTreeMap<String, Utf8PathBuf>,
    /// Tables of add-on instructions (`val3.<Addon>.<arm>.cfx`), in addition to the tables in the controller's `usr/app`.
    #[schemars(with = "Vec<String>")]
    pub add_ons: Vec<Utf8PathBuf>,
    /// Folders and files that a search skips. Applications can still use them as libraries. `*` matches any part of a
    /// name, `**` any folders.
    pub exclude: Patterns,
    /// The file with the known findings, which are not reported.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub baseline: Option<Utf8PathBuf>,
    /// Levels of findings. A key is a code (V0302), a name (argument-range), the beginning of codes (V03) or all; the
    /// most specific key applies.
    pub rules: BTreeMap<String, Level>,
    /// Options of rules.
    pub lint: Options,
    /// Layout of code.
    pub format: CodeLayout,
    /// The controller that applications run on.
    pub run: RunSettings,
    /// The tests of applications.
    pub test: SuiteSettings,
}
