//! The configuration file `val3.toml`: settings with their lines, and the JSON schema.
//!
//! [`Config`] is the only definition of the settings. The parser, the schema, the messages about invalid settings and
//! the output of `val3 check --explain-config` are derived from it. This crate reads no files.

mod add_on_stand_in;
mod arm;
mod config;
mod config_file;
mod default_run;
mod error;
mod format;
mod level;
mod link_shape;
mod options;
mod patterns;
mod run_settings;
mod schema;
mod schema_keys;
mod setting;
mod suite_settings;
mod table_file;
mod table_strings;
pub mod trust;
mod validate;
mod version;

pub use self::arm::{ArmModel, ArmSetting};
pub use add_on_stand_in::{AddOnStandIn, StandInProgram, StandInValue};
pub use config::Config;
pub use config_file::{ConfigFile, FILE_NAME};
pub use default_run::DefaultRun;
pub use error::ConfigError;
pub use format::{CodeLayout, IndentStyle};
pub use level::Level;
pub use link_shape::{LengthUnit, LinkShapeFile};
pub use options::Options;
pub use patterns::Patterns;
pub use run_settings::{Licence, Profile, RunSettings};
pub use schema::{json_schema, json_schema_of};
pub use schema_keys::{SchemaKey, ValueForm, schema_keys, schema_words};
pub use setting::{Setting, settings};
pub use suite_settings::SuiteSettings;
pub use table_file::TableFile;
pub use table_strings::{TableString, table_strings};
