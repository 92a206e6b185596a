//! What tasks do, and what the run time asks of the controller.

use std::sync::Arc;

use val3_bytecode::{DataDef, Image};
use val3_lang::fault::Fault;
use val3_lang::memory::{Memory, StoreId};
use val3_lang::ports::{Origin, Ports, TaskChange, TaskNumber};
use val3_lang::runtime_errors;
use val3_lang::types::BaseType;
use val3_vm::{Host, Loaded};

use super::Devices;
use crate::event::What;

impl Ports for Devices {
    fn origin(&mut self, origin: Origin) {
        self.origin = origin;
    }

    fn task(&mut self, task: TaskNumber, name: &str, change: TaskChange) {
        let (state, code) = match change {
            TaskChange::Created => ("created", None),
            TaskChange::Ended => ("ended", None),
            TaskChange::Halted => ("suspended", None),
            TaskChange::Resumed => ("resumed", None),
            TaskChange::Killed => ("killed", None),
            TaskChange::Failed(Fault(code)) => ("error", Some(code)),
        };
        if change == TaskChange::Created {
            self.names.insert(task, name.to_owned());
        }
        let (program, line, file) = self.place();
        self.record(What::Task { state, name: name.to_owned(), program: program.clone(), line, code });
        if let Some(code) = code {
            let message = runtime_errors::find(code).map_or("", |error| error.short);
            self.record(What::Error { code, message, program, line, file });
        }
        if matches!(change, TaskChange::Ended | TaskChange::Killed) {
            self.names.remove(&task);
            self.cancel_reading(task);
        }
    }

    fn port(&mut self, base: BaseType, path: &str) -> Option<u32> {
        match base {
            BaseType::Dio | BaseType::Aio => Some(self.io.adopt(path, base == BaseType::Dio).number()),
            _ => None,
        }
    }
}

impl Host for Devices {
    fn loaded(&mut self, instance: u16, image: &Arc<Image>, data: &Arc<[StoreId]>) {
        self.hold(instance, image, data);
    }

    fn load(&mut self, from: &str, path: &str, password: &str) -> Result<Loaded, u16> {
        self.load_library(from, path, password)
    }

    fn save(
        &mut self,
        image: &Image,
        memory: &Memory,
        data: &[(&DataDef, StoreId)],
        from: &str,
        to: Option<&str>,
    ) -> u16 {
        self.save_library(image, memory, data, from, to)
    }
}
