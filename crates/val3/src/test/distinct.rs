//! Makes test names unique by adding paths to equal names of applications or scenarios.

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use val3_suite::{TestCase, TestKind};

use crate::paths::Paths;

/// Sets a unique display name for each test. Each test comes with the project file of its application.
pub(super) fn distinguish(tests: Vec<(Utf8PathBuf, &mut TestCase)>, paths: &Paths) {
    let mut applications: BTreeMap<String, BTreeSet<Utf8PathBuf>> = BTreeMap::new();
    let mut scenarios: BTreeMap<(Utf8PathBuf, String), BTreeSet<String>> = BTreeMap::new();
    for (manifest, case) in &tests {
        applications.entry(case.application.clone()).or_default().insert(manifest.clone());
        scenarios.entry((manifest.clone(), case.program.clone())).or_default().insert(case.file.clone());
    }
    for (manifest, case) in tests {
        if applications.get(&case.application).is_some_and(|all| all.len() > 1) {
            case.application_path = Some(paths.to_open(manifest.parent().unwrap_or(&manifest)));
        }
        let same = scenarios.get(&(manifest, case.program.clone()));
        if case.kind == TestKind::Scenario && same.is_some_and(|all| all.len() > 1) {
            let path = Utf8Path::new(&case.file).with_extension("");
            case.scenario_path = Some(paths.to_open(&path));
        }
    }
}
