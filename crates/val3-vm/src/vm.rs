//! Images in memory and the tasks on them.

use std::sync::Arc;

use val3_bytecode::{FatherLink, Image, ImportKind, LinkInit, LinkTarget};
use val3_lang::fault::Fault;
use val3_lang::memory::{Link, Memory, Place, StoreId, View};
use val3_lang::ports::{Ports, Time};

use crate::arguments::Arguments;
use crate::enter::leave;
use crate::execute::Machine;
use crate::roster::Roster;
use crate::task::{Base, Thread};
use crate::{Instance, InstanceId, Rate, Stop, Task, TaskId, TaskState, Turn};

/// Applications and libraries in memory, and the tasks that run.
#[derive(Debug, Clone, Default)]
pub struct Vm {
    /// All data.
    pub memory: Memory,
    pub(crate) instances: Vec<Instance>,
    pub(crate) roster: Roster,
    events: Vec<Event>,
}

/// What has happened to a task.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    /// It was created.
    Created {
        /// The task.
        task: TaskId,
        /// Its name.
        name: String,
    },
    /// Its program has ended.
    Ended(TaskId),
    /// It was halted.
    Halted(TaskId),
    /// It goes on.
    Resumed(TaskId),
    /// It was killed.
    Killed(TaskId),
    /// An error has stopped it.
    Failed(TaskId, Fault),
}

impl Vm {
    /// Takes an application or library into memory, with its data as its files say.
    pub fn load(&mut self, image: Arc<Image>, path: String, ports: &mut dyn Ports) -> InstanceId {
        let data: Arc<[StoreId]> = image.data.iter().map(|data| self.memory.create(&data.init)).collect();
        let instance = Instance {
            data,
            path,
            libraries: vec![None; image.libraries.len()],
            imports: vec![None; image.imports.len()],
            loaded: true,
            image,
        };
        let free = self.instances.iter().position(|instance| !instance.loaded);
        let at = free.unwrap_or(self.instances.len());
        match self.instances.get_mut(at) {
            Some(slot) => *slot = instance,
            None => self.instances.push(instance),
        }
        let id = InstanceId(u16::try_from(at).unwrap_or(u16::MAX));
        self.link_data(id, None, ports);
        id
    }

    /// Lets a library identifier of `user` stand for `library`.
    ///
    /// What the library lacks of what `user` uses raises error 80 when it is used; the answer is whether it has all.
    pub fn connect(&mut self, user: InstanceId, alias: u16, library: InstanceId, ports: &mut dyn Ports) -> bool {
        let Some(instance) = self.instances.get(usize::from(user.0)) else { return false };
        let exporter = self.instances.get(usize::from(library.0));
        let of_alias = |import: &&val3_bytecode::Import| import.library == alias;
        let found: Vec<_> = (0usize..)
            .zip(&instance.image.imports)
            .filter(|(_, import)| of_alias(import))
            .map(|(at, import)| {
                let of_program = matches!(import.kind, ImportKind::Program(_));
                (at, exporter.and_then(|exporter| exporter.export(library, &import.name, of_program)))
            })
            .collect();
        let complete = found.iter().all(|(_, item)| item.is_some());
        if let Some(instance) = self.instances.get_mut(usize::from(user.0)) {
            if let Some(slot) = instance.libraries.get_mut(usize::from(alias)) {
                *slot = Some(library);
            }
            for (at, item) in found {
                if let Some(slot) = instance.imports.get_mut(at) {
                    *slot = item;
                }
            }
        }
        self.link_data(user, Some(alias), ports);
        complete
    }

    /// What is in memory under a number.
    #[must_use]
    pub fn instance(&self, id: InstanceId) -> Option<&Instance> {
        self.instances.get(usize::from(id.0))
    }

    /// The tasks in the order of their creation.
    #[must_use]
    pub fn tasks(&self) -> &[Task] {
        &self.roster.tasks
    }

