//! The application as a whole: its calls, its tasks with the programs they run, and its uses of data.
//!
//! Each program is summed up on its own, without ranges, so that an edit that changes no sum changes nothing here.

mod locks;
mod program;
mod same_name;
mod task_starts;
mod unlisted;

pub use locks::{Lock, locks};
pub use program::{Summary, Use, summary};
pub use task_starts::TaskStart;
pub use unlisted::unlisted_may_use;

use memchr::memchr_iter;
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;

use crate::db::{Db, File, Project, Sources};
use crate::items::project::items;
use crate::pages;

/// A program of the own project (`library` is `None`) or of a library.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Callee {
    /// The library identifier.
    pub library: Option<SmolStr>,
    /// The program.
    pub program: SmolStr,
}

/// A task of the application: `start` and `stop` run in a task of their own, every `taskCreate` names another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Task {
    /// The program that creates it; `None` for the task the controller starts.
    pub created_by: Option<SmolStr>,
    /// How it is started.
    pub start: TaskStart,
}

/// The programs of a project and how they hang together. Names are those of the project's own programs and data.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Application {
    /// Every program could be read and has no fault of names or types, so that the sums are complete.
    pub sound: bool,
    /// All uses of its private names are known: it is sound, and no user page (s8) names its data and programs.
    pub closed: bool,
    /// The tasks, those of `start` and `stop` first.
    pub tasks: Vec<Task>,
    /// For each program the tasks (by their place in `tasks`) that may run it. Programs without an entry are run by
    /// no task of this project.
    pub run_by: FxHashMap<SmolStr, FxHashSet<usize>>,
    /// Programs that run each time the application does, unless one of them returns before.
    pub certain: FxHashSet<SmolStr>,
    /// Programs that run for good once they are called.
    pub endless: FxHashSet<SmolStr>,
    /// How the names begin of tasks that a program ends or whose state it asks for, other than at the end of the
    /// application.
    pub managed_tasks: FxHashSet<SmolStr>,
    /// Programs that call each program, or create a task with it.
    pub callers: FxHashMap<SmolStr, FxHashSet<SmolStr>>,
    /// Programs during which other tasks may run: they wait, or call a program that does, or one that is not known.
    pub waiting: FxHashSet<SmolStr>,
    /// Programs that may call themselves, on their own or through others, and those on a way from one such circle to
    /// another. It is empty for most applications.
    pub circles: FxHashSet<SmolStr>,
    /// For each global the programs that use it.
    pub users: FxHashMap<SmolStr, Vec<(SmolStr, Use)>>,
    /// How the names begin of data that programs read by name, as a text.
    pub named_in_texts: FxHashSet<SmolStr>,
    /// Library identifiers that occur in code.
    pub libraries: FxHashSet<SmolStr>,
    /// Programs that take a flag with `setMutex`.
    pub takers_of_mutexes: FxHashSet<SmolStr>,
    /// Programs that let a stopped arm go on.
    pub restarting: FxHashSet<SmolStr>,
    /// Flags that are tested on one line and set on the next, and the programs that do so.
    pub locks: FxHashMap<SmolStr, Vec<SmolStr>>,
}

/// The programs the controller starts on its own (5.1, 6.2).
pub const ENTRY_POINTS: [&str; 2] = [START, STOP];

/// The program that an application begins with.
pub const START: &str = "start";

/// The program that runs when an application is stopped.
pub const STOP: &str = "stop";

/// The effects of the programs of `project` together.
#[salsa::tracked]
pub fn application(db: &dyn Db, project: Project) -> Application {
    let items = items(db, project);
    let summaries: FxHashMap<&SmolStr, &Summary> =
        items.programs.iter().map(|(name, file)| (name, summary(db, project, *file))).collect();
    let mut names: Vec<&SmolStr> = summaries.keys().copied().collect();
    names.sort_unstable();
    let mut application = Application {
        sound: !items.incomplete && !items.lacks_data && items.lacking_programs.is_empty(),
        ..Application::default()
    };
    application.tasks = entry_tasks(items.programs.keys());
    for name in names {
        let Some(summary) = summaries.get(name) else { continue };
        application.add(name, summary);
    }
    application.find_runs(&summaries);
    application.find_certain(&summaries);
    application.find_managed_tasks(&summaries);
    application.find_waiting(&summaries);
    application.circles = circles(&summaries);
    let has_pages = project.beside(db).iter().any(|name| name.eq_ignore_ascii_case(pages::FOLDER));
    let shows_page = summaries.values().any(|summary| summary.shows_page);
    application.closed = application.sound && !has_pages && !shows_page;
    application
}

