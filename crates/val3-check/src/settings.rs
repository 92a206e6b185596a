//! An application's rules and levels, according to `val3.toml` and the command line.

mod selectors;

use std::collections::BTreeSet;

use camino::Utf8Path;
use rustc_hash::{FxHashMap, FxHashSet};
use val3_analysis::db::{Configuration, Db, Project};
use val3_config::{ConfigError, ConfigFile, Level, Options};
use val3_lang::versions::Version;

pub use selectors::{Exactness, meant_by};

use crate::diagnostic::Diagnostic;
use crate::rule::{Rule, Severity};
use crate::rules;

/// Rule selection of a command line. It overrides every configuration.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RuleSelection {
    /// Codes of the only rules to report; `None` for all.
    pub only: Option<BTreeSet<&'static str>>,
    /// Codes that were stated individually. They are reported even if a configuration turns them off.
    pub named: BTreeSet<&'static str>,
    /// Codes of rules that are not reported.
    pub never: BTreeSet<&'static str>,
    /// Version to which the applications are moved.
    pub target: Option<Version>,
}

/// Application settings.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Settings {
    /// Configured levels by code.
    levels: FxHashMap<&'static str, Configured>,
    selection: RuleSelection,
    /// Options of rules.
    pub options: Options,
}

/// Configured level of a rule, and its key in the configuration.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Configured {
    level: Level,
    exactness: Exactness,
    key: String,
}

impl Settings {
    /// Combines a configuration and a command line.
    ///
    /// # Errors
    /// A key of `[rules]` names no rule, or two keys name the same rule.
    pub fn new(file: Option<&ConfigFile>, selection: &RuleSelection) -> Result<Self, ConfigError> {
        let mut settings = Self { selection: selection.clone(), ..Self::default() };
        settings.options.target_version = selection.target;
        if let Some(file) = file {
            settings.options = file.config.lint.clone();
            settings.options.target_version = selection.target.or(settings.options.target_version);
            for (key, level) in &file.config.rules {
                settings.configure(file, key, *level)?;
            }
            if settings.options.motion {
                settings.turn_motion_on();
            }
        }
        Ok(settings)
    }

    fn configure(&mut self, file: &ConfigFile, key: &str, level: Level) -> Result<(), ConfigError> {
        let meant = meant_by(key);
        if meant.is_empty() {
            return Err(selectors::unknown(file, key));
        }
        for (rule, exactness) in meant {
            let known = self.levels.get(rule.code);
            if let Some(twice) = known.filter(|known| known.exactness == exactness) {
                return Err(selectors::twice(file, key, &twice.key));
            }
            if known.is_none_or(|known| known.exactness < exactness) {
                self.levels.insert(rule.code, Configured { level, exactness, key: key.to_owned() });
            }
        }
        Ok(())
    }

    /// Turns on the rules about the arm (`motion`) that `[rules]` does not mention.
    fn turn_motion_on(&mut self) {
        for rule in rules::of_motion() {
            let on = Configured { level: Level::On, exactness: Exactness::All, key: "lint.motion".to_owned() };
            self.levels.entry(rule.code).or_insert(on);
        }
    }

    /// Level of a finding whose default level is `usual`; `None` if it is not reported.
    pub fn severity(&self, rule: &Rule, usual: Severity) -> Option<Severity> {
        if *rule == rules::file_unreadable::RULE {
            return Some(usual);
        }
        let RuleSelection { only, named, never, .. } = &self.selection;
        if never.contains(rule.code) || only.as_ref().is_some_and(|only| !only.contains(rule.code)) {
            return None;
        }
        let named = named.contains(rule.code);
        match self.levels.get(rule.code).map_or(Level::Default, |configured| configured.level) {
            Level::Off => named.then_some(usual),
            Level::Default => (rule.on || named).then_some(usual),
            Level::On => Some(usual),
            Level::Info => Some(Severity::Info),
            Level::Warning => Some(Severity::Warning),
            Level::Error => Some(Severity::Error),
        }
    }

    /// Sets the configured level of a finding; `None` if it is not reported.
    pub(crate) fn with_level(&self, mut diagnostic: Diagnostic) -> Option<Diagnostic> {
        diagnostic.severity = self.severity(diagnostic.rule, diagnostic.severity)?;
        Some(diagnostic)
    }

    /// Whether findings of this rule are reported; costly rules check this first.
    pub fn is_enabled(&self, rule: &Rule) -> bool {
        self.severity(rule, rule.severity).is_some()
    }

    /// Key of `[rules]` that sets the level of a rule.
    pub fn key_of(&self, rule: &Rule) -> Option<&str> {
        self.levels.get(rule.code).map(|configured| configured.key.as_str())
    }

    /// Whether the command line determines the rule, regardless of the configuration.
    pub fn is_chosen(&self, rule: &Rule) -> bool {
        let RuleSelection { only, named, never, .. } = &self.selection;
        let left_out = only.as_ref().is_some_and(|only| !only.contains(rule.code));
        left_out || named.contains(rule.code) || never.contains(rule.code)
    }
}

/// Settings of all applications in a workspace.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct WorkspaceSettings {
    by_configuration: FxHashMap<Configuration, Settings>,
    /// Settings of applications without a `val3.toml`.
    unconfigured: Settings,
}

impl WorkspaceSettings {
    /// Reads the configurations of `projects`.
    ///
    /// # Errors
    /// The errors of [`Settings::new`], one per configuration.
    pub fn new(db: &dyn Db, projects: &[Project], selection: &RuleSelection) -> Result<Self, Vec<ConfigError>> {
        let mut unconfigured = Settings { selection: selection.clone(), ..Settings::default() };
        unconfigured.options.target_version = selection.target;
        let mut settings = Self { by_configuration: FxHashMap::default(), unconfigured };
        let mut errors = Vec::new();
        let mut seen = FxHashSet::default();
        for configuration in projects.iter().filter_map(|project| project.configuration(db)) {
            if !seen.insert(configuration) {
                continue;
            }
            match Settings::new(Some(configuration.file(db)), selection) {
                Ok(found) => drop(settings.by_configuration.insert(configuration, found)),
                Err(error) => errors.push(error),
            }
        }
        if errors.is_empty() { Ok(settings) } else { Err(errors) }
    }

    /// An application's settings.
    pub fn of(&self, db: &dyn Db, project: Project) -> &Settings {
        let configured = project.configuration(db).and_then(|configuration| self.by_configuration.get(&configuration));
        configured.unwrap_or(&self.unconfigured)
    }

    /// Settings of a file without an application: the settings of the nearest `val3.toml` that an application has.
    pub fn at(&self, db: &dyn Db, path: &Utf8Path) -> &Settings {
        let configured = self.by_configuration.iter().map(|(configuration, it)| (configuration.file(db).folder(), it));
        let above = configured.filter(|(folder, _)| path.starts_with(folder));
        above.max_by_key(|(folder, _)| folder.components().count()).map_or(&self.unconfigured, |(_, settings)| settings)
    }
}

#[cfg(test)]
mod tests;
