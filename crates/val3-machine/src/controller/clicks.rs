//! Clicks on HTML pages (s8): each click executes the programs in the bindings of the page, as tasks.

use std::sync::Arc;

use val3_lang::ports::Ports as _;
use val3_vm::ProgramId;

use super::{Controller, RunPhase};
use crate::screen::HtmlCallback;

impl Controller {
    /// Clicks on an element of the displayed page. The task of a program is called `page.element.event_program`, as in
    /// the logs of controllers.
    ///
    /// # Errors
    /// No page is shown, the element has no program, or the task cannot start.
    pub fn click(&mut self, element: &str) -> Result<(), String> {
        if self.phase != RunPhase::Running {
            return Err("the application is stopped, and a click executes nothing".to_owned());
        }
        let Some(page) = self.devices.state.pendant.shown_html() else {
            return Err(format!("no page with `{element}` is shown: call `userPage` with the name of the page first"));
        };
        let callbacks: Vec<HtmlCallback> = page.clicked(element).cloned().collect();
        let page = page.name.clone();
        if callbacks.is_empty() {
            return Err(format!("the page `{page}`, which is shown, executes no program by a click on `{element}`"));
        }
        callbacks.iter().try_for_each(|callback| self.execute(&page, callback))
    }

    fn execute(&mut self, page: &str, callback: &HtmlCallback) -> Result<(), String> {
        let HtmlCallback { element, event, program, priority } = callback;
        let task = format!("{page}.{element}.{event}_{program}");
        if self.vm.tasks().iter().any(|known| known.name == task && known.owner == self.application) {
            return Err(format!("the task `{task}` of an earlier click still runs"));
        }
        let image = self.vm.space.instance(self.application).map(|instance| Arc::clone(&instance.image));
        let number = image.as_ref().and_then(|image| image.program(program));
        let number = number.ok_or_else(|| format!("the application has no program `{program}`"))?;
        self.devices.origin(self.outside());
        let program = ProgramId { instance: self.application, number };
        let started = self.vm.start(&task, program, *priority, &mut self.devices);
        started.map(drop).map_err(|fault| format!("the task `{task}` cannot start: error {}", fault.0))
    }
}