/// Some program uses an item called `name` of some library. Libraries are loaded in place of each other, so it may be
/// the item of any project.
pub fn is_library_item(db: &dyn Db, name: &str) -> bool {
    is_mentioned(db, Sources::get(db), name.into())
}

/// A query of its own, so that its callers depend on one name and not on all others.
#[salsa::tracked(returns(copy))]
fn is_mentioned(db: &dyn Db, sources: Sources, name: SmolStr) -> bool {
    library_items(db, sources).contains(&name)
}

#[salsa::tracked]
fn library_items(db: &dyn Db, sources: Sources) -> FxHashSet<SmolStr> {
    let files = sources.files(db).values().chain(sources.unlisted(db).values());
    files.flat_map(|file| mentions(db, *file)).cloned().collect()
}

/// The names after a colon in the text of a file: every `library:item`, and some other words. Only the text is searched,
/// so that the check of one program does not parse every program of a workspace.
#[salsa::tracked]
fn mentions(db: &dyn Db, file: File) -> FxHashSet<SmolStr> {
    let mut mentions = FxHashSet::default();
    let text = file.text(db);
    for behind in memchr_iter(b':', text.as_bytes()).filter_map(|at| text.get(at + 1..)) {
        let name = behind.trim_start_matches([' ', '\t']);
        let is_name = |letter: &u8| letter.is_ascii_alphanumeric() || *letter == b'_';
        let len = name.bytes().position(|letter| !is_name(&letter)).unwrap_or(name.len());
        mentions.extend(name.get(..len).filter(|name| !name.is_empty()).map(SmolStr::from));
    }
    mentions
}

fn entry_tasks<'a>(programs: impl Iterator<Item = &'a SmolStr> + Clone) -> Vec<Task> {
    let entry = |name: &&str| programs.clone().any(|program| program == name);
    let task = |name| Task { created_by: None, start: TaskStart::of_controller(name) };
    ENTRY_POINTS.into_iter().filter(entry).map(task).collect()
}

/// Takes away programs that call none of the others, or that none of the others calls, until all are in circles.
fn circles(summaries: &FxHashMap<&SmolStr, &Summary>) -> FxHashSet<SmolStr> {
    let mut left: FxHashSet<SmolStr> = summaries.keys().map(|name| (*name).clone()).collect();
    loop {
        let mut called = FxHashSet::default();
        let mut calling = FxHashSet::default();
        for name in &left {
            let calls = summaries.get(name).into_iter().flat_map(|summary| &summary.calls);
            let own = calls.filter(|callee| callee.library.is_none() && left.contains(&callee.program));
            for callee in own {
                calling.insert(name.clone());
                called.insert(callee.program.clone());
            }
        }
        let before = left.len();
        left.retain(|name| calling.contains(name) && called.contains(name));
        if left.len() == before {
            return left;
        }
    }
}

impl Application {
    fn add(&mut self, name: &SmolStr, summary: &Summary) {
        self.sound &= summary.sound;
        let started = summary.tasks.iter().map(|start| &start.program);
        for callee in summary.calls.iter().chain(started).filter(|callee| callee.library.is_none()) {
            self.callers.entry(callee.program.clone()).or_default().insert(name.clone());
        }
        for start in &summary.tasks {
            self.tasks.push(Task { created_by: Some(name.clone()), start: start.clone() });
        }
        self.named_in_texts.extend(summary.named_in_texts.iter().cloned());
        self.libraries.extend(summary.libraries.iter().cloned());
        if summary.never_ends {
            self.endless.insert(name.clone());
        }
        if summary.takes_mutex {
            self.takers_of_mutexes.insert(name.clone());
        }
        if summary.restarts_arm {
            self.restarting.insert(name.clone());
        }
        for flag in &summary.locks {
            self.locks.entry(flag.clone()).or_default().push(name.clone());
        }
        for (data, uses) in &summary.data {
            self.users.entry(data.clone()).or_default().push((name.clone(), *uses));
        }
    }

