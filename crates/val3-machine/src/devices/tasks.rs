//! Task events, and the services of the controller for the run time.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use val3_bytecode::Image;
use val3_lang::fault::Fault;
use val3_lang::memory::StoreId;
use val3_lang::ports::{CodePlace, Origin, Ports, TaskChange, TaskNumber, Time};
use val3_lang::runtime_errors::{self, IMPOSSIBLE_MOVE, MOTION_FAULT};
use val3_lang::types::BaseType;
use val3_vm::{Host, InstanceId, LibraryOp, LibraryRequest, LoadedLibrary, Space};

use super::Devices;
use super::outside::LoadFault;
use super::saving::{SaveFault, Saving};
use super::state::DeviceState;
use crate::controller_state::MessageSeverity;
use crate::event::EventKind;
use crate::files::FileFault;

impl Ports for Devices {
    fn origin(&mut self, origin: Origin) {
        self.state.record.set_origin(origin);
    }

    fn task(&mut self, task: TaskNumber, name: &str, change: TaskChange, at: Option<CodePlace>) {
        let (state, code) = match change {
            TaskChange::Created => ("created", None),
            TaskChange::Ended => ("ended", None),
            TaskChange::Halted => ("suspended", None),
            TaskChange::Resumed => ("resumed", None),
            TaskChange::Killed => ("killed", None),
            TaskChange::Failed(Fault(code)) => ("error", Some(code)),
        };
        if change == TaskChange::Created {
            self.state.record.name(task, name);
        }
        let (program, line, file) = self.place(at.unwrap_or(self.state.record.origin().at));
        let (name, program_name) = (name.to_owned(), program.clone());
        self.record(EventKind::Task { state, name, program: program_name, line, code, file: file.clone() });
        if let Some(code) = code {
            let (message, help) = runtime_errors::find(code).map_or(("", ""), |error| (error.short, error.long));
            let is_of_move = [IMPOSSIBLE_MOVE, MOTION_FAULT].contains(&code);
            let reason = self.state.refusal.take().filter(|_| is_of_move);
            let is_line_missing = self.lines.take_missing();
            self.record(EventKind::Error { code, message, reason, help, program, line, file, is_line_missing });
        }
        if matches!(change, TaskChange::Ended | TaskChange::Killed) {
            self.state.record.forget(task);
            self.state.questions.cancel(task, &mut self.state.pendant);
            self.lines.forget_sending(task);
        }
    }

    fn port(&mut self, base: BaseType, path: &str) -> Option<u32> {
        match base {
            BaseType::Dio | BaseType::Aio => Some(self.state.io.adopt(path, base == BaseType::Dio).number()),
            BaseType::Sio => Some(self.lines.known_number(path)),
            _ => None,
        }
    }
}

impl Host for Devices {
    fn take_elapsed(&mut self) -> Time {
        self.state.media_cost.take()
    }

    fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed) || self.state.record.bytes() > self.limits.recorded
    }

    fn lacking(&mut self, instruction: &str) {
        let (program, line, file) = self.place(self.state.record.origin().at);
        self.record(EventKind::Lacking { instruction: instruction.to_owned(), program, line, file });
        self.state.lacks = true;
    }

    fn loaded(&mut self, instance: u16, image: &Arc<Image>, data: &Arc<[StoreId]>) {
        self.state.loaded.add(instance, image, data);
    }

    fn no_memory_for(&mut self, path: &str) {
        self.report(&format!("`{path}`: no memory is left for the library"), MessageSeverity::Error, self.now());
    }

    fn load(&mut self, from: &str, library: LibraryRequest<'_>) -> Result<LoadedLibrary, u16> {
        let path = self.stand_ins.path(from, library);
        match self.outside.load(&mut self.state.media_cost, from, path, library.password) {
            Ok((library, files)) => {
                self.state.loaded.keep_read(&library.image, files);
                Ok(library)
            }
            Err(LoadFault::File(fault)) => Err(fault.code()),
            Err(LoadFault::Program(reason)) => {
                self.report_here(&reason, MessageSeverity::Error);
                Err(FileFault::CannotLoad.code())
            }
        }
    }

    fn save(&mut self, space: &Space, from: InstanceId, saved: InstanceId, to: Option<&str>) -> u16 {
        let DeviceState { io, loaded, media_cost, .. } = &mut self.state;
        let saving = Saving { space, from, saved, io, lines: &self.lines, limit: self.limits.saved };
        let saved = saving.save(to, loaded, media_cost, &mut self.outside);
        let lost = if saved.is_ok() { saving.lost_links(loaded) } else { None };
        if let Some(text) = lost {
            self.report_here(&text, MessageSeverity::Warning);
        }
        if let Err(SaveFault::Value(value)) = &saved {
            self.report_here(&value.to_string(), MessageSeverity::Error);
        }
        let code = saved.err().map_or(0, |fault| FileFault::from(fault).code());
        self.reported(code)
    }

    fn library(&mut self, done: LibraryOp, alias: &str, path: &str, code: u16) {
        let op = match done {
            LibraryOp::Load => "load",
            LibraryOp::Save => "save",
        };
        self.record(EventKind::Lib { op, alias: alias.to_owned(), path: path.to_owned(), code });
    }
}
