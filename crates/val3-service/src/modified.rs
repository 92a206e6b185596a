//! Projects in memory that clients have changed, so that their files have other code.

use val3_machine::controller::Controller;
use val3_machine::controller_state::MessageSeverity;
use val3_vm::InstanceId;

use crate::applications;
use crate::context::Context;

impl Context<'_, '_> {
    /// Marks a project in memory as changed. The event log contains each project's first change.
    pub(crate) fn mark_as_modified(&mut self, project: InstanceId) {
        let instance = self.target.debugger.controller.vm.space.instance(project);
        let Some(name) = instance.map(applications::project_name) else { return };
        if self.state.modified.insert(name.clone()) {
            let text = format!("{name} was changed in memory by a client; its files are unchanged");
            report(self.controller(), &text, MessageSeverity::Information);
        }
    }

    /// Reports that changed projects leave the memory.
    pub(crate) fn discard_changes(&mut self) {
        for name in std::mem::take(&mut self.state.modified) {
            let text = format!("{name} leaves the memory with changes of a client, which are not in its files");
            report(self.controller(), &text, MessageSeverity::Warning);
        }
    }
}

fn report(controller: &mut Controller, text: &str, severity: MessageSeverity) {
    let now = controller.now();
    controller.devices.report(text, severity, now);
}