    /// Follows the calls from the program of each task.
    fn find_runs(&mut self, summaries: &FxHashMap<&SmolStr, &Summary>) {
        for (index, task) in self.tasks.iter().enumerate() {
            let first = &task.start.program;
            let mut open: Vec<&SmolStr> = first.library.is_none().then_some(&first.program).into_iter().collect();
            while let Some(program) = open.pop() {
                if self.run_by.entry(program.clone()).or_default().insert(index) {
                    let calls = summaries.get(program).map(|summary| &summary.calls);
                    let own = calls.into_iter().flatten().filter(|callee| callee.library.is_none());
                    open.extend(own.map(|callee| &callee.program));
                }
            }
        }
    }

    /// The effects of all programs of the project on the data called `name`.
    pub fn uses_of(&self, name: &str) -> Use {
        let uses = self.users.get(name).into_iter().flatten();
        uses.fold(Use::default(), |all, (_, one)| Use {
            read: all.read || one.read,
            written: all.written || one.written,
            referenced: all.referenced || one.referenced,
            read_whole: all.read_whole || one.read_whole,
            written_in_parts: all.written_in_parts || one.written_in_parts,
        })
    }

    /// A program reads data by a name that may be `name`, given as a text.
    pub fn is_named_in_text(&self, name: &str) -> bool {
        self.named_in_texts.iter().any(|beginning| beginning.starts_with(name) || name.starts_with(beginning.as_str()))
    }

    /// The number of tasks that may run any of these programs at the same time; 2 means two or more. Tasks of the same
    /// name run one after another.
    pub fn tasks_at_once<'a>(&self, programs: impl IntoIterator<Item = &'a SmolStr>) -> usize {
        let tasks = programs.into_iter().flat_map(|program| self.tasks_of(program));
        let starts = tasks.map(|task| &task.start);
        let mut distinct: FxHashSet<(&SmolStr, &Callee)> = FxHashSet::default();
        for start in starts {
            distinct.insert((&start.beginning, &start.program));
            if start.repeated && start.name.is_none() {
                return 2;
            }
        }
        distinct.len().min(2)
    }

    /// Tasks that programs create may run both programs, each in one of its own, at the same time.
    pub fn run_side_by_side(&self, one: &SmolStr, other: &SmolStr) -> bool {
        let (one, other) = (self.created_tasks_of(one), self.created_tasks_of(other));
        !one.is_empty() && !other.is_empty() && one.union(&other).count() > 1
    }

    /// The tasks that programs create and that may run `program`, by their identity.
    fn created_tasks_of(&self, program: &str) -> FxHashSet<(&SmolStr, &Callee)> {
        let created = self.tasks_of(program).filter(|task| task.created_by.is_some());
        created.map(|task| (&task.start.beginning, &task.start.program)).collect()
    }

    /// A task of this project may be called `name`.
    pub fn may_have_task(&self, name: &str) -> bool {
        self.created_tasks().any(|start| match &start.name {
            Some(known) => known == name,
            None => name.starts_with(start.beginning.as_str()),
        })
    }

    /// The tasks that programs create, in the order of the programs' names.
    pub fn created_tasks(&self) -> impl Iterator<Item = &TaskStart> {
        self.tasks.iter().filter(|task| task.created_by.is_some()).map(|task| &task.start)
    }

    /// Goes from the programs that wait to those that call them.
    fn find_waiting(&mut self, summaries: &FxHashMap<&SmolStr, &Summary>) {
        let calls_unknown = |summary: &Summary| {
            summary.calls.iter().any(|callee| callee.library.is_none() && !summaries.contains_key(&callee.program))
        };
        let first = summaries.iter().filter(|(_, summary)| summary.waits || !summary.sound || calls_unknown(summary));
        let mut open: Vec<SmolStr> = first.map(|(name, _)| (*name).clone()).collect();
        while let Some(program) = open.pop() {
            let callers = self.callers.get(&program).into_iter().flatten();
            let calls = |caller: &&SmolStr| {
                let summary = summaries.get(caller);
                summary.is_some_and(|summary| summary.calls.iter().any(|callee| callee.program == program))
            };
            open.extend(callers.filter(|caller| !self.waiting.contains(*caller)).filter(calls).cloned());
            self.waiting.insert(program);
        }
    }

    /// The tasks that may run a program.
    pub fn tasks_of(&self, program: &str) -> impl Iterator<Item = &Task> {
        let indexes = self.run_by.get(program).into_iter().flatten();
        indexes.filter_map(|index| self.tasks.get(*index))
    }
}
