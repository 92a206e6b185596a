//! `val3 check --explain-config`: each application's settings with their sources.

use std::collections::BTreeMap;
use std::io::{self, Write};

use val3_analysis::db::{Configuration, Database, Project};
use val3_analysis::items::project::items;
use val3_check::rule::Rule;
use val3_check::rules;
use val3_check::settings::Settings;
use val3_config::{ConfigFile, Setting};

use crate::opening::{OpenRequest, OpenedWorkspace};
use crate::report::FindingSeverity;

/// Source of default values.
const DEFAULT: &str = "default";
/// Source of settings that take precedence over every file.
const COMMAND_LINE: &str = "command line";

/// Writes the settings of every application, grouped by `val3.toml`.
pub(crate) fn write(opened: &OpenedWorkspace, request: &OpenRequest, out: &mut dyn Write) -> io::Result<()> {
    let db = &opened.workspace.db;
    let mut groups: BTreeMap<String, ConfigurationGroup> = BTreeMap::new();
    for project in &opened.workspace.projects {
        let configuration = project.configuration(db);
        let file = configuration.map(|configuration| opened.paths.shown(&configuration.file(db).path));
        let group = ConfigurationGroup { opened, request, configuration, projects: Vec::new() };
        groups.entry(file.unwrap_or_default()).or_insert(group).projects.push(*project);
    }
    for (place, (file, group)) in groups.iter().enumerate() {
        if place > 0 {
            writeln!(out)?;
        }
        group.write(file, out)?;
    }
    Ok(())
}

/// Applications with the same configuration.
struct ConfigurationGroup<'a> {
    opened: &'a OpenedWorkspace,
    request: &'a OpenRequest,
    configuration: Option<Configuration>,
    projects: Vec<Project>,
}

/// A setting, its value, and its source.
type SettingRow = [String; 3];

impl ConfigurationGroup<'_> {
    fn write(&self, file: &str, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "{}", if file.is_empty() { "no val3.toml" } else { file })?;
        self.projects.iter().try_for_each(|project| writeln!(out, "  for {}", self.application(*project)))?;
        table(&self.settings(file), out)?;
        let levels = self.levels(file);
        if !levels.is_empty() {
            writeln!(out, "  rules with a level other than the default")?;
            table(&levels, out)?;
        }
        Ok(())
    }

    fn db(&self) -> &Database {
        &self.opened.workspace.db
    }

    fn file(&self) -> Option<&ConfigFile> {
        self.configuration.map(|configuration| configuration.file(self.db()))
    }

    /// Describes the application: version, arm and disk.
    fn application(&self, project: Project) -> String {
        let (db, paths) = (self.db(), &self.opened.paths);
        let known = items(db, project);
        let arm = known.arm.map_or("unknown arm", |arm| arm.name());
        let disk = project.disk(db).map_or("unknown".to_owned(), |disk| paths.shown(disk));
        let manifest = paths.shown(project.manifest(db).path(db));
        format!("{manifest}: version {}, {arm}, Disk:// is {disk}", known.version)
    }

    fn settings(&self, file: &str) -> Vec<SettingRow> {
        val3_config::settings(self.file()).into_iter().map(|setting| self.setting_row(setting, file)).collect()
    }

    fn setting_row(&self, Setting { key, value, line }: Setting, file: &str) -> SettingRow {
        if let Some(path) = self.request.baseline.as_ref().filter(|_| key == "baseline") {
            return [key, format!("\"{path}\""), COMMAND_LINE.to_owned()];
        }
        let by = line.map_or(DEFAULT.to_owned(), |line| format!("{file}:{line}"));
        let value = if value.is_empty() { "-".to_owned() } else { value };
        [key, value, by]
    }

    /// Rules whose level differs from the default.
    fn levels(&self, file: &str) -> Vec<SettingRow> {
        let Some(project) = self.projects.first() else { return Vec::new() };
        let settings = self.opened.settings.of(self.db(), *project);
        let sources = rules::all().iter().filter_map(|rule| Some((rule, self.level_source(settings, rule, file)?)));
        sources.map(|(rule, by)| [format!("{} {}", rule.code, rule.name), level(settings, rule), by]).collect()
    }

    /// Source of a rule's level; `None` for its default.
    fn level_source(&self, settings: &Settings, rule: &Rule, file: &str) -> Option<String> {
        if settings.is_chosen(rule) {
            return Some(COMMAND_LINE.to_owned());
        }
        let key = settings.key_of(rule)?;
        let file_keys = [format!("rules.{key}"), key.to_owned()];
        let line = file_keys.iter().find_map(|key| self.file()?.line(key))?;
        Some(format!("{file}:{line} ({key})"))
    }
}

fn level(settings: &Settings, rule: &Rule) -> String {
    let level = settings.severity(rule, rule.severity).map(FindingSeverity::from);
    level.map_or("off", FindingSeverity::word).to_owned()
}

/// Writes rows with aligned columns.
fn table(rows: &[SettingRow], out: &mut dyn Write) -> io::Result<()> {
    let keys = width(rows.iter().map(|[key, ..]| key));
    let values = width(rows.iter().map(|[_, value, _]| value)).min(40);
    rows.iter().try_for_each(|[key, value, by]| writeln!(out, "    {key:keys$}  {value:values$}  {by}"))
}

/// Number of characters in the longest cell of a column.
fn width<'r>(cells: impl Iterator<Item = &'r String>) -> usize {
    cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
}
