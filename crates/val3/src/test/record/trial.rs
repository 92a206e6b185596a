//! Execution of a scenario before it is written.

use std::rc::Rc;

use camino::Utf8Path;
use val3_machine::controller::Controller;
use val3_suite::{ControllerKeys, Failure, Scenario, Supervision, TestSettings, execute};

use super::super::discovery::Opening;
use super::super::scenarios::case;
use super::super::script_file::ScriptFile;
use super::super::workers::Bench;
use crate::args::ControllerArgs;
use crate::paths::from_here;
use crate::run::unusable_script;
use crate::sockets::ClosedSockets;
use crate::user_error::UserError;
use val3_session::CodeForm;

/// Future path of a scenario, and the project file of its application.
pub(super) struct ScenarioTrial<'t> {
    pub(super) manifest: &'t Utf8Path,
    pub(super) path: &'t Utf8Path,
}

/// Outcome of an execution.
pub(super) struct TrialOutcome {
    pub(super) failures: Vec<Failure>,
    /// Title and lines of the final user page, without surrounding blanks and empty lines.
    pub(super) screen: Vec<String>,
}

impl ScenarioTrial<'_> {
    /// Opens the application on a new controller.
    pub(super) fn opened(&self) -> Result<Bench, UserError> {
        self.bench(&ControllerKeys::default())
    }

    fn bench(&self, keys: &ControllerKeys) -> Result<Bench, UserError> {
        let controller = ControllerArgs::default();
        let opening =
            Opening { controller: &controller, limit: None, form: CodeForm::Plain, replace: None, edited: &[] };
        Bench::open(opening, self.manifest, keys, Rc::new(ClosedSockets::default()))
    }

    /// Executes the scenario with this text.
    ///
    /// # Errors
    /// The application cannot be executed, or the scenario names an object that the application does not contain.
    pub(super) fn execute(&self, text: String) -> Result<TrialOutcome, UserError> {
        let path = from_here(self.path)?;
        let scenario = Scenario::parse(path.as_str(), &text).map_err(|error| unusable_script(&path, &error))?;
        let mut bench = self.bench(scenario.controller_keys())?;
        let keys = scenario.controller_keys().clone();
        let file = ScriptFile { path, scenario, keys };
        bench.prepare(&file)?;
        let limit = file.scenario.limit().map_or(bench.suite.settings, |limit| TestSettings { limit });
        let supervision = Supervision { settings: limit, may_go_on: &|| true, conditions: &mut |_, _| Vec::new() };
        let case = case(self.manifest, self.path);
        let result = execute(&mut bench.controller, &case, &file.scenario, supervision)
            .ok_or_else(|| UserError::new("the scenario was not executed to its end"))?;
        Ok(TrialOutcome { failures: result.failures, screen: screen(&bench.controller) })
    }
}

fn screen(controller: &Controller) -> Vec<String> {
    let pendant = &controller.devices.state.pendant;
    let Some(page) = pendant.page(pendant.shown()) else { return Vec::new() };
    let mut shown: Vec<String> = Vec::new();
    for line in [page.title().to_owned()].into_iter().chain(page.lines()) {
        let line = line.trim();
        if !line.is_empty() && !shown.iter().any(|known| known == line) {
            shown.push(line.to_owned());
        }
    }
    shown
}
