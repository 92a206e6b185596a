//! Selection of report parts.

use camino::Utf8Path;

use crate::model::{ApplicationChange, Change, Comparison, DataChange, ReportClass};

impl Comparison {
    /// Keeps only these parts. Problems remain, because they may hide differences of any part.
    pub fn keep(&mut self, classes: &[ReportClass]) {
        let has = |class| classes.contains(&class);
        self.settings.retain(|file| has(if file.is_io { ReportClass::Io } else { ReportClass::Configuration }));
        if !has(ReportClass::Files) {
            self.others.clear();
        }
        for application in &mut self.applications {
            keep_in(application, classes);
        }
        self.applications.retain(|application| has_content(application, classes));
    }
}

fn keep_in(application: &mut ApplicationChange, classes: &[ReportClass]) {
    let has = |class| classes.contains(&class);
    if !has(ReportClass::Programs) {
        application.programs.clear();
        application.texts.retain(|text| !text.path.to_lowercase().ends_with(".pgx"));
    }
    application.contents.retain(|content| has(class_of_file(&content.path)));
    if !has(ReportClass::Libraries) {
        application.libraries.clear();
        application.types.clear();
        application.interface.clear();
    }
    if !has(ReportClass::Configuration) {
        application.project.clear();
        application.moved_from = None;
    }
    application.data.retain_mut(|data| keep_data(data, classes));
}

/// Returns the part of the report for the XML of a file.
fn class_of_file(path: &str) -> ReportClass {
    match Utf8Path::new(path).extension().map(str::to_lowercase).as_deref() {
        Some("pgx") => ReportClass::Programs,
        Some("dtx") => ReportClass::Data,
        _ => ReportClass::Configuration,
    }
}

/// Keeps the selected values. The values of a user type are selected by the classes of the fields.
fn keep_data(data: &mut DataChange, classes: &[ReportClass]) -> bool {
    if classes.contains(&data.class) {
        return true;
    }
    data.values.retain(|value| classes.contains(&value.class));
    !data.values.is_empty()
}

fn has_content(application: &ApplicationChange, classes: &[ReportClass]) -> bool {
    let is_whole = application.change != Change::Changed && classes.contains(&ReportClass::Configuration);
    let mut rest = application.clone();
    rest.change = Change::Changed;
    is_whole || !rest.is_empty()
}