    /// What has happened since this was asked before.
    pub fn events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.events)
    }

    /// Starts a program without parameters as a task, under any name (5.2).
    ///
    /// # Errors
    /// 61 if there is no such program.
    pub fn start(
        &mut self,
        name: &str,
        (instance, program): (InstanceId, u16),
        priority: u32,
        ports: &mut dyn Ports,
    ) -> Result<TaskId, Fault> {
        let id = self.roster.new_id();
        let stack_size = self.instance(instance).map_or(0, |instance| instance.image.stack_size);
        let mut machine = self.machine(id, 0, (0, 0), stack_size, ports);
        let thread = machine.new_thread((instance, program), &Arguments::new())?;
        self.events.push(Event::Created { task: id, name: name.to_owned() });
        self.roster.tasks.push(Task {
            id,
            name: name.to_owned(),
            owner: instance,
            rate: Rate::Priority(priority),
            state: TaskState::Running,
            thread,
            stack_size,
            left: 0,
        });
        Ok(id)
    }

    /// Gives a task its turn: at most `budget` lines, each of `line_cost` nanoseconds, from `now` on.
    pub fn turn(&mut self, id: TaskId, budget: u32, (now, line_cost): (Time, Time), ports: &mut dyn Ports) -> Turn {
        let nothing = Turn { stop: Stop::Waits, lines: 0, reads_clock: false };
        let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) else { return nothing };
        let stack_size = task.stack_size;
        let mut thread = std::mem::take(&mut task.thread);
        thread.wait = None;
        std::mem::swap(&mut self.memory.stack, &mut thread.stack);
        let end = now + Time::from(budget) * line_cost;
        let mut machine = self.machine(id, budget, (end, line_cost), stack_size, ports);
        let stop = machine.run(&mut thread).unwrap_or_else(Stop::Failed);
        let turn = Turn { stop, lines: budget - machine.budget, reads_clock: machine.reads_clock };
        std::mem::swap(&mut self.memory.stack, &mut thread.stack);
        self.settle(id, thread, stop);
        turn
    }

    fn machine<'v>(
        &'v mut self,
        task: TaskId,
        budget: u32,
        (end, line_cost): (Time, Time),
        stack_size: u32,
        ports: &'v mut dyn Ports,
    ) -> Machine<'v> {
        Machine {
            memory: &mut self.memory,
            instances: &mut self.instances,
            roster: &mut self.roster,
            ports,
            events: &mut self.events,
            task,
            stack_size,
            budget,
            end,
            line_cost,
            reads_clock: false,
        }
    }

    /// Puts the thread of a task back after its turn.
    fn settle(&mut self, id: TaskId, mut thread: Thread, stop: Stop) {
        let Some(at) = self.roster.position(id) else { return };
        let Some(task) = self.roster.tasks.get_mut(at) else { return };
        match stop {
            Stop::Failed(fault) => {
                task.state = TaskState::Failed(fault);
                thread.next = thread.line;
                (thread.since, thread.wait) = (None, None);
                self.events.push(Event::Failed(id, fault));
            }
            Stop::Ended => {
                task.state = TaskState::Killed;
                self.events.push(Event::Ended(id));
            }
            Stop::Budget | Stop::Waits | Stop::Halted => {}
        }
        task.thread = thread;
        self.sweep();
    }

    /// Removes the tasks that have ended or were killed, with the data of their frames.
    fn sweep(&mut self) {
        let is_over = |task: &Task| task.state == TaskState::Killed;
        if !self.roster.tasks.iter().any(is_over) {
            return;
        }
        let (over, left) = std::mem::take(&mut self.roster.tasks).into_iter().partition(is_over);
        self.roster.tasks = left;
        for mut task in over {
            std::mem::swap(&mut self.memory.stack, &mut task.thread.stack);
            leave(&mut self.memory, Base::default());
            std::mem::swap(&mut self.memory.stack, &mut task.thread.stack);
        }
    }

    /// Kills a task from outside.
    pub fn kill(&mut self, id: TaskId) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            task.state = TaskState::Killed;
            self.events.push(Event::Killed(id));
        }
        self.sweep();
    }

    /// Makes the links of data that do not wait for a library, or those that wait for `alias`.
    fn link_data(&mut self, id: InstanceId, alias: Option<u16>, ports: &mut dyn Ports) {
        let Some(instance) = self.instance(id) else { return };
        let image = Arc::clone(&instance.image);
        let alias = alias.and_then(|alias| image.libraries.get(usize::from(alias))).map(|library| &library.alias);
        for init in &image.links {
            let library = match &init.target {
                LinkTarget::Father(father) => father.library.as_ref(),
                LinkTarget::Port(..) => None,
            };
            if library == alias
                && let Some(place) = self.place_of(id, init)
                && let Some(link) = self.target(id, &init.target, ports)
            {
                // The place was looked up just now, so it is there.
                let _ = self.memory.set_link(place, init.link, link);
            }
        }
    }

    fn place_of(&self, id: InstanceId, init: &LinkInit) -> Option<Place> {
        let mut store = self.instance(id)?.data.get(init.data as usize).copied()?;
        for (value, field) in &init.path {
            let place = self.memory.element(View::whole(store), *value).ok()?;
            store = self.memory.part(place, *field).ok()?;
        }
        let found = self.memory.store(store).ok()?;
        Some(found.place(store, init.value))
    }

    fn target(&self, id: InstanceId, target: &LinkTarget, ports: &mut dyn Ports) -> Option<Link> {
        match target {
            LinkTarget::Port(base, path) => ports.port(*base, path).map(Link::Port),
            LinkTarget::Father(father) => self.father(id, father).map(Link::Data),
        }
    }

    fn father(&self, id: InstanceId, father: &FatherLink) -> Option<Place> {
        let own = self.instance(id)?;
        let store = match (&father.library, father.name.as_str()) {
            (Some(library), name) => {
                let at = own.image.libraries.iter().position(|found| found.alias == *library)?;
                let library = self.instance((*own.libraries.get(at)?)?)?;
                library.data.get(usize::from(library.image.data(name)?)).copied()?
            }
            (None, name) => match own.image.data(name) {
                Some(number) => own.data.get(usize::from(number)).copied()?,
                None => builtin(name)?,
            },
        };
        let found = self.memory.store(store).ok()?;
        let number = found.number_of_text(&father.at)?;
        Some(found.place(store, number))
    }
}

/// `world` or `flange`.
fn builtin(name: &str) -> Option<StoreId> {
    val3_lang::builtins::find(name).and_then(|builtin| match builtin.ty {
        val3_lang::types::BaseType::Frame => Some(Memory::WORLD),
        val3_lang::types::BaseType::Tool => Some(Memory::FLANGE),
        _ => None,
    })
}
