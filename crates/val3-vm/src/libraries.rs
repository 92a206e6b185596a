//! Loading and unloading of libraries (6.6).

use std::sync::Arc;

use val3_lang::fault::Fault;
use val3_lang::library_errors as code;
use val3_lang::ports::RuntimeRequest;

use crate::task::Thread;
use crate::turn_context::TurnContext;
use crate::{Host, InstanceId, LibraryOp, LibraryRequest, Space};

/// The application, which is the first instance in memory and is never unloaded.
const APPLICATION: InstanceId = InstanceId(0);

impl TurnContext<'_> {
    /// Executes an instruction's request and returns the result code.
    pub(crate) fn fulfil(&mut self, thread: &Thread, owner: InstanceId, request: RuntimeRequest) -> f64 {
        let (op, library, path) = match request {
            RuntimeRequest::Load { library, path, .. } => (LibraryOp::Load, Some(library), path),
            RuntimeRequest::Save { library, path } => (LibraryOp::Save, library, path.unwrap_or_default()),
        };
        let alias = self.alias(owner, library);
        let code = match request {
            RuntimeRequest::Load { library, path, password } => {
                let request = LibraryRequest { alias: &alias, path: path.as_str(), password: password.as_str() };
                self.load(thread, LibraryIdentifier { owner, number: library }, request)
            }
            RuntimeRequest::Save { library, path } => {
                self.save(owner, library, path.as_ref().map(|path| path.as_str()))
            }
        };
        self.ports.library(op, &alias, path.as_str(), code);
        f64::from(code)
    }

    fn alias(&self, owner: InstanceId, library: Option<u16>) -> String {
        let instance = self.space.instance(owner);
        let found = instance.and_then(|instance| instance.image.libraries.get(usize::from(library?)));
        found.map(|library| library.alias.clone()).unwrap_or_default()
    }

    /// Loads a library, and returns the result code. A library that is already in memory is used unchanged.
    fn load(&mut self, thread: &Thread, identifier: LibraryIdentifier, request: LibraryRequest<'_>) -> u16 {
        let LibraryIdentifier { owner, number } = identifier;
        let from = self.space.instance(owner).map(|instance| instance.path.clone()).unwrap_or_default();
        let loaded = match self.ports.load(&from, request) {
            Ok(loaded) => loaded,
            Err(code) => return code,
        };
        let library = self.space.in_memory(&loaded.path);
        let leaving = self.space.unused(Some(Denotation { identifier, library }));
        if let Some(refusal) = leaving.iter().find_map(|leaving| self.refusal(thread, *leaving)) {
            return refusal;
        }
        let Ok(new) = self.space.take_in(loaded, self.ports) else { return code::CANNOT_LOAD };
        let complete = self.space.connect(owner, number, new, self.ports);
        self.space.drop_unused();
        if complete { code::DONE } else { code::INTERFACE_DIFFERS }
    }

    /// Returns the reason why a library cannot be unloaded; `None` if it can.
    fn refusal(&self, thread: &Thread, library: InstanceId) -> Option<u16> {
        if self.roster.has_tasks_of(library) {
            return Some(code::HAS_TASKS);
        }
        let mut frames = self.roster.tasks.iter().flat_map(|task| &task.thread.frames);
        let is_used = frames.any(|frame| frame.instance == library) || self.is_referred_to(thread, library);
        is_used.then_some(code::IN_USE)
    }

    fn save(&mut self, owner: InstanceId, library: Option<u16>, path: Option<&str>) -> u16 {
        let found = match library {
            None => Some(owner),
            Some(number) => self.space.library(owner, number),
        };
        let Some(id) = found else { return code::NO_LIBRARY };
        self.ports.save(self.space, owner, id, path)
    }
}

/// Library identifier of an application or library.
#[derive(Clone, Copy, PartialEq, Eq)]
struct LibraryIdentifier {
    owner: InstanceId,
    number: u16,
}

