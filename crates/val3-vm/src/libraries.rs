//! Libraries that come and go (6.6).

use std::sync::Arc;

use val3_lang::library_errors as code;
use val3_lang::ports::Request;

use crate::execute::Machine;
use crate::{Host, InstanceId, Space};

impl Machine<'_> {
    /// Does what an instruction has asked for; the code it comes to.
    pub(crate) fn fulfil(&mut self, owner: InstanceId, request: Request) -> f64 {
        f64::from(match request {
            Request::Load { library, path, password } => self.load(owner, library, path.as_str(), password.as_str()),
            Request::Save { library, path } => self.save(owner, library, path.as_ref().map(|path| path.as_str())),
        })
    }

    fn load(&mut self, owner: InstanceId, library: u16, path: &str, password: &str) -> u16 {
        let from = self.space.instance(owner).map(|instance| instance.path.clone()).unwrap_or_default();
        let loaded = match self.ports.load(&from, path, password) {
            Ok(loaded) => loaded,
            Err(code) => return code,
        };
        let old = self.space.library(owner, library);
        let same = old.and_then(|old| self.space.instance(old)).is_some_and(|old| old.path == loaded.path);
        if let Some(old) = old.filter(|_| !same)
            && let Some(refusal) = self.refusal(owner, library, old)
        {
            return refusal;
        }
        let new = self.space.take_in(loaded, self.ports);
        let complete = self.space.connect(owner, library, new, self.ports);
        self.space.drop_unused();
        if complete { code::DONE } else { code::INTERFACE_DIFFERS }
    }

    /// Why a library cannot leave memory; `None` where it can, or where others still use it.
    fn refusal(&self, owner: InstanceId, library: u16, old: InstanceId) -> Option<u16> {
        if self.space.has_other_users(old, owner, library) {
            return None;
        }
        if self.roster.has_tasks_of(old) {
            return Some(code::HAS_TASKS);
        }
        let is_in = |task: &crate::Task| task.thread.frames.iter().any(|frame| frame.instance == old);
        self.roster.tasks.iter().any(is_in).then_some(code::IN_USE)
    }

    fn save(&mut self, owner: InstanceId, library: Option<u16>, path: Option<&str>) -> u16 {
        let found = match library {
            None => Some(owner),
            Some(number) => self.space.library(owner, number),
        };
        let Some(instance) = found.and_then(|id| self.space.instance(id)) else { return code::NO_LIBRARY };
        let image = Arc::clone(&instance.image);
        let data: Vec<_> = image.data.iter().zip(instance.data.iter().copied()).collect();
        self.ports.save(&image, &self.space.memory, &data, &instance.path, path)
    }
}

impl Space {
    /// What a library identifier stands for now.
    pub(crate) fn library(&self, owner: InstanceId, number: u16) -> Option<InstanceId> {
        self.instance(owner)?.libraries.get(usize::from(number)).copied().flatten()
    }

    /// The library in memory; loaded with those that load with it, where it is not there yet.
    pub fn take_in(&mut self, loaded: crate::Loaded, host: &mut dyn Host) -> InstanceId {
        let there = self.instances.iter().position(|instance| instance.loaded && instance.path == loaded.path);
        if let Some(at) = there.and_then(|at| u16::try_from(at).ok()) {
            return InstanceId(at);
        }
        let id = self.load(loaded.image, loaded.path, host);
        self.load_with(id, host);
        id
    }

    /// Loads the libraries that load with an application or library. What cannot be loaded is missing when it is used
    /// (error 80).
    pub fn load_with(&mut self, id: InstanceId, host: &mut dyn Host) {
        let Some(instance) = self.instance(id) else { return };
        let (image, path) = (Arc::clone(&instance.image), instance.path.clone());
        for (number, library) in (0u16..).zip(&image.libraries).filter(|(_, library)| library.autoload) {
            if let Ok(loaded) = host.load(&path, &library.path, "") {
                let library = self.take_in(loaded, host);
                self.connect(id, number, library, host);
            }
        }
    }

    fn has_other_users(&self, library: InstanceId, owner: InstanceId, number: u16) -> bool {
        let ids = (0u16..).map(InstanceId);
        ids.zip(&self.instances).filter(|(_, instance)| instance.loaded).any(|(id, instance)| {
            let mut used = (0u16..).zip(&instance.libraries);
            used.any(|(at, used)| *used == Some(library) && (id, at) != (owner, number))
        })
    }

    /// Drops the libraries that no identifier stands for any more. The application is the first in memory.
    fn drop_unused(&mut self) {
        loop {
            let is_used = |id: InstanceId| {
                self.instances.iter().any(|instance| instance.loaded && instance.libraries.contains(&Some(id)))
            };
            let ids = (1u16..).map(InstanceId).zip(self.instances.iter().skip(1));
            let unused = ids.filter(|(_, instance)| instance.loaded).map(|(id, _)| id).find(|id| !is_used(*id));
            let Some(unused) = unused else { return };
            self.unload(unused);
        }
    }

    fn unload(&mut self, id: InstanceId) {
        let Some(instance) = self.instances.get_mut(usize::from(id.0)) else { return };
        instance.loaded = false;
        instance.libraries.fill(None);
        let data = std::mem::take(&mut instance.data);
        data.iter().for_each(|store| self.memory.remove(*store));
    }
}
