//! Call graph of an application: its calls, its tasks with their programs, and its uses of data.
//!
//! Each program is summarised separately and without ranges. An edit that changes no summary changes no result here.

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

/// A program of the project itself (`library` is `None`) or of a library.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Callee {
    /// Library identifier.
    pub library: Option<SmolStr>,
    /// Program name.
    pub program: SmolStr,
}

/// A task of the application: `start` and `stop` have a task each, and every `taskCreate` defines another task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StaticTask {
    /// Program that creates the task; `None` for a task that the controller starts.
    pub created_by: Option<SmolStr>,
    /// Start of the task.
    pub start: TaskStart,
}

/// The programs of a project and their relations. All names are names of the project's own programs and data.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Application {
    /// Whether every program is readable and has no fault of names or types, so that all sets are complete.
    pub sound: bool,
    /// Whether all uses of private names are known: the application is sound, and no user page (s8) uses its names.
    pub closed: bool,
    /// All tasks; the tasks of `start` and `stop` come first.
    pub tasks: Vec<StaticTask>,
    /// Tasks that may run each program, as indexes in `tasks`. A program without an entry runs in no task of this
    /// project.
    pub run_by: FxHashMap<SmolStr, FxHashSet<usize>>,
    /// Programs that run in each run of the application, unless a program returns early.
    pub certain: FxHashSet<SmolStr>,
    /// Programs that never return.
    pub endless: FxHashSet<SmolStr>,
    /// Name prefixes of tasks that a program kills or whose status it reads, except at the end of the application.
    pub managed_tasks: FxHashSet<SmolStr>,
    /// Programs that call each program or create a task with it.
    pub callers: FxHashMap<SmolStr, FxHashSet<SmolStr>>,
    /// Programs that may let other tasks run: they wait, or call a waiting or unknown program.
    pub waiting: FxHashSet<SmolStr>,
    /// Programs that may call themselves, directly or through other programs, and programs on a call path between two
    /// such cycles. Empty for most applications.
    pub circles: FxHashSet<SmolStr>,
    /// Programs that use each global variable, with the use.
    pub users: FxHashMap<SmolStr, Vec<(SmolStr, Use)>>,
    /// Name prefixes of data that programs access by a name in a string.
    pub named_in_texts: FxHashSet<SmolStr>,
    /// Library identifiers that occur in code.
    pub libraries: FxHashSet<SmolStr>,
    /// Programs that lock a flag with `setMutex`.
    pub takers_of_mutexes: FxHashSet<SmolStr>,
    /// Programs that restart a stopped arm.
    pub restarting: FxHashSet<SmolStr>,
    /// Flags that are tested on one line and set on the next, with the programs that do this.
    pub locks: FxHashMap<SmolStr, Vec<SmolStr>>,
}

/// Programs that the controller itself starts (5.1, 6.2).
pub const ENTRY_POINTS: [&str; 2] = [START, STOP];

/// Program with which an application begins.
pub const START: &str = "start";

/// Program that runs when an application is stopped.
pub const STOP: &str = "stop";

/// Combines the effects of all programs of `project`.
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

/// Whether any program uses a library item called `name`. Libraries can be loaded in place of each other, so the
/// project of the item is not compared.
pub fn is_library_item(db: &dyn Db, name: &str) -> bool {
    is_mentioned(db, Sources::get(db), name.into())
}

/// Whether library items include `name`. A separate query, so that callers depend on one name instead of all names.
#[salsa::tracked(returns(copy))]
fn is_mentioned(db: &dyn Db, sources: Sources, name: SmolStr) -> bool {
    library_items(db, sources).contains(&name)
}

#[salsa::tracked]
fn library_items(db: &dyn Db, sources: Sources) -> FxHashSet<SmolStr> {
    let files = sources.files(db).values().chain(sources.unlisted(db).values());
    files.flat_map(|file| mentions(db, *file)).cloned().collect()
}