/// Library that an identifier is about to denote.
#[derive(Clone, Copy)]
struct Denotation {
    identifier: LibraryIdentifier,
    /// `None` if the library is not in memory yet.
    library: Option<InstanceId>,
}

impl Space {
    /// Returns the library that an identifier currently denotes.
    #[must_use]
    pub fn library(&self, owner: InstanceId, number: u16) -> Option<InstanceId> {
        self.instance(owner)?.libraries.get(usize::from(number)).copied().flatten()
    }

    /// Returns the library with this path, if it is in memory. Media ignore letter case.
    fn in_memory(&self, path: &str) -> Option<InstanceId> {
        let path = path.to_lowercase();
        let there = |instance: &crate::Instance| instance.loaded && instance.path.to_lowercase() == path;
        self.instances.iter().position(there).and_then(|at| u16::try_from(at).ok()).map(InstanceId)
    }

    /// Returns the library in memory. If it is not there yet, it is loaded with its autoload libraries.
    ///
    /// # Errors
    /// 40 if the memory does not suffice, which the event log reports.
    pub fn take_in(&mut self, loaded: crate::LoadedLibrary, host: &mut dyn Host) -> Result<InstanceId, Fault> {
        if let Some(there) = self.in_memory(&loaded.path) {
            return Ok(there);
        }
        let path = loaded.path.clone();
        let id = self.load(loaded.image, loaded.path, host).inspect_err(|_| host.no_memory_for(&path))?;
        self.load_with(id, host);
        Ok(id)
    }

    /// Loads an application's or library's autoload libraries. A library that cannot be loaded causes error 80 when it
    /// is used.
    pub fn load_with(&mut self, id: InstanceId, host: &mut dyn Host) {
        let Some(instance) = self.instance(id) else { return };
        let (image, path) = (Arc::clone(&instance.image), instance.path.clone());
        for (number, library) in (0u16..).zip(&image.libraries).filter(|(_, library)| library.autoload) {
            let request = LibraryRequest { alias: &library.alias, path: &library.path, password: "" };
            let code = match host.load(&path, request) {
                Ok(loaded) => match self.take_in(loaded, host) {
                    Ok(loaded) if self.connect(id, number, loaded, host) => code::DONE,
                    Ok(_) => code::INTERFACE_DIFFERS,
                    Err(_) => code::CANNOT_LOAD,
                },
                Err(code) => code,
            };
            host.library(LibraryOp::Load, &library.alias, &library.path, code);
        }
    }

    /// Returns the libraries that the application does not reach any more after a change of one identifier.
    fn unused(&self, change: Option<Denotation>) -> Vec<InstanceId> {
        let mut used = vec![APPLICATION];
        let mut at = 0;
        while let Some(user) = used.get(at).copied() {
            at += 1;
            let libraries = self.instance(user).map(|instance| instance.libraries.as_slice()).unwrap_or_default();
            for (number, library) in (0u16..).zip(libraries) {
                let identifier = LibraryIdentifier { owner: user, number };
                let library = match change {
                    Some(change) if change.identifier == identifier => change.library,
                    _ => *library,
                };
                used.extend(library.filter(|library| !used.contains(library)));
            }
        }
        let loaded = (0u16..).map(InstanceId).zip(self.instances.iter()).filter(|(_, instance)| instance.loaded);
        loaded.map(|(id, _)| id).filter(|id| !used.contains(id)).collect()
    }

    /// Removes the application and all libraries from memory. No task may exist.
    pub fn unload_application(&mut self) {
        self.unload(APPLICATION);
        self.drop_unused();
    }

    fn drop_unused(&mut self) {
        self.unused(None).into_iter().for_each(|id| self.unload(id));
    }

    fn unload(&mut self, id: InstanceId) {
        let Some(instance) = self.instance_mut(id) else { return };
        instance.loaded = false;
        instance.libraries.fill(None);
        let data = std::mem::take(&mut instance.data);
        let code = instance.image.code_bytes();
        data.iter().for_each(|store| self.memory.remove(*store));
        self.memory.stores.room.give_back(code);
        self.declare_libraries(id);
    }
}