/// Returns the names after a colon in a file: the item of every `library:item`, and some other words. Only the text is
/// searched, because the check of a program would be slow if it parsed every program in the workspace.
#[salsa::tracked]
fn mentions(db: &dyn Db, file: File) -> FxHashSet<SmolStr> {
    let mut mentions = FxHashSet::default();
    let text = file.text(db);
    for behind in memchr_iter(b':', text.as_bytes()).filter_map(|at| text.get(at + 1..)) {
        let name = behind.trim_start_matches([' ', '\t']);
        let len = name.bytes().position(|letter| !letter.is_ascii_alphanumeric() && letter != b'_');
        let len = len.unwrap_or(name.len());
        mentions.extend(name.get(..len).filter(|name| !name.is_empty()).map(SmolStr::from));
    }
    mentions
}

fn entry_tasks<'a>(programs: impl Iterator<Item = &'a SmolStr> + Clone) -> Vec<StaticTask> {
    let entry = |name: &&str| programs.clone().any(|program| program == name);
    let task = |name| StaticTask { created_by: None, start: TaskStart::of_controller(name) };
    ENTRY_POINTS.into_iter().filter(entry).map(task).collect()
}

/// Returns the programs in call cycles, by repeatedly removing programs that call no remaining program or that no
/// remaining program calls.
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
            self.tasks.push(StaticTask { created_by: Some(name.clone()), start: start.clone() });
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

    /// Fills `run_by`: follows the calls from every task's program.
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

    /// Returns the combined uses of the data called `name` by all programs.
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

    /// Whether a program may access the data `name` by a name in a string.
    pub fn is_named_in_text(&self, name: &str) -> bool {
        self.named_in_texts.iter().any(|beginning| beginning.starts_with(name) || name.starts_with(beginning.as_str()))
    }

    /// Returns the number of tasks that may run any of these programs at the same time; 2 means two or more. Tasks with
    /// the same name run one after another.
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

    /// Whether two different created tasks may run the two programs at the same time.
    pub fn run_side_by_side(&self, one: &SmolStr, other: &SmolStr) -> bool {
        let (one, other) = (self.created_tasks_of(one), self.created_tasks_of(other));
        !one.is_empty() && !other.is_empty() && one.union(&other).count() > 1
    }

    /// Returns the identities of created tasks that may run `program`.
    fn created_tasks_of(&self, program: &str) -> FxHashSet<(&SmolStr, &Callee)> {
        let created = self.tasks_of(program).filter(|task| task.created_by.is_some());
        created.map(|task| (&task.start.beginning, &task.start.program)).collect()
    }

    /// Whether a task of this project may have the name `name`.
    pub fn may_have_task(&self, name: &str) -> bool {
        self.created_tasks().any(|start| match &start.name {
            Some(known) => known == name,
            None => name.starts_with(start.beginning.as_str()),
        })
    }

    /// Returns the tasks that programs create, sorted by the creating program.
    pub fn created_tasks(&self) -> impl Iterator<Item = &TaskStart> {
        self.tasks.iter().filter(|task| task.created_by.is_some()).map(|task| &task.start)
    }

    /// Fills `waiting`: follows calls backwards from the waiting programs.
    fn find_waiting(&mut self, summaries: &FxHashMap<&SmolStr, &Summary>) {
        let first = summaries.iter().filter(|(_, summary)| summary.may_wait_directly(summaries));
        let mut open: Vec<SmolStr> = first.map(|(name, _)| (*name).clone()).collect();
        while let Some(program) = open.pop() {
            let callers = self.callers.get(&program).into_iter().flatten();
            let callers = callers.filter(|caller| !self.waiting.contains(*caller));
            let callers = callers.filter(|caller| summaries.get(caller).is_some_and(|it| it.calls_program(&program)));
            open.extend(callers.cloned());
            self.waiting.insert(program);
        }
    }

    /// Returns the tasks that may run a program.
    pub fn tasks_of(&self, program: &str) -> impl Iterator<Item = &StaticTask> {
        let indexes = self.run_by.get(program).into_iter().flatten();
        indexes.filter_map(|index| self.tasks.get(*index))
    }
}
